// What it costs to have Art-Net and sACN in the store: nanoseconds a packet, allocations, and a loopback run
// at the load of a large show.
//     protocol_bench [--universes 512] [--fps 44] [--seconds 10] [--no-limit]
//     protocol_bench --flood 200000 [--seconds 10]      a desk of 64 universes beside so much garbage a
//     second
// What is measured of the network is loopback by unicast.
#include <fmt/core.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "protocol/artnet_node.h"
#include "protocol/receiver.h"
#include "protocol/sacn_receiver.h"
#include "protocol/universe_store.h"
#include "tests/protocol/allocation_counter.h"

namespace {

using namespace hazer::protocol;
using Bytes = std::vector<std::uint8_t>;
using Seconds = std::chrono::duration<double>;

/// The packets of one frame, and where each has its slots.
struct Frame {
    std::vector<Bytes> packets;
    std::size_t slotsOffset = 0;
    std::optional<std::size_t> sequenceOffset;  // absent: not numbered
};

struct Options {
    int universes = 512;
    double fps = 44.0;
    double seconds = 10.0;
    bool skipsLimit = false;
    double floodPerS = 0.0;  // 0: no flood
};

double secondsSince(TimePoint start) {
    return Seconds(Clock::now() - start).count();
}

Frame artNetFrame(int universes) {
    Frame frame{{}, 18, std::nullopt};
    const Slots slots{};
    for (int i = 0; i < universes; ++i) {
        frame.packets.push_back(packArtDmx(static_cast<std::uint16_t>(i), 0, slots));
    }
    return frame;
}

Frame sacnFrame(int universes, std::uint8_t cid = 1) {
    Frame frame{{}, 126, 111};
    const Slots slots{};
    SacnData data;
    data.cid.fill(cid);
    data.sourceName = "bench";
    data.slots = slots;
    for (int i = 0; i < universes; ++i) {
        data.universe = static_cast<std::uint16_t>(i + 1);
        frame.packets.push_back(packSacnData(data));
    }
    return frame;
}

struct Cost {
    double nanoseconds = 0.0;
    double allocations = 0.0;  // of one
};

/// Runs `once(round)` for half a second after a warm-up; it does `count` of what is measured.
template <class Once>
Cost costOf(int count, Once once) {
    for (int round = 0; round < 3; ++round) once(round);
    const std::size_t allocationsBefore = hazer::test::allocationCount();
    const TimePoint start = Clock::now();
    int rounds = 0;
    while (secondsSince(start) < 0.5) once(3 + rounds++);
    const double total = static_cast<double>(rounds) * count;
    return {secondsSince(start) * 1e9 / total,
            static_cast<double>(hazer::test::allocationCount() - allocationsBefore) / total};
}

/// Parsing and copying, with nobody to merge with and nothing to remember.
Cost costOfCopying(Frame frame) {
    std::vector<Slots> universes(frame.packets.size());
    return costOf(static_cast<int>(frame.packets.size()), [&](int round) {
        for (Bytes& packet : frame.packets) {
            packet[frame.slotsOffset] = static_cast<std::uint8_t>(round);
            const ArtNetPacket parsed = parseArtNet(packet);
            const auto& dmx = std::get<ArtDmx>(parsed);
            std::ranges::copy(dmx.slots, universes[dmx.portAddress].begin());
        }
    });
}

/// Through the node into the merger, from `sources` addresses in turn.
Cost costOfMerging(Frame frame, int sources) {
    UniverseMerger merger;
    ArtNetNode node{ArtNetNodeConfig{}};
    TimePoint now{std::chrono::hours(1)};
    const auto once = [&](int round) {
        now += std::chrono::milliseconds(23);
        const Endpoint from{{10, 0, 0, static_cast<std::uint8_t>(round % sources)}, kArtNetPort};
        for (Bytes& packet : frame.packets) {
            packet[frame.slotsOffset] = static_cast<std::uint8_t>(round);
            node.receive(packet, from, now, merger);
        }
    };
    return costOf(static_cast<int>(frame.packets.size()), once);
}

/// The same through the sACN listener, from `sources` CIDs in turn.
Cost costOfMergingSacn(Frame frame, int sources) {
    constexpr std::size_t kCidOffset = 22;
    UniverseMerger merger;
    SacnListener listener;
    TimePoint now{std::chrono::hours(1)};
    const IpEndpoint from{.address = {10, 0, 0, 1}, .port = kSacnPort};
    const auto once = [&](int round) {
        now += std::chrono::milliseconds(23);
        for (Bytes& packet : frame.packets) {
            packet[kCidOffset] = static_cast<std::uint8_t>(round % sources);
            packet[*frame.sequenceOffset] = static_cast<std::uint8_t>(round / sources);
            packet[frame.slotsOffset] = static_cast<std::uint8_t>(round);
            listener.receive(packet, from, from, now, merger);
        }
    };
    return costOf(static_cast<int>(frame.packets.size()), once);
}

Cost costOfLatching(const Frame& frame) {
    UniverseStore store;
    ArtNetNode node{ArtNetNodeConfig{}};
    const TimePoint now{std::chrono::hours(1)};
    store.change([&](UniverseMerger& merger) {
        for (const Bytes& packet : frame.packets) node.receive(packet, {}, now, merger);
    });
    UniverseSet set;
    return costOf(1, [&](int) { store.latch(set, now); });
}

double cpuSeconds(int who) {
    rusage usage{};
    getrusage(who, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Load {
    std::uint64_t sent = 0;
    std::uint64_t taken = 0;
    std::uint64_t droppedBySystem = 0;
    double seconds = 0.0;
    double receiverShare = 0.0;  // of a core
    std::vector<double> latenciesUs;
};

/// A desk: all universes in one burst a frame, each packet with the moment of its sending in its first slots.
class Desk {
 public:
    Desk(std::uint16_t port, Frame frame)
        : socket_(context_, asio::ip::udp::v4()),
          to_(asio::ip::address_v4::loopback(), port),
          frame_(std::move(frame)) {}

    /// Returns the number of packets sent. `cpuS` becomes what this thread needed.
    std::uint64_t play(double fps, double seconds, double& cpuS) {
        const double cpuBefore = cpuSeconds(RUSAGE_THREAD);
        const TimePoint start = Clock::now();
        std::uint64_t sent = 0;
        for (int i = 0; i / fps < seconds; ++i) {
            std::this_thread::sleep_until(start +
                                          std::chrono::duration_cast<Clock::duration>(Seconds(i / fps)));
            for (Bytes& packet : frame_.packets) sent += send(packet) ? 1U : 0U;
        }
        cpuS = cpuSeconds(RUSAGE_THREAD) - cpuBefore;
        return sent;
    }

 private:
    bool send(Bytes& packet) {
        const Clock::rep now = Clock::now().time_since_epoch().count();
        std::memcpy(&packet[frame_.slotsOffset], &now, sizeof now);
        if (frame_.sequenceOffset) ++packet[*frame_.sequenceOffset];
        std::error_code failure;
        socket_.send_to(asio::buffer(packet), to_, 0, failure);
        return !failure;
    }

    asio::io_context context_;
    asio::ip::udp::socket socket_;
    asio::ip::udp::endpoint to_;
    Frame frame_;
};

/// From the call that sent a packet to the moment its batch was merged, for what came since the last look.
void collectLatencies(const UniverseSet& set, TimePoint since, std::vector<double>& latenciesUs) {
    for (const auto& [id, universe] : set) {
        if (universe.lastReceived <= since) continue;
        Clock::rep sent = 0;
        std::memcpy(&sent, universe.slots.data(), sizeof sent);
        const auto latency = universe.lastReceived.time_since_epoch() - Clock::duration(sent);
        latenciesUs.push_back(std::chrono::duration<double, std::micro>(latency).count());
    }
}

/// A receiver of either protocol that runs.
struct Listening {
    std::uint16_t port = 0;
    std::function<std::uint64_t()> taken;
    std::function<std::uint64_t()> droppedBySystem;
};

Load measureLoad(const Listening& receiver, UniverseStore& store, const Frame& frame, double fps,
                 double seconds, bool latches) {
    Load load;
    double deskCpuS = 0.0;
    const double processBefore = cpuSeconds(RUSAGE_SELF);
    const double ownBefore = cpuSeconds(RUSAGE_THREAD);
    const TimePoint start = Clock::now();
    std::atomic<bool> isOver = false;
    std::thread desk([&] {
        load.sent = Desk(receiver.port, frame).play(fps, seconds, deskCpuS);
        isOver = true;
    });
    UniverseSet set;
    TimePoint lastLook{};
    while (!isOver) {
        std::this_thread::sleep_for(std::chrono::milliseconds(16));
        if (!latches) continue;
        const TimePoint now = Clock::now();
        store.latch(set, now);
        collectLatencies(set, lastLook, load.latenciesUs);
        lastLook = now;
    }
    desk.join();
    load.seconds = secondsSince(start);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    load.receiverShare =
        (cpuSeconds(RUSAGE_SELF) - processBefore - (cpuSeconds(RUSAGE_THREAD) - ownBefore) - deskCpuS) /
        load.seconds;
    load.taken = receiver.taken();
    load.droppedBySystem = receiver.droppedBySystem();
    return load;
}

Load measureArtNet(int universes, double fps, double seconds, bool latches) {
    ReceiverConfig config;
    config.address = "127.0.0.1";
    config.port = 0;
    UniverseStore store;
    const Receiver receiver(config, store);
    const Listening listening{receiver.port(), [&] { return receiver.counters().dmx; },
                              [&] { return receiver.counters().droppedBySystem; }};
    return measureLoad(listening, store, artNetFrame(universes), fps, seconds, latches);
}

Load measureSacn(int universes, double fps, double seconds, bool latches) {
    SacnReceiverConfig config;
    config.interface = "lo";
    config.port = 0;
    UniverseStore store;
    const SacnReceiver receiver(config, store);
    const Listening listening{receiver.port(), [&] { return receiver.counters().levels; },
                              [&] { return receiver.droppedBySystem(); }};
    return measureLoad(listening, store, sacnFrame(universes), fps, seconds, latches);
}

double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

void printLoad(const char* protocol, int universes, double fps, Load load) {
    fmt::print("| {}, {} universes at {:.0f} Hz, {:.0f} s | {} sent, {} lost ({} by the system) |\n",
               protocol, universes, fps, load.seconds, load.sent, load.sent - load.taken,
               load.droppedBySystem);
    fmt::print("| receive and merge thread | {:.1f} % of a core |\n", 100.0 * load.receiverShare);
    fmt::print("| packet to store | median {:.0f} us, p99 {:.0f} us |\n", quantile(load.latenciesUs, 0.5),
               quantile(load.latenciesUs, 0.99));
}

/// Doubles the rate from that of the show until packets are lost.
void printLimit(int universes, double fps) {
    double lossless = 0.0;
    for (double rate = fps; rate < 4000.0; rate *= 1.25) {
        const Load load = measureArtNet(universes, rate, 2.0, false);
        if (load.taken < load.sent) {
            fmt::print("| first loss | at {:.0f} packets/s: {} of {} |\n",
                       static_cast<double>(load.sent) / load.seconds, load.sent - load.taken, load.sent);
            break;
        }
        const double achieved = static_cast<double>(load.sent) / load.seconds;
        if (achieved < lossless) break;  // the sender can no more
        lossless = achieved;
    }
    fmt::print("| highest rate without loss | {:.0f} packets/s = {:.0f} universes at 44 Hz |\n", lossless,
               lossless / 44.0);
}

/// Memory of this process [MiB].
double residentMiB() {
    std::ifstream stream("/proc/self/statm");
    std::uint64_t total = 0;
    std::uint64_t resident = 0;
    stream >> total >> resident;
    return static_cast<double>(resident) * 4096.0 / 1048576.0;
}

/// Datagrams that nobody wants: random bytes, and packets of the protocol that are sound up to a random
/// place.
std::vector<Bytes> garbage(const Frame& frame) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> anyByte(0, 255);
    std::vector<Bytes> datagrams;
    for (std::size_t i = 0; i < 4096; ++i) {
        Bytes datagram = frame.packets[i % frame.packets.size()];
        const std::size_t sound = i % 2 == 0 ? 0 : random() % datagram.size();
        for (std::size_t at = sound; at < datagram.size(); ++at) {
            datagram[at] = static_cast<std::uint8_t>(anyByte(random));
        }
        datagram.resize(sound + random() % (datagram.size() - sound) + 1);
        datagrams.push_back(std::move(datagram));
    }
    return datagrams;
}

/// Sound packets of sACN, each of a source and a universe that never were before.
std::vector<Bytes> newSources(const Frame& frame) {
    std::mt19937 random(2);
    std::vector<Bytes> datagrams;
    for (std::size_t i = 0; i < 65536; ++i) {
        Bytes datagram = frame.packets[i % frame.packets.size()];
        for (std::size_t at = 22; at < 38; ++at) datagram[at] = static_cast<std::uint8_t>(random());
        const auto universe = static_cast<std::uint16_t>(1 + random() % kMaxSacnUniverse);
        datagram[113] = static_cast<std::uint8_t>(universe >> 8);
        datagram[114] = static_cast<std::uint8_t>(universe);
        datagrams.push_back(std::move(datagram));
    }
    return datagrams;
}

/// Sends datagrams in turn, `perS` a second, from its construction to its destruction.
class Flood {
 public:
    Flood(std::uint16_t port, std::vector<Bytes> datagrams, double perS)
        : socket_(context_, asio::ip::udp::v4()), datagrams_(std::move(datagrams)) {
        socket_.bind({asio::ip::make_address("127.0.0.2"), 0});  // not the desk's
        socket_.connect({asio::ip::address_v4::loopback(), port});
        thread_ = std::jthread([this, perS](const std::stop_token& stop) { run(stop, perS); });
    }

    std::uint64_t sent() const { return sent_; }
    double cpuS() const { return cpuS_; }

 private:
    void run(const std::stop_token& stop, double perS) {
        const TimePoint start = Clock::now();
        std::error_code failure;
        while (!stop.stop_requested()) {
            const auto due = static_cast<std::uint64_t>(secondsSince(start) * perS);
            for (; sent_ < due; ++sent_) {
                socket_.send(asio::buffer(datagrams_[sent_ % datagrams_.size()]), 0, failure);
            }
            cpuS_ = cpuSeconds(RUSAGE_THREAD);
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    }

    asio::io_context context_;
    asio::ip::udp::socket socket_;
    std::vector<Bytes> datagrams_;
    std::atomic<std::uint64_t> sent_ = 0;
    std::atomic<double> cpuS_ = 0.0;
    std::jthread thread_;
};

/// A desk beside a flood: what of its packets arrives, how long a frame waits for its universes, and memory
/// once the flood has filled what it can fill, and at the end.
void printFlood(const char* what, const Listening& receiver, UniverseStore& store, const Frame& frame,
                std::vector<Bytes> datagrams, const Options& options) {
    constexpr double kFps = 44.0;
    Flood flood(receiver.port, std::move(datagrams), options.floodPerS);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    const double memoryBefore = residentMiB();
    const std::uint64_t takenBefore = receiver.taken();
    const std::uint64_t droppedBefore = receiver.droppedBySystem();
    const std::uint64_t floodBefore = flood.sent();
    const double othersBefore = cpuSeconds(RUSAGE_THREAD) + flood.cpuS();
    const double processBefore = cpuSeconds(RUSAGE_SELF);
    std::atomic<bool> isOver = false;
    std::uint64_t sent = 0;
    double deskCpuS = 0.0;
    const TimePoint start = Clock::now();
    std::thread desk([&] {
        sent = Desk(receiver.port, frame).play(kFps, options.seconds, deskCpuS);
        isOver = true;
    });
    std::vector<double> latchesUs;
    UniverseSet set;
    while (!isOver) {
        std::this_thread::sleep_for(std::chrono::milliseconds(16));
        const TimePoint before = Clock::now();
        store.latch(set, before);
        latchesUs.push_back(1e6 * secondsSince(before));
    }
    desk.join();
    const double passedS = secondsSince(start);
    const double floodPerS = static_cast<double>(flood.sent() - floodBefore) / passedS;
    const double others = cpuSeconds(RUSAGE_THREAD) + flood.cpuS() - othersBefore + deskCpuS;
    const double receiverShare = (cpuSeconds(RUSAGE_SELF) - processBefore - others) / passedS;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    fmt::print("| {} | {:.0f} datagrams/s; the desk: {} sent, {} taken; {} of all lost by the system |\n",
               what, floodPerS, sent, receiver.taken() - takenBefore,
               receiver.droppedBySystem() - droppedBefore);
    fmt::print("| receive and merge thread; memory | {:.0f} % of a core; {:.1f} MiB, then {:.1f} MiB |\n",
               100.0 * receiverShare, memoryBefore, residentMiB());
    fmt::print("| a frame waits for its universes | median {:.0f} us, p99 {:.0f} us, worst {:.0f} us |\n",
               quantile(latchesUs, 0.5), quantile(latchesUs, 0.99), quantile(latchesUs, 1.0));
}

std::uint64_t takenOfDesk(UniverseStore& store) {
    std::uint64_t count = 0;
    for (const UniverseStatus& status : store.status(Clock::now())) {
        for (const SourceStatus& source : status.sources) {
            if (source.address == "127.0.0.1") count += source.packetCount;
        }
    }
    return count;
}

/// The universes of the desk are patched, as they are in a show: they always have room.
void askFor(const Frame& frame, UniverseId first, UniverseStore& store) {
    store.change([&](UniverseMerger& merger) {
        for (std::size_t i = 0; i < frame.packets.size(); ++i, ++first.number) merger.ask(first);
    });
}

void printArtNetFlood(const Options& options) {
    const Frame frame = artNetFrame(64);
    ReceiverConfig config;
    config.address = "127.0.0.1";
    config.port = 0;
    UniverseStore store;
    askFor(frame, {Transport::kArtNet, 0}, store);
    const Receiver receiver(config, store);
    const Listening listening{receiver.port(), [&] { return takenOfDesk(store); },
                              [&] { return receiver.counters().droppedBySystem; }};
    printFlood("garbage beside Art-Net", listening, store, frame, garbage(frame), options);
}

void printSacnFlood(const char* what, std::vector<Bytes> datagrams, const Options& options) {
    const Frame frame = sacnFrame(64);
    SacnReceiverConfig config;
    config.interface = "lo";
    config.port = 0;
    UniverseStore store;
    askFor(frame, {Transport::kSacn, 1}, store);
    const SacnReceiver receiver(config, store);
    const Listening listening{receiver.port(), [&] { return takenOfDesk(store); },
                              [&] { return receiver.droppedBySystem(); }};
    printFlood(what, listening, store, frame, std::move(datagrams), options);
}

void printFloods(const Options& options) {
    printArtNetFlood(options);
    printSacnFlood("garbage beside sACN", garbage(sacnFrame(64, 2)), options);
    printSacnFlood("new sources without end beside sACN", newSources(sacnFrame(64)), options);
}

Options parse(int argc, char** argv) {
    Options options;
    CLI::App app{"What it costs to have Art-Net and sACN in the store"};
    app.add_option("--universes", options.universes)->check(CLI::Range(1, 32768));
    app.add_option("--fps", options.fps)->check(CLI::Range(1.0, 1000.0));
    app.add_option("--seconds", options.seconds)->check(CLI::Range(1.0, 3600.0));
    app.add_flag("--no-limit", options.skipsLimit, "Do not look for the highest rate");
    app.add_option("--flood", options.floodPerS, "Only this: garbage a second beside a desk")
        ->check(CLI::Range(1.0, 1e7));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error));
    }
    return options;
}

