// Gobos: the same picture the same way round on the floor and in the air, however the lamp hangs and turns;
// shadows in both.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::Camera;
using render::FloatImage;
using render::MeshInstance;
using render::Scene;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr int kGobo = 64;
constexpr int kSize = 128;

/// Open in one quarter of the picture only (right of the centre and above it), so that every turn and every
/// mirror image differs.
std::vector<std::uint8_t> quarterGobo() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kGobo; ++y) {
        for (int x = 0; x < kGobo; ++x) {
            const bool open = x >= kGobo / 2 && y < kGobo / 2;
            for (int c = 0; c < 3; ++c) rgba.push_back(open ? 255 : 0);
            rgba.push_back(255);
        }
    }
    return rgba;
}

/// A place on the gobo, in tangents of the angle from the axis, turned back by the gobo's own rotation.
/// Straight from the definition: looking along the beam with image-up upwards, the picture has been turned
/// counter-clockwise by `turnRad`.
glm::dvec2 onGobo(const glm::dvec2& tangent, double turnRad) {
    return {std::cos(turnRad) * tangent.x + std::sin(turnRad) * tangent.y,
            -std::sin(turnRad) * tangent.x + std::cos(turnRad) * tangent.y};
}

bool isOpen(const glm::dvec2& place) {
    return place.x > 0.0 && place.y > 0.0;
}

/// Far enough from the edges of the open quarter that a pixel is clearly in or out.
bool isClear(const glm::dvec2& place, double margin) {
    return std::min(std::abs(place.x), std::abs(place.y)) > margin;
}

class GoboGl : public GlTest {
 protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        plane_ = renderer().addMesh(render::makePlane());
        box_ = renderer().addMesh(render::makeBox());
        const std::vector<std::uint8_t> rgba = quarterGobo();
        gobo_ = renderer().addGobo(rgba.data(), kGobo, kGobo);
    }

    MeshInstance floor() const {
        MeshInstance floor;
        floor.mesh = plane_;
        floor.worldFromMesh = glm::scale(glm::dmat4(1.0), glm::dvec3(40.0, 40.0, 1.0));
        floor.material.specular = 0.0f;
        floor.castsShadow = false;
        return floor;
    }

    /// A sharp lamp at 6 m, turned by pan about Z and tilt about X.
    Scene lamp(double panDeg, double tiltDeg, double turnDeg) const {
        Scene scene;
        Beam beam;
        beam.lensPositionM = {0.0, 0.0, 6.0};
        beam.lensRadiusM = 0.02;
        beam.worldFromBeam =
            glm::dmat3(glm::rotate(glm::dmat4(1.0), panDeg * kRadPerDeg, glm::dvec3(0.0, 0.0, 1.0)) *
                       glm::rotate(glm::dmat4(1.0), tiltDeg * kRadPerDeg, glm::dvec3(1.0, 0.0, 0.0)));
        beam.fieldAngleRad = 30.0 * kRadPerDeg;
        beam.edge = render::BeamEdge::kFlat;
        beam.fluxLm = 10000.0;
        beam.gobo = gobo_;
        beam.goboRotationRad = turnDeg * kRadPerDeg;
        scene.beams.push_back(beam);
        return scene;
    }

    render::MeshId plane_ = -1;
    render::MeshId box_ = -1;
    render::GoboId gobo_ = -1;
};

/// Where a pixel's ray of a camera that looks straight down from 20 m meets the floor.
glm::dvec3 floorPoint(const Camera& camera, int x, int y) {
    const double half = std::tan(0.5 * camera.verticalFovRad) * camera.positionM.z;
    return {camera.positionM.x + (2.0 * (x + 0.5) / kSize - 1.0) * half,
            camera.positionM.y + (1.0 - 2.0 * (y + 0.5) / kSize) * half, 0.0};
}

