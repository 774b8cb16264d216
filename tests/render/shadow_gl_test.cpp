// Shadows on surfaces as drawn, against plain geometry; and maps that are drawn only when they must be.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/camera.h"
#include "render/gpu_beam.h"
#include "render/mesh_builder.h"
#include "render/passes/shadow_pass.h"
#include "render/scene_plan.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::Camera;
using render::FloatImage;
using render::MeshId;
using render::MeshInstance;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr int kSize = 192;

/// A ball of diameter 1 whose facets are finer than any map.
render::Mesh roundBall() {
    render::Mesh mesh;
    render::appendSurface(mesh, 192, 96, [](float u, float v) {
        const double azimuth = 2.0 * kPi * static_cast<double>(u);
        const double polar = kPi * (1.0 - static_cast<double>(v));
        const glm::vec3 direction(glm::dvec3(std::sin(polar) * std::cos(azimuth),
                                             std::sin(polar) * std::sin(azimuth), std::cos(polar)));
        return render::Vertex{0.5f * direction, direction};
    });
    return mesh;
}

/// Columns: right, up and backwards of a lamp at `from` that looks at `at`.
glm::dmat3 lookingAt(const glm::dvec3& from, const glm::dvec3& at) {
    const glm::dvec3 back = glm::normalize(from - at);
    const glm::dvec3 side = std::abs(back.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(side, back));
    return {right, glm::cross(back, right), back};
}

class ShadowGl : public GlTest {
 protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        plane_ = add(render::makePlane());
        box_ = add(render::makeBox());
        facets_ = add(render::makeSphere());
        ball_ = add(roundBall());
        cylinder_ = add(render::makeCylinder());
        teapot_ = add(render::makeTeapot());
    }

    MeshId add(const render::Mesh& mesh) {
        bounds_.push_back({render::boundingSphere(mesh), render::boundingBox(mesh)});
        const MeshId id = renderer().addMesh(mesh);
        // Ids count on from test to test of one renderer.
        firstId_ = std::min(firstId_, id);
        return id;
    }

    static MeshInstance body(MeshId mesh, const glm::dvec3& at, const glm::dvec3& size,
                             bool castsShadow = true) {
        MeshInstance instance;
        instance.mesh = mesh;
        instance.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), at), size);
        instance.material.specular = 0.0f;
        instance.castsShadow = castsShadow;
        return instance;
    }

    /// A point source of light on a floor, in clear air.
    Scene floorUnder(const glm::dvec3& lamp, const glm::dvec3& target, double halfAngleDeg,
                     bool floorCasts) const {
        Scene scene;
        Beam beam;
        beam.lensPositionM = lamp;
        beam.worldFromBeam = lookingAt(lamp, target);
        beam.lensRadiusM = 0.0;
        beam.edge = render::BeamEdge::kFlat;
        beam.fieldAngleRad = 2.0 * halfAngleDeg * kRadPerDeg;
        beam.intensityCd = 10000.0;
        scene.beams.push_back(beam);
        scene.haze.scatteringPerM = 0.0f;
        scene.haze.extinctionPerM = 0.0f;
        scene.instances.push_back(body(plane_, {0, 0, 0}, {400, 400, 1}, floorCasts));
        return scene;
    }

    /// What a texel of the first beam's map covers at 1 m from the apex [m].
    double texelAt1M(const Scene& scene, const Camera& camera) {
        render::Settings settings;
        settings.width = settings.height = kSize;
        std::vector<render::MeshBounds> bounds(static_cast<std::size_t>(firstId_));
        bounds.insert(bounds.end(), bounds_.begin(), bounds_.end());
        const render::ScenePlan plan = render::planScene(scene, camera, settings, bounds);
        EXPECT_EQ(plan.shadowMaps.size(), 1u);
        double texel = 0.0;
        for (const render::ShadowFacePlan& face : plan.shadowMaps.front().faces) {
            const glm::dvec2 perTangent = render::shadowProjection(face).texelsPerTangent;
            texel = std::max(texel, 1.0 / std::min(perTangent.x, perTangent.y));
        }
        return texel;
    }

    MeshId plane_ = -1, box_ = -1, facets_ = -1, ball_ = -1, cylinder_ = -1, teapot_ = -1;
    MeshId firstId_ = 1 << 30;
    std::vector<render::MeshBounds> bounds_;
};

