// The packets of streaming ACN as pure functions of bytes. Source: ANSI E1.31-2018; the sections named below
// are its own. docs/sacn.md tells what hazer does with them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

/// The UDP port of sACN (ACN-SDT multicast port), both ends.
inline constexpr std::uint16_t kSacnPort = 5568;

/// Universes are 1..63999 (section 6.2.7); synchronization addresses have the same range (section 6.2.4).
inline constexpr std::uint16_t kMaxSacnUniverse = 63999;

/// Where universe discovery is sent to (section 6.2.7).
inline constexpr std::uint16_t kSacnDiscoveryUniverse = 64214;

/// Universes in one page of universe discovery (section 8.5).
inline constexpr std::size_t kSacnUniversesPerPage = 512;

/// Bytes of the source name on the wire, the closing NUL included (section 6.2.2).
inline constexpr std::size_t kSacnNameSize = 64;

/// Start code of DMX512 levels, and of ETC's per-address priorities.
inline constexpr std::uint8_t kStartCodeLevels = 0x00;
inline constexpr std::uint8_t kStartCodeSlotPriorities = 0xDD;

/// Names a source for as long as it runs, whatever address it sends from (section 5.6).
using Cid = std::array<std::uint8_t, 16>;

/// Levels, or what else a start code says, for one universe (sections 5, 6 and 7).
struct SacnData {
    Cid cid{};
    std::string_view sourceName{};  ///< At most 63 bytes inside the datagram; meant to be UTF-8, unchecked.
    std::uint8_t priority = kDefaultPriority;  ///< 0..200.
    /// 0: shown at once. Else levels wait for this synchronization address. Before 2016 the field was
    /// reserved, so that values beyond 63999 can be met.
    std::uint16_t syncAddress = 0;
    std::uint8_t sequence = 0;
    bool isPreview = false;      ///< Preview_Data: not meant for live output.
    bool isTerminated = false;   ///< Stream_Terminated: the source stops; slots mean nothing.
    bool forcesSync = false;     ///< Force_Synchronization: go on without synchronization if it is lost.
    std::uint16_t universe = 1;  ///< 1..63999.
    std::uint8_t startCode = 0;  ///< 0 levels, 0xDD per-address priorities.
    std::span<const std::uint8_t> slots{};  ///< 0..512 values, inside the datagram that was parsed.
};

/// Everything that waits for `syncAddress` is due (sections 6.3 and 11).
struct SacnSync {
    Cid cid{};
    std::uint8_t sequence = 0;
    std::uint16_t syncAddress = 0;  ///< 0 is not allowed but occurs; it means nothing.
};

/// A page of the list of universes that a source sends (sections 4.3 and 8).
struct SacnDiscovery {
    Cid cid{};
    std::string_view sourceName{};  ///< As in SacnData.
    std::uint8_t page = 0;
    std::uint8_t lastPage = 0;                      ///< At least `page`.
    std::span<const std::uint8_t> universeBytes{};  ///< Two bytes each, high byte first; at most 512.

    std::size_t universeCount() const { return universeBytes.size() / 2; }

    /// Whatever the source wrote there; index < universeCount().
    std::uint16_t universe(std::size_t index) const {
        return static_cast<std::uint16_t>(universeBytes[2 * index] << 8 | universeBytes[2 * index + 1]);
    }
};

/// Why a datagram is none of the packets we use.
enum class SacnRefusal : std::uint8_t {
    kNotSacn,       ///< Does not begin with the preamble of ACN over UDP.
    kTruncated,     ///< Ends before what it says that it holds.
    kBadLength,     ///< The lengths inside contradict each other.
    kBadField,      ///< A field that can have one value only has another, or a universe out of range.
    kBadPriority,   ///< Priority above 200.
    kUnusedVector,  ///< ACN, but of a kind that we do not use; also the drafts before the standard.
};

using SacnPacket = std::variant<SacnData, SacnSync, SacnDiscovery, SacnRefusal>;

/// Parses one datagram of any length. Never throws, never reads outside `datagram`; the result refers into
/// it. Bytes behind the end of the packet are not looked at.
SacnPacket parseSacn(std::span<const std::uint8_t> datagram);

/// The same fields that parseSacn gives; `slots` 0..512, priority 0..200, universe 1..63999. Names are cut to
/// 63 bytes.
std::vector<std::uint8_t> packSacnData(const SacnData& data);

/// syncAddress 1..63999.
std::vector<std::uint8_t> packSacnSync(const SacnSync& sync);

/// universeBytes as SacnDiscovery has them, at most 512 universes, ascending.
std::vector<std::uint8_t> packSacnDiscovery(const SacnDiscovery& discovery);

}  // namespace hazer::protocol
