#include "protocol/sequence_table.h"

#include "protocol/sequence.h"

namespace hazer::protocol {

bool SequenceTable::accept(const StreamKey& key, std::uint8_t sequence, TimePoint now) {
    if (sequence == 0) return true;
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
        if (makeRoom(now)) entries_.emplace(key, Entry{sequence, now});
        return true;
    }
    Entry& entry = found->second;
    if (now - entry.time <= kForgetAfter && !isInOrder(sequence, entry.sequence)) return false;
    entry = {sequence, now};
    return true;
}

// Forgets the streams that have been silent. At most once every kForgetAfter, so that a flood of made-up
// senders does not buy a walk through the whole table with each packet.
bool SequenceTable::makeRoom(TimePoint now) {
    if (entries_.size() < kCapacity) return true;
    if (now < nextSweep_) return false;
    nextSweep_ = now + kForgetAfter;
    std::erase_if(entries_, [&](const auto& item) { return now - item.second.time > kForgetAfter; });
    return entries_.size() < kCapacity;
}

}  // namespace hazer::protocol
