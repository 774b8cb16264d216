// How long a rig takes to open: a made-up MVR of many fixtures of a few types, as a show with its patch and
// its meshes. Baseline: the same rig with its archive and scene alone, read to plain data.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <vector>

#include "app/patch.h"
#include "app/paths.h"
#include "app/staging.h"
#include "fixtures/mvr.h"
#include "render/asset_list.h"
#include "tests/fixtures/description.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace hazer;

std::string contentOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A fixture of hazer's library with its wheels, as an archive.
std::string libraryGdtf(const char* name) {
    const std::filesystem::path folder = app::libraryFolder() / name;
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            files.emplace_back(entry.path().lexically_relative(folder).generic_string(),
                               contentOf(entry.path()));
    }
    const std::vector<std::uint8_t> bytes = fixtures::testing::zipOf(files);
    return {bytes.begin(), bytes.end()};
}

/// Rows of fixtures, a slot range for each, every tenth with a focus point.
std::string sceneXml(int fixtures) {
    constexpr std::array kTypes{"spot", "wash", "beam", "par"};
    std::string objects;
    for (int i = 0; i < fixtures; ++i) {
        const double x = 500.0 * (i % 50) - 12500.0;
        const double y = 1000.0 * (i / 50);
        objects += fmt::format(
            R"(<Fixture name="F" uuid="f{0}"><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{1},{2},7000}}</Matrix>
<GDTFSpec>{3}.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode>{4}<FixtureID>{0}</FixtureID><UnitNumber>0</UnitNumber>
<Addresses><Address break="0">{5}.{6}</Address></Addresses><Color>0.3127,0.3290,100</Color></Fixture>)",
            i, x, y, kTypes[static_cast<std::size_t>(i) % kTypes.size()],
            i % 10 == 0 ? "<Focus>p</Focus>" : "", 1 + i / 25, 1 + 20 * (i % 25));
    }
    return R"(<GeneralSceneDescription verMajor="1" verMinor="6"><Scene><Layers><Layer><ChildList><FocusPoint uuid="p"/>)" +
           objects + "</ChildList></Layer></Layers></Scene></GeneralSceneDescription>";
}

double medianMs(int runs, const std::function<void()>& work) {
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::nth_element(times, times.begin() + runs / 2);
    return times[static_cast<std::size_t>(runs / 2)];
}

}  // namespace

int main(int argumentCount, char** arguments) {
    int fixtures = 2000;
    int runs = 5;
    CLI::App options("How long a rig takes to open");
    options.add_option("--fixtures", fixtures, "Fixtures in it; 2000 unless given")
        ->check(CLI::PositiveNumber);
    options.add_option("--runs", runs, "Times it is opened; 5 unless given")->check(CLI::PositiveNumber);
    CLI11_PARSE(options, argumentCount, arguments);

    const test::TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes =
        fixtures::testing::zipOf({{"GeneralSceneDescription.xml", sceneXml(fixtures)},
                                  {"spot.gdtf", libraryGdtf("moving-spot")},
                                  {"wash.gdtf", libraryGdtf("moving-wash")},
                                  {"beam.gdtf", libraryGdtf("moving-beam")},
                                  {"par.gdtf", libraryGdtf("par-rgbw")}});
    const std::filesystem::path file =
        folder.write("rig.mvr", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const double sceneMs = medianMs(runs, [&] { fixtures::MvrArchive(file).readScene(); });
    const double showMs = medianMs(runs, [&] { app::loadShow(file); });
    const double openMs = medianMs(runs, [&] {
        const app::Show show = app::loadShow(file);
        const app::Patch patch(show);
        render::AssetList assets;
        app::Staging staging(show, assets);
        staging.scene(patch, app::controlsOf(show), 0.0);
    });
    fmt::print("{} fixtures, {} kB: scene alone {:.1f} ms, show {:.1f} ms, ready to draw {:.1f} ms\n",
               fixtures, bytes.size() / 1000, sceneMs, showMs, openMs);
    return 0;
}
