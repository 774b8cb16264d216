#include "tests/protocol/packets.h"

#include <algorithm>
#include <iterator>

namespace hazer::protocol::test {
namespace {

std::uint8_t highByte(std::size_t value) {
    return static_cast<std::uint8_t>(value >> 8);
}
std::uint8_t lowByte(std::size_t value) {
    return static_cast<std::uint8_t>(value & 0xFF);
}

}  // namespace

Bytes dmxDatagram(const DmxFields& fields) {
    const std::size_t length = fields.claimedLength.value_or(static_cast<std::uint16_t>(fields.slots.size()));
    const std::uint8_t header[] = {'A',
                                   'r',
                                   't',
                                   '-',
                                   'N',
                                   'e',
                                   't',
                                   0,
                                   0x00,
                                   0x50,
                                   0,
                                   14,
                                   fields.sequence,
                                   fields.physical,
                                   fields.subUni,
                                   fields.net,
                                   highByte(length),
                                   lowByte(length)};
    Bytes datagram(std::size(header) + fields.slots.size());
    const auto slots = std::ranges::copy(header, datagram.begin()).out;
    std::ranges::copy(fields.slots, slots);
    return datagram;
}

Bytes pollDatagram() {
    Bytes datagram{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x20, 0, 14, 0x02, 0x10};
    datagram.resize(22);
    return datagram;
}

Bytes targetedPollDatagram(std::uint16_t first, std::uint16_t last) {
    Bytes datagram = pollDatagram();
    datagram[12] = 0x20;
    datagram[14] = highByte(last);
    datagram[15] = lowByte(last);
    datagram[16] = highByte(first);
    datagram[17] = lowByte(first);
    return datagram;
}

Bytes prefixOf(std::span<const std::uint8_t> bytes, std::size_t size) {
    return Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace hazer::protocol::test
