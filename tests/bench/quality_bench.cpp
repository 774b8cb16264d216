// How the error of the light in the air depends on each number of render/air_quality.h, one at a time, over
// random scenes: what the laws behind --max-error are fitted to. With --kept, how well those keep their word,
// and where they do not, how large the error is with one number after the other as fine as it goes.
//     quality_bench [--kept] [--scenes 24] [--seed 1000] [--size 128x96] [--nodes 4096] [--references FOLDER]
// Errors are rms_rel of hazer report accuracy, against the converged picture.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "app/report/statistics.h"
#include "render/air_quality.h"
#include "render/gl/headless_context.h"
#include "render/renderer.h"
#include "tests/support/random_air.h"

namespace {

using hazer::app::pictureError;
using hazer::render::AirQuality;
using hazer::render::BeamEdge;
using hazer::render::FloatImage;
using hazer::render::Renderer;
using hazer::render::Settings;
using hazer::test::RandomAir;

struct Options {
    bool kept = false;
    int scenes = 24;
    int seed = 1000;
    std::string size = "128x96";
    std::string only;
    std::string references;
    int width = 128;
    int height = 96;
    int nodes = 4096;
};

/// A number of AirQuality, and the values that are tried.
struct Law {
    std::string name;
    std::vector<double> values;
    std::function<void(AirQuality&, double)> set;
    std::function<void(RandomAir&)> prepare;  ///< Leaves in the scene what the number is about.
};

void takeGobos(RandomAir& air) {
    for (auto& beam : air.scene.beams) beam.gobo = -1;
}

void takeNoise(RandomAir& air) {
    air.scene.haze.noise.amount = 0.0f;
}

void takeShadows(RandomAir& air) {
    for (auto& body : air.scene.instances) body.castsShadow = false;
}

void setEdges(RandomAir& air, BeamEdge edge) {
    for (auto& beam : air.scene.beams) beam.edge = edge;
}

bool has(const RandomAir& air, const char* word) {
    return air.what.find(word) != std::string::npos;
}

/// As fine as can be, so that one number's error stands alone.
AirQuality finest() {
    AirQuality quality;
    quality.gridStep = 1;
    quality.shadowIntervals = 232;
    quality.profilePairs = 4;
    quality.goboTaps = 256;
    quality.noiseNodes = 128;
    quality.goboTolerance = 0.005;
    quality.goboLevelsApart = 0.0;
    return quality;
}

class Bench {
 public:
    explicit Bench(const Options& options)
        : options_(options),
          renderer_(HAZER_SHADER_FOLDER),
          assets_(hazer::test::addRandomAirAssets(renderer_)) {}

    RandomAir scene(int index) const {
        return hazer::test::makeRandomAir(static_cast<std::uint32_t>(options_.seed + index), assets_);
    }

    FloatImage draw(const RandomAir& air, Settings settings) {
        settings.width = options_.width;
        settings.height = options_.height;
        settings.bloom = false;
        renderer_.render(air.scene, air.camera, settings);
        return renderer_.readRadiance();
    }

    FloatImage converged(const RandomAir& air, int nodes) {
        Settings settings;
        settings.samples = nodes;
        return draw(air, settings);
    }

    /// The converged picture, from the folder of references if it is there.
    FloatImage reference(const RandomAir& air, int index, int nodes);

    void printKept();
    void printCauses(const RandomAir& air, const FloatImage& reference, double asked);
    void printLaw(const Law& law, bool (*isOf)(const RandomAir&));

 private:
    Options options_;
    Renderer renderer_;
    hazer::test::RandomAirAssets assets_;
};

FloatImage Bench::reference(const RandomAir& air, int index, int nodes) {
    if (options_.references.empty()) return converged(air, nodes);
    const auto file = std::filesystem::path(options_.references) /
                      fmt::format("{}-{}-{}", options_.seed + index, options_.size, nodes);
    FloatImage picture{options_.width, options_.height, {}};
    picture.rgb.resize(static_cast<std::size_t>(options_.width) * static_cast<std::size_t>(options_.height) *
                       3);
    const auto bytes = static_cast<std::streamsize>(picture.rgb.size() * sizeof(float));
    std::ifstream kept(file, std::ios::binary);
    if (kept.read(reinterpret_cast<char*>(picture.rgb.data()), bytes)) return picture;
    picture = converged(air, nodes);
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(picture.rgb.data()), bytes);
    return picture;
}

