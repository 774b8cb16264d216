// What was given to the renderer comes back as it was, and a frame's own times are known when it is done.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/gobo_store.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

class ReadBackGl : public GlTest {};

TEST_F(ReadBackGl, AMeshComesBackAsItWasAdded) {
    const render::Mesh box = render::makeBox();
    const render::Mesh teapot = render::makeTeapot();
    const render::MeshId first = renderer().addMesh(box);
    const render::MeshId second = renderer().addMesh(teapot);
    for (const auto& [id, mesh] : {std::pair(first, &box), std::pair(second, &teapot)}) {
        const render::Mesh copy = renderer().readMesh(id);
        EXPECT_EQ(copy.indices, mesh->indices);
        ASSERT_EQ(copy.vertices.size(), mesh->vertices.size());
        EXPECT_EQ(std::memcmp(copy.vertices.data(), mesh->vertices.data(),
                              copy.vertices.size() * sizeof(render::Vertex)),
                  0);
    }
}

TEST_F(ReadBackGl, AGoboComesBackAsLinearTransmission) {
    const std::vector<std::uint8_t> grey{188, 188, 188, 255};
    const render::GoboId gobo = renderer().addGobo(grey.data(), 1, 1);
    const std::vector<std::uint8_t>& texels = renderer().readGobo(gobo);
    ASSERT_EQ(texels.size(), 4u * render::kGoboSize * render::kGoboSize);
    const std::size_t middle = 4u * (render::kGoboSize / 2 * render::kGoboSize + render::kGoboSize / 2);
    const double linear = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(texels[middle], 255.0 * linear, 1.0);
    EXPECT_EQ(texels[0], 0) << "outside the inscribed circle";
}

TEST_F(ReadBackGl, TimesAreThoseOfTheLastFrame) {
    render::Scene scene;
    draw(scene, render::Camera{}, 32, 32);
    const auto has = [](const std::vector<render::PassTime>& times, const char* name) {
        return std::any_of(times.begin(), times.end(),
                           [&](const auto& pass) { return pass.name == name && pass.milliseconds >= 0.0; });
    };
    EXPECT_TRUE(has(renderer().lastPassTimes(), "tone map"));
    EXPECT_FALSE(has(renderer().lastPassTimes(), "beams"));
    render::Beam beam;
    beam.fluxLm = 1000.0;
    scene.beams.push_back(beam);
    draw(scene, render::Camera{}, 32, 32);
    EXPECT_TRUE(has(renderer().lastPassTimes(), "beams"));
}

}  // namespace
}  // namespace hazer::test
