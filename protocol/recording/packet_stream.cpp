#include "protocol/recording/packet_stream.h"

#include <algorithm>

#include "protocol/artnet.h"
#include "protocol/sacn.h"

namespace hazer::protocol {
namespace {

constexpr std::size_t kArtDmxSequenceOffset = 12;
constexpr std::size_t kSacnDataSequenceOffset = 111;
constexpr std::size_t kSacnSyncSequenceOffset = 44;

StreamedPacket streamOf(const ArtDmx& dmx, const IpEndpoint& from) {
    StreamedPacket packet;
    const auto behindAddress = std::copy_n(from.address.begin(), 4, packet.stream.source.begin());
    behindAddress[0] = static_cast<std::uint8_t>(from.port >> 8);
    behindAddress[1] = static_cast<std::uint8_t>(from.port & 0xFF);
    behindAddress[2] = dmx.physical;
    packet.stream.number = dmx.portAddress;
    packet.sequenceOffset = kArtDmxSequenceOffset;
    packet.holdsLevels = true;
    return packet;
}

StreamedPacket streamOf(const SacnData& data) {
    StreamedPacket packet;
    packet.stream = {Transport::kSacn, false, data.cid, data.universe};
    packet.sequenceOffset = kSacnDataSequenceOffset;
    packet.startCode = data.startCode;
    packet.holdsLevels = true;
    packet.ends = data.isTerminated;
    return packet;
}

StreamedPacket streamOf(const SacnSync& sync) {
    StreamedPacket packet;
    packet.stream = {Transport::kSacn, true, sync.cid, sync.syncAddress};
    packet.sequenceOffset = kSacnSyncSequenceOffset;
    return packet;
}

}  // namespace

std::optional<StreamedPacket> streamOf(std::span<const std::uint8_t> datagram, const IpEndpoint& from) {
    const ArtNetPacket artNet = parseArtNet(datagram);
    if (const auto* dmx = std::get_if<ArtDmx>(&artNet)) return streamOf(*dmx, from);
    const SacnPacket sacn = parseSacn(datagram);
    if (const auto* data = std::get_if<SacnData>(&sacn)) return streamOf(*data);
    if (const auto* sync = std::get_if<SacnSync>(&sacn)) return streamOf(*sync);
    return std::nullopt;
}

}  // namespace hazer::protocol
