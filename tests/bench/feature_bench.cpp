// What each feature of a frame costs: one scene with every feature, and the same with each taken away.
//     feature_bench [--size 1280x720] [--frames 10] [--repeats 3] [--only bloom ...] [--json]
// Every case runs in processes of its own. Such a process draws the scene without the feature first, when
// nothing of it has ever existed there; then with everything; then without the feature again. The second
// time over the first says whether a feature that is not needed costs anything. The row "nothing", where
// nothing is taken away, says how far apart two times of the same frame are on this machine.
#include <epoxy/gl.h>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/report/statistics.h"
#include "render/gl/headless_context.h"
#include "render/renderer.h"
#include "tests/support/feature_scene.h"

namespace {

using hazer::app::median;
using hazer::render::Renderer;
using hazer::test::FeatureScene;
using hazer::test::Removal;
using nlohmann::ordered_json;

constexpr const char* kNothing = "nothing";

struct Options {
    std::string size = "1280x720";
    std::string shaders = HAZER_SHADER_FOLDER;
    std::vector<std::string> only;
    std::string child;  // the case that this process is for; empty: this is the parent
    int width = 1280;
    int height = 720;
    int frames = 10;
    int repeats = 3;
    bool isJson = false;
};

/// Medians over frames.
struct Times {
    double frameMs = 0.0;
    ordered_json passMs;  ///< By name, in the order of drawing.
};

Times drawFrames(Renderer& renderer, const FeatureScene& made, int frames) {
    constexpr int kWarmUpFrames = 2;
    std::vector<double> wholeMs;
    std::map<std::string, std::vector<double>> passMs;
    std::vector<hazer::render::PassTime> passes;
    for (int frame = 0; frame < frames + kWarmUpFrames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        renderer.render(made.scene, made.camera, made.settings);
        glFinish();
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        if (frame < kWarmUpFrames) continue;
        wholeMs.push_back(took.count());
        passes = renderer.lastPassTimes();
        for (const auto& [name, milliseconds] : passes) passMs[name].push_back(milliseconds);
    }
    Times times{median(wholeMs), ordered_json::object()};
    for (const auto& pass : passes) times.passMs[pass.name] = median(passMs[pass.name]);
    return times;
}

FeatureScene without(const FeatureScene& full, const std::string& feature) {
    FeatureScene made = full;
    for (const Removal& removal : hazer::test::removals()) {
        if (removal.name == feature) removal.apply(made);
    }
    return made;
}

/// Measures one case in this process, which must be a fresh one.
ordered_json measureCase(const Options& options) {
    const hazer::render::gl::HeadlessContext context;
    Renderer renderer(options.shaders);
    FeatureScene full = hazer::test::makeFullScene(renderer);
    full.settings.width = options.width;
    full.settings.height = options.height;
    const FeatureScene made = without(full, options.child);
    const Times never = drawFrames(renderer, made, options.frames);
    const hazer::render::Resources resources = renderer.resources();
    drawFrames(renderer, full, 2);
    const Times after = drawFrames(renderer, made, options.frames);
    return {{"device", hazer::render::gl::describeContext()},
            {"never_ms", never.frameMs},
            {"after_ms", after.frameMs},
            {"passes", never.passMs},
            {"shaders", resources.shaders.size()},
            {"bytes", textureBytes(resources) + bufferBytes(resources)}};
}

ordered_json runChild(const Options& options, const std::string& name) {
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = fmt::format("'{}' --child '{}' --size {} --frames {} --shaders '{}'", self,
                                            name, options.size, options.frames, options.shaders);
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no process could be started");
    std::string output;
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
        output.push_back(static_cast<char>(letter));
    if (pclose(pipe) != 0) throw std::runtime_error("a case failed: " + name);
    return ordered_json::parse(output);
}

/// Runs of one case, each in a process of its own.
struct Case {
    std::string name;
    std::vector<ordered_json> runs;

    double medianOf(const std::function<double(const ordered_json&)>& value) const {
        std::vector<double> values;
        for (const ordered_json& run : runs) values.push_back(value(run));
        return median(values);
    }
    double neverMs() const {
        return medianOf([](const ordered_json& run) { return run["never_ms"].get<double>(); });
    }
    double passMs(const std::string& pass) const {
        return medianOf([&](const ordered_json& run) { return run["passes"].value(pass, 0.0); });
    }
    std::vector<double> ratios() const {
        std::vector<double> values;
        for (const ordered_json& run : runs)
            values.push_back(run["after_ms"].get<double>() / run["never_ms"].get<double>());
        return values;
    }
};

std::vector<Case> measureAll(const Options& options) {
    std::vector<Case> cases{{kNothing, {}}};
    for (const Removal& removal : hazer::test::removals()) {
        const bool asked =
            options.only.empty() || std::ranges::find(options.only, removal.name) != options.only.end();
        if (asked) cases.push_back({removal.name, {}});
    }
    // All cases in turn, again and again: a machine that slows down is equally unfair to all.
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        for (Case& one : cases) one.runs.push_back(runChild(options, one.name));
    }
    return cases;
}

