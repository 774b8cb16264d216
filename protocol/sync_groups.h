// Who waits for which synchronization packet.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "protocol/merge_source.h"

namespace hazer::protocol {

/// The sources that hold levels, by group. Every step takes constant or logarithmic time, whatever a network
/// makes up. Does not own the sources: one that goes away must leave before.
class SyncGroups {
 public:
    void add(MergeSource& source, SyncGroup group);

    /// A source that does not wait is left as it is.
    void remove(MergeSource& source);

    /// Puts a copied source where the one that it was copied from stands in the groups of its merger. Whole
    /// once all sources of that merger have been restored.
    void restore(MergeSource& source);

    /// One source that waits for `group`, or null; it goes on waiting.
    MergeSource* next(SyncGroup group);

 private:
    static constexpr std::size_t kMaxEmptyGroups = 256;

    std::vector<MergeSource*>& listOf(SyncGroup group);

    /// Empty lists stay for the next packet of their group, so that nothing is allocated frame by frame.
    std::map<SyncGroup, std::vector<MergeSource*>> groups_;
    std::size_t emptyCount_ = 0;
};

}  // namespace hazer::protocol
