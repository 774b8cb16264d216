#include "tests/golden/scene_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/demo_programme.h"
#include "app/paths.h"
#include "app/session.h"
#include "app/session_view.h"
#include "app/show.h"
#include "protocol/dmx.h"

namespace hazer::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path goldenFolder() {
    return fs::path(HAZER_GOLDEN_FOLDER);
}

Tolerance toleranceOf(const json& entry) {
    if (entry.at("why").get<std::string>().empty())
        throw std::runtime_error("a tolerance says why it is as it is");
    return {entry.at("absolute").get<double>(), entry.at("relative").get<double>(),
            entry.at("share").get<double>(), entry.at("ceiling").get<double>()};
}

glm::dvec3 vectorOf(const json& entry) {
    return {entry.at(0).get<double>(), entry.at(1).get<double>(), entry.at(2).get<double>()};
}

render::Camera cameraOf(const json& entry) {
    render::Camera camera;
    camera.positionM = vectorOf(entry.at("position"));
    camera.targetM = vectorOf(entry.at("target"));
    camera.verticalFovRad = glm::radians(entry.at("fov").get<double>());
    return camera;
}

GoldenScene sceneOf(const json& entry, const json& tolerances) {
    GoldenScene scene;
    scene.name = entry.at("name");
    scene.what = entry.at("what");
    scene.show = entry.contains("own_show") ? goldenFolder() / "shows" / entry.at("own_show")
                                            : app::showFolder() / entry.at("show");
    if (entry.at("camera").is_string()) {
        scene.cameraName = entry.at("camera");
    } else {
        scene.camera = cameraOf(entry.at("camera"));
    }
    scene.set = entry.value("set", scene.set);
    scene.demoProgramme = entry.value("demo_programme", scene.demoProgramme);
    scene.timeS = entry.value("time", scene.timeS);
    scene.view = entry.value("view", scene.view);
    scene.maxError = entry.value("max_error", scene.maxError);
    scene.radiance = toleranceOf(tolerances.at("radiance"));
    scene.display = toleranceOf(tolerances.at("display"));
    return scene;
}

void holdAll(const GoldenScene& scene, app::Patch& patch) {
    for (const auto& [fixture, attributes] : scene.set) {
        app::PatchedFixture* patched = patch.find(fixture);
        if (patched == nullptr)
            throw std::runtime_error(fmt::format("{}: no fixture '{}'", scene.name, fixture));
        for (const auto& [attribute, value] : attributes) {
            if (!patched->fixture.hold(attribute, value)) {
                throw std::runtime_error(fmt::format("{}: '{}' has no '{}'", scene.name, fixture, attribute));
            }
        }
    }
}

void playDemo(double timeS, app::Patch& patch) {
    for (app::PatchedFixture& patched : patch.fixtures()) {
        protocol::Slots slots{};
        app::writeDemoLook(patched.fixture, timeS, slots);
        patched.fixture.decode(slots);
    }
}

void cutLenses(render::FloatImage& image) {
    for (float& value : image.rgb) {
        // A comparison lets NaN through, so that it is found later.
        if (value > kBrightestCdPerM2) value = kBrightestCdPerM2;
    }
}

GoldenPictures picturesOf(const app::SessionView& view) {
    return {view.numbers, app::falseColor(view.numbers, view.from, view.to)};
}

}  // namespace

std::vector<GoldenScene> loadScenes() {
    std::ifstream stream(goldenFolder() / "scenes.json");
    const json list = json::parse(stream);
    std::vector<GoldenScene> scenes;
    for (const json& entry : list.at("scenes")) {
        scenes.push_back(sceneOf(entry, list.at("tolerances").at(entry.at("tolerances").get<std::string>())));
    }
    return scenes;
}

GoldenPictures drawScene(const GoldenScene& scene) {
    const app::Show show = app::loadShow(scene.show);
    app::Session session(show, {});
    if (scene.demoProgramme) playDemo(scene.timeS, session.patch());
    holdAll(scene, session.patch());
    session.settle();
    session.setTime(scene.timeS);
    session.camera() = scene.camera ? *scene.camera : show.camera(scene.cameraName).camera;
    session.settings().width = scene.width;
    session.settings().height = scene.height;
    session.settings().maxError = scene.maxError;
    session.draw();
    if (scene.view == "error") return picturesOf(app::drawErrorView(session));
    if (scene.view == "cost") return picturesOf(app::drawCostView(session));
    GoldenPictures pictures{session.renderer().readRadiance(), session.renderer().readDisplay()};
    cutLenses(pictures.radiance);
    return pictures;
}

fs::path referenceFolder() {
    return goldenFolder() / "reference";
}

fs::path radianceReference(const GoldenScene& scene) {
    return referenceFolder() / (scene.name + ".exr");
}

fs::path displayReference(const GoldenScene& scene) {
    return referenceFolder() / (scene.name + ".png");
}

}  // namespace hazer::test
