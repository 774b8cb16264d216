// What is said of a plan: for each feature, with it and without it; and every reason.
#include "render/plan_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/feature_scene.h"

namespace hazer::test {
namespace {

using render::FramePart;
using render::PlanSummary;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class PlanSummaryTest : public ::testing::Test {
 protected:
    PlanSummary summarize(int darkLampsBesides = 0) const {
        const render::ScenePlan plan = render::planScene(full_.scene, full_.camera, full_.settings,
                                                         assets_.meshBounds(), assets_.webs());
        return render::summarizePlan(
            {full_.scene, full_.camera, full_.settings, plan, assets_.counts(), darkLampsBesides});
    }

    FramePart part(const std::string& name) const {
        const PlanSummary summary = summarize();
        const auto found = std::ranges::find(summary.parts, name, &FramePart::name);
        EXPECT_NE(found, summary.parts.end()) << name;
        return found == summary.parts.end() ? FramePart{} : *found;
    }

    void expectLeftOut(const std::string& name, const std::string& reason) const {
        const FramePart found = part(name);
        EXPECT_FALSE(found.needed) << name;
        EXPECT_EQ(found.reason, reason) << name;
    }

    render::AssetList assets_;
    FeatureScene full_ = makeFullScene(assets_);
};

/// No pass, no shader and no texture of a part that is left out is planned for any other part.
void expectNothingOf(const FramePart& absent, const PlanSummary& summary) {
    const render::Resources needed = render::neededResources(summary);
    for (const std::string& pass : absent.passes) EXPECT_THAT(summary.passes, Not(Contains(pass)));
    for (const render::TextureUse& use : absent.resources.textures) {
        EXPECT_FALSE(std::ranges::any_of(needed.textures, [&](const auto& t) { return t.name == use.name; }))
            << use.name;
    }
    for (const std::string& shader : absent.resources.shaders)
        EXPECT_THAT(needed.shaders, Not(Contains(shader)));
    for (const std::string& feature : absent.features) {
        for (const render::VariantUse& variant : summary.variants)
            EXPECT_THAT(" " + variant.shader + " ", Not(HasSubstr(" " + feature + " ")));
    }
}

TEST_F(PlanSummaryTest, EachFeatureIsNeededUntilItIsTakenAway) {
    const FeatureScene before = full_;
    for (const Removal& removal : removals()) {
        if (removal.part.empty()) continue;
        full_ = before;
        EXPECT_TRUE(part(removal.part).needed) << removal.part;
        removal.apply(full_);
        const FramePart absent = part(removal.part);
        EXPECT_FALSE(absent.needed) << removal.part;
        EXPECT_FALSE(absent.reason.empty());
        expectNothingOf(absent, summarize());
    }
}

TEST_F(PlanSummaryTest, EveryPartHasAReason) {
    const FeatureScene before = full_;
    for (const Removal& removal : removals()) {
        full_ = before;
        removal.apply(full_);
        for (const FramePart& found : summarize().parts) EXPECT_FALSE(found.reason.empty()) << found.name;
    }
}

TEST_F(PlanSummaryTest, PassesAreInTheOrderOfTheFrame) {
    EXPECT_THAT(summarize().passes,
                ::testing::ElementsAre("shadow maps", "surfaces", "lit surfaces", "beams", "lenses",
                                       "block means", "bloom", "display grid", "tone map", "antialias"));
}

TEST_F(PlanSummaryTest, WithoutABodyThereIsOnlyTheBackground) {
    full_.scene.instances.clear();
    EXPECT_THAT(summarize().passes, ::testing::ElementsAre("background", "beams", "lenses", "block means",
                                                           "bloom", "display grid", "tone map", "antialias"));
    expectLeftOut("bodies", "the scene has no body");
}

TEST_F(PlanSummaryTest, BeamsAreCountedByTheirShaders) {
    const PlanSummary summary = summarize();
    std::size_t inTheAir = 0;
    for (const render::VariantUse& variant : summary.variants) {
        if (variant.pass == "beams") inTheAir += variant.beams;
    }
    EXPECT_EQ(inTheAir, 2u);
    const auto withGobo = std::ranges::find_if(summary.variants, [](const auto& variant) {
        return variant.pass == "beams" && variant.shader.find("GOBO") != std::string::npos;
    });
    ASSERT_NE(withGobo, summary.variants.end());
    EXPECT_EQ(withGobo->shader, "air.frag GOBO SHADOW NOISE");
    EXPECT_EQ(withGobo->beams, 1u);
}

TEST_F(PlanSummaryTest, NoLampIsLit) {
    for (render::Beam& beam : full_.scene.beams) beam.fluxLm = 0.0;
    for (const char* name : {"light in the air", "light on surfaces", "soft profile", "gobos",
                             "photometric webs", "shadow maps", "lenses"})
        expectLeftOut(name, "no lamp is lit");
    for (const char* name : {"noise in the haze", "uniform samples", "coarse grid of the air"})
        expectLeftOut(name, "there is no light in the air");
    expectLeftOut("dark lamps", "2 of 2 lamps are dark");
}

TEST_F(PlanSummaryTest, DarkLampsAreCounted) {
    expectLeftOut("dark lamps", "no lamp is dark");
    full_.scene.beams.front().fluxLm = 0.0;
    expectLeftOut("dark lamps", "1 of 2 lamps is dark");
    const PlanSummary summary = summarize(3);
    EXPECT_EQ(summary.litLamps, 1);
    EXPECT_EQ(summary.darkLamps, 4);
    EXPECT_EQ(summary.parts.back().reason, "4 of 5 lamps are dark");
}

TEST_F(PlanSummaryTest, WhyThereIsNoAir) {
    full_.scene.haze.scatteringPerM = 0.0f;
    expectLeftOut("light in the air", "the haze scatters nothing");
    full_.scene.instances.clear();
    EXPECT_EQ(part("gobos").reason, "1 of 2 lit lamps has a gobo");  // seen in the lens
    for (render::Beam& beam : full_.scene.beams) beam.showsLens = false;
    expectLeftOut("gobos", "there is neither light in the air nor a body or lens to see a gobo on");
    expectLeftOut("shadow maps", "there is neither light in the air nor a body to see a shadow on");
    expectLeftOut("light on surfaces", "the scene has no body");
}

TEST_F(PlanSummaryTest, WhyThereIsNoLightOnSurfaces) {
    full_.scene.instances.erase(full_.scene.instances.begin());
    full_.scene.instances.front().worldFromMesh[3] = {0.0, 0.0, 9.0, 1.0};
    expectLeftOut("light on surfaces", "no lit lamp reaches a body");
    EXPECT_THAT(summarize().passes, Not(Contains("lit surfaces")));
}

TEST_F(PlanSummaryTest, WhyThereIsNoNoise) {
    full_.scene.haze.noise.amount = 0.0f;
    expectLeftOut("noise in the haze", "noise is 0");
}

TEST_F(PlanSummaryTest, WhyThereAreTablesOfGobos) {
    EXPECT_EQ(part("tables of gobos").reason, "1 of 2 lit lamps sends a gobo through the haze");
    EXPECT_EQ(part("tables of gobos").resources.textures.front().layers, 1);
    // The same gobo in another profile is a table of its own.
    full_.scene.beams[1].gobo = full_.scene.beams[0].gobo;
    EXPECT_EQ(part("tables of gobos").resources.textures.front().layers, 1);
    full_.scene.beams[1].beamAngleRad *= 0.8;
    EXPECT_EQ(part("tables of gobos").resources.textures.front().layers, 2);
    full_.settings.samples = 64;
    EXPECT_FALSE(part("tables of gobos").needed);
    EXPECT_TRUE(part("gobos").needed);
}

TEST_F(PlanSummaryTest, WhyThereAreComposedApertures) {
    expectLeftOut("composed apertures",
                  "no lit lamp that is seen has more in its way than a gobo or an iris alone");
    const int gobos = part("gobos").resources.textures.front().layers;
    full_.scene.beams.back().aperture.blades[0].distance = 0.2;
    EXPECT_EQ(part("composed apertures").reason, "1 of 2 lit lamps has more than a gobo in the way");
    EXPECT_EQ(summarize().passes.front(), "apertures");
    EXPECT_EQ(part("gobos").resources.textures.front().layers, gobos + 1);
    full_.scene.beams.front().gobo = -1;
    EXPECT_EQ(part("gobos").reason, "composed apertures are looked at like gobos");
    full_.settings.gobos = false;
    expectLeftOut("composed apertures", "gobos are switched off");
}

TEST_F(PlanSummaryTest, LampsBeyondTheMostAperturesAreTold) {
    for (int i = 0; i <= render::kMostComposedApertures; ++i) {
        full_.scene.beams.push_back(full_.scene.beams.back());
        full_.scene.beams.back().aperture.blades[0].distance = 0.01 * i;
    }
    EXPECT_EQ(part("composed apertures").reason,
              "64 of 67 lit lamps have more than a gobo in the way; 1 further one shines without, for want "
              "of memory");
}

TEST_F(PlanSummaryTest, WhyThereIsNoGobo) {
    full_.settings.gobos = false;
    expectLeftOut("gobos", "gobos are switched off");
    full_.scene.beams.front().gobo = -1;
    expectLeftOut("gobos", "no lit lamp has a gobo");
    expectLeftOut("tables of gobos", "no lit lamp sends a gobo through the haze");
}

TEST_F(PlanSummaryTest, WhyThereIsNoShadow) {
    const FeatureScene before = full_;
    full_.settings.shadows = false;
    expectLeftOut("shadow maps", "shadows are switched off");
    full_ = before;
    full_.scene.instances.back().castsShadow = false;
    expectLeftOut("shadow maps", "no body casts a shadow");
    full_ = before;
    for (render::Beam& beam : full_.scene.beams) beam.castsShadow = false;
    expectLeftOut("shadow maps", "no lit lamp casts shadows");
    full_ = before;
    full_.scene.instances.back().worldFromMesh[3] = {0.0, 0.0, 9.0, 1.0};
    expectLeftOut("shadow maps", "no caster stands in any lit cone");
}

TEST_F(PlanSummaryTest, ShadowTilesNameTheirLampAndCasters) {
    full_.scene.beams.back().castsShadow = false;
    const PlanSummary summary = summarize();
    ASSERT_EQ(summary.shadowTiles.size(), 1u);
    EXPECT_EQ(summary.shadowTiles.front().beam, 0);
    EXPECT_EQ(summary.shadowTiles.front().casters, 1u);
    EXPECT_EQ(part("shadow maps").reason, "1 of 2 lit lamps has a caster in the cone");
}

TEST_F(PlanSummaryTest, WhyThereIsNoLens) {
    for (render::Beam& beam : full_.scene.beams) beam.lensRadiusM = 0.0;
    expectLeftOut("lenses", "no lit lamp shows a lens that has a size");
}

TEST_F(PlanSummaryTest, WhyThereIsNoGrid) {
    full_.settings.airStep = 1;
    expectLeftOut("coarse grid of the air", "the settings ask for every pixel to be integrated");
    full_.settings.airStep = 4;
    EXPECT_TRUE(part("coarse grid of the air").needed);
    EXPECT_EQ(part("coarse grid of the air").reason, "every 4th pixel of the air is integrated first");
    full_.settings.samples = 40;
    expectLeftOut("coarse grid of the air", "a given number of samples is drawn as it is, for comparison");
    full_.settings.samples = 0;
    full_.settings.integrator = render::Integrator::kUniform;
    expectLeftOut("coarse grid of the air", "the thesis' integrator is drawn as it is, for comparison");
    EXPECT_TRUE(part("uniform samples").needed);
}

TEST_F(PlanSummaryTest, ThinBeamsAreThoseThatTheGridWouldMiss) {
    full_.settings.airStep = 4;
    expectLeftOut("thin beams", "no lit lamp's beam is so thin on the screen that the grid could miss it");
    full_.scene.beams.back().fieldAngleRad = 0.002;
    full_.scene.beams.back().beamAngleRad = 0.001;
    EXPECT_TRUE(part("thin beams").needed);
    EXPECT_THAT(part("thin beams").reason, HasSubstr("1 of 2 lit lamps is"));
    full_.settings.airStep = 1;
    expectLeftOut("thin beams", "without a coarse grid no beam can slip through it");
}

// Other constants, and nothing else.
TEST_F(PlanSummaryTest, DeltaEddingtonTakesNoShaderOfItsOwn) {
    full_.scene.haze.scatteringPerM = full_.scene.haze.extinctionPerM = 0.5f;
    full_.scene.haze.phase = {0.5f, 0.0f, 1.0f};
    const render::Resources before = render::neededResources(summarize());
    EXPECT_THAT(part("light in the air").reason, EndsWith("into haze that scatters 0.5 /m"));
    full_.scene.haze.deltaEddington = true;
    EXPECT_EQ(render::neededResources(summarize()).shaders, before.shaders);
    EXPECT_THAT(part("light in the air").reason,
                EndsWith("into haze that scatters 0.375 /m beside its forward peak"));
}

TEST_F(PlanSummaryTest, WhatIsLeftOutSaysWhatItSaves) {
    removals().front().apply(full_);
    const FramePart air = part("light in the air");
    EXPECT_THAT(air.passes, Contains("beams"));
    EXPECT_THAT(air.resources.shaders, Contains("air.frag"));
    const FramePart noise = part("noise in the haze");
    ASSERT_EQ(noise.resources.textures.size(), 1u);
    EXPECT_GE(noise.resources.textures.front().bytes, std::size_t{64} * 64 * 64);
    EXPECT_THAT(noise.features, Contains("NOISE"));
}

}  // namespace
}  // namespace hazer::test
