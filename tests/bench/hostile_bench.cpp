// What files of attackers cost: the processor time until each is loaded or refused, and the memory that this
// takes at most, each in a process of its own. Baseline: the harmless file of each kind, which comes first.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/patch.h"
#include "app/staging.h"
#include "fixtures/container.h"
#include "fixtures/fixture_file.h"
#include "fixtures/wheel_image.h"
#include "render/asset_list.h"
#include "render/rig_mesh.h"
#include "tests/bench/hostile_files.h"
#include "tests/bench/peak_memory.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace hazer;

constexpr double kMostMs = 1000.0;
constexpr double kMostMib = 256.0;

void stage(const app::Show& show) {
    const app::Patch patch(show);
    render::AssetList assets;
    app::Staging staging(show, assets);
    staging.scene(patch, app::controlsOf(show), 0.0);
}

void loadFixture(const std::filesystem::path& file) {
    const fixtures::FixtureTypePtr type = fixtures::loadFixtureType(file);
    if (type->modes.empty()) return;
    app::Show show;
    app::ShowFixture& fixture = show.fixtures.emplace_back();
    fixture.name = "fixture";
    fixture.mode = type->modes.front().name;
    fixture.rig = app::RigFixture{type, glm::dmat4(1.0), {}, {}, {}};
    stage(show);
}

void load(const std::filesystem::path& file) {
    const std::string end = file.extension().string();
    if (end == ".mvr") {
        stage(app::loadShow(file));
    } else if (end == ".gdtf") {
        loadFixture(file);
    } else {
        const fixtures::Bytes bytes = fixtures::readFile(file, std::size_t{64} << 20);
        if (end == ".png") {
            fixtures::decodeWheelImage(bytes, file.filename().string());
        } else {
            render::parseRigMesh(bytes, file.filename().string());
        }
    }
}

/// In a process of its own: milliseconds of the processor, whatever else is running, mebibytes, and what came
/// of it.
void loadAndTell(const std::filesystem::path& file) {
    spdlog::set_level(spdlog::level::off);
    std::string outcome = "loaded";
    const std::clock_t start = std::clock();
    try {
        load(file);
    } catch (const std::runtime_error& error) {
        outcome = error.what();
    }
    const double ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fmt::print("{:.1f} {:.1f} {}\n", ms, bench::peakMib(), outcome);
}

struct Cost {
    double ms = 0.0;
    double mib = 0.0;
    std::string outcome = "CRASHED";

    bool isTooMuch() const { return ms > kMostMs || mib > kMostMib || outcome == "CRASHED"; }
};

Cost measure(const std::filesystem::path& file) {
    // The system limits hold where a reader does not.
    const std::string command =
        fmt::format("ulimit -v 8000000; ulimit -t 100; /proc/{}/exe --load '{}'", getpid(), file.string());
    const std::unique_ptr<FILE, int (*)(FILE*)> child(popen(command.c_str(), "r"), &pclose);
    std::string text;
    std::array<char, 4096> buffer;
    while (std::fgets(buffer.data(), buffer.size(), child.get()) != nullptr) text += buffer.data();
    Cost cost;
    std::istringstream stream(text);
    if (stream >> cost.ms >> cost.mib) std::getline(stream >> std::ws, cost.outcome);
    return cost;
}

bool tell(const std::string& name, const Cost& cost) {
    fmt::print("{:<28} {:8.1f} ms {:7.1f} MiB {} {}\n", name, cost.ms, cost.mib,
               cost.isTooMuch() ? "TOO MUCH" : "        ", cost.outcome.substr(0, 150));
    std::fflush(stdout);
    return !cost.isTooMuch();
}

}  // namespace

int main(int argumentCount, char** arguments) {
    std::string only;
    std::filesystem::path toLoad;
    std::vector<std::filesystem::path> files;
    CLI::App options("What files of attackers cost");
    options.add_option("--only", only, "Only the files with this in their name");
    options.add_option("--load", toLoad, "Load one file and tell what it cost");
    options.add_option("files", files, "Further files, such as those of a folder of hostile ones");
    CLI11_PARSE(options, argumentCount, arguments);
    if (!toLoad.empty()) {
        loadAndTell(toLoad);
        return 0;
    }

    const test::TemporaryFolder folder;
    bool holds = true;
    for (const bench::HostileFile& hostile : bench::hostileFiles()) {
        if (hostile.name.find(only) == std::string::npos) continue;
        const std::filesystem::path file = folder.write(hostile.name, hostile.bytes());
        holds = tell(hostile.name, measure(file)) && holds;
        std::filesystem::remove(file);
        if (!std::filesystem::is_empty(folder.path())) {
            fmt::print("{} wrote a file\n", hostile.name);
            holds = false;
        }
    }
    for (const std::filesystem::path& file : files)
        holds = tell(file.filename().string(), measure(file)) && holds;
    fmt::print("{}\n", holds ? fmt::format("All within {} ms and {} MiB.", kMostMs, kMostMib)
                             : "Some take too much.");
    return holds ? 0 : 1;
}
