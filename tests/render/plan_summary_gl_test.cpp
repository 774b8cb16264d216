// What a scene does not need does not exist: a fresh renderer that has drawn it holds exactly the passes,
// textures and shaders that the plan's summary names.
#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "render/asset_list.h"
#include "tests/render/ies_text.h"
#include "tests/support/feature_scene.h"
#include "tests/support/gl_test.h"
#include "tests/support/resource_check.h"

namespace hazer::test {
namespace {

using render::FramePart;
using render::PlanSummary;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

using Change = std::function<void(FeatureScene&)>;

constexpr GLuint kHighestName = 4096;

template <typename IsName>
std::vector<GLuint> namesThatExist(IsName isName) {
    std::vector<GLuint> names;
    for (GLuint name = 1; name < kHighestName; ++name) {
        if (isName(name) == GL_TRUE) names.push_back(name);
    }
    return names;
}

struct Drawn {
    std::unique_ptr<render::Renderer> renderer;
    PlanSummary summary;
    std::size_t textures = 0;  ///< That OpenGL itself has more of than before.
    std::size_t programs = 0;
};

class PlanSummaryGlTest : public GlTest {
 protected:
    /// The full scene after a change, drawn by a renderer of its own, which has never drawn anything else.
    static Drawn drawFresh(const Change& change, const render::IesWeb* web = nullptr) {
        Drawn drawn;
        // A program that is in use stays until another one is.
        glUseProgram(0);
        const std::size_t texturesBefore = namesThatExist(glIsTexture).size();
        const std::size_t programsBefore = namesThatExist(glIsProgram).size();
        drawn.renderer = std::make_unique<render::Renderer>(shaderFolder());
        render::AssetList assets;
        FeatureScene made = makeFullScene(assets);
        makeFullScene(*drawn.renderer);
        if (web != nullptr) {
            assets.addWeb(*web);
            drawn.renderer->addWeb(*web);
        }
        made.settings.width = 96;
        made.settings.height = 54;
        change(made);
        drawn.renderer->render(made.scene, made.camera, made.settings);
        const render::ScenePlan plan =
            render::planScene(made.scene, made.camera, made.settings, assets.meshBounds(), assets.webs());
        drawn.summary =
            render::summarizePlan({made.scene, made.camera, made.settings, plan, assets.counts()});
        drawn.textures = namesThatExist(glIsTexture).size() - texturesBefore;
        drawn.programs = namesThatExist(glIsProgram).size() - programsBefore;
        return drawn;
    }
};

void expectNoneOf(const FramePart& absent, const render::Renderer& renderer) {
    const render::Resources real = renderer.resources();
    for (const std::string& pass : absent.passes) EXPECT_THAT(passNames(renderer), Not(Contains(pass)));
    for (const render::TextureUse& use : absent.resources.textures) {
        EXPECT_FALSE(std::ranges::any_of(real.textures, [&](const auto& t) { return t.name == use.name; }))
            << use.name;
    }
    for (const std::string& shader : real.shaders) {
        for (const std::string& feature : absent.features)
            EXPECT_THAT(" " + shader + " ", Not(HasSubstr(" " + feature + " ")));
        EXPECT_THAT(absent.resources.shaders, Not(Contains(shader)));
    }
}

TEST_F(PlanSummaryGlTest, TheFullFrameIsAsPlanned) {
    const Drawn drawn = drawFresh([](FeatureScene&) {});
    expectAsPlanned(drawn.summary, *drawn.renderer);
}

TEST_F(PlanSummaryGlTest, NothingEscapesTheList) {
    for (const int step : {1, 4}) {
        const Drawn drawn = drawFresh([step](FeatureScene& made) { made.settings.airStep = step; });
        EXPECT_EQ(drawn.textures, drawn.renderer->resources().textures.size());
        EXPECT_EQ(drawn.programs, drawn.renderer->resources().shaders.size());
    }
}

TEST_F(PlanSummaryGlTest, WhatIsTakenAwayLeavesNothingBehind) {
    for (const Removal& removal : removals()) {
        SCOPED_TRACE("without " + removal.name);
        const Drawn drawn = drawFresh(removal.apply);
        expectAsPlanned(drawn.summary, *drawn.renderer);
        for (const FramePart& part : drawn.summary.parts) {
            if (!part.needed) expectNoneOf(part, *drawn.renderer);
        }
    }
}

TEST_F(PlanSummaryGlTest, AnEmptySceneTakesTheLeast) {
    const Drawn drawn = drawFresh([](FeatureScene& made) {
        made.scene.beams.clear();
        made.scene.instances.clear();
        made.settings.bloom = false;
    });
    expectAsPlanned(drawn.summary, *drawn.renderer);
    for (const FramePart& part : drawn.summary.parts)
        EXPECT_EQ(part.needed,
                  part.name == "picture" || part.name == "bare background" || part.name == "meshes");
}

TEST_F(PlanSummaryGlTest, WhatCameAndWentLeavesNoTraceInThePicture) {
    render::Renderer renderer(shaderFolder());
    FeatureScene full = makeFullScene(renderer);
    full.settings.width = 96;
    full.settings.height = 54;
    // With the coarse grid, whose targets hang on those of the picture.
    full.settings.airStep = 4;
    renderer.render(full.scene, full.camera, full.settings);
    const std::vector<float> before = renderer.readRadiance().rgb;
    for (const Removal& removal : removals()) {
        SCOPED_TRACE("without " + removal.name);
        FeatureScene made = full;
        removal.apply(made);
        renderer.render(made.scene, made.camera, made.settings);
        const std::vector<float> after = renderer.readRadiance().rgb;
        const Drawn fresh = drawFresh([&](FeatureScene& other) {
            other.settings.airStep = 4;
            removal.apply(other);
        });
        EXPECT_TRUE(after == fresh.renderer->readRadiance().rgb);
        EXPECT_THAT(passNames(renderer), ::testing::ElementsAreArray(fresh.summary.passes));
        renderer.render(full.scene, full.camera, full.settings);
        EXPECT_TRUE(before == renderer.readRadiance().rgb);
    }
}

TEST_F(PlanSummaryGlTest, GridWebAndWideLampAreAsPlanned) {
    const Drawn grid = drawFresh([](FeatureScene& made) {
        made.settings.airStep = 4;
        made.scene.beams.back().fieldAngleRad = 0.002;
        made.scene.beams.back().beamAngleRad = 0.001;
    });
    expectAsPlanned(grid.summary, *grid.renderer);
    IesText file;
    const render::IesWeb web = render::parseIesWeb(file.text(), "test.ies");
    const Drawn withWeb = drawFresh([](FeatureScene& made) { made.scene.beams.back().web = 0; }, &web);
    expectAsPlanned(withWeb.summary, *withWeb.renderer);
    const Drawn wide = drawFresh([](FeatureScene& made) {
        made.scene.beams.back().fieldAngleRad = 2.8;
        made.scene.beams.back().beamAngleRad = 2.0;
    });
    expectAsPlanned(wide.summary, *wide.renderer);
}

TEST_F(PlanSummaryGlTest, ComposedAperturesAreAsPlanned) {
    for (const bool hasGobo : {true, false}) {
        const Drawn drawn = drawFresh([&](FeatureScene& made) {
            if (!hasGobo) made.scene.beams.front().gobo = -1;
            made.scene.beams.back().aperture.blades[0].distance = 0.2;
            made.scene.beams.front().aperture.blades[1].distance = 0.3;
        });
        expectAsPlanned(drawn.summary, *drawn.renderer);
        EXPECT_EQ(drawn.textures, drawn.renderer->resources().textures.size());
        EXPECT_EQ(drawn.programs, drawn.renderer->resources().shaders.size());
    }
}

TEST_F(PlanSummaryGlTest, BeamsAsLinesAreAsPlanned) {
    for (const bool isThin : {true, false}) {
        const Drawn drawn = drawFresh([&](FeatureScene& made) {
            if (!isThin) return;
            made.scene.beams.back().fieldAngleRad = 0.002;
            made.scene.beams.back().beamAngleRad = 0.001;
        });
        expectAsPlanned(drawn.summary, *drawn.renderer);
        const auto part = std::ranges::find(drawn.summary.parts, "beams as lines", &FramePart::name);
        ASSERT_NE(part, drawn.summary.parts.end());
        EXPECT_EQ(part->needed, isThin);
        if (!part->needed) expectNoneOf(*part, *drawn.renderer);
    }
}

TEST_F(PlanSummaryGlTest, LampsThatShineBackwardsAreAsPlanned) {
    for (const render::Integrator integrator : {render::Integrator::kAngle, render::Integrator::kUniform}) {
        const Drawn drawn = drawFresh([&](FeatureScene& made) {
            made.settings.integrator = integrator;
            made.scene.beams.back().fieldAngleRad = 4.2;
            made.scene.beams.back().beamAngleRad = 3.0;
        });
        expectAsPlanned(drawn.summary, *drawn.renderer);
        const auto part = std::ranges::find(drawn.summary.parts, "light backwards", &FramePart::name);
        ASSERT_NE(part, drawn.summary.parts.end());
        EXPECT_EQ(part->needed, integrator == render::Integrator::kAngle);
        if (!part->needed) expectNoneOf(*part, *drawn.renderer);
    }
}

}  // namespace
}  // namespace hazer::test
