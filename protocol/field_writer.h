// A cursor over a datagram that is being written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace hazer::protocol {

/// Writes fields one after another into a datagram that was zeroed, so that a skipped field is 0. The caller
/// sees to it that everything fits.
class FieldWriter {
 public:
    explicit FieldWriter(std::span<std::uint8_t> bytes) : rest_(bytes) {}

    void skip(std::size_t count) { rest_ = rest_.subspan(count); }

    void u8(std::uint8_t value) {
        rest_[0] = value;
        skip(1);
    }

    void u16BigEndian(std::uint16_t value) {
        u8(static_cast<std::uint8_t>(value >> 8));
        u8(static_cast<std::uint8_t>(value & 0xFF));
    }

    void u16LittleEndian(std::uint16_t value) {
        u8(static_cast<std::uint8_t>(value & 0xFF));
        u8(static_cast<std::uint8_t>(value >> 8));
    }

    void u32BigEndian(std::uint32_t value) {
        u16BigEndian(static_cast<std::uint16_t>(value >> 16));
        u16BigEndian(static_cast<std::uint16_t>(value & 0xFFFF));
    }

    void bytes(std::span<const std::uint8_t> values) {
        std::copy(values.begin(), values.end(), rest_.begin());
        skip(values.size());
    }

    /// A text field that always ends with a NUL, cut if it must be.
    void text(std::string_view value, std::size_t fieldSize) {
        std::copy_n(value.begin(), std::min(value.size(), fieldSize - 1), rest_.begin());
        skip(fieldSize);
    }

 private:
    std::span<std::uint8_t> rest_;
};

}  // namespace hazer::protocol
