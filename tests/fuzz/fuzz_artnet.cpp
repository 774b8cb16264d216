// Any bytes as an Art-Net datagram.
#include <algorithm>
#include <cstdlib>

#include "protocol/artnet.h"

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

// What is packed from a packet is read as the same packet.
void checkTimeCode(const ArtTimeCode& code) {
    const auto packed = packArtTimeCode(code);
    const ArtNetPacket again = parseArtNet(packed);
    const auto* copy = std::get_if<ArtTimeCode>(&again);
    require(copy && copy->timeS() == code.timeS() && code.timeS() >= 0.0 && code.timeS() < 86401.0);
}

void checkTrigger(const ArtTrigger& trigger) {
    const auto packed = packArtTrigger(trigger);
    const ArtNetPacket again = parseArtNet(packed);
    const auto* copy = std::get_if<ArtTrigger>(&again);
    require(copy && copy->oem == trigger.oem && copy->key == trigger.key && copy->subKey == trigger.subKey);
}

void checkReply(const PeerPollReply& reply) {
    require(reply.shortName.size() <= 18 && reply.longName.size() <= 64);
    for (const auto& wanted : reply.wanted) require(!wanted || *wanted <= kMaxPortAddress);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span datagram(data, size);
    const ArtNetPacket packet = parseArtNet(datagram);
    if (const auto* dmx = std::get_if<ArtDmx>(&packet)) checkDmx(*dmx);
    if (const auto* code = std::get_if<ArtTimeCode>(&packet)) checkTimeCode(*code);
    if (const auto* trigger = std::get_if<ArtTrigger>(&packet)) checkTrigger(*trigger);
    if (const auto* reply = std::get_if<PeerPollReply>(&packet)) checkReply(*reply);
    return 0;
}
