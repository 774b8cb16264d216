// Whole pictures, light in the air and on surfaces, against the oracle of scenes.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <vector>

#include "render/gobo_picture.h"
#include "render/oracle/scene_oracle.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using namespace render;
using render::oracle::GoboPicture;
using render::oracle::Library;
using render::oracle::SceneOracle;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kSize = 96;
constexpr int kPixels = 200;

/// Open in the quarter that is seen right of the centre and above it, and in a stripe below: no turn and no
/// mirror image is like another.
std::vector<std::uint8_t> lopsidedGobo() {
    constexpr int kGobo = 64;
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kGobo; ++y) {
        for (int x = 0; x < kGobo; ++x) {
            const bool isOpen = (x >= kGobo / 2 && y < kGobo / 2) || (y > 44 && y < 52);
            const std::uint8_t value = isOpen ? 255 : 0;
            rgba.insert(rgba.end(), {value, value, value, 255});
        }
    }
    return rgba;
}

double rms(const std::vector<double>& errors) {
    double sum = 0.0;
    for (const double error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
}

double quantile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

class OracleGl : public GlTest {
 protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        plane_ = renderer().addMesh(makePlane());
        ball_ = renderer().addMesh(makeSphere());
        const std::vector<std::uint8_t> rgba = lopsidedGobo();
        gobo_ = renderer().addGobo(rgba.data(), 64, 64);
    }

    /// A lamp that shines at a wall, and a floor.
    Scene stage() const {
        Scene scene;
        Beam beam;
        beam.lensPositionM = {-1.0, -4.0, 3.0};
        // Along +Y, 15 degrees down.
        beam.worldFromBeam =
            glm::dmat3(glm::rotate(glm::dmat4(1.0), 75.0 * kRadPerDeg, glm::dvec3(1.0, 0.0, 0.0)));
        beam.lensRadiusM = 0.05;
        beam.fieldAngleRad = 36.0 * kRadPerDeg;
        beam.edge = BeamEdge::kFlat;
        beam.intensityCd = 20000.0;
        beam.color = Color(1.2f, 0.95f, 0.6f);
        beam.showsLens = false;
        scene.beams.push_back(beam);
        scene.haze.extinctionPerM = 0.05f;
        scene.haze.scatteringPerM = 0.03f;
        scene.ambient.illuminanceLx = 20.0f;
        const auto wall = glm::rotate(glm::translate(glm::dmat4(1.0), {0.0, 4.0, 0.0}), 90.0 * kRadPerDeg,
                                      glm::dvec3(1.0, 0.0, 0.0));
        scene.instances.push_back({plane_, glm::scale(wall, glm::dvec3(30.0)), {}, false});
        scene.instances.push_back({plane_, glm::scale(glm::dmat4(1.0), glm::dvec3(30.0)), {}, false});
        return scene;
    }

    MeshInstance ball(const glm::dvec3& centerM, double diameterM) const {
        return {ball_, glm::scale(glm::translate(glm::dmat4(1.0), centerM), glm::dvec3(diameterM)), {}, true};
    }

    /// Errors of random pixels off the outlines, over the root mean square of the light; sorted.
    std::vector<double> errorsOf(const Scene& scene, const Camera& camera);

    MeshId plane_ = -1;
    MeshId ball_ = -1;
    GoboId gobo_ = -1;
};

std::vector<double> OracleGl::errorsOf(const Scene& scene, const Camera& camera) {
    Settings settings;
    settings.samples = 512;
    const FloatImage picture = draw(scene, camera, kSize, kSize, settings);
    Library library;
    for (MeshId mesh = 0; mesh <= ball_; ++mesh) library.meshes.push_back(renderer().readMesh(mesh));
    for (GoboId gobo = 0; gobo <= gobo_; ++gobo) {
        library.gobos.emplace_back(renderer().readGobo(gobo), kGoboSize);
    }
    library.density = render::oracle::hazeDensity(scene.haze, scene.timeS);
    const SceneOracle oracle(scene, camera, kSize, kSize, library);
    std::mt19937 random(9);
    std::vector<double> errors;
    double light = 0.0;
    for (int i = 0; i < kPixels; ++i) {
        const int x = static_cast<int>(random() % kSize);
        const int y = static_cast<int>(random() % kSize);
        if (!oracle.isClearOfOutlines(x + 0.5, y + 0.5)) continue;
        const glm::dvec3 expected = oracle.air(x + 0.5, y + 0.5) + oracle.surface(x + 0.5, y + 0.5);
        // Luminance is the same number in Rec. 709, which pictures are read in, and in Rec. 2020.
        const float* rgb = picture.at(x, y);
        const double got = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        const double wanted = glm::dot(expected, glm::dvec3(0.2627, 0.6780, 0.0593));
        errors.push_back(std::abs(got - wanted));
        light += wanted * wanted;
    }
    EXPECT_GT(light, 0.0);
    for (double& error : errors) error /= std::sqrt(light / static_cast<double>(errors.size()));
    std::sort(errors.begin(), errors.end());
    fmt::print("rms error {:.1e}, 97 % {:.1e}, worst {:.1e}\n", rms(errors), quantile(errors, 0.97),
               errors.back());
    return errors;
}

