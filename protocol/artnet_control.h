// What Art-Net 4 has for running a node and a show from afar. See artnet.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// What ArtAddress can order besides names and addresses. Others are possible on the wire.
enum class AddressCommand : std::uint8_t {
    kNone = 0x00,
    kCancelMerge = 0x01,
    kIndicatorsNormal = 0x02,
    kIndicatorsMute = 0x03,
    kIndicatorsLocate = 0x04,
    kFailHold = 0x08,
    kFailZero = 0x09,
    kMergeLatest = 0x10,   ///< Port 0; one more for each further port.
    kMergeHighest = 0x50,  ///< The same.
    kClear = 0x90,         ///< The same.
};

/// A desk programs a node (section ArtAddress).
struct ArtAddress {
    std::uint8_t bindIndex = 0;     ///< Of the ArtPollReply that is meant; 0 and 1: the first.
    std::string_view shortName{};   ///< Empty: no change. Inside the datagram.
    std::string_view longName{};    ///< The same.
    std::uint8_t netSwitch = 0x7F;  ///< As kNoSwitchChange describes; 7 bits of value.
    std::uint8_t subSwitch = 0x7F;  ///< 4 bits of value.
    std::array<std::uint8_t, 4> swOut{0x7F, 0x7F, 0x7F, 0x7F};  ///< 4 bits of value each.
    AddressCommand command = AddressCommand::kNone;
};

/// A switch byte changes something only with bit 7, above the value, or if it is 0: back to the address that
/// the node has by itself.
inline constexpr std::uint8_t kNoSwitchChange = 0x7F;
inline constexpr std::uint8_t kSwitchReset = 0x00;
inline constexpr std::uint8_t kSwitchProgram = 0x80;

inline constexpr std::size_t kArtAddressSize = 107;
std::array<std::uint8_t, kArtAddressSize> packArtAddress(const ArtAddress& address);

/// A desk wants to change or read the IP address of a node (section ArtIpProg).
struct ArtIpProg {};

inline constexpr std::size_t kArtIpProgReplySize = 34;

/// The answer of a node that keeps its address: `ownAddress` as it stands, the rest 0.
std::array<std::uint8_t, kArtIpProgReplySize> packArtIpProgReply(Ipv4Address ownAddress);

enum class TimeCodeType : std::uint8_t { kFilm24, kEbu25, kDropFrame2997, kSmpte30 };

/// The time of a show (section ArtTimeCode).
struct ArtTimeCode {
    std::uint8_t streamId = 0;  ///< 0 is the main one.
    std::uint8_t hours = 0;     ///< 0..23
    std::uint8_t minutes = 0;   ///< 0..59
    std::uint8_t seconds = 0;   ///< 0..59
    std::uint8_t frames = 0;    ///< 0..29, below what the type has in a second.
    TimeCodeType type = TimeCodeType::kEbu25;

    /// Seconds since 0:00:00:00, exact also for drop frame.
    double timeS() const;
};

inline constexpr std::size_t kArtTimeCodeSize = 19;
std::array<std::uint8_t, kArtTimeCodeSize> packArtTimeCode(const ArtTimeCode& timeCode);

/// Triggers that are meant for everybody carry this Oem.
inline constexpr std::uint16_t kOemEverybody = 0xFFFF;

/// Something shall happen now (section ArtTrigger).
struct ArtTrigger {
    std::uint16_t oem = kOemEverybody;
    /// With kOemEverybody: 0 ASCII, 1 macro, 2 soft key, 3 show; else the manufacturer's own.
    std::uint8_t key = 0;
    std::uint8_t subKey = 0;
    std::span<const std::uint8_t> data{};  ///< At most 512 bytes, inside the datagram that was parsed.
};

/// At most 512 bytes of the data reach the wire, which has room for so many in any case.
std::vector<std::uint8_t> packArtTrigger(const ArtTrigger& trigger);

}  // namespace hazer::protocol
