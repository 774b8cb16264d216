// Heads and bodies that are pointed at places.
#include "app/aim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "app/fixture_library.h"
#include "fixtures/gdtf.h"

namespace hazer::app {
namespace {

fixtures::Fixture fixtureOf(const std::string& name, const glm::dmat4& worldFromFixture) {
    const fixtures::FixtureTypePtr type = fixtures::loadGdtf(findLibraryFixture(name).value());
    return {name, type, type->modes.front().name, 1, worldFromFixture};
}

/// Degrees between the first beam and the way from its lens to the target.
double offDeg(const fixtures::Fixture& fixture, const glm::dvec3& targetM) {
    const glm::dmat4 beam = fixture.state().beams.front().worldFromBeam;
    const glm::dvec3 way = glm::normalize(targetM - glm::dvec3(beam[3]));
    return glm::degrees(
        std::acos(std::clamp(glm::dot(way, -glm::normalize(glm::dvec3(beam[2]))), -1.0, 1.0)));
}

const glm::dmat4 kHung = glm::translate(glm::dmat4(1.0), {1.0, 2.0, 6.0});

TEST(Aim, AHeadFindsEveryTargetInItsReach) {
    for (const glm::dmat4& place : {kHung, glm::rotate(kHung, 0.7, glm::dvec3(0.3, 1.0, 0.2))}) {
        for (const glm::dvec3 target :
             {glm::dvec3(0.0, 0.0, 0.0), {1.0, 2.0, 0.0}, {-4.0, 9.0, 1.0}, {7.0, -3.0, 5.0}}) {
            fixtures::Fixture fixture = fixtureOf("moving-spot", place);
            aim(fixture, target);
            fixture.settle();
            EXPECT_LT(offDeg(fixture, target), 0.05) << target.x << " " << target.y;
        }
    }
}

// The mirror of a scanner does not reach a quarter turn, and its two ways are not quite square.
TEST(Aim, AScannerFindsTargetsInItsReach) {
    fixtures::Fixture fixture = fixtureOf("scanner", kHung);
    fixture.settle();
    const glm::dmat4 beam = fixture.state().beams.front().worldFromBeam;
    const glm::dvec3 ahead = -glm::normalize(glm::dvec3(beam[2]));
    const glm::dvec3 target = glm::dvec3(beam[3]) + 5.0 * ahead;
    aim(fixture, target);
    fixture.settle();
    EXPECT_LT(offDeg(fixture, target), 0.5);
    for (const glm::dvec3& side : {glm::dvec3(beam[0]), glm::dvec3(beam[1])}) {
        const glm::dvec3 beside = target + 1.2 * glm::normalize(side);
        aim(fixture, beside);
        fixture.settle();
        EXPECT_LT(offDeg(fixture, beside), 3.0);
    }
}

TEST(Aim, WhatCannotTurnIsHungSo) {
    fixtures::Fixture fixture = fixtureOf("fresnel", kHung);
    const glm::dvec3 target(-3.0, -2.0, 0.0);
    aim(fixture, target);
    fixture.settle();
    EXPECT_LT(offDeg(fixture, target), 3.0);
    EXPECT_EQ(fixture.worldFromFixture()[3], kHung[3]);
}

}  // namespace
}  // namespace hazer::app
