// A cursor over received bytes that cannot be made to read outside them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hazer::protocol {

/// Reads forward through a datagram. The first read past the end latches failed(); from then on every read
/// gives 0 or nothing, so that a parser reads a whole header first and asks once.
class ByteReader {
 public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    /// The next `count` bytes, or an empty span if there are fewer.
    std::span<const std::uint8_t> take(std::size_t count) {
        if (failed_ || count > rest_.size()) {
            failed_ = true;
            return {};
        }
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }

    std::uint8_t u8() {
        const auto bytes = take(1);
        return bytes.empty() ? std::uint8_t{0} : bytes[0];
    }

    std::uint16_t u16BigEndian() {
        const auto bytes = take(2);
        return bytes.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
    }

    std::uint32_t u32BigEndian() {
        const auto bytes = take(4);
        if (bytes.empty()) return 0;
        return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
               bytes[3];
    }

    std::uint16_t u16LittleEndian() {
        const auto bytes = take(2);
        return bytes.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(bytes[1] << 8 | bytes[0]);
    }

    /// Bytes not read yet.
    std::size_t remaining() const { return rest_.size(); }

    bool failed() const { return failed_; }

 private:
    std::span<const std::uint8_t> rest_;
    bool failed_ = false;
};

}  // namespace hazer::protocol
