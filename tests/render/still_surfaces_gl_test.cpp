// Bodies that stand still are not drawn anew, and nobody sees the difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/feature_scene.h"
#include "tests/support/gl_test.h"

namespace hazer::test {
namespace {

class StillSurfacesGl : public GlTest {
 protected:
    StillSurfacesGl() : own_(shaderFolder()), other_(shaderFolder()), full_(makeFullScene(own_)) {
        makeFullScene(other_);
        full_.settings.width = 96;
        full_.settings.height = 54;
    }

    static std::vector<float> picture(render::Renderer& renderer, const FeatureScene& made) {
        renderer.render(made.scene, made.camera, made.settings);
        return renderer.readRadiance().rgb;
    }

    /// By a renderer that has just drawn something else.
    std::vector<float> pictureAnew(const FeatureScene& made) {
        FeatureScene elsewhere = made;
        elsewhere.camera.verticalFovRad *= 0.9;
        picture(other_, elsewhere);
        return picture(other_, made);
    }

    bool keepsPicture() const {
        const auto textures = own_.resources().textures;
        return std::ranges::any_of(textures, [](const auto& t) { return t.name == "still surfaces"; });
    }

    render::Renderer own_;
    render::Renderer other_;
    FeatureScene full_;
};

// The haze goes on moving.
TEST_F(StillSurfacesGl, EveryFrameIsAsIfDrawnAnew) {
    for (const double timeS : {0.0, 0.5, 1.0, 1.5}) {
        full_.scene.timeS = timeS;
        EXPECT_TRUE(picture(own_, full_) == pictureAnew(full_)) << timeS << " s";
    }
    EXPECT_TRUE(keepsPicture());
}

TEST_F(StillSurfacesGl, WhatMovesIsNotKept) {
    for (int frame = 0; frame < 4; ++frame) {
        full_.camera.positionM.x += 0.01;
        picture(own_, full_);
    }
    EXPECT_FALSE(keepsPicture());
}

TEST_F(StillSurfacesGl, EveryChangeIsSeenAtOnce) {
    struct Change {
        std::string name;
        std::function<void(FeatureScene&)> apply;
    };
    const std::vector<Change> changes{
        {"camera", [](FeatureScene& s) { s.camera.verticalFovRad *= 1.01; }},
        {"body", [](FeatureScene& s) { s.scene.instances.back().worldFromMesh[3].x += 0.02; }},
        {"albedo", [](FeatureScene& s) { s.scene.instances.front().material.albedo.g *= 0.9f; }},
        {"lamp's dimmer", [](FeatureScene& s) { s.scene.beams.front().fluxLm *= 0.99; }},
        {"lamp's gobo", [](FeatureScene& s) { s.scene.beams.front().goboRotationRad += 0.05; }},
        {"ambient light", [](FeatureScene& s) { s.scene.ambient.illuminanceLx += 1.0f; }},
        {"background", [](FeatureScene& s) { s.scene.backgroundCdPerM2 += 0.5f; }},
        {"haze", [](FeatureScene& s) { s.scene.haze.extinctionPerM *= 1.1f; }},
        {"shadows", [](FeatureScene& s) { s.settings.shadows = false; }},
        {"gobos", [](FeatureScene& s) { s.settings.gobos = false; }},
        {"size", [](FeatureScene& s) { s.settings.width += 8; }},
        {"bodies", [](FeatureScene& s) { s.scene.instances.clear(); }},
    };
    for (const Change& change : changes) {
        SCOPED_TRACE(change.name);
        std::vector<float> before;
        for (int frame = 0; frame < 3; ++frame) before = picture(own_, full_);
        FeatureScene changed = full_;
        change.apply(changed);
        const std::vector<float> after = picture(own_, changed);
        EXPECT_FALSE(after == before);
        EXPECT_TRUE(after == pictureAnew(changed));
        EXPECT_TRUE(before == picture(own_, full_));
    }
}

}  // namespace
}  // namespace hazer::test
