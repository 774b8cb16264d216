// What the light in the air costs, and how wrong it is, feature by feature: the angle integrator and the
// thesis' method against a converged picture, drawn in turn, so that a busy machine is equally unfair to
// both.
//     air_bench [--scene gobo ...] [--size 256x256] [--frames 15] [--best] [--nodes 4096] [--shaders FOLDER]
// Milliseconds are CPU time of all cores over that of the same picture without haze; errors are over pixels
// brighter than 1e-4 of the brightest, in shares of the root mean square of the picture.
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "render/gl/headless_context.h"
#include "tests/bench/air_scenes.h"

namespace {

using hazer::bench::AirScene;
using hazer::render::FloatImage;
using hazer::render::Integrator;
using hazer::render::Renderer;
using hazer::render::Settings;

struct Options {
    std::vector<std::string> scenes;
    std::string size = "256x256";
    std::string shaders = HAZER_SHADER_FOLDER;
    std::string picture;
    int width = 256;
    int height = 256;
    int frames = 15;
    int nodes = 4096;
    bool best = false;
    std::vector<int> samples;
};

struct Way {
    std::string name;
    Settings settings;
    std::vector<double> withHazeMs;
    std::vector<double> withoutMs;
};

double typical(std::vector<double> values, bool best) {
    std::sort(values.begin(), values.end());
    return best ? values.front() : values[values.size() / 2];
}

/// By the median frame, or by the fastest.
double airMs(const Way& way, bool best) {
    return typical(way.withHazeMs, best) - typical(way.withoutMs, best);
}

double cpuMs() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double drawMs(Renderer& renderer, const AirScene& scene, const Settings& settings) {
    const double before = cpuMs();
    renderer.render(scene.scene, scene.camera, settings);
    glFinish();
    return cpuMs() - before;
}

Settings base(const Options& options) {
    Settings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.bloom = false;
    return settings;
}

std::vector<Way> makeWays(const Options& options) {
    std::vector<Way> ways;
    Way uniform{"uniform 110", base(options), {}, {}};
    uniform.settings.integrator = Integrator::kUniform;
    ways.push_back(uniform);
    ways.push_back({"angle", base(options), {}, {}});
    for (const int samples : options.samples) {
        ways.push_back({fmt::format("angle {}", samples), base(options), {}, {}});
        ways.back().settings.samples = samples;
    }
    return ways;
}

/// Fills in the milliseconds of every way, drawn in turn.
void measure(Renderer& renderer, const AirScene& scene, std::vector<Way>& ways, int frames) {
    AirScene clear = scene;
    clear.scene.haze.scatteringPerM = 0.0f;
    for (int frame = 0; frame < frames + 2; ++frame) {
        for (Way& way : ways) {
            const double withoutMs = drawMs(renderer, clear, way.settings);
            const double withHazeMs = drawMs(renderer, scene, way.settings);
            if (frame < 2) continue;
            way.withoutMs.push_back(withoutMs);
            way.withHazeMs.push_back(withHazeMs);
        }
    }
}

struct Errors {
    double rms = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
};

Errors compare(const FloatImage& got, const FloatImage& reference) {
    float brightest = 0.0f;
    for (const float value : reference.rgb) brightest = std::max(brightest, value);
    std::vector<double> errors;
    double sum = 0.0;
    double total = 0.0;
    for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
        const double want = static_cast<double>(reference.rgb[i]);
        if (want < 1e-4 * static_cast<double>(brightest)) continue;
        errors.push_back(std::abs(static_cast<double>(got.rgb[i]) - want));
        sum += errors.back() * errors.back();
        total += want * want;
    }
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    const double scale = std::sqrt(static_cast<double>(errors.size()) / total);
    return {std::sqrt(sum / total), errors[errors.size() * 99 / 100] * scale, errors.back() * scale};
}

void run(Renderer& renderer, const AirScene& scene, const Options& options) {
    Settings converged = base(options);
    converged.samples = options.nodes;
    renderer.render(scene.scene, scene.camera, converged);
    const FloatImage reference = renderer.readRadiance();
    std::vector<Way> ways = makeWays(options);
    measure(renderer, scene, ways, options.frames);
    const double uniformMs = airMs(ways.front(), options.best);
    for (const Way& way : ways) {
        renderer.render(scene.scene, scene.camera, way.settings);
        const FloatImage image = renderer.readRadiance();
        if (!options.picture.empty()) {
            hazer::render::writeImage(image, options.picture + scene.name + " " + way.name + ".exr");
        }
        const Errors errors = compare(image, reference);
        const double ms = airMs(way, options.best);
        fmt::print("{:18} {:12} {:9.2f} ms  1/{:<6.1f} rms {:.1e}  99 % {:.1e}  max {:.1e}\n", scene.name,
                   way.name, ms, uniformMs / ms, errors.rms, errors.p99, errors.largest);
        std::fflush(stdout);
    }
}

Options parse(int argc, char** argv) {
    Options options;
    CLI::App app{"Times and errors of the light in the air, feature by feature"};
    app.add_option("--scene", options.scenes, "only these");
    app.add_option("--size", options.size);
    app.add_option("--frames", options.frames)->check(CLI::Range(1, 1000));
    app.add_flag("--best", options.best, "the fastest frame instead of the median: on a busy machine");
    app.add_option("--nodes", options.nodes, "of the converged picture")->check(CLI::Range(4, 16384));
    app.add_option("--samples", options.samples, "draw by this many nodes, too");
    app.add_option("--shaders", options.shaders);
    app.add_option("--pictures", options.picture, "write pictures: start of their file names");
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
    const hazer::render::gl::HeadlessContext context;
    Renderer renderer(options.shaders);
    for (const AirScene& scene : hazer::bench::makeAirScenes(renderer)) {
        const bool asked = options.scenes.empty() || std::find(options.scenes.begin(), options.scenes.end(),
                                                               scene.name) != options.scenes.end();
        if (asked) run(renderer, scene, options);
    }
    return 0;
}