void printCost(const char* what, const Cost& cost) {
    fmt::print("| {} | {:.0f} ns, {:.3f} allocations |\n", what, cost.nanoseconds, cost.allocations);
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    const Frame frame = artNetFrame(options.universes);
    const Frame sacn = sacnFrame(options.universes);
    fmt::print("| what | measured |\n|---|---|\n");
    if (options.floodPerS > 0.0) {
        printFloods(options);
        return 0;
    }
    printCost("baseline: parse one ArtDmx and copy its slots", costOfCopying(frame));
    printCost("parse and merge one ArtDmx, one source", costOfMerging(frame, 1));
    printCost("the same, two sources", costOfMerging(frame, 2));
    printCost("parse and merge one sACN packet, one source", costOfMergingSacn(sacn, 1));
    printCost("the same, two sources", costOfMergingSacn(sacn, 2));
    const Cost latch = costOfLatching(frame);
    fmt::print("| latch {} universes | {:.0f} us, {:.3f} allocations |\n", options.universes,
               latch.nanoseconds / 1000.0, latch.allocations);
    printLoad("Art-Net", options.universes, options.fps,
              measureArtNet(options.universes, options.fps, options.seconds, true));
    printLoad("sACN", options.universes, options.fps,
              measureSacn(options.universes, options.fps, options.seconds, true));
    if (!options.skipsLimit) printLimit(options.universes, options.fps);
}
