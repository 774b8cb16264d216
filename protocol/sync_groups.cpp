#include "protocol/sync_groups.h"

#include <algorithm>

namespace hazer::protocol {

void SyncGroups::add(MergeSource& source, SyncGroup group) {
    std::vector<MergeSource*>& list = listOf(group);
    if (list.empty()) --emptyCount_;
    source.held->group = group;
    source.held->place = list.size();
    source.held->isWaiting = true;
    list.push_back(&source);
}

void SyncGroups::remove(MergeSource& source) {
    if (!source.isHolding()) return;
    std::vector<MergeSource*>& list = groups_.find(source.held->group)->second;
    list[source.held->place] = list.back();
    list.back()->held->place = source.held->place;
    list.pop_back();
    source.held->isWaiting = false;
    if (list.empty()) ++emptyCount_;
}

void SyncGroups::restore(MergeSource& source) {
    if (!source.isHolding()) return;
    std::vector<MergeSource*>& list = groups_[source.held->group];
    list.resize(std::max(list.size(), source.held->place + 1));
    list[source.held->place] = &source;
}

MergeSource* SyncGroups::next(SyncGroup group) {
    const auto found = groups_.find(group);
    return found == groups_.end() || found->second.empty() ? nullptr : found->second.back();
}

std::vector<MergeSource*>& SyncGroups::listOf(SyncGroup group) {
    const auto found = groups_.find(group);
    if (found != groups_.end()) return found->second;
    if (emptyCount_ >= kMaxEmptyGroups) {
        std::erase_if(groups_, [](const auto& item) { return item.second.empty(); });
        emptyCount_ = 0;
    }
    ++emptyCount_;
    return groups_[group];
}

}  // namespace hazer::protocol
