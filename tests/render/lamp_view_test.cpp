// What a lamp sees of a box and of a sphere, against points strewn inside them.
#include "render/lamp_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

namespace hazer::test {
namespace {

using render::EdgedBox;
using render::LampView;
using render::TangentRect;
using render::ViewedPart;

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 pointInBox(Random& random, const glm::dvec3& half) {
    return {uniform(random, -half.x, half.x), uniform(random, -half.y, half.y),
            uniform(random, -half.z, half.z)};
}

/// A box of any size and direction, somewhere around the lamp; one in four is flat.
EdgedBox anyBox(Random& random) {
    const glm::dquat turn = glm::normalize(glm::dquat(uniform(random, -1, 1), uniform(random, -1, 1),
                                                      uniform(random, -1, 1), uniform(random, -1, 1)));
    EdgedBox box;
    box.middleM = {uniform(random, -6, 6), uniform(random, -6, 6), uniform(random, -10, 3)};
    box.halfEdgesM = glm::mat3_cast(turn);
    for (int k = 0; k < 3; ++k) box.halfEdgesM[k] *= std::pow(10.0, uniform(random, -1.5, 1.0));
    if (random() % 4 == 0) box.halfEdgesM[2] = glm::dvec3(0.0);
    return box;
}

bool isInView(const glm::dvec3& point, const LampView& view) {
    return -point.z >= view.nearestM && std::abs(point.x) <= view.halfTangent * -point.z &&
           std::abs(point.y) <= view.halfTangent * -point.z;
}

void expectInside(const std::optional<ViewedPart>& part, const glm::dvec3& point) {
    ASSERT_TRUE(part.has_value());
    constexpr double kRounding = 1e-9;
    const glm::dvec2 tangent = glm::dvec2(point) / -point.z;
    for (int k = 0; k < 2; ++k) {
        EXPECT_GE(tangent[k], part->rect.low[k] - kRounding);
        EXPECT_LE(tangent[k], part->rect.high[k] + kRounding);
    }
    EXPECT_GE(-point.z, part->nearM - kRounding);
    EXPECT_LE(-point.z, part->farM + kRounding);
}

TEST(LampView, EnclosesWhateverOfABoxIsInView) {
    Random random(1);
    int inView = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const EdgedBox box = anyBox(random);
        const LampView view{std::pow(10.0, uniform(random, -2.0, 0.5)), uniform(random, 0.01, 2.0)};
        const std::optional<ViewedPart> part = render::viewBox(box, view);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 point = box.middleM + box.halfEdgesM * pointInBox(random, glm::dvec3(1.0));
            if (!isInView(point, view)) continue;
            expectInside(part, point);
            ++inView;
        }
    }
    EXPECT_GT(inView, 5000);
}

TEST(LampView, IsTightAroundABoxThatIsPartlyInView) {
    // A deck of 12 x 8 x 1 m under a lamp that looks straight down from 5 m above its top: the far end of
    // what is seen is the bottom of the deck, and no more than the view is lit.
    const EdgedBox deck{{0.0, 0.0, -5.5}, glm::dmat3({6, 0, 0}, {0, 4, 0}, {0, 0, 0.5})};
    const std::optional<ViewedPart> part = render::viewBox(deck, {0.2, 0.1});
    ASSERT_TRUE(part.has_value());
    EXPECT_NEAR(part->nearM, 5.0, 1e-12);
    EXPECT_NEAR(part->farM, 6.0, 1e-12);
    EXPECT_NEAR(part->rect.high.x, 0.2, 1e-12);
    // The same deck 3 m aside reaches from 1 m beside the axis outwards... of the near side's rim.
    const EdgedBox aside{{3.4, 0.0, -5.5}, glm::dmat3({3, 0, 0}, {0, 4, 0}, {0, 0, 0.5})};
    const std::optional<ViewedPart> edge = render::viewBox(aside, {0.2, 0.1});
    ASSERT_TRUE(edge.has_value());
    EXPECT_NEAR(edge->rect.low.x, 0.4 / 6.0, 1e-12);
}

