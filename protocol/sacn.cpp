#include "protocol/sacn.h"

#include <algorithm>
#include <cassert>

#include "protocol/byte_reader.h"
#include "protocol/field_writer.h"

namespace hazer::protocol {
namespace {

// ANSI E1.17 over UDP: preamble size, post-amble size and the packet identifier, all in one.
constexpr std::array<std::uint8_t, 16> kPreamble{0x00, 0x10, 0x00, 0x00, 'A', 'S', 'C', '-',
                                                 'E',  '1',  '.',  '1',  '7', 0,   0,   0};

constexpr std::uint32_t kRootVectorData = 4;
constexpr std::uint32_t kRootVectorExtended = 8;
constexpr std::uint32_t kDataVectorPacket = 2;
constexpr std::uint32_t kExtendedVectorSync = 1;
constexpr std::uint32_t kExtendedVectorDiscovery = 2;
constexpr std::uint32_t kDiscoveryVectorList = 1;
constexpr std::uint8_t kDmpVectorSetProperty = 2;
constexpr std::uint8_t kDmpAddressType = 0xA1;
constexpr std::uint16_t kDmpFirstAddress = 0;
constexpr std::uint16_t kDmpIncrement = 1;

constexpr std::uint8_t kOptionPreview = 0x80;
constexpr std::uint8_t kOptionTerminated = 0x40;
constexpr std::uint8_t kOptionForceSync = 0x20;

constexpr std::size_t kFlagsAndLengthSize = 2;
constexpr std::uint16_t kPduFlags = 0x7000;
constexpr std::uint16_t kPduLengthMask = 0x0FFF;

constexpr std::size_t kFramingOffset = 38;    // of every packet: here its root layer ends
constexpr std::size_t kDataHeaderSize = 126;  // up to the start code, it included
constexpr std::size_t kDmpOffset = 115;
constexpr std::size_t kSyncSize = 49;
constexpr std::size_t kDiscoveryHeaderSize = 120;
constexpr std::size_t kDiscoveryListOffset = 112;

// A protocol data unit begins with four bits of flags and its own length of twelve, these two bytes included.
// Narrows `inside` to the PDU that begins there. A PDU may end before what contains it, never behind.
bool enterPdu(ByteReader& inside) {
    const std::size_t available = inside.remaining();
    const std::uint16_t flagsAndLength = inside.u16BigEndian();
    const std::size_t length = flagsAndLength & kPduLengthMask;
    if ((flagsAndLength & ~kPduLengthMask) != kPduFlags) return false;
    if (length < kFlagsAndLengthSize || length > available) return false;
    inside = ByteReader(inside.take(length - kFlagsAndLengthSize));
    return true;
}

// What a PDU that cannot be entered means: one that claims more than arrived was cut on its way.
SacnRefusal refusalOfPdu(ByteReader inside) {
    const std::size_t available = inside.remaining();
    const std::uint16_t flagsAndLength = inside.u16BigEndian();
    const bool wasCut = inside.failed() || (flagsAndLength & kPduLengthMask) > available;
    return wasCut ? SacnRefusal::kTruncated : SacnRefusal::kBadLength;
}

template <typename Array>
Array takeArray(ByteReader& reader) {
    Array array{};
    const auto bytes = reader.take(array.size());
    std::ranges::copy(bytes, array.begin());
    return array;
}

// The field should end with a NUL. One that does not loses its last byte, as if it did.
std::string_view takeName(ByteReader& reader) {
    const auto field = reader.take(kSacnNameSize);
    if (field.empty()) return {};
    const auto name = field.first(kSacnNameSize - 1);
    const auto end = std::ranges::find(name, std::uint8_t{0});
    return {reinterpret_cast<const char*>(name.data()), static_cast<std::size_t>(end - name.begin())};
}

bool isUniverse(std::uint16_t number) {
    return number >= 1 && number <= kMaxSacnUniverse;
}

SacnPacket parseProperties(ByteReader dmp, SacnData data) {
    const std::uint8_t vector = dmp.u8();
    const std::uint8_t addressType = dmp.u8();
    const std::uint16_t firstAddress = dmp.u16BigEndian();
    const std::uint16_t increment = dmp.u16BigEndian();
    const std::size_t valueCount = dmp.u16BigEndian();  // of the start code and the slots
    data.startCode = dmp.u8();
    if (dmp.failed()) return SacnRefusal::kBadLength;
    if (vector != kDmpVectorSetProperty || addressType != kDmpAddressType ||
        firstAddress != kDmpFirstAddress || increment != kDmpIncrement) {
        return SacnRefusal::kBadField;
    }
    if (valueCount < 1) return SacnRefusal::kBadLength;
    if (valueCount - 1 > dmp.remaining()) return SacnRefusal::kBadLength;
    data.slots = dmp.take(std::min(valueCount - 1, kSlotCount));
    return data;
}

SacnPacket parseData(ByteReader framing, const Cid& cid) {
    if (framing.u32BigEndian() != kDataVectorPacket) {
        return framing.failed() ? SacnRefusal::kBadLength : SacnRefusal::kUnusedVector;
    }
    SacnData data;
    data.cid = cid;
    data.sourceName = takeName(framing);
    data.priority = framing.u8();
    data.syncAddress = framing.u16BigEndian();
    data.sequence = framing.u8();
    const std::uint8_t options = framing.u8();
    data.isPreview = options & kOptionPreview;
    data.isTerminated = options & kOptionTerminated;
    data.forcesSync = options & kOptionForceSync;
    data.universe = framing.u16BigEndian();
    if (framing.failed()) return SacnRefusal::kBadLength;
    if (data.priority > kMaxPriority) return SacnRefusal::kBadPriority;
    if (!isUniverse(data.universe)) return SacnRefusal::kBadField;
    if (!enterPdu(framing)) return SacnRefusal::kBadLength;
    return parseProperties(framing, data);
}

SacnPacket parseSync(ByteReader& framing, const Cid& cid) {
    SacnSync sync;
    sync.cid = cid;
    sync.sequence = framing.u8();
    sync.syncAddress = framing.u16BigEndian();
    framing.take(2);  // reserved
    if (framing.failed()) return SacnRefusal::kBadLength;
    return sync;
}

SacnPacket parseDiscovery(ByteReader& framing, const Cid& cid) {
    SacnDiscovery discovery;
    discovery.cid = cid;
    discovery.sourceName = takeName(framing);
    framing.take(4);  // reserved
    if (framing.failed() || !enterPdu(framing)) return SacnRefusal::kBadLength;
    const std::uint32_t vector = framing.u32BigEndian();
    discovery.page = framing.u8();
    discovery.lastPage = framing.u8();
    if (framing.failed()) return SacnRefusal::kBadLength;
    if (vector != kDiscoveryVectorList) return SacnRefusal::kUnusedVector;
    if (discovery.page > discovery.lastPage) return SacnRefusal::kBadField;
    if (framing.remaining() % 2 != 0 || framing.remaining() > 2 * kSacnUniversesPerPage) {
        return SacnRefusal::kBadLength;
    }
    discovery.universeBytes = framing.take(framing.remaining());
    return discovery;
}

SacnPacket parseExtended(ByteReader framing, const Cid& cid) {
    const std::uint32_t vector = framing.u32BigEndian();
    if (framing.failed()) return SacnRefusal::kBadLength;
    if (vector == kExtendedVectorSync) return parseSync(framing, cid);
    if (vector == kExtendedVectorDiscovery) return parseDiscovery(framing, cid);
    return SacnRefusal::kUnusedVector;
}

// The flags and length of a PDU that begins at `offset` and goes on to the end of the datagram.
void writePduStart(FieldWriter& writer, std::size_t datagramSize, std::size_t offset) {
    writer.u16BigEndian(static_cast<std::uint16_t>(kPduFlags | (datagramSize - offset)));
}

// Everything up to the vector of the framing layer.
void writeRootLayer(FieldWriter& writer, std::size_t datagramSize, std::uint32_t rootVector, const Cid& cid,
                    std::uint32_t framingVector) {
    writer.bytes(kPreamble);
    writePduStart(writer, datagramSize, kPreamble.size());
    writer.u32BigEndian(rootVector);
    writer.bytes(cid);
    writePduStart(writer, datagramSize, kFramingOffset);
    writer.u32BigEndian(framingVector);
}

std::uint8_t optionsOf(const SacnData& data) {
    return static_cast<std::uint8_t>((data.isPreview ? kOptionPreview : 0) |
                                     (data.isTerminated ? kOptionTerminated : 0) |
                                     (data.forcesSync ? kOptionForceSync : 0));
}

}  // namespace

SacnPacket parseSacn(std::span<const std::uint8_t> datagram) {
    ByteReader reader(datagram);
    if (!std::ranges::equal(reader.take(kPreamble.size()), kPreamble)) return SacnRefusal::kNotSacn;
    const ByteReader beforeRoot = reader;
    if (!enterPdu(reader)) return refusalOfPdu(beforeRoot);
    const std::uint32_t rootVector = reader.u32BigEndian();
    const Cid cid = takeArray<Cid>(reader);
    if (reader.failed()) return SacnRefusal::kBadLength;
    if (rootVector != kRootVectorData && rootVector != kRootVectorExtended) return SacnRefusal::kUnusedVector;
    if (!enterPdu(reader)) return SacnRefusal::kBadLength;
    return rootVector == kRootVectorData ? parseData(reader, cid) : parseExtended(reader, cid);
}

std::vector<std::uint8_t> packSacnData(const SacnData& data) {
    assert(data.slots.size() <= kSlotCount);
    assert(data.priority <= kMaxPriority);
    assert(isUniverse(data.universe));
    std::vector<std::uint8_t> datagram(kDataHeaderSize + data.slots.size());
    FieldWriter writer(datagram);
    writeRootLayer(writer, datagram.size(), kRootVectorData, data.cid, kDataVectorPacket);
    writer.text(data.sourceName, kSacnNameSize);
    writer.u8(data.priority);
    writer.u16BigEndian(data.syncAddress);
    writer.u8(data.sequence);
    writer.u8(optionsOf(data));
    writer.u16BigEndian(data.universe);
    writePduStart(writer, datagram.size(), kDmpOffset);
    writer.u8(kDmpVectorSetProperty);
    writer.u8(kDmpAddressType);
    writer.u16BigEndian(kDmpFirstAddress);
    writer.u16BigEndian(kDmpIncrement);
    writer.u16BigEndian(static_cast<std::uint16_t>(1 + data.slots.size()));
    writer.u8(data.startCode);
    writer.bytes(data.slots);
    return datagram;
}

std::vector<std::uint8_t> packSacnSync(const SacnSync& sync) {
    assert(isUniverse(sync.syncAddress));
    std::vector<std::uint8_t> datagram(kSyncSize);
    FieldWriter writer(datagram);
    writeRootLayer(writer, datagram.size(), kRootVectorExtended, sync.cid, kExtendedVectorSync);
    writer.u8(sync.sequence);
    writer.u16BigEndian(sync.syncAddress);
    return datagram;
}

std::vector<std::uint8_t> packSacnDiscovery(const SacnDiscovery& discovery) {
    assert(discovery.universeCount() <= kSacnUniversesPerPage);
    assert(discovery.page <= discovery.lastPage);
    std::vector<std::uint8_t> datagram(kDiscoveryHeaderSize + discovery.universeBytes.size());
    FieldWriter writer(datagram);
    writeRootLayer(writer, datagram.size(), kRootVectorExtended, discovery.cid, kExtendedVectorDiscovery);
    writer.text(discovery.sourceName, kSacnNameSize);
    writer.skip(4);  // reserved
    writePduStart(writer, datagram.size(), kDiscoveryListOffset);
    writer.u32BigEndian(kDiscoveryVectorList);
    writer.u8(discovery.page);
    writer.u8(discovery.lastPage);
    writer.bytes(discovery.universeBytes);
    return datagram;
}

}  // namespace hazer::protocol