/// World direction of a pixel's ray.
glm::dvec3 pixelDirection(const Camera& camera, int x, int y) {
    const glm::dvec2 tangent = render::viewTangent(camera, 1.0);
    const glm::dvec3 inView((2.0 * (x + 0.5) / kSize - 1.0) * tangent.x,
                            (1.0 - 2.0 * (y + 0.5) / kSize) * tangent.y, -1.0);
    return render::worldFromView(camera) * glm::normalize(inView);
}

/// How far the straight way between two points stays from a centre.
double missOf(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& centre) {
    const glm::dvec3 way = to - from;
    const double share = std::clamp(glm::dot(centre - from, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::distance(centre, from + share * way);
}

struct Ball {
    glm::dvec3 centre;
    double radius;
};

struct Verdict {
    int lit = 0, dark = 0, wrong = 0;
};

/// Looks at every pixel that shows the floor, away from the ball's outline: what sees the lamp past the ball
/// by more than `slackM` must be as bright as without the ball, what is hidden from it by more than that must
/// be black.
Verdict judge(const FloatImage& with, const FloatImage& without, const Camera& camera, const glm::dvec3& lamp,
              const Ball& ball, double slackM) {
    Verdict verdict;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const glm::dvec3 ray = pixelDirection(camera, x, y);
            if (ray.z >= 0.0) continue;
            const glm::dvec3 floor = camera.positionM - ray * (camera.positionM.z / ray.z);
            const double open = without.at(x, y)[1];
            if (missOf(camera.positionM, floor, ball.centre) < 1.02 * ball.radius || open <= 0.0) continue;
            const double missM = missOf(lamp, floor, ball.centre);
            const double share = with.at(x, y)[1] / open;
            if (missM > ball.radius + slackM) {
                ++verdict.lit;
                verdict.wrong += share < 0.98 ? 1 : 0;
            } else if (missM < ball.radius - slackM) {
                ++verdict.dark;
                verdict.wrong += share > 0.02 ? 1 : 0;
            }
        }
    }
    return verdict;
}

struct SphereCase {
    double lampM;     ///< Distance from the ball.
    double slantDeg;  ///< Of the light against the vertical.
    double liftM;     ///< The ball's lowest point over the floor.
    double cameraM;   ///< Distance from the ball.
    bool floorCasts;
};

TEST_F(ShadowGl, ABallsShadowIsWhereGeometryPutsItToATexel) {
    constexpr double kRadius = 0.5;
    for (const SphereCase& c :
         {SphereCase{3.0, 30.0, 0.0, 4.0, false}, SphereCase{8.0, 45.0, 0.0, 6.0, true},
          SphereCase{8.0, 70.0, 0.0, 6.0, true}, SphereCase{8.0, 80.0, 0.3, 6.0, true},
          SphereCase{30.0, 45.0, 0.5, 10.0, false}, SphereCase{100.0, 60.0, 0.0, 5.0, true},
          SphereCase{8.0, 5.0, 1.0, 40.0, true}}) {
        SCOPED_TRACE(fmt::format("lamp at {} m, {} deg, lifted by {} m", c.lampM, c.slantDeg, c.liftM));
        const Ball ball{{0.0, 0.0, kRadius + c.liftM}, kRadius};
        const glm::dvec3 towards(std::sin(c.slantDeg * kRadPerDeg), 0.0, std::cos(c.slantDeg * kRadPerDeg));
        const glm::dvec3 lamp = ball.centre + c.lampM * towards;
        Scene scene = floorUnder(lamp, ball.centre, std::atan(2.5 / c.lampM) / kRadPerDeg, c.floorCasts);
        // From the side, onto the place where the ball stands and its shadow begins.
        const Camera camera{ball.centre + c.cameraM * glm::normalize(glm::dvec3(-1.0, -1.0, 0.7)),
                            {-0.3, 0.0, 0.0},
                            {0.0, 0.0, 1.0},
                            2.0 * std::atan(1.6 / c.cameraM)};
        const FloatImage without = draw(scene, camera, kSize, kSize);
        scene.instances.push_back(body(ball_, ball.centre, glm::dvec3(2.0 * kRadius)));
        const FloatImage with = draw(scene, camera, kSize, kSize);
        const double texelM = texelAt1M(scene, camera) * (c.lampM + kRadius);
        // Half of the filter, and the step off the surface.
        const Verdict verdict = judge(with, without, camera, lamp, ball, 2.0 * texelM);
        fmt::print("texel {:.1f} mm: {} lit, {} dark, {} wrong\n", 1e3 * texelM, verdict.lit, verdict.dark,
                   verdict.wrong);
        EXPECT_LT(texelM, 0.04);
        EXPECT_GT(verdict.lit, 1000);
        EXPECT_GT(verdict.dark, 300);
        EXPECT_EQ(verdict.wrong, 0);
    }
}

