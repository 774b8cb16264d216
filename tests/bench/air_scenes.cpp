#include "tests/bench/air_scenes.h"

#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>

namespace hazer::bench {
namespace {

using render::Beam;
using render::BeamEdge;
using render::Camera;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr int kGoboPixels = 512;

struct Parts {
    render::MeshId plane = -1;
    render::MeshId sphere = -1;
    render::GoboId gobo = -1;
};

/// Twelve uneven spokes with holes between them; no turn and no mirror image of it is the same.
bool isOpen(double x, double y) {
    const double r = std::hypot(x, y);
    const double turn = std::atan2(y, x) / (2.0 * kPi) + 0.5;
    const double spoke = turn * 12.0 - std::floor(turn * 12.0);
    const bool bar = spoke < 0.25 + 0.35 * turn;
    const double hole = std::hypot(x - 0.45, y - 0.2);
    return (r < 0.95 && r > 0.12 && !bar) || hole < 0.18;
}

render::GoboId addSpokes(render::Renderer& renderer) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kGoboPixels; ++y) {
        for (int x = 0; x < kGoboPixels; ++x) {
            const double half = 0.5 * kGoboPixels;
            const bool open = isOpen((x + 0.5 - half) / half, (half - y - 0.5) / half);
            for (int c = 0; c < 3; ++c) rgba.push_back(open ? 255 : 0);
            rgba.push_back(255);
        }
    }
    return renderer.addGobo(rgba.data(), kGoboPixels, kGoboPixels);
}

render::MeshInstance black(render::MeshId mesh, const glm::dvec3& at, const glm::dvec3& size) {
    render::MeshInstance body;
    body.mesh = mesh;
    body.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), at), size);
    body.material.albedo = render::Color(0.0f);
    body.material.specular = 0.0f;
    return body;
}

/// A lamp at 6 m, tilted, over a floor that it lights.
AirScene plain(const Parts& parts) {
    AirScene made;
    made.name = "plain";
    Beam beam;
    beam.lensPositionM = {-1.5, 0.0, 6.0};
    beam.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), 20.0 * kRadPerDeg, glm::dvec3(0.0, -1.0, 0.0)));
    beam.lensRadiusM = 0.07;
    beam.fieldAngleRad = 30.0 * kRadPerDeg;
    beam.beamAngleRad = 22.0 * kRadPerDeg;
    beam.fluxLm = 10000.0;
    beam.edge = BeamEdge::kFlat;
    beam.showsLens = false;
    made.scene.beams.push_back(beam);
    made.scene.haze.extinctionPerM = 0.02f;
    made.scene.haze.scatteringPerM = 0.02f;
    made.scene.instances.push_back(black(parts.plane, {0.0, 0.0, 0.0}, {60.0, 60.0, 1.0}));
    made.scene.instances.back().castsShadow = false;
    made.camera = {{1.0, -8.0, 1.7}, {0.2, 0.0, 2.9}, {0.0, 0.0, 1.0}, 45.0 * kRadPerDeg};
    return made;
}

AirScene named(AirScene scene, const char* name) {
    scene.name = name;
    return scene;
}

AirScene soft(AirScene scene) {
    scene.scene.beams.front().edge = BeamEdge::kSoft;
    return named(std::move(scene), "soft");
}

AirScene gobo(AirScene scene, const Parts& parts) {
    scene.scene.beams.front().gobo = parts.gobo;
    return named(std::move(scene), "gobo");
}

AirScene shadow(AirScene scene, const Parts& parts, const char* name) {
    scene.scene.instances.push_back(black(parts.sphere, {0.1, 0.1, 2.3}, {0.8, 0.8, 0.8}));
    scene.scene.instances.push_back(black(parts.sphere, {-0.7, -0.2, 3.2}, {0.25, 0.25, 0.25}));
    scene.scene.instances.push_back(black(parts.sphere, {-0.3, 0.4, 3.4}, {0.3, 0.3, 0.3}));
    return named(std::move(scene), name);
}

AirScene noise(AirScene scene) {
    scene.scene.haze.noise.amount = 0.7f;
    scene.scene.haze.noise.scaleM = 1.6f;
    return named(std::move(scene), "noise");
}

/// As uneven as it gets, in swirls far smaller than what lies between two looks.
AirScene fineNoise(AirScene scene) {
    scene.scene.haze.noise.amount = 1.0f;
    scene.scene.haze.noise.scaleM = 0.2f;
    return named(std::move(scene), "fine noise");
}

AirScene thick(AirScene scene) {
    scene.scene.haze.extinctionPerM = 2.5f;
    scene.scene.haze.scatteringPerM = 2.5f;
    return named(std::move(scene), "thick");
}

AirScene narrow(AirScene scene) {
    scene.scene.beams.front().fieldAngleRad = 1.0 * kRadPerDeg;
    return named(std::move(scene), "narrow");
}

AirScene wide(AirScene scene) {
    scene.scene.beams.front().fieldAngleRad = 130.0 * kRadPerDeg;
    scene.scene.beams.front().beamAngleRad = 80.0 * kRadPerDeg;
    return named(std::move(scene), "wide");
}

AirScene inside(AirScene scene) {
    scene.camera = {{0.3, -0.2, 1.7}, {-1.5, 0.6, 5.0}, {0.0, 0.0, 1.0}, 60.0 * kRadPerDeg};
    return named(std::move(scene), "inside");
}

}  // namespace

std::vector<AirScene> makeAirScenes(render::Renderer& renderer) {
    Parts parts;
    parts.plane = renderer.addMesh(render::makePlane());
    parts.sphere = renderer.addMesh(render::makeSphere());
    parts.gobo = addSpokes(renderer);
    const AirScene base = plain(parts);
    return {base,
            soft(base),
            gobo(base, parts),
            named(gobo(soft(base), parts), "soft gobo"),
            shadow(base, parts, "shadow"),
            shadow(soft(base), parts, "soft shadow"),
            shadow(gobo(base, parts), parts, "gobo shadow"),
            noise(base),
            fineNoise(base),
            named(noise(shadow(gobo(base, parts), parts, "")), "gobo shadow noise"),
            thick(base),
            narrow(base),
            wide(base),
            named(wide(soft(base)), "soft wide"),
            inside(base),
            named(inside(gobo(base, parts)), "inside gobo")};
}

}  // namespace hazer::bench
