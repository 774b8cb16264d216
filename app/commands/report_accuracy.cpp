// hazer report accuracy: error against run time of every integrator and setting.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/assignment.h"
#include "app/commands/report.h"
#include "app/commands/size_option.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/report/accuracy_files.h"
#include "app/report/accuracy_run.h"
#include "app/report/accuracy_scenes.h"
#include "app/report/accuracy_tables.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct ReportOptions {
    std::string show;
    std::vector<std::string> scenes;
    std::vector<std::string> assignments;
    std::string camera;
    std::string out = "hazer-report";
    Size size{256, 256};
    bool isQuick = false;
    bool isJson = false;
};

/// What is to be measured: the user's own show, or scenes that come with hazer.
std::vector<NamedScene> scenesOf(const ReportOptions& options) {
    if (options.show.empty()) return accuracyScenes(options.scenes);
    return {{std::filesystem::path(options.show).stem().string(), options.show}};
}

AccuracyOptions accuracyOptions(const ReportOptions& options) {
    if (!options.isQuick) return {integratorSettings(false)};
    return {integratorSettings(true), 50, 0.2, 2.0};
}

AccuracyScene measure(const NamedScene& named, const ReportOptions& options, const AccuracyOptions& accuracy,
                      const std::function<void()>& step) {
    Session session(loadShow(named.show), {});
    session.settings().width = options.size.width;
    session.settings().height = options.size.height;
    if (!options.camera.empty()) session.camera() = session.show().camera(options.camera).camera;
    for (const std::string& assignment : options.assignments) assign(assignment, session.patch());
    session.settle();
    AccuracyScene scene = measureAccuracy(session, accuracy, step);
    scene.name = named.name;
    return scene;
}

int runAccuracy(const ReportOptions& options) {
    const std::vector<NamedScene> scenes = scenesOf(options);
    const AccuracyOptions accuracy = accuracyOptions(options);
    const render::gl::HeadlessContext context;
    AccuracyReport report{render::gl::describeContext(), options.size.width, options.size.height, {}};
    const Interrupt interrupt;
    {
        Progress progress("measuring setting", static_cast<int>(scenes.size() * accuracy.settings.size()));
        int done = 0;
        for (const NamedScene& scene : scenes) {
            report.scenes.push_back(measure(scene, options, accuracy, [&] {
                interrupt.throwIfAsked();
                progress.show(++done);
            }));
        }
    }
    writeAccuracyReport(report, options.out);
    if (options.isJson) {
        fmt::print("{}\n", accuracyJson(report).dump(2));
    } else {
        fmt::print("{}\n", (std::filesystem::path(options.out) / "accuracy.md").string());
    }
    return kExitOk;
}

}  // namespace

void addAccuracyReport(CLI::App& report, Command& chosen) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* command = report.add_subcommand(
        "accuracy", "Error against run time of the light in the air, for every integrator and setting.");
    beginHelpWith(*command,
                  "  hazer report accuracy                               all scenes, a few minutes\n"
                  "  hazer report accuracy --quick --scene gobo --scene shadow\n"
                  "  hazer report accuracy myshow.toml --set spot1.Dimmer=1 --size 1280x720\n");
    CLI::Option* show = command->add_option(
        "SHOW", options->show, "Your show file (.toml); the scenes that come with hazer unless given");
    command
        ->add_option("--scene", options->scenes,
                     "Only this scene of those that come with hazer; may be repeated")
        ->check(CLI::IsMember(accuracySceneNames()))
        ->excludes(show);
    command->add_option("--out", options->out, "Folder of the report; hazer-report unless given");
    addSizeOption(*command, options->size);
    command->add_option("--camera", options->camera, "Name of a camera of the show; its first unless given");
    command
        ->add_option("--set", options->assignments,
                     "Hold an attribute, FIXTURE.Attribute=VALUE, as hazer render does; may be repeated")
        ->check(checkAssignment);
    command->add_flag("--quick", options->isQuick, "Fewer settings and shorter measurements");
    command->add_flag("--json", options->isJson, "Print accuracy.json, too");
    command->callback([options, &chosen] { chosen = [options] { return runAccuracy(*options); }; });
}

}  // namespace hazer::app
