#include "tests/support/feature_scene.h"

#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>

#include "render/mesh.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::MeshInstance;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

/// Bars with gaps of the same width, and a border.
render::GoboId addBars(render::AssetSink& assets) {
    constexpr int kEdge = 128;
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kEdge; ++y) {
        for (int x = 0; x < kEdge; ++x) {
            const bool isOpen = (x / 8) % 2 == 0 && y > 16 && y < kEdge - 24;
            for (int c = 0; c < 3; ++c) rgba.push_back(isOpen ? 255 : 0);
            rgba.push_back(255);
        }
    }
    return assets.addGobo(rgba.data(), kEdge, kEdge);
}

/// At 6 m, tilted towards the middle of the stage from the side.
Beam lampAt(double xM, double tiltDeg) {
    Beam beam;
    beam.lensPositionM = {xM, 0.0, 6.0};
    beam.worldFromBeam =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), tiltDeg * kRadPerDeg, glm::dvec3(0.0, 1.0, 0.0)));
    beam.lensRadiusM = 0.07;
    beam.fieldAngleRad = 30.0 * kRadPerDeg;
    beam.beamAngleRad = 20.0 * kRadPerDeg;
    beam.fluxLm = 10000.0;
    return beam;
}

MeshInstance bodyAt(render::MeshId mesh, const glm::dvec3& at, const glm::dvec3& size) {
    MeshInstance body;
    body.mesh = mesh;
    body.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), at), size);
    return body;
}

void takeShadows(FeatureScene& made) {
    for (MeshInstance& body : made.scene.instances) body.castsShadow = false;
}

void hardenEdges(FeatureScene& made) {
    for (Beam& beam : made.scene.beams) beam.edge = render::BeamEdge::kFlat;
}

void hideLenses(FeatureScene& made) {
    for (Beam& beam : made.scene.beams) beam.showsLens = false;
}

void clearHaze(FeatureScene& made) {
    made.scene.haze.scatteringPerM = 0.0f;
    made.scene.haze.extinctionPerM = 0.0f;
}

}  // namespace

FeatureScene makeFullScene(render::AssetSink& assets) {
    FeatureScene made;
    made.scene.beams = {lampAt(-1.5, -15.0), lampAt(2.0, 18.0)};
    made.scene.beams.front().gobo = addBars(assets);
    const render::MeshId plane = assets.addMesh(render::makePlane());
    const render::MeshId sphere = assets.addMesh(render::makeSphere());
    made.scene.instances = {bodyAt(plane, {0.0, 0.0, 0.0}, {20.0, 20.0, 1.0}),
                            bodyAt(sphere, {-0.4, 0.0, 2.0}, {0.9, 0.9, 0.9})};
    made.scene.instances.front().castsShadow = false;
    made.scene.haze.extinctionPerM = 0.02f;
    made.scene.haze.scatteringPerM = 0.02f;
    made.scene.haze.noise.amount = 0.7f;
    made.scene.ambient.illuminanceLx = 5.0f;
    made.camera = {{1.0, -9.0, 1.7}, {0.2, 0.0, 2.9}, {0.0, 0.0, 1.0}, 45.0 * kRadPerDeg};
    return made;
}

const std::vector<Removal>& removals() {
    static const std::vector<Removal> kAll{
        {"haze", "light in the air", clearHaze},
        {"noise", "noise in the haze", [](FeatureScene& made) { made.scene.haze.noise.amount = 0.0f; }},
        {"shadow casters", "shadow maps", takeShadows},
        {"gobo", "gobos", [](FeatureScene& made) { made.scene.beams.front().gobo = -1; }},
        {"soft edges", "soft profile", hardenEdges},
        {"second lamp", "", [](FeatureScene& made) { made.scene.beams.pop_back(); }},
        {"lenses", "lenses", hideLenses},
        {"bloom", "bloom", [](FeatureScene& made) { made.settings.bloom = false; }},
        {"surfaces", "bodies", [](FeatureScene& made) { made.scene.instances.clear(); }}};
    return kAll;
}

}  // namespace hazer::test
