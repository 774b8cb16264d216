#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol::test {
namespace {

void append16(Bytes& to, std::size_t value) {
    to.push_back(static_cast<std::uint8_t>(value >> 8));
    to.push_back(static_cast<std::uint8_t>(value & 0xFF));
}

void append32(Bytes& to, std::uint32_t value) {
    append16(to, value >> 16);
    append16(to, value & 0xFFFF);
}

void append(Bytes& to, const Bytes& bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

Bytes padded(const std::string& text, std::size_t size) {
    Bytes bytes(text.begin(), text.end());
    bytes.resize(size);
    return bytes;
}

// Flags, length and content of a protocol data unit.
Bytes pdu(const Bytes& content) {
    Bytes bytes;
    append16(bytes, 0x7000 | (content.size() + 2));
    append(bytes, content);
    return bytes;
}

Bytes packet(std::uint32_t rootVector, std::uint8_t cid, const Bytes& framingContent) {
    Bytes root;
    append32(root, rootVector);
    append(root, Bytes(16, cid));
    append(root, pdu(framingContent));
    Bytes bytes{0, 16, 0, 0, 'A', 'S', 'C', '-', 'E', '1', '.', '1', '7', 0, 0, 0};
    append(bytes, pdu(root));
    return bytes;
}

}  // namespace

Bytes sacnData(const SacnDataFields& fields) {
    Bytes dmp{2, 0xA1, 0, 0, 0, 1};
    append16(dmp, fields.claimedCount.value_or(static_cast<std::uint16_t>(1 + fields.slots.size())));
    dmp.push_back(fields.startCode);
    append(dmp, fields.slots);
    Bytes framing;
    append32(framing, 2);
    append(framing, padded(fields.name, 64));
    framing.push_back(fields.priority);
    append16(framing, fields.syncAddress);
    framing.push_back(fields.sequence);
    framing.push_back(fields.options);
    append16(framing, fields.universe);
    append(framing, pdu(dmp));
    return packet(4, fields.cid, framing);
}

Bytes sacnSync(std::uint16_t syncAddress, std::uint8_t sequence, std::uint8_t cid) {
    Bytes framing;
    append32(framing, 1);
    framing.push_back(sequence);
    append16(framing, syncAddress);
    append16(framing, 0);
    return packet(8, cid, framing);
}

Bytes sacnDiscovery(const SacnDiscoveryFields& fields) {
    Bytes list;
    append32(list, 1);
    list.push_back(fields.page);
    list.push_back(fields.lastPage);
    for (const std::uint16_t universe : fields.universes) append16(list, universe);
    Bytes framing;
    append32(framing, 2);
    append(framing, padded(fields.name, 64));
    append32(framing, 0);
    append(framing, pdu(list));
    return packet(8, fields.cid, framing);
}

Bytes olaDraftDiscovery() {
    Bytes framing;
    append32(framing, 4);
    append(framing, padded("viz-loop", 64));
    framing.resize(framing.size() + 7);
    append(framing, pdu({0, 1, 0, 2}));
    return packet(4, 1, framing);
}

}  // namespace hazer::protocol::test
