// Receives Art-Net on a thread of its own and never waits for drawing.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "protocol/artnet_node.h"
#include "protocol/datagram.h"
#include "protocol/receiver_counters.h"
#include "protocol/universe_store.h"

namespace hazer::protocol {

struct ReceiverConfig {
    std::string address = "0.0.0.0";  ///< Local IPv4 address to bind. 0.0.0.0 hears broadcasts too.
    std::uint16_t port = 6454;        ///< UDP port; 0 lets the system choose (see Receiver::port).
    /// Port-Addresses 0..32767 we ask desks for in ArtPollReply.
    std::vector<std::uint16_t> portAddresses{};
    std::string shortName = "hazer";                           ///< At most 17 characters reach the wire.
    std::string longName = "hazer stage-lighting visualizer";  ///< At most 63 characters reach the wire.
    /// Replies to desks wait a random time from 0 up to this, as Art-Net 4 asks. 0 in tests.
    std::chrono::milliseconds maxPollReplyDelay{1000};
    bool isProgrammable = false;  ///< Whether ArtAddress may change names, addresses and merging.
    DatagramTap tap{};            ///< Hears everything that arrives; may be empty.
};

/// Owns the socket and the thread. From the constructor to the destructor, every universe that arrives stands
/// in `store`, asked for or not. Other programs may listen on the same port if they, too, allow it
/// (SO_REUSEADDR).
class Receiver {
 public:
    /// Throws NetworkError if the address is not one of this machine or the port cannot be bound. `store`
    /// must outlive it.
    Receiver(ReceiverConfig config, UniverseStore& store);
    ~Receiver();  ///< Stops at once, whatever is arriving.
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    std::uint16_t port() const;         ///< The port really bound.
    ReceiverCounters counters() const;  ///< Thread-safe.
    ArtNetStatus status() const;        ///< Thread-safe.

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
