#include "protocol/artnet_ports.h"

#include <algorithm>

namespace hazer::protocol {
namespace {

// A field of a Port-Address after a switch byte: what it is now, what it is by patch, or what the byte says.
int switched(std::uint8_t switchByte, int now, int patched, int mask) {
    if (switchByte == kSwitchReset) return patched & mask;
    return switchByte & kSwitchProgram ? switchByte & mask : now & mask;
}

}  // namespace

ArtNetPorts::ArtNetPorts(std::vector<std::uint16_t> portAddresses) {
    std::ranges::sort(portAddresses);
    portAddresses.erase(std::unique(portAddresses.begin(), portAddresses.end()), portAddresses.end());
    for (const std::uint16_t portAddress : portAddresses) {
        ArtNetPort& port = ports_.emplace_back();
        port.patched = port.onWire = portAddress;
    }
}

ArtNetPort* ArtNetPorts::atBindIndex(std::uint8_t bindIndex) {
    const std::size_t index = bindIndex == 0 ? 0 : bindIndex - 1U;
    return index < ports_.size() ? &ports_[index] : nullptr;
}

std::optional<std::uint16_t> ArtNetPorts::universeOf(std::uint16_t onWire) const {
    if (!hasMoved_) return onWire;
    const auto port = std::ranges::find(ports_, onWire, &ArtNetPort::onWire);
    if (port != ports_.end()) return port->patched;
    const bool hasMovedAway = std::ranges::binary_search(ports_, onWire, {}, &ArtNetPort::patched);
    return hasMovedAway ? std::nullopt : std::optional(onWire);
}

bool ArtNetPorts::program(ArtNetPort& port, const ArtAddress& address) {
    const int net = switched(address.netSwitch, port.onWire >> 8, port.patched >> 8, 0x7F);
    const int subNet = switched(address.subSwitch, port.onWire >> 4, port.patched >> 4, 0x0F);
    const int universe = switched(address.swOut[0], port.onWire, port.patched, 0x0F);
    const auto programmed = static_cast<std::uint16_t>(net << 8 | subNet << 4 | universe);
    const bool isChanged = programmed != port.onWire;
    port.onWire = programmed;
    hasMoved_ =
        std::ranges::any_of(ports_, [](const ArtNetPort& each) { return each.onWire != each.patched; });
    return isChanged;
}

std::optional<ArtNetPortChange> ArtNetPorts::update(std::size_t index, UniverseMerger& merger,
                                                    TimePoint now) {
    ArtNetPort& port = ports_[index];
    const UniverseId universe{Transport::kArtNet, port.patched};
    const bool isReceiving = merger.isLive(universe, now);
    const bool isMerging = merger.isMerging(universe, now);
    const MergeMode mode = merger.mode(universe);
    const bool hasMergingChanged = isMerging != port.isMerging;
    if (!hasMergingChanged && isReceiving == port.isReceiving && mode == port.mode) return std::nullopt;
    port.isReceiving = isReceiving;
    port.isMerging = isMerging;
    port.mode = mode;
    return ArtNetPortChange{port.onWire, isMerging, hasMergingChanged};
}

}  // namespace hazer::protocol
