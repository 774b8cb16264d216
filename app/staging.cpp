#include "app/staging.h"

#include "app/bare_light.h"

namespace hazer::app {

SceneControls controlsOf(const Show& show) {
    SceneControls controls;
    controls.haze = show.haze;
    controls.ambient = show.ambient;
    controls.backgroundCdPerM2 = show.backgroundCdPerM2;
    return controls;
}

Staging::Staging(const Show& show, render::AssetSink& assets)
    : rig_(assets), dressing_(dressSet(show, assets)), lights_(lightBeams(show, assets)) {}

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

}  // namespace hazer::app