TEST_F(GoboGl, LiesOnTheFloorAsTheLampTurnsIt) {
    for (const double pan : {0.0, 35.0, 120.0}) {
        for (const double tilt : {0.0, 25.0, -30.0}) {
            for (const double turn : {0.0, 90.0, 200.0}) {
                Scene scene = lamp(pan, tilt, turn);
                scene.haze.scatteringPerM = 0.0f;
                scene.instances.push_back(floor());
                const Camera camera{{0.0, 0.0, 20.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0 * kRadPerDeg};
                const FloatImage image = draw(scene, camera, kSize, kSize);
                const Beam& beam = scene.beams.front();
                int lit = 0, wrong = 0;
                for (int y = 0; y < kSize; ++y) {
                    for (int x = 0; x < kSize; ++x) {
                        const glm::dvec3 inBeam = glm::transpose(beam.worldFromBeam) *
                                                  (floorPoint(camera, x, y) - beam.lensPositionM);
                        const glm::dvec2 place = onGobo(glm::dvec2(inBeam) / -inBeam.z, beam.goboRotationRad);
                        if (glm::length(place) > 0.9 * std::tan(15.0 * kRadPerDeg) || !isClear(place, 0.03))
                            continue;
                        const bool bright = image.at(x, y)[1] > 1.0f;
                        lit += bright ? 1 : 0;
                        wrong += bright != isOpen(place) ? 1 : 0;
                    }
                }
                EXPECT_GT(lit, 30);
                EXPECT_EQ(wrong, 0) << "pan " << pan << ", tilt " << tilt << ", turn " << turn;
            }
        }
    }
}

TEST_F(GoboGl, LiesTheSameWayInTheAir) {
    // The camera sits on the axis and looks along the beam with image-up upwards: a pixel's ray crosses the
    // gobo from its middle straight towards the pixel's own direction, so the picture is the gobo.
    for (const double turn : {0.0, 90.0, 200.0}) {
        const Scene scene = lamp(35.0, 20.0, turn);
        const Beam& beam = scene.beams.front();
        const glm::dvec3 along = beam.worldFromBeam * glm::dvec3(0.0, 0.0, -1.0);
        const Camera camera{beam.lensPositionM + 3.0 * along, beam.lensPositionM + 9.0 * along,
                            beam.worldFromBeam[1], 24.0 * kRadPerDeg};
        const FloatImage image = draw(scene, camera, kSize, kSize);
        const float brightest = *std::max_element(image.rgb.begin(), image.rgb.end());
        ASSERT_GT(brightest, 0.0f);
        int wrong = 0, checked = 0;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec2 pixel(2.0 * (x + 0.5) / kSize - 1.0, 1.0 - 2.0 * (y + 0.5) / kSize);
                const glm::dvec2 place = onGobo(pixel, beam.goboRotationRad);
                if (glm::length(pixel) > 0.8 || !isClear(place, 0.15)) continue;
                ++checked;
                // Every ray begins in the middle of the gobo, whose corner is as soft as the picture's
                // pixels: a little light everywhere.
                wrong += (image.at(x, y)[1] > 0.3f * brightest) != isOpen(place) ? 1 : 0;
            }
        }
        EXPECT_GT(checked, 1000);
        EXPECT_EQ(wrong, 0) << "turn " << turn;
    }
}

TEST_F(GoboGl, ACasterDarkensTheFloorAndTheAirBehindIt) {
    Scene scene = lamp(0.0, 0.0, 0.0);
    scene.beams.front().gobo = -1;
    scene.instances.push_back(floor());
    MeshInstance caster;
    caster.mesh = box_;
    caster.worldFromMesh = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, 3.0)) *
                           glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 0.5, 0.05));
    Scene blocked = scene;
    blocked.instances.push_back(caster);
    const Camera camera{{0.0, -10.0, 2.0}, {0.0, 0.0, 1.5}, {0.0, 0.0, 1.0}, 30.0 * kRadPerDeg};
    const FloatImage open = draw(scene, camera, kSize, kSize);
    const FloatImage shaded = draw(blocked, camera, kSize, kSize);
    // 1 m below the box, on the axis: in its shadow of 0.75 m within a beam of 2.1 m, so about a third of the
    // light is missing.
    const int x = kSize / 2;
    const int y = static_cast<int>(kSize * (0.5 - 0.5 * ((2.0 - 2.0) / 10.0) / std::tan(15.0 * kRadPerDeg)));
    const double ratio = shaded.at(x, y - 2)[1] / open.at(x, y - 2)[1];
    EXPECT_GT(ratio, 0.4);
    EXPECT_LT(ratio, 0.8);
    // Above the box nothing changes.
    const int above = static_cast<int>(kSize * (0.5 - 0.5 * (2.6 / 10.0) / std::tan(15.0 * kRadPerDeg)));
    EXPECT_NEAR(shaded.at(x, above)[1], open.at(x, above)[1], 0.01 * open.at(x, above)[1]);

    // The floor under the box is dark, and lit beside the shadow.
    const Camera down{{3.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 40.0 * kRadPerDeg};
    Scene surfacesOnly = blocked;
    surfacesOnly.haze.scatteringPerM = 0.0f;
    const FloatImage floorOnly = draw(surfacesOnly, down, kSize, kSize);
    Scene unblocked = scene;
    unblocked.haze.scatteringPerM = 0.0f;
    const FloatImage floorOpen = draw(unblocked, down, kSize, kSize);
    EXPECT_GT(floorOpen.at(kSize / 2, kSize / 2)[1], 1.0f);
    EXPECT_LT(floorOnly.at(kSize / 2, kSize / 2)[1], 0.01f * floorOpen.at(kSize / 2, kSize / 2)[1]);
}

