// Any bytes as an Art-Net datagram: through the parser, and through a node that remembers earlier ones.
#include <algorithm>
#include <cstdlib>

#include "protocol/artnet.h"
#include "protocol/artnet_node.h"

namespace {

using namespace hazer::protocol;

void require(bool condition) {
    if (!condition) std::abort();
}

// What was parsed keeps its promises, and is the same after it is packed and parsed again.
void checkDmx(const ArtDmx& dmx) {
    require(dmx.portAddress <= kMaxPortAddress);
    require(!dmx.slots.empty() && dmx.slots.size() <= kSlotCount);
    const auto packed = packArtDmx(dmx.portAddress, dmx.sequence, dmx.slots);
    const ArtNetPacket again = parseArtNet(packed);
    const auto* copy = std::get_if<ArtDmx>(&again);
    require(copy && copy->portAddress == dmx.portAddress && copy->sequence == dmx.sequence);
    require(std::ranges::equal(copy->slots.first(dmx.slots.size()), dmx.slots));
}

std::uint64_t total(const ReceiverCounters& c) {
    return c.dmx + c.late + c.refused + c.polls + c.ignored + c.malformed;
}

// The datagram twice, then the replies it is owed.
void checkNode(std::span<const std::uint8_t> datagram) {
    const TimePoint start{std::chrono::hours(1)};
    const Endpoint desk{{10, 0, 0, 1}, kArtNetPort};
    UniverseMerger merger;
    ArtNetNode node({.portAddresses = {0, 1, kMaxPortAddress}});
    node.receive(datagram, desk, start, merger);
    node.receive(datagram, desk, start + std::chrono::milliseconds(10), merger);
    require(total(node.counters()) == 2);
    while (const auto reply = node.takeDueReply(start + std::chrono::seconds(1))) {
        require(node.packReply(*reply, {10, 0, 0, 9}).size() <= 3);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span datagram(data, size);
    const ArtNetPacket packet = parseArtNet(datagram);
    if (const auto* dmx = std::get_if<ArtDmx>(&packet)) checkDmx(*dmx);
    checkNode(datagram);
    return 0;
}
