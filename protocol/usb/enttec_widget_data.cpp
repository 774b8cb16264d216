#include "protocol/usb/enttec_widget_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>

#include "protocol/byte_reader.h"
#include "protocol/printable_text.h"

namespace hazer::protocol {
namespace {

constexpr std::size_t kChangeBytes = 5;
constexpr double kTimeUnitUs = 10.67;
constexpr std::size_t kLongestName = 32;

using ChangeBits = std::bitset<8 * kChangeBytes>;

ChangeBits changeBits(std::span<const std::uint8_t> bytes) {
    ChangeBits bits;
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = (bytes[i / 8] >> i % 8 & 1) != 0;
    return bits;
}

}  // namespace

std::optional<EnttecDmx> parseEnttecDmx(std::span<const std::uint8_t> data) {
    ByteReader reader(data);
    const std::uint8_t status = reader.u8();
    const std::uint8_t startCode = reader.u8();
    if (reader.failed() || reader.remaining() > kSlotCount) return std::nullopt;
    return EnttecDmx{(status & 1) != 0, (status & 2) != 0, startCode, reader.take(reader.remaining())};
}

void EnttecChanges::begin(std::span<const std::uint8_t> slots) {
    slots_ = {};
    std::ranges::copy(slots.first(std::min(slots.size(), slots_.size())), slots_.begin());
}

bool EnttecChanges::apply(std::span<const std::uint8_t> data) {
    ByteReader reader(data);
    const std::size_t firstIndex = std::size_t{8} * reader.u8();
    const auto changed = reader.take(kChangeBytes);
    if (reader.failed()) return false;
    const ChangeBits bits = changeBits(changed);
    const auto values = reader.take(bits.count());
    if (reader.failed() || reader.remaining() > 0) return false;
    // Index 0 of the frame is the start code: it has a value of its own among the others.
    Slots slots = slots_;
    auto value = values.begin();
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (!bits[i]) continue;
        const std::size_t index = firstIndex + i;
        if (index >= kFrameSize) return false;
        if (index > 0) slots[index - 1] = *value;
        if (index == 0 && *value != 0) return false;
        ++value;
    }
    slots_ = slots;
    return true;
}

std::optional<EnttecParameters> parseEnttecParameters(std::span<const std::uint8_t> data) {
    ByteReader reader(data);
    const int minor = reader.u8();
    const int major = reader.u8();
    EnttecParameters parameters;
    parameters.firmware = fmt::format("{}.{}", major, minor);
    parameters.breakUs = reader.u8() * kTimeUnitUs;
    parameters.markAfterBreakUs = reader.u8() * kTimeUnitUs;
    parameters.framesPerS = reader.u8();
    if (reader.failed()) return std::nullopt;
    return parameters;
}

std::optional<std::string> parseEnttecSerial(std::span<const std::uint8_t> data) {
    if (data.size() != 4) return std::nullopt;
    if (std::ranges::all_of(data, [](std::uint8_t byte) { return byte == 0xFF; })) return std::string();
    // Binary-coded decimal is hexadecimal that happens to have no letters. Some clones have letters.
    return fmt::format("{:02x}{:02x}{:02x}{:02x}", data[3], data[2], data[1], data[0]);
}

std::optional<EnttecIdentity> parseEnttecIdentity(std::span<const std::uint8_t> data) {
    ByteReader reader(data);
    EnttecIdentity identity;
    identity.id = reader.u16LittleEndian();
    if (reader.failed()) return std::nullopt;
    const auto text = reader.take(std::min(reader.remaining(), kLongestName));
    identity.name = printableText(std::string(text.begin(), std::ranges::find(text, 0)));
    return identity;
}

}  // namespace hazer::protocol
