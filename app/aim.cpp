#include "app/aim.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "fixtures/text.h"

namespace hazer::app {
namespace {

using fixtures::Fixture;

struct Ray {
    glm::dvec3 originM;
    glm::dvec3 direction;
};

std::optional<Ray> firstBeam(const Fixture& fixture) {
    const fixtures::FixtureState state = fixture.state();
    if (state.beams.empty()) return std::nullopt;
    const glm::dmat4& beam = state.beams.front().worldFromBeam;
    return Ray{glm::dvec3(beam[3]), -glm::dvec3(beam[2])};
}

bool canTurn(const Fixture& fixture, const char* attribute) {
    for (const fixtures::AttributeRange& range : fixture.attributes()) {
        if (fixtures::equalsIgnoringCase(range.attribute, attribute))
            return range.physicalTo != range.physicalFrom;
    }
    return false;
}

void panAndTiltTo(double panDeg, double tiltDeg, Fixture& fixture) {
    fixture.preset("Pan", panDeg);
    fixture.preset("Tilt", tiltDeg);
    fixture.settle();
}

glm::dvec3 directionAt(double panDeg, double tiltDeg, Fixture& fixture) {
    panAndTiltTo(panDeg, tiltDeg, fixture);
    return firstBeam(fixture)->direction;
}

/// How pan and tilt swing the beam: straight on at tilt 0, and two directions square to it that the beam
/// takes at tilt 90, for pan 0 and for pan 90. Exact for heads whose two axes are square to each other.
struct Swing {
    glm::dvec3 ahead;
    glm::dvec3 tilted;
    glm::dvec3 tiltedAtPan;

    explicit Swing(Fixture& fixture)
        : ahead(directionAt(0.0, 0.0, fixture)),
          tilted(directionAt(0.0, 90.0, fixture)),
          tiltedAtPan(directionAt(90.0, 90.0, fixture)) {}

    double panDeg(const glm::dvec3& wanted) const {
        const double across = glm::dot(wanted, tiltedAtPan);
        const double along = glm::dot(wanted, tilted);
        const bool isAhead = std::hypot(across, along) < 1e-9;
        return isAhead ? 0.0 : glm::degrees(std::atan2(across, along));
    }

    double tiltDeg(const glm::dvec3& wanted) const {
        return glm::degrees(std::acos(std::clamp(glm::dot(wanted, ahead), -1.0, 1.0)));
    }
};

/// The lens moves with the head, so that its direction to the target is found in a few rounds.
void aimHead(Fixture& fixture, const glm::dvec3& targetM) {
    constexpr int kRounds = 4;
    const Swing swing(fixture);
    panAndTiltTo(0.0, 0.0, fixture);
    for (int round = 0; round < kRounds; ++round) {
        const glm::dvec3 way = targetM - firstBeam(fixture)->originM;
        if (glm::length(way) < 1e-6) return;
        const glm::dvec3 wanted = glm::normalize(way);
        panAndTiltTo(swing.panDeg(wanted), swing.tiltDeg(wanted), fixture);
    }
}

void aimBody(Fixture& fixture, const Ray& beam, const glm::dvec3& targetM) {
    const glm::dvec3 placeM(fixture.worldFromFixture()[3]);
    const glm::dvec3 way = targetM - placeM;
    if (glm::length(way) < 1e-6) return;
    const glm::dvec3 wanted = glm::normalize(way);
    const double cosine = std::clamp(glm::dot(beam.direction, wanted), -1.0, 1.0);
    glm::dvec3 axis = glm::cross(beam.direction, wanted);
    // Opposite ways have every axis between them.
    if (glm::length(axis) < 1e-9) axis = glm::cross(beam.direction, glm::dvec3(1.0, 1e-3, 1e-3));
    glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), std::acos(cosine), glm::normalize(axis));
    turn = glm::translate(glm::dmat4(1.0), placeM) * turn * glm::translate(glm::dmat4(1.0), -placeM);
    fixture.place(turn * fixture.worldFromFixture());
}

}  // namespace

void aim(fixtures::Fixture& fixture, const glm::dvec3& targetM) {
    const std::optional<Ray> beam = firstBeam(fixture);
    if (!beam) return;
    if (canTurn(fixture, "Pan") && canTurn(fixture, "Tilt")) {
        aimHead(fixture, targetM);
    } else {
        aimBody(fixture, *beam, targetM);
    }
}

}  // namespace hazer::app
