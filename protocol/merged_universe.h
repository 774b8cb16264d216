// The sources of one universe and the look they make together.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/merge_source.h"
#include "protocol/slot_merge.h"
#include "protocol/sync_groups.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

/// What a patch sees under one id. A universe has one, except where Transport::kAny was asked for: then the
/// sources of all transports stand together, under the id of kAny and under those that were asked for
/// besides.
struct Look {
    UniverseId id{};
    MergeMode mode = MergeMode::kHighest;
    LossRule loss{};
    Universe universe{};
    bool hasShown = false;  ///< Levels have come, ever.
    TimePoint lostAt{};     ///< Of a look that is lost.

    bool covers(Transport transport) const {
        return id.transport == Transport::kAny || id.transport == transport;
    }
};

/// Not thread-safe. Every function that takes a time first lets go of what was overdue by then, each at its
/// own time, so that the result does not depend on how often it is asked.
class MergedUniverse {
 public:
    MergedUniverse(const MergeRules& rules, SyncGroups& syncGroups)
        : rules_(rules), syncGroups_(syncGroups) {}
    /// A copy that belongs to other rules and groups: those of a copied merger.
    MergedUniverse(const MergedUniverse& other, const MergeRules& rules, SyncGroups& syncGroups);
    ~MergedUniverse();
    MergedUniverse(const MergedUniverse&) = delete;
    MergedUniverse& operator=(const MergedUniverse&) = delete;

    std::vector<Look>& looks() { return looks_; }
    const std::vector<Look>& looks() const { return looks_; }
    Look& addLook(UniverseId id);
    Look* findLook(UniverseId id);
    const Look* findLook(UniverseId id) const;

    /// Takes over the sources and, where it has one of the same id, the looks of a universe that goes away.
    void absorb(MergedUniverse& other);

    Verdict show(const Levels& levels, TimePoint now);
    Verdict hold(const Levels& levels, SyncGroup group, TimePoint now);
    Verdict setPriorities(const SourceId& id, std::span<const std::uint8_t> priorities, TimePoint now);
    void leave(const SourceId& id, TimePoint now);
    void clear(TimePoint now);
    void cancelMerge() { cancelsMergeNext_ = true; }

    /// The levels that `source` holds become its levels; the look follows with mergeLooks.
    void commitHeld(MergeSource& source, TimePoint now);
    void mergeLooks(TimePoint now);

    MergeSource* find(const SourceId& id);

    void advance(TimePoint now) {
        if (now >= deadline_) advanceTo(now);
    }

    /// When something will change without a packet; TimePoint::max() if never.
    TimePoint nextDeadline() const;

    /// The same or earlier, at no cost.
    TimePoint earliestDeadline() const { return deadline_; }

    std::size_t sourceCount() const { return sources_.size(); }
    bool hasLiveSource() const;
    bool isLive(const Look& look) const;
    bool isMerging(const Look& look) const;
    TimePoint lastHeard() const { return lastHeard_; }  ///< Any packet at all.

    Universe lookAt(const Look& look, TimePoint now) const;  ///< A fade included.
    UniverseStatus statusOf(const Look& look, TimePoint now) const;

    bool isAskedFor = false;

 private:
    MergeSource* place(const SourceId& id, TimePoint now);
    MergeSource* placeOfALostOne(Transport transport, TimePoint now);
    MergeSource& insert(const SourceId& id);
    bool hear(MergeSource& source, TimePoint now);
    void countPacket(MergeSource& source, TimePoint now);
    void revive(MergeSource& source, TimePoint now);
    bool replace(MergeSource& source, const PacketLevels& levels, std::uint64_t changeNumber);

    void advanceTo(TimePoint now);
    bool endSampling(TimePoint at);
    bool decideLosses(TimePoint at);
    bool mayLose(TimePoint at) const;
    void lose(MergeSource& source);

    bool counts(const MergeSource& source, const Look& look) const;
    void gather(const Look& look) const;
    void merge(Look& look, TimePoint now);
    bool wins(const Look& look, std::size_t index) const;
    SourceStatus statusOf(const MergeSource& source, TimePoint now) const;

    const MergeRules& rules_;
    SyncGroups& syncGroups_;
    // What follows is copied by the constructor that copies; scratch is not.
    std::vector<Look> looks_;
    std::vector<DeepPtr<MergeSource>> sources_;  ///< Ascending by id.
    const MergeSource* only_ = nullptr;          ///< After cancelMerge, as long as it lives.
    bool cancelsMergeNext_ = false;
    bool hasOverdue_ = false;
    TimePoint deadline_ = TimePoint::max();
    TimePoint lastHeard_{};
    std::uint64_t changeNumber_ = 0;
    std::uint64_t refused_ = 0;
    mutable std::vector<const MergeSource*> gathered_;  ///< Scratch of gather().
    mutable std::vector<Contribution> contributions_;   ///< Scratch, in the order of gathered_.
};

}  // namespace hazer::protocol
