// The scenes and settings that hazer report accuracy compares.
#include <gtest/gtest.h>

#include <set>

#include "app/report/accuracy_scenes.h"
#include "app/report/integrator_settings.h"
#include "app/show.h"

namespace hazer::app {
namespace {

TEST(AccuracyScenes, allCanBeReadAndAreLit) {
    const std::vector<NamedScene> scenes = accuracyScenes({});
    EXPECT_EQ(scenes.size(), accuracySceneNames().size());
    for (const NamedScene& scene : scenes) {
        const Show show = loadShow(scene.show);
        EXPECT_FALSE(show.title.empty()) << scene.name;
        EXPECT_FALSE(show.lights.empty() && show.fixtures.empty()) << scene.name;
        EXPECT_NE(show.cameras.front().name, "default") << scene.name;
        // A ray that meets nothing has no end that the uniform integrator could march to.
        EXPECT_FALSE(show.objects.empty()) << scene.name;
        EXPECT_GT(show.haze.scatteringPerM, 0.0f) << scene.name;
        for (const ShowLight& light : show.lights) {
            EXPECT_TRUE(light.goboFile.empty() || std::filesystem::exists(light.goboFile)) << scene.name;
        }
    }
}

TEST(AccuracyScenes, areChosenByName) {
    const std::vector<NamedScene> scenes = accuracyScenes({"thesis", "gobo", "gobo"});
    ASSERT_EQ(scenes.size(), 2u);
    EXPECT_EQ(scenes[0].name, "gobo");
    EXPECT_EQ(scenes[1].name, "thesis");
}

TEST(IntegratorSettings, areNamedOnceAndGrowDearer) {
    for (const bool isQuick : {false, true}) {
        std::set<std::string> names;
        int samplesBefore = 0;
        for (const IntegratorSetting& setting : integratorSettings(isQuick)) {
            EXPECT_TRUE(names.insert(setting.integrator + setting.setting).second) << setting.setting;
            if (setting.integrator != kUniformName) continue;
            EXPECT_GT(setting.settings.samples, samplesBefore);
            EXPECT_EQ(setting.settings.integrator, render::Integrator::kUniform);
            samplesBefore = setting.settings.samples;
        }
        EXPECT_EQ(names.count(kAngleName + kOwnSetting), 1u);
        for (const int samples : thesisSamples())
            EXPECT_EQ(names.count(kUniformName + samplesSetting(samples)), 1u);
    }
}

}  // namespace
}  // namespace hazer::app
