// hazer report stability: stiff and extreme cases of light and of motion.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/report.h"
#include "app/interrupt.h"
#include "app/paths.h"
#include "app/picture_file.h"
#include "app/progress.h"
#include "app/report/stability_tables.h"
#include "app/report/text_file.h"
#include "render/gl/headless_context.h"

namespace hazer::app {
namespace {

struct StabilityOptions {
    std::string out = "hazer-report";
    std::size_t rays = 1'000'000;
    bool isJson = false;
};

constexpr int kCaseSize = 32;
constexpr int kComparedEach = 12;
constexpr std::size_t kRaysEach = 64 * 64;

StabilityReport measure(const StabilityOptions& options) {
    const render::gl::HeadlessContext context;
    render::Renderer renderer(shaderFolder());
    for (const render::Mesh& mesh : stabilityMeshes()) renderer.addMesh(mesh);
    StabilityReport report;
    report.device = render::gl::describeContext();
    const std::vector<StabilityCase> cases = stabilityCases();
    const std::size_t scenes = (options.rays + kRaysEach - 1) / kRaysEach;
    Progress progress("drawing case", static_cast<int>(cases.size() + scenes));
    const Interrupt interrupt;
    int done = 0;
    const auto step = [&] {
        interrupt.throwIfAsked();
        progress.show(++done);
    };
    for (const StabilityCase& one : cases) {
        step();
        report.light.push_back(runCase(one, renderer, kCaseSize));
    }
    report.random = runRandomRays(renderer, options.rays, kComparedEach, report.worstRay, step);
    report.refusals = runRefusals();
    report.motion = motionStability();
    return report;
}

int runStability(const StabilityOptions& options) {
    const StabilityReport report = measure(options);
    const std::filesystem::path folder = options.out;
    makeFolder(folder);
    writeText(folder / "stability.json", stabilityJson(report).dump(2) + "\n");
    writeText(folder / "stability.md", stabilityMarkdown(report));
    if (options.isJson) {
        fmt::print("{}\n", stabilityJson(report).dump(2));
    } else {
        fmt::print("{}\n", (folder / "stability.md").string());
    }
    if (!report.passed())
        fmt::print(stderr, "hazer: not every case passed; see the verdicts in the report\n");
    return kExitOk;
}

}  // namespace

void addStabilityReport(CLI::App& report, Command& chosen) {
    auto options = std::make_shared<StabilityOptions>();
    CLI::App* command = report.add_subcommand(
        "stability", "Stiff and extreme cases: every number looked at, light held against the oracle.");
    beginHelpWith(*command,
                  "  hazer report stability                 a minute or two\n"
                  "  hazer report stability --rays 20000    a few seconds\n");
    command->add_option("--out", options->out, "Folder of the report; hazer-report unless given");
    command->add_option("--rays", options->rays, "Random rays, 1000..100000000; a million unless given")
        ->check(CLI::Range(1000, 100'000'000));
    command->add_flag("--json", options->isJson, "Print stability.json, too");
    command->callback([options, &chosen] { chosen = [options] { return runStability(*options); }; });
}

}  // namespace hazer::app
