// Keeps a table of senders bounded.
#pragma once

#include <cstddef>
#include <map>

#include "protocol/dmx.h"

namespace hazer::protocol {

/// For tables whose entries have a `time`, that of their last packet. Not thread-safe.
class TableSweep {
 public:
    /// Whether there is room for one more. A full table forgets what has been silent for longer than
    /// `forgetAfter`: at most once in such a time, so that a flood of made-up senders does not buy a walk
    /// through the whole table with each packet.
    template <class Key, class Entry>
    bool makeRoom(std::map<Key, Entry>& table, std::size_t capacity, Clock::duration forgetAfter,
                  TimePoint now) {
        if (table.size() < capacity) return true;
        if (now < next_) return false;
        next_ = now + forgetAfter;
        std::erase_if(table, [&](const auto& item) { return now - item.second.time > forgetAfter; });
        return table.size() < capacity;
    }

 private:
    TimePoint next_{};
};

}  // namespace hazer::protocol