void Bench::printCauses(const RandomAir& air, const FloatImage& reference, double asked) {
    const AirQuality fine = finest();
    const std::vector<std::pair<const char*, std::function<void(AirQuality&)>>> numbers{
        {"intervals", [&](AirQuality& q) { q.shadowIntervals = fine.shadowIntervals; }},
        {"bisections", [&](AirQuality& q) { q.shadowBisections = fine.shadowBisections; }},
        {"taps", [&](AirQuality& q) { q.goboTaps = fine.goboTaps; }},
        {"cubic", [&](AirQuality& q) { q.goboTolerance = fine.goboTolerance; }},
        {"levels", [&](AirQuality& q) { q.goboLevelsApart = fine.goboLevelsApart; }},
        {"noise", [&](AirQuality& q) { q.noiseNodes = fine.noiseNodes; }},
        {"pairs", [&](AirQuality& q) { q.profilePairs = fine.profilePairs; }},
        {"all", [&](AirQuality& q) { q = fine; }}};
    std::string line;
    for (const auto& [name, refine] : numbers) {
        Settings settings;
        settings.quality = hazer::render::airQualityFor(asked);
        refine(*settings.quality);
        const double got = pictureError(draw(air, settings), reference).rmsRel;
        line += fmt::format(" {} {:.2f}", name, got / asked);
    }
    fmt::print("    {:g}:{}\n", asked, line);
}

void Bench::printKept() {
    const std::vector<double> asked{0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};
    for (int i = 0; i < options_.scenes; ++i) {
        const RandomAir air = scene(i);
        const FloatImage best = reference(air, i, options_.nodes);
        const FloatImage half = reference(air, i, options_.nodes / 2);
        std::string line = fmt::format("half {:.5f} lit {:5d}", pictureError(half, best).rmsRel,
                                       pictureError(best, best).litPixels);
        std::vector<double> missed;
        for (const double share : asked) {
            Settings settings;
            settings.maxError = share;
            const double got = pictureError(draw(air, settings), best).rmsRel;
            line += fmt::format(" {:5.2f}{}", got / share, got > share ? "!" : " ");
            if (got > share) missed.push_back(share);
        }
        fmt::print("{}  {}\n", line, air.what);
        for (const double share : missed) printCauses(air, best, share);
        std::fflush(stdout);
    }
}

void Bench::printLaw(const Law& law, bool (*isOf)(const RandomAir&)) {
    fmt::print("{}", law.name);
    for (const double value : law.values) fmt::print(" {:8g}", value);
    fmt::print("\n");
    std::vector<std::vector<double>> errors(law.values.size());
    for (int i = 0; i < options_.scenes; ++i) {
        RandomAir air = scene(i);
        if (!isOf(air)) continue;
        law.prepare(air);
        const FloatImage reference = converged(air, options_.nodes);
        if (hazer::app::litPixels(reference).empty()) continue;
        std::string line;
        for (std::size_t v = 0; v < law.values.size(); ++v) {
            Settings settings;
            settings.quality = finest();
            law.set(*settings.quality, law.values[v]);
            errors[v].push_back(pictureError(draw(air, settings), reference).rmsRel);
            line += fmt::format(" {:8.5f}", errors[v].back());
        }
        fmt::print("{}  {}\n", line, air.what);
        std::fflush(stdout);
    }
    std::string median = "median ";
    std::string worst = "worst  ";
    for (auto& of : errors) {
        if (of.empty()) continue;
        std::sort(of.begin(), of.end());
        median += fmt::format(" {:8.5f}", of[of.size() / 2]);
        worst += fmt::format(" {:8.5f}", of.back());
    }
    fmt::print("{}\n{}\n", median, worst);
}