/// Is it lit all around, two pixels wide? At an outline a smooth normal may look away from the eye and is
/// then taken for the back of a sheet.
bool isWellInside(const FloatImage& image, int x, int y) {
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            const int u = x + dx, v = y + dy;
            if (u < 0 || v < 0 || u >= kSize || v >= kSize || image.at(u, v)[1] <= 0.0f) return false;
        }
    }
    return true;
}

/// Where a lit body casts onto nothing but itself, what its own map takes from it where the light comes in at
/// more than `leastCosine`: the darkest pixel's share.
struct SelfShadow {
    double darkest = 1.0;
    int looked = 0;
};

TEST_F(ShadowGl, LitFacesHaveNoDotsAtGrazingLight) {
    struct Shape {
        const char* name;
        MeshId mesh;
        glm::dvec3 size;
        double leastCosine;
    };
    // The cosine of the smooth normal; facets of a coarse body turn away from the light before it does.
    for (const Shape& shape :
         {Shape{"floor", plane_, {6, 6, 1}, 0.0}, Shape{"box", box_, {1, 1, 1}, 0.0},
          Shape{"thin box", box_, {2, 2, 0.01}, 0.0}, Shape{"round ball", ball_, {1, 1, 1}, 0.05},
          Shape{"coarse ball", facets_, {1, 1, 1}, 0.2}, Shape{"cylinder", cylinder_, {1, 1, 1}, 0.15}}) {
        for (const double slantDeg : {0.0, 50.0, 75.0, 85.0, 88.0}) {
            for (const double lampM : {3.0, 12.0, 100.0}) {
                const glm::dvec3 towards(std::sin(slantDeg * kRadPerDeg), 0.1,
                                         std::cos(slantDeg * kRadPerDeg));
                const glm::dvec3 lamp = lampM * glm::normalize(towards);
                Scene scene = floorUnder(lamp, {0, 0, 0}, std::atan(2.0 / lampM) / kRadPerDeg, false);
                scene.instances = {body(shape.mesh, {0, 0, 0}, shape.size, false)};
                const Camera camera{{2.0, -4.0, 3.0}, {0, 0, 0}, {0, 0, 1}, 30.0 * kRadPerDeg};
                const FloatImage open = draw(scene, camera, kSize, kSize);
                scene.instances.front().castsShadow = true;
                const FloatImage self = draw(scene, camera, kSize, kSize);
                SelfShadow worst;
                for (int y = 0; y < kSize; ++y) {
                    for (int x = 0; x < kSize; ++x) {
                        // A white diffuse body of this size receives about I / r^2 cos.
                        const double cosine =
                            static_cast<double>(open.at(x, y)[1]) * kPi / 0.5 * lampM * lampM / 10000.0;
                        if (cosine <= 1.3 * shape.leastCosine || !isWellInside(open, x, y)) continue;
                        ++worst.looked;
                        worst.darkest =
                            std::min(worst.darkest, static_cast<double>(self.at(x, y)[1] / open.at(x, y)[1]));
                    }
                }
                EXPECT_GT(worst.darkest, 0.97) << shape.name << ", " << slantDeg << " deg, lamp at " << lampM
                                               << " m, " << worst.looked << " pixels";
            }
        }
    }
}

