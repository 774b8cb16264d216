// Tells ArtDmx that comes too late from ArtDmx in order, sender by sender.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"
#include "protocol/table_sweep.h"

namespace hazer::protocol {

/// One stream of numbered packets. The UDP port belongs to it: two programs on one machine number their
/// packets each for themselves, and so do two inputs (Physical) of one sender.
struct StreamKey {
    Endpoint source;
    std::uint8_t physical = 0;
    std::uint16_t portAddress = 0;
    auto operator<=>(const StreamKey&) const = default;
};

/// The last sequence number of every stream of late. Bounded: when it is full of streams younger than
/// kForgetAfter, the packets of further streams are taken in whatever order they come. Not thread-safe.
class SequenceTable {
 public:
    static constexpr std::size_t kCapacity = 4096;

    /// A stream silent for longer starts anew: its sender may have been restarted.
    static constexpr std::chrono::seconds kForgetAfter{1};

    /// Whether the packet is in order, and if so remembers it. Sequence 0 has no order: always true.
    bool accept(const StreamKey& key, std::uint8_t sequence, TimePoint now);

 private:
    struct Entry {
        std::uint8_t sequence;
        TimePoint time;
    };

    std::map<StreamKey, Entry> entries_;
    TableSweep sweep_;
};

}  // namespace hazer::protocol