Options parse(int argc, char** argv) {
    Options options;
    CLI::App app{"Error of the light in the air by each number that it is integrated with"};
    app.add_flag("--kept", options.kept, "the errors that --max-error keeps instead");
    app.add_option("--scenes", options.scenes)->check(CLI::Range(1, 1000));
    app.add_option("--seed", options.seed);
    app.add_option("--size", options.size);
    app.add_option("--only", options.only, "start of a number's name");
    app.add_option("--references", options.references,
                   "folder that keeps the converged pictures of --kept from run to run")
        ->check(CLI::ExistingDirectory);
    app.add_option("--nodes", options.nodes, "of the converged picture")->check(CLI::Range(4, 16384));
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
    Bench bench(options);
    if (options.kept) {
        bench.printKept();
        return 0;
    }
    const auto onlyGobo = [](RandomAir& air) {
        takeNoise(air);
        takeShadows(air);
    };
    const auto onlyShadow = [](RandomAir& air) {
        takeNoise(air);
        takeGobos(air);
    };
    const auto onlyNoise = [](RandomAir& air) {
        takeGobos(air);
        takeShadows(air);
    };
    const auto onlySoft = [](RandomAir& air) {
        takeNoise(air);
        takeGobos(air);
        takeShadows(air);
        setEdges(air, BeamEdge::kSoft);
    };
    const auto noNoise = [](RandomAir& air) { takeNoise(air); };
    const auto noShadow = [](RandomAir& air) { takeShadows(air); };
    const auto gobo = [](const RandomAir& air) { return has(air, "gobo"); };
    const auto shadow = [](const RandomAir& air) { return has(air, "shadow"); };
    const auto noise = [](const RandomAir& air) { return has(air, "noise"); };
    const auto both = [](const RandomAir& air) { return has(air, "gobo") && has(air, "shadow"); };
    const auto noisyGobo = [](const RandomAir& air) { return has(air, "gobo") && has(air, "noise"); };
    const auto all = [](const RandomAir&) { return true; };
    const auto taps = [](AirQuality& q, double v) { q.goboTaps = static_cast<int>(v); };
    const auto intervals = [](AirQuality& q, double v) { q.shadowIntervals = static_cast<int>(v); };
    const auto nodes = [](AirQuality& q, double v) { q.noiseNodes = static_cast<int>(v); };
    const auto pairs = [](AirQuality& q, double v) { q.profilePairs = static_cast<int>(v); };
    const auto step4 = [](AirQuality& q, double v) {
        q.gridStep = 4;
        q.gridTolerance = v;
    };
    const auto step2 = [](AirQuality& q, double v) {
        q.gridStep = 2;
        q.gridTolerance = v;
    };
    const std::vector<double> tapCounts{8, 16, 32, 48, 64, 96, 128, 256};
    const std::vector<double> nodeCounts{4, 6, 8, 12, 16, 24, 32, 64};
    const std::vector<double> tolerances{0.8, 0.4, 0.2, 0.1, 0.04, 0.02, 0.008};
    const auto run = [&](const Law& law, bool (*isOf)(const RandomAir&)) {
        if (law.name.starts_with(options.only)) bench.printLaw(law, isOf);
    };
    run({"taps, no shadow", tapCounts, taps, onlyGobo}, gobo);
    run({"taps, with shadow", tapCounts, taps, noNoise}, both);
    run({"intervals", {4, 6, 8, 12, 16, 29, 58, 116}, intervals, onlyShadow}, shadow);
    run({"noise nodes", nodeCounts, nodes, onlyNoise}, noise);
    run({"noise nodes, gobo", nodeCounts, nodes, noShadow}, noisyGobo);
    const std::vector<double> bends{1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005};
    const auto bend = [](AirQuality& q, double v) { q.goboTolerance = v; };
    const auto levels = [](AirQuality& q, double v) {
        q.goboTolerance = 0.005;
        q.goboLevelsApart = v;
    };
    run({"levels apart", {0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 1.0, 2.0}, levels, onlyGobo}, gobo);
    run({"cubic", bends, bend, onlyGobo}, gobo);
    run({"swirls", bends, bend, noShadow}, noisyGobo);
    run({"pairs", {2, 3, 4}, pairs, onlySoft}, all);
    run({"grid 4", tolerances, step4, [](RandomAir&) {}}, all);
    run({"grid 2", tolerances, step2, [](RandomAir&) {}}, all);
    return 0;
}
