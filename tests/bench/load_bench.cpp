// How long fixture files take to load, and how much memory at most, each in a process of its own. Beside it
// the mere reading of the same bytes.
//     load_bench FILE.gdtf FOLDER ...
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "fixtures/fixture_file.h"

namespace {

using namespace hazer;

constexpr int kRuns = 7;

/// What the loading of a file took.
struct Cost {
    double readMs = 0.0;
    double loadMs = 0.0;
    long peakKb = 0;  ///< More than before.
    std::size_t modes = 0;
    bool isLoaded = false;
};

long peakKb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

template <typename Work>
double medianMs(const Work& work) {
    std::vector<double> times;
    for (int run = 0; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::nth_element(times, times.begin() + kRuns / 2);
    return times[kRuns / 2];
}

Cost measure(const std::filesystem::path& file) {
    Cost cost;
    const long before = peakKb();
    try {
        cost.modes = fixtures::loadFixtureType(file)->modes.size();
    } catch (const std::exception&) {
        return cost;
    }
    cost.isLoaded = true;
    cost.peakKb = peakKb() - before;
    cost.loadMs = medianMs([&] { fixtures::loadFixtureType(file); });
    cost.readMs = medianMs([&] {
        std::ifstream stream(file, std::ios::binary);
        const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
    });
    return cost;
}

/// Peaks of memory only ever grow, so each file has a process of its own.
Cost measureApart(const std::filesystem::path& file) {
    int ends[2];
    Cost cost;
    if (pipe(ends) != 0) return cost;
    const pid_t child = fork();
    if (child == 0) {
        cost = measure(file);
        const bool isWritten = write(ends[1], &cost, sizeof cost) == static_cast<ssize_t>(sizeof cost);
        _exit(isWritten ? 0 : 1);
    }
    close(ends[1]);
    if (read(ends[0], &cost, sizeof cost) != static_cast<ssize_t>(sizeof cost)) cost = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return cost;
}

bool isFixtureFile(const std::filesystem::path& path) {
    return path.extension() == ".gdtf" || path.extension() == ".qxf";
}

std::vector<std::filesystem::path> filesIn(const std::vector<std::string>& paths) {
    std::vector<std::filesystem::path> files;
    for (const std::string& path : paths) {
        if (!std::filesystem::is_directory(path)) {
            files.emplace_back(path);
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
            if (isFixtureFile(entry.path())) files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("How long fixture files take to load");
    std::vector<std::string> paths;
    app.add_option("paths", paths, "Files, or folders of them")->required()->check(CLI::ExistingPath);
    CLI11_PARSE(app, argc, argv);

    fmt::print("{:>9} {:>9} {:>9} {:>6}  file\n", "read ms", "load ms", "peak MB", "modes");
    for (const std::filesystem::path& file : filesIn(paths)) {
        const Cost cost = measureApart(file);
        if (!cost.isLoaded) {
            fmt::print("{:>9} {:>9} {:>9} {:>6}  {}\n", "-", "refused", "-", "-", file.filename().string());
            continue;
        }
        fmt::print("{:9.2f} {:9.2f} {:9.1f} {:6}  {}\n", cost.readMs, cost.loadMs,
                   static_cast<double>(cost.peakKb) / 1000.0, cost.modes, file.filename().string());
    }
    return 0;
}
