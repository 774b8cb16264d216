// The order of numbered packets, the same rule for Art-Net and sACN.
#pragma once

#include <cstdint>

namespace hazer::protocol {

/// Packets fewer places than this behind the last one are late; those further behind come from a sender that
/// began anew, which must not be shut out until it has counted up again. E1.31 section 6.7.2; Art-Net names
/// no window.
inline constexpr int kSequenceWindow = 20;

/// Whether a packet numbered `sequence` is to be taken after one numbered `last`. The difference is a signed
/// byte, so that the step from 255 to 0 or 1 goes forward.
constexpr bool isInOrder(std::uint8_t sequence, std::uint8_t last) {
    const int distance = static_cast<std::int8_t>(static_cast<std::uint8_t>(sequence - last));
    return distance > 0 || distance <= -kSequenceWindow;
}

}  // namespace hazer::protocol
