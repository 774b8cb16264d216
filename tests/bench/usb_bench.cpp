// What it costs to have DMX from USB in the store: nanoseconds for each USB packet and for each frame, beside
// a mere copy of the same bytes in the same run; and a look for interfaces that are not there.
//     usb_bench
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include "protocol/universe_merger.h"
#include "protocol/usb/ftdi_widget.h"
#include "protocol/usb/usb_interfaces.h"
#include "tests/protocol/allocation_counter.h"

namespace {

using namespace hazer::protocol;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kPacketSize = 64;

/// `bytes` as a chip of full speed sends them, a break at the end if asked for.
std::vector<Bytes> packetsOf(const Bytes& bytes, bool endsWithBreak) {
    constexpr std::size_t kPayload = kPacketSize - 2;
    std::vector<Bytes> packets;
    for (std::size_t at = 0; at < bytes.size(); at += kPayload) {
        Bytes packet{0x01, 0x60};
        packet.insert(packet.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at + kPayload, bytes.size())));
        packets.push_back(std::move(packet));
    }
    if (endsWithBreak) packets.back()[1] = 0x70;
    return packets;
}

std::vector<Bytes> proFrame() {
    return packetsOf(packEnttec(EnttecLabel::kReceivedDmx, Bytes(2 + kSlotCount)), false);
}

std::vector<Bytes> openFrame() {
    return packetsOf(Bytes(kFrameSize + 1), true);
}

struct Cost {
    double packetNs = 0.0;
    double frameNs = 0.0;
    double allocations = 0.0;  // for each frame
};

/// Runs `once()`, which handles one frame of `packets` packets, for half a second after a warm-up.
template <class Once>
Cost costOf(std::size_t packets, Once once) {
    for (int i = 0; i < 100; ++i) once();
    const std::size_t allocations = hazer::test::allocationCount();
    const TimePoint start = Clock::now();
    double frames = 0.0;
    while (Clock::now() - start < std::chrono::milliseconds(500)) {
        for (int i = 0; i < 100; ++i) once();
        frames += 100.0;
    }
    const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count() / frames;
    return {ns / static_cast<double>(packets), ns,
            static_cast<double>(hazer::test::allocationCount() - allocations) / frames};
}

Cost costOfCopying(const std::vector<Bytes>& frame) {
    std::array<std::uint8_t, 1024> copy{};
    return costOf(frame.size(), [&] {
        auto end = copy.begin();
        for (const Bytes& packet : frame) end = std::ranges::copy(packet, end).out;
        asm volatile("" : : "r"(copy.data()) : "memory");
    });
}

Cost costOfReceiving(std::vector<Bytes> frame) {
    UniverseMerger merger;
    TimePoint now{std::chrono::hours(1)};
    FtdiWidget widget(kPacketSize, now);
    const ShowSlots show = [&](std::span<const std::uint8_t> slots) {
        merger.show({.universe = {Transport::kDmx, 1}, .source = {Transport::kDmx, {}}, .slots = slots}, now);
    };
    return costOf(frame.size(), [&] {
        now += std::chrono::milliseconds(23);
        if (frame.back().size() > kPacketSize / 4) ++frame.back()[kPacketSize / 4];  // a slot of each frame
        for (const Bytes& packet : frame) widget.receive(packet, now, show);
    });
}

/// In a folder that looks like sysfs on a machine with keyboards and hubs, but without an interface.
Cost costOfLooking() {
    const auto sysfs = std::filesystem::temp_directory_path() / "hazer-usb-bench";
    for (int i = 0; i < 12; ++i) {
        const auto device = sysfs / "bus/usb/devices" / fmt::format("1-{}", i);
        std::filesystem::create_directories(device.string() + ":1.0");
        std::filesystem::create_directories(device);
        std::ofstream(device / "idVendor") << "046d\n";
        std::ofstream(device / "idProduct") << "c31c\n";
    }
    const Cost cost = costOf(1, [&] { findUsbInterfaces(sysfs); });
    std::filesystem::remove_all(sysfs);
    return cost;
}

void print(const char* what, const Cost& cost) {
    fmt::print("{:<34} {:>8.0f} ns/packet {:>8.0f} ns/frame {:>6.2f} allocations/frame\n", what,
               cost.packetNs, cost.frameNs, cost.allocations);
}

}  // namespace

int main() {
    print("copying 512 slots", costOfCopying(proFrame()));
    print("Pro: to the merged universe", costOfReceiving(proFrame()));
    print("Open DMX: to the merged universe", costOfReceiving(openFrame()));
    print("a bare status packet", costOfReceiving({Bytes{0x01, 0x60}}));
    fmt::print("{:<34} {:>8.0f} us\n", "a look for interfaces", 1e-3 * costOfLooking().frameNs);
}