// A plate that lies on the floor, thinner than what a bias would lift it by: its shadow begins at its edge.
TEST_F(ShadowGl, AThinPlatesShadowBeginsAtItsEdge) {
    for (const double thickM : {0.01, 0.05}) {
        const glm::dvec3 lamp(8.0, 0.0, 4.0);
        Scene scene = floorUnder(lamp, {0, 0, 0}, 15.0, true);
        const Camera camera{{-0.5, -0.001, 3.0}, {-0.5, 0.0, 0.0}, {0, 1, 0}, 15.0 * kRadPerDeg};
        const FloatImage without = draw(scene, camera, kSize, kSize);
        scene.instances.push_back(body(box_, {0.0, 0.0, 0.5 * thickM}, {1.0, 1.0, thickM}));
        const FloatImage with = draw(scene, camera, kSize, kSize);
        // Light comes from +X: behind the edge at x = -0.5 the shadow is thickM * (8.5 / 4) long.
        const double footprintM = texelAt1M(scene, camera) * 9.4 / std::sin(std::atan2(4.0, 8.5));
        const double shadowM = thickM * 8.5 / (4.0 - thickM);
        int dark = 0, lit = 0;
        for (int x = 0; x < kSize; ++x) {
            const glm::dvec3 ray = pixelDirection(camera, x, kSize / 2);
            const double behindM = -0.5 - (camera.positionM - ray * (camera.positionM.z / ray.z)).x;
            const double share = with.at(x, kSize / 2)[1] / without.at(x, kSize / 2)[1];
            if (behindM > 0.3 * footprintM + 0.002 && behindM < shadowM - 1.5 * footprintM) {
                ++dark;
                EXPECT_LT(share, 0.1) << "plate of " << thickM << " m, " << behindM << " m behind it";
            }
            if (behindM > shadowM + 2.0 * footprintM) {
                ++lit;
                EXPECT_GT(share, 0.98);
            }
        }
        fmt::print("plate of {} m: texel on the floor {:.1f} mm, shadow {:.1f} mm, {} dark, {} lit\n", thickM,
                   1e3 * footprintM, 1e3 * shadowM, dark, lit);
        EXPECT_GT(lit, 10);
        EXPECT_TRUE(dark > 3 || shadowM < 4.0 * footprintM);
    }
}

// Seen from so near that a texel of the largest map is several pixels.
TEST_F(ShadowGl, AnEdgeIsAsSoftAsATexel) {
    Scene scene = floorUnder({0.0, 0.0, 6.0}, {0, 0, 0}, 20.0, true);
    const Camera camera{{0.0, -0.001, 0.2}, {0.0, 0.0, 0.0}, {0, 1, 0}, 30.0 * kRadPerDeg};
    const FloatImage without = draw(scene, camera, kSize, kSize);
    scene.instances.push_back(body(box_, {-2.0, 0.0, 5.0}, {4.0, 4.0, 0.01}));
    const FloatImage with = draw(scene, camera, kSize, kSize);
    const double texelM = texelAt1M(scene, camera) * 6.0;
    const double pixelM = 2.0 * 0.2 * std::tan(15.0 * kRadPerDeg) / kSize;
    ASSERT_GT(texelM, 3.0 * pixelM);
    const int row = kSize / 2;
    int between = 0;
    for (int x = 0; x < kSize; ++x) {
        const double share = with.at(x, row)[1] / without.at(x, row)[1];
        between += share > 0.1 && share < 0.9 ? 1 : 0;
    }
    const double softness = between * pixelM / texelM;
    fmt::print("from 10 % to 90 % in {:.2f} texels of {:.1f} mm\n", softness, 1e3 * texelM);
    EXPECT_NEAR(softness, 1.3, 0.4);
}

// A lamp that shines all around, a ball across the seam of two faces of its cube.
TEST_F(ShadowGl, AWideLampsShadowsHaveNoSeams) {
    const glm::dvec3 lamp(0.0, 0.0, 2.5);
    for (const double halfAngleDeg : {75.0, 88.0}) {
        for (const glm::dvec3& centre : {glm::dvec3(1.2, 0.0, 1.3), glm::dvec3(0.9, 0.9, 1.4),
                                         glm::dvec3(0.0, -0.8, 1.2), glm::dvec3(0.0, 0.0, 1.0)}) {
            const Ball ball{centre, 0.4};
            Scene scene = floorUnder(lamp, {0, 0, 0}, halfAngleDeg, false);
            const Camera camera{{-1.0, -2.0, 5.0}, centre * 1.6, {0, 0, 1}, 60.0 * kRadPerDeg};
            const FloatImage without = draw(scene, camera, kSize, kSize);
            scene.instances.push_back(body(ball_, ball.centre, glm::dvec3(0.8)));
            const FloatImage with = draw(scene, camera, kSize, kSize);
            const Verdict verdict =
                judge(with, without, camera, lamp, ball, 2.5 * texelAt1M(scene, camera) * 2.0);
            EXPECT_GT(verdict.lit, 3000);
            EXPECT_GT(verdict.dark, 300);
            EXPECT_EQ(verdict.wrong, 0)
                << "half angle " << halfAngleDeg << ", ball at " << centre.x << ", " << centre.y;
        }
    }
}

