// How long a rig takes to open: a made-up MVR of many fixtures of a few types, as a show with its patch and
// its meshes. Baseline: the same rig with its archive and scene alone, read to plain data.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <vector>

#include "app/patch.h"
#include "app/paths.h"
#include "app/staging.h"
#include "fixtures/mvr.h"
#include "render/asset_list.h"
#include "tests/bench/peak_memory.h"
#include "tests/fixtures/description.h"
#include "tests/support/mesh_bytes.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace hazer;

std::string contentOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A ball of rings x rings places, twice as many triangles, and a size that only its number has.
std::string ball3ds(int rings, int number) {
    const auto count = static_cast<std::uint16_t>(rings * rings);
    std::string places = test::bytesOf<std::uint16_t>({count});
    std::string faces = test::bytesOf<std::uint16_t>({static_cast<std::uint16_t>(2 * rings * (rings - 1))});
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < rings; ++i) {
            const double up = 3.1416 * ring / (rings - 1);
            const double around = 6.2832 * i / rings;
            const double radius = 100.0 + number;
            places += test::bytesOf<float>({static_cast<float>(radius * std::sin(up) * std::cos(around)),
                                            static_cast<float>(radius * std::sin(up) * std::sin(around)),
                                            static_cast<float>(radius * std::cos(up))});
            if (ring + 1 == rings) continue;
            const auto at = [&](int r, int n) { return static_cast<std::uint16_t>(r * rings + n % rings); };
            faces += test::bytesOf<std::uint16_t>({at(ring, i), at(ring + 1, i), at(ring, i + 1), 7});
            faces += test::bytesOf<std::uint16_t>({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1), 7});
        }
    }
    return test::file3ds(test::chunk3ds(
        0x4000, std::string("b\0", 2) +
                    test::chunk3ds(0x4100, test::chunk3ds(0x4110, places) + test::chunk3ds(0x4120, faces))));
}

/// A fixture of hazer's library with its wheels, as an archive; each of its parts is a mesh, of which there
/// are three.
std::string libraryGdtf(const char* name, int number) {
    constexpr int kMeshes = 3;
    constexpr int kRings = 32;
    const std::filesystem::path folder = app::libraryFolder() / name;
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            files.emplace_back(entry.path().lexically_relative(folder).generic_string(),
                               contentOf(entry.path()));
    }
    for (auto& [file, content] : files) {
        constexpr std::string_view kModel = "<Model ";
        int model = 0;
        std::size_t at = file == "description.xml" ? content.find(kModel) : std::string::npos;
        for (; at != std::string::npos; at = content.find(kModel, at + kModel.size()))
            content.insert(at + kModel.size(), fmt::format("File=\"{}\" ", model++ % kMeshes));
    }
    for (int mesh = 0; mesh < kMeshes; ++mesh)
        files.emplace_back(fmt::format("models/3ds/{}.3ds", mesh), ball3ds(kRings, number * kMeshes + mesh));
    const std::vector<std::uint8_t> bytes = fixtures::testing::zipOf(files);
    return {bytes.begin(), bytes.end()};
}

/// Rows of fixtures, a slot range for each, every tenth with a focus point.
std::string sceneXml(int fixtures, int types) {
    std::string objects;
    for (int i = 0; i < fixtures; ++i) {
        const double x = 500.0 * (i % 50) - 12500.0;
        const double y = 1000.0 * (i / 50);
        objects += fmt::format(
            R"(<Fixture name="F" uuid="f{0}"><Matrix>{{1,0,0}}{{0,1,0}}{{0,0,1}}{{{1},{2},7000}}</Matrix>
<GDTFSpec>{3}.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode>{4}<FixtureID>{0}</FixtureID><UnitNumber>0</UnitNumber>
<Addresses><Address break="0">{5}.{6}</Address></Addresses><Color>0.3127,0.3290,100</Color></Fixture>)",
            i, x, y, i % types, i % 10 == 0 ? "<Focus>p</Focus>" : "", 1 + i / 25, 1 + 20 * (i % 25));
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
    int types = 20;
    int runs = 5;
    CLI::App options("How long a rig takes to open");
    options.add_option("--fixtures", fixtures, "Fixtures in it; 2000 unless given")
        ->check(CLI::PositiveNumber);
    options.add_option("--types", types, "GDTFs that they share; 20 unless given")
        ->check(CLI::PositiveNumber);
    options.add_option("--runs", runs, "Times it is opened; 5 unless given")->check(CLI::PositiveNumber);
    CLI11_PARSE(options, argumentCount, arguments);

    constexpr std::array kFixtures{"moving-spot", "moving-wash", "moving-beam", "par-rgbw"};
    std::vector<std::pair<std::string, std::string>> files{
        {"GeneralSceneDescription.xml", sceneXml(fixtures, types)}};
    for (int type = 0; type < types; ++type) {
        files.emplace_back(fmt::format("{}.gdtf", type),
                           libraryGdtf(kFixtures[static_cast<std::size_t>(type) % kFixtures.size()], type));
    }
    const test::TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes = fixtures::testing::zipOf(files);
    const std::filesystem::path file =
        folder.write("rig.mvr", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const double beforeMib = bench::peakMib();
    const double sceneMs = medianMs(runs, [&] { fixtures::MvrArchive(file).readScene(); });
    const double showMs = medianMs(runs, [&] { app::loadShow(file); });
    std::size_t sharedTypes = 0;
    std::size_t meshBytes = 0;
    const double openMs = medianMs(runs, [&] {
        const app::Show show = app::loadShow(file);
        const app::Patch patch(show);
        render::AssetList assets;
        app::Staging staging(show, assets);
        staging.scene(patch, app::controlsOf(show), 0.0);
        std::set<const fixtures::FixtureType*> distinct;
        for (const app::ShowFixture& fixture : show.fixtures) distinct.insert(fixture.rig->type.get());
        sharedTypes = distinct.size();
        meshBytes = assets.counts().meshBytes;
    });
    fmt::print(
        "{} fixtures of {} GDTFs, {} kB: scene alone {:.1f} ms, show {:.1f} ms, ready to draw {:.1f} ms; {} "
        "types and "
        "{} kB of meshes in memory, {:.0f} MiB more than before\n",
        fixtures, types, bytes.size() / 1000, sceneMs, showMs, openMs, sharedTypes, meshBytes / 1000,
        bench::peakMib() - beforeMib);
    return 0;
}
