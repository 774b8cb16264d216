// What reading and writing captures both know of UDP (RFC 768).
#pragma once

#include <cstddef>
#include <cstdint>

namespace hazer::protocol {

inline constexpr std::uint8_t kUdp = 17;  ///< Its number in the headers of IP.
inline constexpr std::size_t kUdpHeaderSize = 8;

}  // namespace hazer::protocol
