// Receives Art-Net on a thread of its own and never waits for drawing.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "protocol/universe_store.h"

namespace hazer::protocol {

struct ReceiverConfig {
    std::string address = "0.0.0.0";          ///< Local IPv4 address to bind. 0.0.0.0 hears broadcasts too.
    std::uint16_t port = 6454;                ///< UDP port; 0 lets the system choose (see Receiver::port).
    std::vector<std::uint16_t> portAddresses; ///< Port-Addresses 0..32767 we ask desks for in ArtPollReply.
    std::string shortName = "hazer";          ///< At most 17 characters reach the wire.
    std::string longName = "hazer stage-lighting visualizer";  ///< At most 63 characters reach the wire.
    std::chrono::milliseconds maxPollReplyDelay{1000};  ///< Replies wait a random time up to this (Art-Net 4); 0 in tests.
};

/// Everything that arrived falls in exactly one of these.
struct ReceiverCounters {
    std::uint64_t dmx = 0;       ///< ArtDmx taken into the store.
    std::uint64_t late = 0;      ///< ArtDmx refused: sequence older than one already taken.
    std::uint64_t polls = 0;     ///< ArtPoll answered.
    std::uint64_t ignored = 0;   ///< Art-Net packets of a kind that we do not use.
    std::uint64_t malformed = 0; ///< Not Art-Net, or broken.
};

/// Owns the socket and the thread. Throws protocol::NetworkError if the port cannot be bound.
class Receiver {
public:
    Receiver(ReceiverConfig config, UniverseStore& store);
    ~Receiver();
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    std::uint16_t port() const;          ///< The port really bound.
    ReceiverCounters counters() const;   ///< Thread-safe.

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
