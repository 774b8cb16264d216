// Takes many datagrams from a socket at once, each with where it arrived and when.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "protocol/datagram.h"

namespace hazer::protocol {

/// A datagram and the interface that it came in by.
struct ArrivedDatagram {
    Datagram datagram{};
    unsigned interfaceIndex = 0;  ///< The system's number of it; 0: not told.
    /// How many the socket has lost since it was opened, because they came faster than they were taken. Goes
    /// round at 2^32; 0 where the system does not tell.
    std::uint32_t lostBefore = 0;
};

/// Reuses its memory: what it hands out is valid until the next receive.
class DatagramBatch {
 public:
    static constexpr std::size_t kCapacity = 64;

    /// Longer than any packet of Art-Net or sACN; the rest of a longer datagram is cut off.
    static constexpr std::size_t kMaxDatagramSize = 2048;

    DatagramBatch();
    ~DatagramBatch();
    DatagramBatch(const DatagramBatch&) = delete;
    DatagramBatch& operator=(const DatagramBatch&) = delete;

    /// Asks the system to tell addresses, interfaces and times of what arrives at a UDP socket.
    static void prepare(int socket, bool isIpv6);

    /// Up to kCapacity datagrams that have arrived at a socket that does not wait, which is bound to `port`.
    /// None if there is nothing, or something is wrong with the network.
    std::span<const ArrivedDatagram> receive(int socket, std::uint16_t port);

 private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

}  // namespace hazer::protocol
