// What an FTDI chip puts round the bytes of a serial line: two bytes of status before each USB packet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hazer::protocol {

/// Bits of the second status byte, as in a 16550's line status register.
inline constexpr std::uint8_t kFtdiOverrun = 0x02;
inline constexpr std::uint8_t kFtdiBreak = 0x10;

struct FtdiPacket {
    std::uint8_t modemStatus = 0;
    std::uint8_t lineStatus = 0;
    std::span<const std::uint8_t>
        payload{};  ///< Mostly empty: a chip that hears nothing says so every few ms.
};

/// Cuts the first packet from a bulk transfer, which holds several of `packetSize` bytes (the endpoint's
/// wMaxPacketSize, 64 or 512), the last one shorter. Nothing at the end, or where a status is not whole.
inline std::optional<FtdiPacket> takeFtdiPacket(std::span<const std::uint8_t>& transfer,
                                                std::size_t packetSize) {
    constexpr std::size_t kStatusSize = 2;
    if (transfer.size() < kStatusSize) return std::nullopt;
    const auto packet = transfer.first(transfer.size() < packetSize ? transfer.size() : packetSize);
    transfer = transfer.subspan(packet.size());
    return FtdiPacket{packet[0], packet[1], packet.subspan(kStatusSize)};
}

}  // namespace hazer::protocol
