// What recordings cost: seeking, recording under load, the punctuality of a replay.
//   recording_bench seek --hours 2 --folder /tmp      writes and deletes 12 GB
//   recording_bench record --seconds 10
//   recording_bench replay --seconds 10
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <thread>

#include "protocol/artnet.h"
#include "protocol/recording/lateness.h"
#include "protocol/recording/pcap_format.h"
#include "protocol/recording/recorder.h"
#include "protocol/recording/recording_player.h"
#include "protocol/recording/resender.h"
#include "protocol/sacn.h"

namespace {

using namespace hazer::protocol;
using namespace std::chrono_literals;

constexpr double kFramesPerS = 44.0;
constexpr std::chrono::microseconds kSpacing{10};

struct Options {
    std::string folder = "/tmp";
    double hours = 0.1;
    double seconds = 10.0;
    int universes = 0;  // 0: as the work needs
};

double secondsSince(TimePoint start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A fade on every universe, half of them by Art-Net and half by sACN, with full frames. A desk sends the
/// universes of a frame one after another, as fast as a network card of 500 Mbit/s lets it.
class Desk {
 public:
    Datagram packet(int universe, std::uint64_t frame) {
        Slots slots;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            slots[i] = static_cast<std::uint8_t>(frame + i + static_cast<std::size_t>(universe));
        }
        const auto sequence = static_cast<std::uint8_t>(frame % 255 + 1);
        const auto number = static_cast<std::uint16_t>(universe / 2 + 1);
        const bool isSacn = universe % 2 == 1;
        if (isSacn) {
            SacnData data;
            data.cid = {1, 2, 3};
            data.sourceName = "bench";
            data.sequence = sequence;
            data.universe = number;
            data.slots = slots;
            bytes_ = packSacnData(data);
        } else {
            bytes_ = packArtDmx(number, sequence, slots);
        }
        const std::uint16_t port = isSacn ? kSacnPort : kArtNetPort;
        return {{{10, 0, 0, 1}, false, port},
                {{10, 0, 0, 2}, false, port},
                timeOf(frame) + universe * kSpacing,
                bytes_};
    }

    static WallTime timeOf(std::uint64_t frame) {
        const auto ns =
            std::chrono::nanoseconds(std::llround(1e9 * static_cast<double>(frame) / kFramesPerS));
        return WallTime(std::chrono::seconds(1'700'000'000) + ns);
    }

 private:
    std::vector<std::uint8_t> bytes_;
};

std::uint64_t writeCapture(const std::filesystem::path& file, int universes, double seconds) {
    std::ofstream stream(file, std::ios::binary);
    std::vector<std::uint8_t> bytes = packPcapFileHeader();
    Desk desk;
    std::uint64_t packets = 0;
    const auto frames = static_cast<std::uint64_t>(seconds * kFramesPerS);
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        for (int universe = 0; universe < universes; ++universe, ++packets) {
            appendPcapRecord(bytes, desk.packet(universe, frame));
        }
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        bytes.clear();
    }
    return packets;
}

/// Memory of this process [MiB], of which none is the page cache.
double residentMiB() {
    std::ifstream stream("/proc/self/statm");
    std::uint64_t total = 0;
    std::uint64_t resident = 0;
    stream >> total >> resident;
    return static_cast<double>(resident) * 4096.0 / 1048576.0;
}

/// Lets the system forget what it keeps of the file in memory.
void dropFromMemory(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY);
    ::fdatasync(descriptor);
    ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    ::close(descriptor);
}

/// 300 seeks to random moments; `isCold`: each from the disk.
void printSeeks(RecordingPlayer& player, const std::filesystem::path& file, bool isCold) {
    Lateness seeks;
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::int64_t> anyTime(0, player.duration()->count());
    UniverseSet looks;
    for (int i = 0; i < 300; ++i) {
        if (isCold) dropFromMemory(file);
        const TimePoint before = Clock::now();
        player.goTo(RecordingTime(anyTime(random)));
        player.latch(looks);
        seeks.add(Clock::now() - before);
    }
    fmt::print("300 seeks{}: median {:.1f} ms, p99 {:.1f} ms, worst {:.1f} ms\n",
               isCold ? " from the disk" : "", 1e3 * seeks.withinS(0.5), 1e3 * seeks.withinS(0.99),
               1e3 * seeks.worstS());
}

void benchSeek(const Options& options) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / "recording_bench.pcap";
    const int universes = options.universes > 0 ? options.universes : 64;
    const double seconds = 3600.0 * options.hours;
    const std::uint64_t packets = writeCapture(file, universes, seconds);
    fmt::print("{} universes, {:.0f} s, {} packets, {:.2f} GB\n", universes, seconds, packets,
               1e-9 * static_cast<double>(std::filesystem::file_size(file)));
    const double memoryBefore = residentMiB();
    const TimePoint start = Clock::now();
    RecordingPlayer player(file, {}, {}, RecordingPlayer::Indexing::kBackground);
    player.awaitIndex();
    const double indexS = secondsSince(start);
    fmt::print("index: {:.1f} s, {:.2f} us a packet, {} key frames, {:.0f} MiB\n", indexS,
               1e6 * indexS / static_cast<double>(packets), player.index().size(),
               residentMiB() - memoryBefore);
    printSeeks(player, file, false);
    printSeeks(player, file, true);
    std::filesystem::remove(file);
}

