#include "protocol/recording/usb_wrapping.h"

#include <algorithm>

namespace hazer::protocol {
namespace {

constexpr std::array<std::uint8_t, 8> kMark{'h', 'a', 'z', 'e', 'r', 'U', 'S', 'B'};

}  // namespace

std::vector<std::uint8_t> wrapUsbFrame(const UsbFrame& frame, std::uint8_t sequence) {
    SacnData data;
    const auto behindMark = std::ranges::copy(kMark, data.cid.begin()).out;
    std::copy_n(frame.source.id.begin(), data.cid.size() - kMark.size(), behindMark);
    data.sourceName = frame.name;
    data.sequence = sequence;
    data.universe = frame.line;
    data.startCode = frame.startCode;
    data.slots = frame.slots;
    return packSacnData(data);
}

bool isWrappedUsbFrame(std::span<const std::uint8_t> datagram) {
    constexpr std::size_t kCidOffset = 22;
    return datagram.size() >= kCidOffset + kMark.size() &&
           std::ranges::equal(datagram.subspan(kCidOffset, kMark.size()), kMark);
}

std::optional<UsbFrame> unwrapUsbFrame(const SacnData& data) {
    if (!std::equal(kMark.begin(), kMark.end(), data.cid.begin())) return std::nullopt;
    UsbFrame frame;
    frame.line = data.universe;
    frame.source.transport = Transport::kDmx;
    std::copy(data.cid.begin() + kMark.size(), data.cid.end(), frame.source.id.begin());
    frame.name = data.sourceName;
    frame.startCode = data.startCode;
    frame.slots = data.slots;
    return frame;
}

void UsbRecording::record(UniverseId universe, std::span<const std::uint8_t> slots, WallTime time) {
    if (universe.number == 0 || universe.number > kMaxSacnUniverse) return;
    const auto high = static_cast<std::uint8_t>(universe.number >> 8);
    const auto low = static_cast<std::uint8_t>(universe.number & 0xFF);
    const IpEndpoint from{{127, 0, 0, 1}, false, kSacnPort};
    const IpEndpoint group{{239, 255, high, low}, false, kSacnPort};
    const UsbFrame frame{.line = universe.number, .name = "USB DMX", .slots = slots};
    const std::vector<std::uint8_t> bytes = wrapUsbFrame(frame, sequences_[universe]++);
    recorder_.record({from, group, time, bytes});
}

}  // namespace hazer::protocol