/// Nothing stands before the lamp that its shadow could fall on: not a pixel may change.
TEST_F(ShadowGl, WhatIsBeforeTheFirstCasterIsLit) {
    const glm::dvec3 lamp(0.0, 0.0, 6.0);
    Scene scene = floorUnder(lamp, {0, 0, 0}, 20.0, false);
    scene.instances.push_back(body(ball_, {0.0, 0.0, 4.0}, glm::dvec3(0.5), false));
    const Camera camera{{0.0, -4.0, 6.0}, {0.0, 0.0, 3.5}, {0, 0, 1}, 50.0 * kRadPerDeg};
    const FloatImage without = draw(scene, camera, kSize, kSize);
    scene.instances.push_back(body(box_, {0.0, 0.0, -2.0}, glm::dvec3(3.0, 3.0, 1.0)));
    const FloatImage with = draw(scene, camera, kSize, kSize);
    for (std::size_t i = 0; i < with.rgb.size(); ++i) ASSERT_EQ(with.rgb[i], without.rgb[i]);
}

// ---- maps are drawn when they must be ----

class ShadowPassGl : public ShadowGl {
 protected:
    void SetUp() override {
        ShadowGl::SetUp();
        if (IsSkipped()) return;
        pass_ = std::make_unique<render::ShadowPass>(shaderFolder());
        meshes_.add(render::makeBox());
    }

    int redrawn(const Scene& scene) {
        const render::ScenePlan plan = render::planScene(scene, {}, {}, meshes_.bounds());
        pass_->draw(scene, plan, meshes_);
        return pass_->redrawn();
    }

    static Scene twoLamps() {
        Scene scene;
        for (const double x : {-3.0, 3.0}) {
            Beam beam;
            beam.lensPositionM = {x, 0.0, 6.0};
            beam.intensityCd = 1000.0;
            scene.beams.push_back(beam);
            scene.instances.push_back(body(0, {x, 0.0, 2.0}, glm::dvec3(0.5)));
        }
        return scene;
    }

    render::MeshStore meshes_;
    std::unique_ptr<render::ShadowPass> pass_;
};

TEST_F(ShadowPassGl, NoCasterNothingAllocated) {
    Scene scene = twoLamps();
    for (MeshInstance& instance : scene.instances) instance.castsShadow = false;
    EXPECT_EQ(redrawn(scene), 0);
    EXPECT_EQ(pass_->textures().atlas, 0u);
    EXPECT_EQ(pass_->textures().faces, 0u);
    EXPECT_EQ(pass_->atlasEdge(), 0);
    render::Resources resources;
    pass_->list(resources);
    EXPECT_TRUE(resources.textures.empty());
}

TEST_F(ShadowPassGl, WhatStandsStillKeepsItsMap) {
    Scene scene = twoLamps();
    EXPECT_EQ(redrawn(scene), 2);
    EXPECT_EQ(redrawn(scene), 0);
    // A lamp that turns, a caster that moves, one that goes: only the maps they are in are drawn again.
    scene.beams[0].worldFromBeam = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.02, glm::dvec3(1, 0, 0)));
    EXPECT_EQ(redrawn(scene), 1);
    scene.instances[1].worldFromMesh[3].x += 0.05;
    EXPECT_EQ(redrawn(scene), 1);
    EXPECT_EQ(redrawn(scene), 0);
    // Colour, brightness and what another lamp sees are no reason; nor that a lamp before it in the list goes
    // dark.
    scene.beams[1].color = glm::vec3(0.5f);
    EXPECT_EQ(redrawn(scene), 0);
    scene.beams.erase(scene.beams.begin());
    EXPECT_EQ(redrawn(scene), 0);
}

}  // namespace
}  // namespace hazer::test
