#include "protocol/sequence_table.h"

namespace hazer::protocol {
namespace {

// Art-Net names no window. Packets overtake each other by a few places; a number much further back is a
// sender that was restarted, which must not be shut out until it has counted up again.
constexpr int kWindow = 20;

// The difference as a signed byte makes 255 -> 1 and, for senders that count through 0, 255 -> 0 steps
// forward.
bool follows(std::uint8_t sequence, std::uint8_t last) {
    const int distance = static_cast<std::int8_t>(static_cast<std::uint8_t>(sequence - last));
    return distance > 0 || distance <= -kWindow;
}

}  // namespace

bool SequenceTable::accept(const StreamKey& key, std::uint8_t sequence, TimePoint now) {
    if (sequence == 0) return true;
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
        if (makeRoom(now)) entries_.emplace(key, Entry{sequence, now});
        return true;
    }
    Entry& entry = found->second;
    if (now - entry.time <= kForgetAfter && !follows(sequence, entry.sequence)) return false;
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
