#include "protocol/sacn_sync.h"

#include <algorithm>

#include "protocol/sacn.h"

namespace hazer::protocol {

bool SacnSyncTable::mustWait(std::uint16_t address, bool forcesSync, TimePoint now) {
    if (address == 0 || address > kMaxSacnUniverse) return false;
    auto found = entries_.find(address);
    if (found == entries_.end()) {
        if (!makeRoom(now)) return false;
        found = entries_.emplace(address, Entry{}).first;
        ++revision_;
    }
    Entry& entry = found->second;
    entry.lastData = now;
    if (!entry.lastSync) return false;
    const bool isLost = now - *entry.lastSync > kLossAfter;
    return !isLost || !forcesSync;
}

bool SacnSyncTable::takeSync(std::uint16_t address, TimePoint now) {
    const auto found = entries_.find(address);
    if (found == entries_.end()) return false;
    found->second.lastSync = now;
    return true;
}

std::vector<SacnSyncStatus> SacnSyncTable::status(TimePoint now) const {
    std::vector<SacnSyncStatus> all;
    for (const auto& [address, entry] : entries_) {
        const TimePoint lastSync = entry.lastSync.value_or(TimePoint{});
        const bool isLost = entry.lastSync && now - lastSync > kLossAfter;
        all.push_back({address, entry.lastSync.has_value(), isLost, lastSync});
    }
    return all;
}

// The address that no data has named for the longest time gives up its place, if it is out of use.
bool SacnSyncTable::makeRoom(TimePoint now) {
    if (entries_.size() < kCapacity) return true;
    const auto oldest =
        std::ranges::min_element(entries_, {}, [](const auto& item) { return item.second.lastData; });
    if (now - oldest->second.lastData <= kLossAfter) return false;
    entries_.erase(oldest);
    return true;
}

}  // namespace hazer::protocol
