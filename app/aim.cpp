#include "app/aim.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <initializer_list>
#include <optional>
#include <utility>

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

/// Empty if the fixture cannot turn there.
std::optional<std::pair<double, double>> reachDeg(const Fixture& fixture, const char* attribute) {
    for (const fixtures::AttributeRange& range : fixture.attributes()) {
        if (!fixtures::equalsIgnoringCase(range.attribute, attribute)) continue;
        if (range.physicalTo == range.physicalFrom) return std::nullopt;
        return std::minmax(range.physicalFrom, range.physicalTo);
    }
    return std::nullopt;
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

/// What of a direction is square to others of length 1, made as long.
glm::dvec3 squareTo(glm::dvec3 direction, std::initializer_list<glm::dvec3> others) {
    for (const glm::dvec3& other : others) direction -= glm::dot(direction, other) * other;
    const double length = glm::length(direction);
    return length > 1e-6 ? direction / length : glm::dvec3(0.0);
}

/// A head whose two axes are square to each other, and what they reach. A mirror swings the beam almost so.
class Head {
 public:
    Head(Fixture& fixture, std::pair<double, double> panDeg, std::pair<double, double> tiltDeg)
        : panReachDeg_(panDeg), tiltReachDeg_(tiltDeg) {
        const double tilt = farthest(tiltReachDeg_);
        const double pan = farthest(panReachDeg_);
        ahead_ = directionAt(0.0, 0.0, fixture);
        tilted_ = squareTo(directionAt(0.0, tilt, fixture), {ahead_}) * (tilt < 0.0 ? -1.0 : 1.0);
        across_ =
            squareTo(directionAt(pan, tilt, fixture), {ahead_, tilted_}) * (pan * tilt < 0.0 ? -1.0 : 1.0);
    }

    /// Of all turns that point there the shortest within reach; if there is none, of all.
    std::pair<double, double> anglesTo(const glm::dvec3& wanted) const {
        const double along = glm::dot(wanted, tilted_);
        const double across = glm::dot(wanted, across_);
        const bool isAhead = std::hypot(across, along) < 1e-9;
        const double pan = isAhead ? 0.0 : glm::degrees(std::atan2(across, along));
        const double tilt = glm::degrees(std::acos(std::clamp(glm::dot(wanted, ahead_), -1.0, 1.0)));
        std::pair<double, double> best{pan, tilt};
        double leastCost = cost(best);
        for (const double turnDeg : {-540.0, -360.0, -180.0, 180.0, 360.0, 540.0}) {
            const bool isOver = std::abs(std::remainder(turnDeg, 360.0)) > 1.0;
            const std::pair other{pan + turnDeg, isOver ? -tilt : tilt};
            if (cost(other) >= leastCost) continue;
            best = other;
            leastCost = cost(other);
        }
        return best;
    }

 private:
    /// Up to a quarter turn, where the direction tells most.
    static double farthest(const std::pair<double, double>& reachDeg) {
        const auto [low, high] = reachDeg;
        return high >= -low ? std::min(high, 90.0) : std::max(low, -90.0);
    }

    static double beyond(const std::pair<double, double>& reachDeg, double deg) {
        return std::max({reachDeg.first - deg, deg - reachDeg.second, 0.0});
    }

    double cost(const std::pair<double, double>& anglesDeg) const {
        constexpr double kOutOfReach = 1e4;
        const double outside =
            beyond(panReachDeg_, anglesDeg.first) + beyond(tiltReachDeg_, anglesDeg.second);
        return kOutOfReach * (outside > 1e-6 ? 1.0 + outside : 0.0) + std::abs(anglesDeg.first) +
               1e-3 * std::abs(anglesDeg.second);
    }

    std::pair<double, double> panReachDeg_, tiltReachDeg_;
    glm::dvec3 ahead_{0.0};
    glm::dvec3 tilted_{0.0};  ///< Where the beam goes from `ahead_` as tilt grows.
    glm::dvec3 across_{0.0};  ///< Where it goes from there as pan grows.
};

/// The lens moves with the head, so that its direction to the target is found in a few rounds.
void aimHead(const Head& head, Fixture& fixture, const glm::dvec3& targetM) {
    constexpr int kRounds = 4;
    panAndTiltTo(0.0, 0.0, fixture);
    for (int round = 0; round < kRounds; ++round) {
        const glm::dvec3 way = targetM - firstBeam(fixture)->originM;
        if (glm::length(way) < 1e-6) return;
        const auto [panDeg, tiltDeg] = head.anglesTo(glm::normalize(way));
        panAndTiltTo(panDeg, tiltDeg, fixture);
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
    const auto panDeg = reachDeg(fixture, "Pan");
    const auto tiltDeg = reachDeg(fixture, "Tilt");
    if (panDeg && tiltDeg) {
        aimHead(Head(fixture, *panDeg, *tiltDeg), fixture, targetM);
    } else {
        aimBody(fixture, *beam, targetM);
    }
}

}  // namespace hazer::app
