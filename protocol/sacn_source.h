// A source of sACN without sockets or clocks: levels and the time go in, datagrams come out when they are
// due.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/sacn.h"

namespace hazer::protocol {

/// A CID that nobody else has: a random UUID (RFC 4122, version 4).
Cid randomCid();

struct SacnSourceConfig {
    Cid cid{};                                 ///< Not all 0.
    std::string name = "hazer";                ///< UTF-8; at most 63 bytes reach the wire.
    std::uint8_t priority = kDefaultPriority;  ///< 0..200.
    /// 1..63999: levels carry it and each group of them is followed by a synchronization packet. 0: none.
    std::uint16_t syncAddress = 0;
    bool isPreview = false;
};

/// Not thread-safe; times handed in must not go back.
class SacnSource {
 public:
    /// Unchanged content is sent this many times more (E1.31 section 6.6.2), a DMX frame apart, then kept
    /// alive at an interval between 800 and 1000 ms.
    static constexpr int kRepeats = 3;
    static constexpr std::chrono::microseconds kRepeatInterval{22'700};
    static constexpr std::chrono::milliseconds kKeepAliveInterval{900};

    /// E131_UNIVERSE_DISCOVERY_INTERVAL (section 4.3).
    static constexpr std::chrono::seconds kDiscoveryInterval{10};

    /// Copies of a termination (section 6.2.6).
    static constexpr int kTerminations = 3;

    /// Takes one datagram and the universe, synchronization address or discovery universe whose group it is
    /// for.
    using Emit = std::function<void(std::uint16_t number, std::span<const std::uint8_t> datagram)>;

    explicit SacnSource(SacnSourceConfig config);

    /// 1..512 slots; universe 1..63999. Due at once if they differ from those of before.
    void setLevels(std::uint16_t universe, std::span<const std::uint8_t> slots);

    /// Per-address priorities, 0..200 each; at most 512.
    void setSlotPriorities(std::uint16_t universe, std::span<const std::uint8_t> priorities);

    /// When something is due next; past: at once. Nothing is ever due before the first levels.
    std::optional<TimePoint> nextDue() const;

    /// Emits all that is due at `now`: levels and priorities, then synchronization, then discovery.
    void emitDue(TimePoint now, const Emit& emit);

    /// Ends every universe and forgets it.
    void terminate(const Emit& emit);

 private:
    /// Slots under one start code, and when they were sent.
    struct Content {
        std::vector<std::uint8_t> slots;
        int repeatsLeft = 0;
        std::optional<TimePoint> lastSent;  ///< Of these slots; nothing: not yet.

        void set(std::span<const std::uint8_t> newSlots);
        TimePoint due() const;
        void markSent(TimePoint now);
    };

    struct Output {
        Content levels;
        Content priorities;
        std::uint8_t sequence = 0;
    };

    void emitContent(std::uint16_t universe, Output& output, const Content& content, std::uint8_t startCode,
                     bool isTerminated, const Emit& emit);
    void emitSync(const Emit& emit);
    void emitDiscovery(const Emit& emit);

    SacnSourceConfig config_;
    std::map<std::uint16_t, Output> outputs_;
    std::uint8_t syncSequence_ = 0;
    TimePoint nextDiscovery_{};
};

}  // namespace hazer::protocol
