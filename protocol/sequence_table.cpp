#include "protocol/sequence_table.h"

#include "protocol/sequence.h"

namespace hazer::protocol {

bool SequenceTable::accept(const StreamKey& key, std::uint8_t sequence, TimePoint now) {
    if (sequence == 0) return true;
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
        if (sweep_.makeRoom(entries_, kCapacity, kForgetAfter, now))
            entries_.emplace(key, Entry{sequence, now});
        return true;
    }
    Entry& entry = found->second;
    if (now - entry.time <= kForgetAfter && !isInOrder(sequence, entry.sequence)) return false;
    entry = {sequence, now};
    return true;
}

}  // namespace hazer::protocol