// By the gobo's table a ray's line on the gobo may run with the ray or against it: the shadow is taken off
// all the same.
TEST_F(GoboGl, ACasterDarkensTheAirBehindItFromEverySide) {
    Scene scene = lamp(0.0, 0.0, 0.0);
    MeshInstance caster;
    caster.mesh = box_;
    caster.worldFromMesh = glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, 0.3, 3.0)) *
                           glm::scale(glm::dmat4(1.0), glm::dvec3(0.4, 0.4, 0.1));
    scene.instances.push_back(caster);
    render::Settings sampled;
    sampled.samples = 512;
    for (const double turnDeg : {20.0, 110.0, 200.0, 290.0}) {
        const double turn = turnDeg * kRadPerDeg;
        const Camera camera{{9.0 * std::cos(turn), 9.0 * std::sin(turn), 3.0},
                            {0.0, 0.0, 2.5},
                            {0.0, 0.0, 1.0},
                            40.0 * kRadPerDeg};
        const FloatImage got = draw(scene, camera, kSize, kSize);
        const FloatImage want = draw(scene, camera, kSize, kSize, sampled);
        double error = 0.0, light = 0.0;
        for (std::size_t i = 0; i < want.rgb.size(); ++i) {
            error += std::pow(got.rgb[i] - want.rgb[i], 2.0);
            light += std::pow(want.rgb[i], 2.0);
        }
        EXPECT_LT(std::sqrt(error / light), 0.01) << "from " << turnDeg << " deg";
    }
}

// No acne: a lit flat floor that casts shadows itself is as bright as one that does not.
TEST_F(GoboGl, ALitSurfaceDoesNotShadowItself) {
    for (const double tilt : {0.0, 40.0, 60.0}) {
        Scene scene = lamp(0.0, tilt, 0.0);
        scene.beams.front().gobo = -1;
        scene.haze.scatteringPerM = 0.0f;
        scene.instances.push_back(floor());
        const Camera camera{{0.0, 6.0 * std::tan(tilt * kRadPerDeg) + 0.01, 15.0},
                            {0.0, 6.0 * std::tan(tilt * kRadPerDeg), 0.0},
                            {0.0, 1.0, 0.0},
                            60.0 * kRadPerDeg};
        const FloatImage clean = draw(scene, camera, kSize, kSize);
        scene.instances.front().castsShadow = true;
        const FloatImage self = draw(scene, camera, kSize, kSize);
        for (std::size_t i = 1; i < clean.rgb.size(); i += 3)
            EXPECT_NEAR(self.rgb[i], clean.rgb[i], 0.01f * clean.rgb[i]) << "tilt " << tilt;
    }
}

// Beyond the field there is the holder of the gobo: nothing shines there, however soft the beam and blurred
// the gobo.
TEST_F(GoboGl, BeyondTheFieldAnOpenGoboIsDark) {
    Scene scene = lamp(0.0, 0.0, 0.0);
    const std::vector<std::uint8_t> open(std::size_t{4} * kGobo * kGobo, 255);
    Beam& beam = scene.beams.front();
    beam.gobo = renderer().addGobo(open.data(), kGobo, kGobo);
    beam.edge = render::BeamEdge::kSoft;
    beam.beamAngleRad = 0.5 * beam.fieldAngleRad;
    scene.haze.scatteringPerM = 0.0f;
    scene.instances.push_back(floor());
    // So far off that a pixel is several texels wide.
    const Camera camera{{0.0, 0.0, 60.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 10.0 * kRadPerDeg};
    const FloatImage image = draw(scene, camera, kSize, kSize);
    const float brightest = *std::max_element(image.rgb.begin(), image.rgb.end());
    const double edgeM = 6.0 * std::tan(15.0 * kRadPerDeg);
    const double pixelM = 2.0 * std::tan(5.0 * kRadPerDeg) * 60.0 / kSize;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            if (glm::length(glm::dvec2(floorPoint(camera, x, y))) < edgeM + 2.0 * pixelM) continue;
            ASSERT_LT(image.at(x, y)[1], 1e-4f * brightest) << x << ", " << y;
        }
    }
}

// 10 000 lm on the floor: illuminance summed over the floor is the flux.
TEST_F(GoboGl, TheFloorReceivesTheLampsLumens) {
    for (const render::BeamEdge edge : {render::BeamEdge::kFlat, render::BeamEdge::kSoft}) {
        Scene scene = lamp(0.0, 0.0, 0.0);
        Beam& beam = scene.beams.front();
        beam.gobo = -1;
        beam.edge = edge;
        beam.beamAngleRad = 18.0 * kRadPerDeg;
        scene.haze.scatteringPerM = 0.0f;
        scene.haze.extinctionPerM = 0.0f;
        scene.instances.push_back(floor());
        const Camera camera{{0.0, 0.0, 20.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 30.0 * kRadPerDeg};
        const FloatImage image = draw(scene, camera, 256, 256);
        const double pixelM = 2.0 * std::tan(15.0 * kRadPerDeg) * 20.0 / 256.0;
        double flux = 0.0;
        for (std::size_t i = 1; i < image.rgb.size(); i += 3) {
            flux += static_cast<double>(image.rgb[i]) * 3.14159265358979 /
                    static_cast<double>(scene.instances.front().material.albedo.g) * pixelM * pixelM;
        }
        EXPECT_NEAR(flux, 10000.0, 100.0);
    }
}

}  // namespace
}  // namespace hazer::test
