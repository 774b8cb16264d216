// What is remembered of every sACN sender: its last sequence number and what it calls itself.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"
#include "protocol/sacn.h"
#include "protocol/table_sweep.h"

namespace hazer::protocol {

/// One series of sequence numbers (E1.31 section 6.7): the data of one universe, whatever its start code, or
/// the synchronization packets of one address, from one source.
struct SacnStreamKey {
    std::uint16_t number = 0;  ///< Universe or synchronization address.
    bool isSync = false;
    Cid cid{};
    auto operator<=>(const SacnStreamKey&) const = default;
};

/// Bounded: when it is full of streams that are alive, the packets of further ones are taken in whatever
/// order they come. Not thread-safe.
class SacnStreams {
 public:
    static constexpr std::size_t kCapacity = 16384;

    /// A stream silent for longer starts anew, as its source is lost (E1.31 section 6.7.1).
    static constexpr std::chrono::milliseconds kForgetAfter{2500};

    /// False: the packet is late or a duplicate. A stream that is not remembered takes any.
    bool isInOrder(const SacnStreamKey& key, std::uint8_t sequence, TimePoint now) const;

    /// Remembers a packet that was taken. Returns whether the stream is new, or says another name or comes
    /// from another address than before, so that it should be described anew.
    bool take(const SacnStreamKey& key, std::uint8_t sequence, std::string_view name, const IpEndpoint& from,
              TimePoint now);

    /// Moves the order on if the stream is remembered; a packet that says nothing to us does not make one.
    void pass(const SacnStreamKey& key, std::uint8_t sequence, TimePoint now);

    void forget(const SacnStreamKey& key) { streams_.erase(key); }

    std::size_t size() const { return streams_.size(); }

 private:
    struct Stream {
        std::uint8_t sequence = 0;
        TimePoint time{};
        IpEndpoint from{};
        std::array<char, kSacnNameSize> name{};
    };

    std::map<SacnStreamKey, Stream> streams_;
    TableSweep sweep_;
};

}  // namespace hazer::protocol
