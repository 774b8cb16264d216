#include "render/oracle/lamp.h"

#include <algorithm>
#include <cmath>

namespace hazer::render::oracle {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The soft profile's pedestal, a share of the peak.
constexpr double kProfileCut = 0.005;

/// A caster this close to the lens is the lamp's own housing.
constexpr double kHousingM = 0.01;

constexpr int kEdgeLooks = 512;

bool isLitAt(const Lamp& lamp, const Bodies& bodies, const Ray& inLamp, double t) {
    return isLit(lamp, bodies, inLamp.originM + t * inLamp.direction, 1.0);
}

/// Where between two places of the ray light turns into shadow, or shadow into light.
double edgeBetween(const Lamp& lamp, const Bodies& bodies, const Ray& inLamp, Stretch change) {
    const bool isLitAtFrom = isLitAt(lamp, bodies, inLamp, change.fromM);
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (change.fromM + change.toM);
        (isLitAt(lamp, bodies, inLamp, middle) == isLitAtFrom ? change.fromM : change.toM) = middle;
    }
    return 0.5 * (change.fromM + change.toM);
}

/// A web is a grid: columns are azimuths from +X towards +Y, rows angles from the axis that grow with the
/// square of the row.
double webTowards(const IesWeb& web, const glm::dvec3& direction) {
    const double theta = std::atan2(std::hypot(direction.x, direction.y), -direction.z);
    const double azimuth = std::atan2(direction.y, direction.x);
    const double row = std::min((kWebThetas - 1) * std::sqrt(theta / kPi), kWebThetas - 1.000001);
    const double turns = azimuth / (2.0 * kPi);
    const double column = kWebAzimuths * (turns - std::floor(turns));
    const auto at = [&](int down, int right) {
        const int x = (static_cast<int>(column) + right) % kWebAzimuths;
        const int y = static_cast<int>(row) + down;
        return static_cast<double>(
            web.relative[static_cast<std::size_t>(y) * kWebAzimuths + static_cast<std::size_t>(x)]);
    };
    const double right = column - std::floor(column);
    return std::lerp(std::lerp(at(0, 0), at(0, 1), right), std::lerp(at(1, 0), at(1, 1), right),
                     row - std::floor(row));
}

}  // namespace

Lamp makeLamp(const Beam& beam, std::span<const IesWeb> webs) {
    const IesWeb* web = beam.web < 0 ? nullptr : &webs[static_cast<std::size_t>(beam.web)];
    Lamp lamp{beam,
              web == nullptr ? beamShape(beam) : webShape(beam, *web),
              {},
              {},
              glm::transpose(beam.worldFromBeam)};
    lamp.model = {lamp.shape.cutHalfAngleRad, lamp.shape.beamHalfAngleRad, lamp.shape.exponent, kProfileCut,
                  lamp.shape.apexToLensM};
    if (web != nullptr) {
        lamp.model.web = [web](const glm::dvec3& direction) { return webTowards(*web, direction); };
    }
    lamp.apexM = beam.lensPositionM + lamp.shape.apexToLensM * beam.worldFromBeam[2];
    return lamp;
}

glm::dvec3 throughGobo(const Lamp& lamp, const GoboPicture& gobo, const glm::dvec3& inLampM,
                       double footprintM) {
    const double axialM = -inLampM.z;
    if (axialM <= 0.0) return glm::dvec3(0.0);
    const double fieldTangent = std::tan(lamp.shape.fieldHalfAngleRad);
    const double turn = lamp.beam.goboRotationRad;
    const glm::dvec2 seen = glm::dvec2(inLampM) / (axialM * fieldTangent);
    // The picture is turned counter-clockwise as seen along the beam, so the place turns back.
    const glm::dvec2 place(std::cos(turn) * seen.x + std::sin(turn) * seen.y,
                           std::cos(turn) * seen.y - std::sin(turn) * seen.x);
    // What blurs as a disc does is looked at in squares as wide as its radius.
    double blur = footprintM / axialM;
    if (lamp.beam.focusDistanceM > 0.0) {
        const double fromLensM = std::max(axialM - lamp.shape.apexToLensM, 1e-3);
        blur = std::max(blur,
                        lamp.beam.lensRadiusM * std::abs(1.0 / fromLensM - 1.0 / lamp.beam.focusDistanceM));
    }
    return gobo.transmission(place, 0.5 * blur / fieldTangent * gobo.size());
}

bool isLit(const Lamp& lamp, const Bodies& bodies, const glm::dvec3& inLampM, double shareOfWay) {
    if (!lamp.beam.castsShadow) return true;
    const double lensM = lamp.shape.apexToLensM;
    const double wayM = lensM > 0.0 ? -inLampM.z : glm::length(inLampM);
    const double housing = wayM > 0.0 ? (lensM + kHousingM) / wayM : shareOfWay;
    if (housing >= shareOfWay) return true;
    const glm::dvec3 way = lamp.beam.worldFromBeam * inLampM;
    return !bodies.isBlocked(lamp.apexM + housing * way, lamp.apexM + shareOfWay * way);
}

std::vector<Stretch> litParts(const Lamp& lamp, const Bodies& bodies, const Ray& inLamp,
                              const Stretch& stretch) {
    if (!lamp.beam.castsShadow) return {stretch};
    const std::vector<Stretch> looks = splitByAngle(inLamp, stretch, kEdgeLooks);
    const auto middle = [](const Stretch& part) { return 0.5 * (part.fromM + part.toM); };
    std::vector<Stretch> lit;
    double lookedAt = middle(looks.front());
    double since = stretch.fromM;  // where the present light or shadow began
    bool wasLit = isLitAt(lamp, bodies, inLamp, lookedAt);
    for (const Stretch& look : looks) {
        const bool isLitHere = isLitAt(lamp, bodies, inLamp, middle(look));
        if (isLitHere != wasLit) {
            const double edge = edgeBetween(lamp, bodies, inLamp, {lookedAt, middle(look)});
            if (wasLit) lit.push_back({since, edge});
            since = edge;
        }
        wasLit = isLitHere;
        lookedAt = middle(look);
    }
    if (wasLit) lit.push_back({since, stretch.toM});
    return lit;
}

}  // namespace hazer::render::oracle