TEST_F(OracleGl, WallFloorAndAir) {
    EXPECT_LT(rms(errorsOf(stage(), {{0.5, -9.0, 2.0}, {0.0, 0.0, 1.6}, {0.0, 0.0, 1.0}, 0.7})), 2e-3);
}

TEST_F(OracleGl, AShinyBallAndItsShadow) {
    Scene scene = stage();
    scene.instances.push_back(ball({-1.0, 0.0, 2.0}, 0.9));
    scene.instances.back().material = {Color(0.1f, 0.2f, 0.4f), 0.2f, 60.0f};
    // Shadows on surfaces have filtered edges: a few pixels lie on them.
    EXPECT_LT(quantile(errorsOf(scene, {{2.0, -6.0, 2.6}, {-0.6, 0.4, 1.8}, {0.0, 0.0, 1.0}, 0.6}), 0.97),
              1e-2);
}

// So near that a texel of the gobo is wider than a pixel: nothing is blurred, in the air or on the wall.
TEST_F(OracleGl, AGoboTurnedOnTheWallAndInTheAir) {
    Scene scene = stage();
    scene.beams.front().gobo = gobo_;
    scene.beams.front().goboRotationRad = 25.0 * kRadPerDeg;
    EXPECT_LT(rms(errorsOf(scene, {{-0.4, 2.0, 1.4}, {-1.2, 4.0, 0.9}, {0.0, 0.0, 1.0}, 0.25})), 1e-2);
}

TEST_F(OracleGl, UnevenHaze) {
    Scene scene = stage();
    scene.haze.noise.amount = 0.7f;
    scene.haze.noise.scaleM = 1.2f;
    scene.timeS = 3.7;
    scene.ambient.illuminanceLx = 0.0f;
    for (MeshInstance& instance : scene.instances) instance.material = {Color(0.0f), 0.0f, 1.0f};
    EXPECT_LT(rms(errorsOf(scene, {{0.5, -9.0, 2.0}, {0.0, 0.0, 1.6}, {0.0, 0.0, 1.0}, 0.7})), 1e-2);
}

// The forward peak goes straight on, in the air, to surfaces and from them.
TEST_F(OracleGl, ThickHazeByDeltaEddington) {
    Scene scene = stage();
    scene.haze.extinctionPerM = 0.25f;
    scene.haze.scatteringPerM = 0.24f;
    scene.haze.phase = {0.85f, -0.5f, 0.95f};
    scene.haze.deltaEddington = true;
    EXPECT_LT(rms(errorsOf(scene, {{0.5, -9.0, 2.0}, {0.0, 0.0, 1.6}, {0.0, 0.0, 1.0}, 0.7})), 2e-3);
}

TEST_F(OracleGl, FarFromTheOrigin) {
    Scene scene = stage();
    const glm::dvec3 far(70000.0, -30000.0, 500.0);
    for (Beam& beam : scene.beams) beam.lensPositionM += far;
    for (MeshInstance& instance : scene.instances) instance.worldFromMesh[3] += glm::dvec4(far, 0.0);
    const Camera camera{
        far + glm::dvec3(0.5, -9.0, 2.0), far + glm::dvec3(0.0, 0.0, 1.6), {0.0, 0.0, 1.0}, 0.7};
    EXPECT_LT(rms(errorsOf(scene, camera)), 2e-3);
}

}  // namespace
}  // namespace hazer::test