void benchRecord(const Options& options) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / "recording_bench.pcap";
    const int universes = options.universes > 0 ? options.universes : 512;
    Recorder recorder({.file = file, .replacesFile = true});
    Desk desk;
    Lateness costs;
    const TimePoint start = Clock::now();
    std::uint64_t packets = 0;
    for (std::uint64_t frame = 0; secondsSince(start) < options.seconds; ++frame) {
        std::this_thread::sleep_until(start + (Desk::timeOf(frame) - Desk::timeOf(0)));
        for (int universe = 0; universe < universes; ++universe, ++packets) {
            const Datagram packet = desk.packet(universe, frame);
            const TimePoint before = Clock::now();
            recorder.record(packet);
            costs.add(Clock::now() - before);
        }
    }
    recorder.finish();
    const RecorderStatus status = recorder.status();
    fmt::print("{} universes, {:.1f} s: {} packets handed over, {} written, {} dropped, {:.1f} MB/s\n",
               universes, options.seconds, packets, status.packets, status.dropped,
               1e-6 * static_cast<double>(status.bytes) / options.seconds);
    fmt::print(
        "the receiving thread spends at most {:.0f} us on a packet in the median, {:.0f} us for 99 in 100\n",
        1e6 * costs.withinS(0.5), 1e6 * costs.withinS(0.99));
    std::filesystem::remove(file);
}

void benchReplay(const Options& options) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / "recording_bench.pcap";
    const int universes = options.universes > 0 ? options.universes : 512;
    const std::uint64_t packets = writeCapture(file, universes, options.seconds);
    Resender resender(file, {}, {.port = std::uint16_t{9}});
    resender.run([] { return false; });
    const ResenderStatus status = resender.status();
    fmt::print(
        "{} universes, {} of {} packets sent to loopback; late by {:.3f} ms in the median, {:.3f} ms p99, "
        "{:.3f} ms at worst\n",
        universes, status.packets, packets, 1e3 * status.medianLateS, 1e3 * status.p99LateS,
        1e3 * status.worstLateS);
    std::filesystem::remove(file);
}

}  // namespace

int main(int argumentCount, char** arguments) {
    CLI::App program("What recordings cost.");
    program.require_subcommand(1);
    Options options;
    for (const auto& [name, bench] : {std::pair("seek", &benchSeek), std::pair("record", &benchRecord),
                                      std::pair("replay", &benchReplay)}) {
        CLI::App* command = program.add_subcommand(name);
        command->add_option("--folder", options.folder, "Where the recording is written");
        command->add_option("--hours", options.hours, "Length of the recording to seek in");
        command->add_option("--seconds", options.seconds, "How long to record or replay");
        command->add_option("--universes", options.universes, "64 for seek, 512 for the others unless given");
        command->callback([&options, run = bench] { run(options); });
    }
    CLI11_PARSE(program, argumentCount, arguments);
    return 0;
}
