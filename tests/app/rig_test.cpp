#include "app/rig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "fixtures/color.h"
#include "render/mesh.h"

namespace hazer::app {
namespace {

fixtures::BeamState litBeam() {
    fixtures::BeamState state;
    state.fluxLm = 10000.0;
    state.colorXyz = fixtures::xyzFromTemperature(6500.0);
    return state;
}

TEST(BeamFromState, aDarkLampGivesNoBeam) {
    fixtures::BeamState state = litBeam();
    state.fluxLm = 0.0;
    EXPECT_FALSE(beamFromState(state));
    state = litBeam();
    state.colorXyz = glm::dvec3(0.0);
    EXPECT_FALSE(beamFromState(state));
    state = litBeam();
    state.type = fixtures::BeamType::kNone;
    EXPECT_FALSE(beamFromState(state));
}

TEST(BeamFromState, fluxIsWhatTheColourLetsThrough) {
    fixtures::BeamState state = litBeam();
    state.colorXyz *= 0.25;
    const auto beam = beamFromState(state);
    ASSERT_TRUE(beam);
    EXPECT_NEAR(beam->fluxLm, 2500.0, 1e-6);
    EXPECT_NEAR(0.2627 * beam->color.r + 0.6780 * beam->color.g + 0.0593 * beam->color.b, 1.0, 1e-3);
}

TEST(BeamFromState, carriesPoseAndOptics) {
    fixtures::BeamState state = litBeam();
    state.worldFromBeam = glm::rotate(glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0}), 0.5, {1.0, 0.0, 0.0});
    state.lensRadiusM = 0.07;
    state.beamAngleDeg = 10.0;
    state.fieldAngleDeg = 20.0;
    const auto beam = beamFromState(state);
    ASSERT_TRUE(beam);
    EXPECT_EQ(beam->lensPositionM, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(-beam->worldFromBeam[2].y, std::sin(0.5), 1e-12);
    EXPECT_NEAR(-beam->worldFromBeam[2].z, -std::cos(0.5), 1e-12);
    EXPECT_EQ(beam->lensRadiusM, 0.07);
    EXPECT_NEAR(beam->beamAngleRad, 0.174533, 1e-6);
    EXPECT_NEAR(beam->fieldAngleRad, 0.349066, 1e-6);
}

TEST(BeamFromState, equalAnglesAreAHardEdgeOfASpotAlone) {
    fixtures::BeamState state = litBeam();
    state.type = fixtures::BeamType::kWash;
    state.beamAngleDeg = state.fieldAngleDeg = 20.0;
    EXPECT_EQ(beamFromState(state)->edge, render::BeamEdge::kSoft);
    EXPECT_NEAR(glm::degrees(beamFromState(state)->fieldAngleRad), 20.0, 1e-9);
    state.type = fixtures::BeamType::kSpot;
    state.beamAngleDeg = state.fieldAngleDeg = 20.0;
    EXPECT_EQ(beamFromState(state)->edge, render::BeamEdge::kFlat);
    state.fieldAngleDeg = 22.0;
    EXPECT_EQ(beamFromState(state)->edge, render::BeamEdge::kSoft);
}

TEST(BeamFromState, staysWithinWhatTheRendererTakes) {
    fixtures::BeamState state = litBeam();
    state.beamAngleDeg = 200.0;
    state.fieldAngleDeg = 190.0;
    const auto beam = beamFromState(state);
    EXPECT_LE(beam->fieldAngleRad, 3.1);
    EXPECT_LE(beam->beamAngleRad, beam->fieldAngleRad);
    state.beamAngleDeg = state.fieldAngleDeg = 0.0;
    EXPECT_GT(beamFromState(state)->beamAngleRad, 0.0);
}

TEST(BeamFromState, withoutAFocusIsSharpEverywhere) {
    fixtures::BeamState state = litBeam();
    state.focus.reset();
    EXPECT_EQ(beamFromState(state)->focusDistanceM, 0.0);
    state.focus = 0.8;
    EXPECT_NEAR(beamFromState(state)->focusDistanceM, 10.0, 1e-9);
}

TEST(BeamFromState, whatOnlyGlowsIsSeenFromEverywhereBefore) {
    fixtures::BeamState state = litBeam();
    state.type = fixtures::BeamType::kGlow;
    state.beamAngleDeg = state.fieldAngleDeg = 5.0;
    EXPECT_NEAR(glm::degrees(beamFromState(state)->beamAngleRad), 120.0, 1e-9);
}

/// Takes meshes, and nothing else.
class MeshesOnly : public render::AssetSink {
 public:
    render::MeshId addMesh(const render::Mesh& mesh) override {
        meshes.push_back(mesh);
        return static_cast<render::MeshId>(meshes.size()) - 1;
    }
    render::GoboId addGobo(const std::uint8_t*, int, int) override { return -1; }
    render::WebId addWeb(const render::IesWeb&) override { return -1; }

