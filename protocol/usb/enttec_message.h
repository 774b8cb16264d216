// The messages of ENTTEC's DMX USB Pro and of the many interfaces that speak like it, as ENTTEC publishes
// them in its "DMX USB Pro Widget API": 7E, label, length (2 bytes, low one first), data, E7.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hazer::protocol {

inline constexpr std::size_t kMaxEnttecData = 600;

/// What a message is about. Those that hazer uses.
enum class EnttecLabel : std::uint8_t {
    kParameters = 3,     ///< Asks for, and answers with, firmware and timing.
    kReceivedDmx = 5,    ///< A whole frame.
    kReceiveMode = 8,    ///< 0: every frame as kReceivedDmx; 1: only what changes, as kChangeOfState.
    kChangeOfState = 9,  ///< The slots of a block of 40 that changed.
    kSerialNumber = 10,  ///< Asks for, and answers with, four bytes.
    kManufacturer = 77,  ///< An extension that OLA and DMXking defined.
    kDeviceName = 78,    ///< The same.
};

struct EnttecMessage {
    std::uint8_t label = 0;
    std::span<const std::uint8_t> data{};  ///< 0..600 bytes.
};

/// The bytes of a message with at most 600 bytes of data.
std::vector<std::uint8_t> packEnttec(EnttecLabel label, std::span<const std::uint8_t> data = {});

/// Finds messages in a stream that is cut anywhere. Nothing in it is escaped, so that 7E and E7 are data as
/// well: a message whose end is not E7 did not begin there, and the search goes on one byte later. Allocates
/// nothing.
class EnttecDecoder {
 public:
    /// Consumes `bytes` from the front until a message is whole; call again until nothing comes. The data of
    /// the message stay valid until the next call.
    std::optional<EnttecMessage> next(std::span<const std::uint8_t>& bytes);

    /// Bytes that belong to no message.
    std::uint64_t skippedBytes() const { return skippedBytes_; }

 private:
    static constexpr std::size_t kMaxMessage = kMaxEnttecData + 5;

    std::span<const std::uint8_t> kept() const { return std::span(buffer_).subspan(begin_, end_ - begin_); }
    std::optional<EnttecMessage> takeKept();
    void skipFalseStart();
    void keep(std::span<const std::uint8_t>& bytes);

    std::array<std::uint8_t, 2 * kMaxMessage> buffer_{};
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::uint64_t skippedBytes_ = 0;
};

}  // namespace hazer::protocol