TEST(LampView, ABoxAroundTheLampBeginsAtTheLens) {
    const EdgedBox room{{0.0, 0.0, 0.0}, glm::dmat3(5.0)};
    const std::optional<ViewedPart> part = render::viewBox(room, {0.5, 0.3});
    ASSERT_TRUE(part.has_value());
    EXPECT_NEAR(part->nearM, 0.3, 1e-12);
    EXPECT_NEAR(part->farM, 5.0, 1e-12);
    EXPECT_NEAR(part->rect.low.x, -0.5, 1e-12);
}

TEST(LampView, WhatIsBehindOrBesideIsNotSeen) {
    const glm::dmat3 half(0.5);
    EXPECT_FALSE(render::viewBox({{0, 0, 3}, half}, {1.0, 0.1}).has_value());
    EXPECT_FALSE(render::viewBox({{5, 0, -2}, half}, {1.0, 0.1}).has_value());
    EXPECT_FALSE(render::viewBox({{0, 0, -2}, half}, {1.0, 3.0}).has_value());
    // No single plane of the view tells this one apart: its corners are on both sides of each.
    const glm::dmat3 turned = glm::mat3_cast(glm::angleAxis(0.785398, glm::dvec3(0, 0, 1)));
    EXPECT_FALSE(render::viewBox({{3.2, 3.2, -2}, turned * glm::dmat3({0.1, 0, 0}, {0, 9, 0}, {0, 0, 0.1})},
                                 {1.0, 0.1})
                     .has_value());
}

TEST(LampView, EnclosesWhateverOfASphereIsInView) {
    Random random(2);
    int inView = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const glm::dvec3 middle(uniform(random, -6, 6), uniform(random, -6, 6), uniform(random, -10, 3));
        const double radius = std::pow(10.0, uniform(random, -1.0, 1.0));
        const LampView view{std::pow(10.0, uniform(random, -2.0, 0.5)), uniform(random, 0.01, 2.0)};
        const std::optional<ViewedPart> part = render::viewSphere(middle, radius, view);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 point = pointInBox(random, glm::dvec3(1.0));
            if (glm::length(point) > 1.0 || !isInView(middle + radius * point, view)) continue;
            expectInside(part, middle + radius * point);
            ++inView;
        }
    }
    EXPECT_GT(inView, 3000);
}

TEST(LampView, IsTightAroundASphere) {
    const std::optional<ViewedPart> part = render::viewSphere({0.0, 0.0, -4.0}, 1.0, {2.0, 0.1});
    ASSERT_TRUE(part.has_value());
    // The tangent from a point at distance d to a sphere of radius r: r / sqrt(d^2 - r^2).
    EXPECT_NEAR(part->rect.high.x, 1.0 / std::sqrt(15.0), 1e-12);
    EXPECT_NEAR(part->rect.low.y, -1.0 / std::sqrt(15.0), 1e-12);
    EXPECT_NEAR(part->nearM, 3.0, 1e-12);
    EXPECT_NEAR(part->farM, 5.0, 1e-12);
}

TEST(LampView, ARectangleIsCutToTheCircleOfTheBeam) {
    Random random(3);
    for (int trial = 0; trial < 2000; ++trial) {
        const glm::dvec2 a(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5));
        const glm::dvec2 b(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5));
        const TangentRect rect{glm::min(a, b), glm::max(a, b)};
        const std::optional<TangentRect> cut = render::cutToCircle(rect, 1.0);
        const glm::dvec2 nearest = glm::clamp(glm::dvec2(0.0), rect.low, rect.high);
        EXPECT_EQ(cut.has_value(), glm::length(nearest) <= 1.0);
        for (int i = 0; i < 50 && cut; ++i) {
            const glm::dvec2 point(uniform(random, rect.low.x, rect.high.x),
                                   uniform(random, rect.low.y, rect.high.y));
            if (glm::length(point) > 1.0) continue;
            EXPECT_EQ(point, glm::clamp(point, cut->low, cut->high));
        }
    }
    // A corner of the square that the circle does not reach is cut away.
    const std::optional<TangentRect> corner = render::cutToCircle({{0.6, 0.6}, {1.0, 1.0}}, 1.0);
    ASSERT_TRUE(corner.has_value());
    EXPECT_NEAR(corner->high.x, 0.8, 1e-12);
}

}  // namespace
}  // namespace hazer::test
