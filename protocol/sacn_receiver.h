// Receives sACN on a thread of its own and never waits for drawing.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "protocol/datagram.h"
#include "protocol/sacn_listener.h"
#include "protocol/universe_store.h"

namespace hazer::protocol {

struct SacnReceiverConfig {
    /// 1..63999 each: their multicast groups are joined, by IPv4 and IPv6, and that of universe discovery.
    /// Unicast brings universes whether they are listed or not.
    std::vector<std::uint16_t> universes{};
    /// Whether the groups of universes that sources announce (universe discovery) are joined as well, at most
    /// SacnReceiver::kMostAnnounced of them, the lowest numbers.
    bool joinsAnnounced = false;
    /// The name or an address of the only interface to listen on; empty: all. Loopback is heard by unicast
    /// alone, and then only from this machine.
    std::string interface {};
    std::uint16_t port = kSacnPort;  ///< UDP port; 0 lets the system choose (see SacnReceiver::port).
    PreviewRule preview = PreviewRule::kBoth;
    DatagramTap tap{};  ///< May be empty.
    /// Called once each, from the constructor or the receiving thread, with a sentence about what does not
    /// work here: no IPv6, no interface for multicast, a group that could not be joined. May be empty.
    std::function<void(const std::string&)> notice{};
};

/// A universe's or source's oddities apart, everything a display needs besides the store.
struct SacnReport {
    SacnCounters counters{};
    std::uint64_t otherInterface = 0;  ///< Datagrams left alone: they came by an interface not chosen.
    std::vector<SacnDiscoveredSource> discovered;
    std::vector<SacnSyncStatus> syncs;
    std::set<std::uint16_t> universesOfWrongGroups;
    std::size_t membershipCount = 0;  ///< Groups joined, counted at each interface.
    std::size_t socketCount = 0;
};

/// Owns the sockets and the thread. Other programs may listen on the same port if they, too, allow it
/// (SO_REUSEADDR). Groups are joined anew when interfaces come and go.
class SacnReceiver {
 public:
    /// Anybody can announce all 63999 universes, and each takes a place in the switch.
    static constexpr std::size_t kMostAnnounced = 256;

    /// Throws NetworkError if the interface is not there or the port cannot be bound. `store` must outlive
    /// it.
    SacnReceiver(SacnReceiverConfig config, UniverseStore& store);
    ~SacnReceiver();  ///< Stops at once, whatever is arriving.
    SacnReceiver(const SacnReceiver&) = delete;
    SacnReceiver& operator=(const SacnReceiver&) = delete;

    std::uint16_t port() const;     ///< The port really bound.
    SacnCounters counters() const;  ///< Thread-safe.
    SacnReport report() const;      ///< Thread-safe.

    /// Datagrams that arrived faster than they were read, and were lost. Thread-safe; counted by Linux alone.
    std::uint64_t droppedBySystem() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