ordered_json toJson(const Options& options, const std::vector<Case>& cases) {
    ordered_json json{{"device", cases.front().runs.front()["device"]},
                      {"size", {options.width, options.height}},
                      {"frames", options.frames},
                      {"rows", ordered_json::array()}};
    for (const Case& one : cases) {
        json["rows"].push_back({{"without", one.name},
                                {"frame_ms", one.neverMs()},
                                {"after_over_never", one.ratios()},
                                {"shaders", one.runs.front()["shaders"]},
                                {"bytes", one.runs.front()["bytes"]},
                                {"passes", ordered_json::object()}});
        for (const auto& [pass, milliseconds] : one.runs.front()["passes"].items())
            json["rows"].back()["passes"][pass] = one.passMs(pass);
    }
    return json;
}

std::string costRow(const Case& one, const Case& full) {
    const double saved = full.neverMs() - one.neverMs();
    const double bytes = one.runs.front()["bytes"].get<double>();
    const double savedBytes = full.runs.front()["bytes"].get<double>() - bytes;
    const std::vector<double> ratios = one.ratios();
    const auto [least, most] = std::ranges::minmax(ratios);
    return fmt::format("| {} | {:.1f} | {:.1f} | {} | {} | {:.1f} | {:.1f} | {:.2f} ({:.2f}..{:.2f}) |\n",
                       one.name, one.neverMs(), saved, one.runs.front()["passes"].size(),
                       one.runs.front()["shaders"].get<int>(), bytes * 1e-6, savedBytes * 1e-6,
                       median(ratios), least, most);
}

/// Of all cases: those of the full frame in the order of drawing, then those that only stand in for others.
std::vector<std::string> passNames(const std::vector<Case>& cases) {
    std::vector<std::string> names;
    for (const Case& one : cases) {
        for (const auto& item : one.runs.front()["passes"].items()) {
            if (std::ranges::find(names, item.key()) == names.end()) names.push_back(item.key());
        }
    }
    return names;
}

std::string passTable(const std::vector<Case>& cases) {
    const std::vector<std::string> passes = passNames(cases);
    std::string text = fmt::format("| ms of a pass, without | {} |\n|---|", fmt::join(passes, " | "));
    for (std::size_t i = 0; i < passes.size(); ++i) text += "---|";
    text += "\n";
    for (const Case& one : cases) {
        text += fmt::format("| {} |", one.name);
        for (const std::string& pass : passes) {
            const bool has = one.runs.front()["passes"].contains(pass);
            text += has ? fmt::format(" {:.1f} |", one.passMs(pass)) : std::string(" – |");
        }
        text += "\n";
    }
    return text;
}

/// The tables of docs/rendering.md.
std::string toMarkdown(const Options& options, const std::vector<Case>& cases) {
    std::string text = fmt::format(
        "{}, {} x {} pixels, medians of {} frames in each of {} processes.\n\n"
        "| without | frame, ms | saved, ms | passes | shaders | MB | saved, MB | after it was there |\n"
        "|---|---|---|---|---|---|---|---|\n",
        cases.front().runs.front()["device"].get<std::string>(), options.width, options.height,
        options.frames, options.repeats);
    for (const Case& one : cases) text += costRow(one, cases.front());
    return text + "\n" + passTable(cases);
}

Options parse(int argc, char** argv) {
    Options options;
    CLI::App app{"What each feature of a frame costs"};
    app.add_option("--size", options.size);
    app.add_option("--frames", options.frames)->check(CLI::Range(1, 1000));
    app.add_option("--repeats", options.repeats, "processes of each case")->check(CLI::Range(1, 100));
    app.add_option("--only", options.only, "features; all unless given");
    app.add_option("--shaders", options.shaders);
    app.add_option("--child", options.child)->group("");
    app.add_flag("--json", options.isJson);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    }
    if (std::sscanf(options.size.c_str(), "%dx%d", &options.width, &options.height) != 2) std::exit(1);
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    if (!options.child.empty()) {
        fmt::print("{}\n", measureCase(options).dump());
        return 0;
    }
    const std::vector<Case> cases = measureAll(options);
    fmt::print("{}", options.isJson ? toJson(options, cases).dump(2) + "\n" : toMarkdown(options, cases));
    return 0;
}
