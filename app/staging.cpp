#include "app/staging.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "app/bare_light.h"
#include "app/scenery.h"

namespace hazer::app {

SceneControls controlsOf(const Show& show) {
    SceneControls controls;
    controls.haze = show.haze;
    controls.ambient = show.ambient;
    controls.backgroundCdPerM2 = show.backgroundCdPerM2;
    return controls;
}

Staging::Staging(const Show& show, render::AssetSink& assets)
    : rig_(assets), dressing_(dressSet(show, assets)), lights_(lightBeams(show, assets)) {
    warnings_ = appendScenery(show.scenery, assets, dressing_);
}

render::Scene Staging::scene(const Patch& patch, const SceneControls& controls, double timeS) {
    render::Scene scene;
    scene.beams = lights_;
    scene.haze = controls.haze;
    scene.ambient = controls.ambient;
    scene.backgroundCdPerM2 = controls.backgroundCdPerM2;
    scene.timeS = timeS;
    for (const DressedObject& object : dressing_) {
        if (object.isFurther && !controls.furtherObjects) continue;
        render::MeshInstance& instance = scene.instances.emplace_back(object.instance);
        instance.material.specular = controls.specular.value_or(instance.material.specular);
        instance.material.shininess = controls.shininess.value_or(instance.material.shininess);
    }
    for (const PatchedFixture& patched : patch.fixtures()) {
        patched.fixture.state(state_);
        rig_.append(state_, scene);
    }
    return scene;
}

void warnAboutRig(const Show& show, const Staging& staging) {
    constexpr std::size_t kMostSaid = 10;
    std::vector<std::string> warnings = show.warnings;
    warnings.insert(warnings.end(), staging.warnings().begin(), staging.warnings().end());
    for (std::size_t i = 0; i < std::min(kMostSaid, warnings.size()); ++i)
        spdlog::warn("{}: {}", show.rig.file.string(), warnings[i]);
    if (warnings.size() > kMostSaid) {
        spdlog::warn("{}: {} more; 'hazer inspect' of it lists them", show.rig.file.string(),
                     warnings.size() - kMostSaid);
    }
}

}  // namespace hazer::app