    std::vector<render::Mesh> meshes;
};

void append(std::vector<std::uint8_t>& bytes, const void* from, std::size_t size) {
    const auto* const first = static_cast<const std::uint8_t*>(from);
    bytes.insert(bytes.end(), first, first + size);
}

/// A binary glTF 2.0 with one tetrahedron of edges 2, 4 and 8 at the origin, in glTF's own axes: Y up.
using Corners = std::array<std::array<float, 3>, 4>;

std::vector<std::uint8_t> tetrahedronGlb(const Corners& corners = {
                                             {{0, 0, 0}, {2, 0, 0}, {0, 8, 0}, {0, 0, -4}}}) {
    std::string json =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":12,"type":"VEC3","min":[0,0,-4],"max":[2,8,0]}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":144}],"buffers":[{"byteLength":144}]})";
    while (json.size() % 4 != 0) json += ' ';
    constexpr std::array kTriangles{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    std::vector<std::uint8_t> places;
    for (const int corner : kTriangles) append(places, corners[static_cast<std::size_t>(corner)].data(), 12);
    const auto word = [](std::vector<std::uint8_t>& bytes, std::size_t value) {
        const auto small = static_cast<std::uint32_t>(value);
        append(bytes, &small, sizeof small);
    };
    std::vector<std::uint8_t> glb;
    append(glb, "glTF", 4);
    word(glb, 2);
    word(glb, 12 + 8 + json.size() + 8 + places.size());
    word(glb, json.size());
    append(glb, "JSON", 4);
    append(glb, json.data(), json.size());
    word(glb, places.size());
    append(glb, "BIN\0", 4);
    append(glb, places.data(), places.size());
    return glb;
}

render::Scene sceneOf(const fixtures::FixtureState& state, MeshesOnly& assets) {
    Rig rig(assets);
    render::Scene scene;
    rig.append(state, scene);
    return scene;
}

/// Where the scene's first body has a vertex.
glm::dvec3 placeOf(const render::Vertex& vertex, const render::Scene& scene) {
    return glm::dvec3(scene.instances[0].worldFromMesh * glm::dvec4(vertex.positionM, 1.0));
}

// Whatever units a model has, its bounds are as long, wide and high as the fixture says.
TEST(RigBodies, ModelsHaveTheSizeThatTheFixtureSays) {
    fixtures::Model model;
    model.sizeM = {0.3, 0.2, 0.1};
    model.file = std::make_shared<const fixtures::ModelFile>(fixtures::ModelFile{"a.glb", tetrahedronGlb()});
    fixtures::FixtureState state;
    state.parts = {{glm::translate(glm::dmat4(1.0), {5.0, 0.0, 0.0}), &model}, {glm::dmat4(1.0), &model}};
    MeshesOnly assets;
    const render::Scene scene = sceneOf(state, assets);
    ASSERT_EQ(assets.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    glm::dvec3 low(1e9), high(-1e9);
    for (const render::Vertex& vertex : assets.meshes[0].vertices) {
        const glm::dvec3 place = placeOf(vertex, scene);
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    // From the origin, which stays where it is; Y up becomes Z up.
    EXPECT_NEAR(glm::distance(low, glm::dvec3(5.0, 0.0, 0.0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(high, glm::dvec3(5.3, 0.2, 0.1)), 0.0, 1e-6);
}

// A plate has no height to be scaled by: it stays about where it is.
TEST(RigBodies, FlatModelsStayInPlace) {
    fixtures::Model model;
    model.sizeM = {0.2, 0.2, 0.01};
    const Corners plate{{{0, 0.5f, 0}, {2, 0.5f, 0}, {0, 0.5f, -4}, {2, 0.5f, -4}}};
    model.file =
        std::make_shared<const fixtures::ModelFile>(fixtures::ModelFile{"a.glb", tetrahedronGlb(plate)});
    fixtures::FixtureState state;
    state.parts = {{glm::dmat4(1.0), &model}};
    MeshesOnly assets;
    const render::Scene scene = sceneOf(state, assets);
    ASSERT_EQ(assets.meshes.size(), 1u);
    for (const render::Vertex& vertex : assets.meshes[0].vertices) {
        const glm::dvec3 place = placeOf(vertex, scene);
        EXPECT_NEAR(place.z, 0.01 * 0.5 / 4.0, 1e-6);
    }
}

TEST(RigBodies, ABrokenModelIsAPlainShape) {
    fixtures::Model model;
    std::vector<std::uint8_t> bytes = tetrahedronGlb();
    bytes.resize(bytes.size() / 2);
    model.file = std::make_shared<const fixtures::ModelFile>(fixtures::ModelFile{"a.glb", bytes});
    fixtures::FixtureState state;
    state.parts = {{glm::dmat4(1.0), &model}};
    MeshesOnly assets;
    const render::Scene scene = sceneOf(state, assets);
    EXPECT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(assets.meshes.at(0).vertices.size(), render::makeBox().vertices.size());
}

TEST(FocusDistance, runsFromTwoMetresToAKilometre) {
    EXPECT_NEAR(focusDistanceM(0.0), 2.0, 1e-12);
    EXPECT_NEAR(focusDistanceM(0.5), 4.0, 1e-12);
    EXPECT_NEAR(focusDistanceM(0.8), 10.0, 1e-9);
    EXPECT_NEAR(focusDistanceM(1.0), 1000.0, 1e-9);
    EXPECT_NEAR(focusDistanceM(-1.0), 2.0, 1e-12);
}

}  // namespace
}  // namespace hazer::app
