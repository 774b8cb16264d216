#include "protocol/merged_universe.h"

#include <algorithm>
#include <utility>

namespace hazer::protocol {
namespace {

constexpr std::chrono::milliseconds kPriorityLossTime{2500};

// The standard of Art-Net 4 merges two; the others leave it to the receiver to say.
std::size_t maxSources(Transport transport, const MergeRules& rules) {
    return transport == Transport::kArtNet ? 2 : rules.sacnSourcesPerUniverse;
}

bool hasFreshPriorities(const MergeSource& source, TimePoint now) {
    return source.hasPriorities() && now - source.priorities->lastReceived < kPriorityLossTime;
}

bool isSame(const PacketLevels& a, const PacketLevels& b) {
    return a.slotCount == b.slotCount && a.priority == b.priority && a.isPreview == b.isPreview &&
           std::equal(a.slots.begin(), a.slots.begin() + a.slotCount, b.slots.begin());
}

Contribution contributionOf(const MergeSource& source) {
    // A priority of 0 still controls its slots, if nobody else does (E1.31 section 6.2.3).
    return {.levels = std::span(source.levels.slots).first(source.levels.slotCount),
            .priority = std::max<std::uint8_t>(source.levels.priority, 1),
            .slotPriorities = source.hasPriorities() ? &source.priorities->slots : nullptr};
}

// How much of a look is left, 0..1.
double fadeFactor(const Look& look, TimePoint now) {
    if (!look.universe.isLost || !look.loss.fadesOut) return 1.0;
    const std::chrono::duration<double> since = now - look.lostAt;
    const std::chrono::duration<double> fadeTime = look.loss.fadeTime;
    return since >= fadeTime ? 0.0 : std::clamp(1.0 - since / fadeTime, 0.0, 1.0);
}

}  // namespace

MergedUniverse::MergedUniverse(const MergedUniverse& other, const MergeRules& rules, SyncGroups& syncGroups)
    : isAskedFor(other.isAskedFor),
      rules_(rules),
      syncGroups_(syncGroups),
      looks_(other.looks_),
      sources_(other.sources_),
      only_(other.only_ ? find(other.only_->id) : nullptr),
      cancelsMergeNext_(other.cancelsMergeNext_),
      hasOverdue_(other.hasOverdue_),
      deadline_(other.deadline_),
      lastHeard_(other.lastHeard_),
      changeNumber_(other.changeNumber_),
      refused_(other.refused_) {
    for (const auto& source : sources_) {
        source->owner = this;
        syncGroups_.restore(*source);
    }
}

MergedUniverse::~MergedUniverse() {
    for (const auto& source : sources_) syncGroups_.remove(*source);
}

Look& MergedUniverse::addLook(UniverseId id) {
    if (Look* const look = findLook(id)) return *look;
    Look& look = looks_.emplace_back();
    look.id = id;
    look.mode = rules_.mode;
    look.loss = rules_.loss;
    return look;
}

Look* MergedUniverse::findLook(UniverseId id) {
    const auto found = std::ranges::find(looks_, id, &Look::id);
    return found == looks_.end() ? nullptr : &*found;
}

const Look* MergedUniverse::findLook(UniverseId id) const {
    return const_cast<MergedUniverse*>(this)->findLook(id);
}

void MergedUniverse::absorb(MergedUniverse& other) {
    for (auto& source : other.sources_) {
        source->owner = this;
        sources_.push_back(std::move(source));
    }
    other.sources_.clear();
    std::ranges::sort(sources_, {}, [](const auto& source) { return source->id; });
    if (other.isAskedFor) looks_.insert(looks_.end(), other.looks_.begin(), other.looks_.end());
    hasOverdue_ = hasOverdue_ || other.hasOverdue_;
    deadline_ = std::min(deadline_, other.deadline_);
    lastHeard_ = std::max(lastHeard_, other.lastHeard_);
    refused_ += other.refused_;
    mergeLooks(lastHeard_);
}

MergeSource* MergedUniverse::find(const SourceId& id) {
    const auto found = std::ranges::find_if(sources_, [&](const auto& source) { return source->id == id; });
    return found == sources_.end() ? nullptr : found->get();
}

MergeSource* MergedUniverse::place(const SourceId& id, TimePoint now) {
    lastHeard_ = now;
    if (MergeSource* const known = find(id)) return known;
    const auto count = static_cast<std::size_t>(std::ranges::count_if(
        sources_, [&](const auto& source) { return source->id.transport == id.transport; }));
    if (count < maxSources(id.transport, rules_)) return &insert(id);
    MergeSource* const lost = placeOfALostOne(id.transport, now);
    if (!lost) {
        ++refused_;
        return nullptr;
    }
    std::erase_if(sources_, [&](const auto& source) { return source.get() == lost; });
    return &insert(id);
}

MergeSource& MergedUniverse::insert(const SourceId& id) {
    const auto behind = std::ranges::find_if(sources_, [&](const auto& source) { return source->id > id; });
    return **sources_.insert(behind, makeDeep<MergeSource>(*this, id));
}

// The one that was lost longest ago.
MergeSource* MergedUniverse::placeOfALostOne(Transport transport, TimePoint now) {
    MergeSource* oldest = nullptr;
    for (const auto& source : sources_) {
        const bool isFree =
            source->id.transport == transport && !source->isAlive && !hasFreshPriorities(*source, now);
        if (isFree && (!oldest || source->lastLevels < oldest->lastLevels)) oldest = source.get();
    }
    return oldest;
}

Verdict MergedUniverse::show(const Levels& levels, TimePoint now) {
    advance(now);
    MergeSource* const source = place(levels.source, now);
    if (!source) return Verdict::kTooManySources;
    source->describe(levels.name, levels.address);
    syncGroups_.remove(*source);
    bool isChanged = hear(*source, now);
    PacketLevels taken;
    taken.take(levels);
    isChanged = replace(*source, taken, ++changeNumber_) || isChanged;
    source->isSynchronized = false;
    if (isChanged) mergeLooks(now);
    return Verdict::kTaken;
}

Verdict MergedUniverse::hold(const Levels& levels, SyncGroup group, TimePoint now) {
    advance(now);
    MergeSource* const source = place(levels.source, now);
    if (!source) return Verdict::kTooManySources;
    source->describe(levels.name, levels.address);
    const bool isChanged = hear(*source, now);
    syncGroups_.remove(*source);
    if (!source->held) source->held = makeDeep<HeldLevels>();
    source->held->levels.take(levels);
    source->held->changeNumber = ++changeNumber_;
    syncGroups_.add(*source, group);
    source->isSynchronized = true;
    if (isChanged) mergeLooks(now);
    return Verdict::kTaken;
}

void MergedUniverse::commitHeld(MergeSource& source, TimePoint now) {
    replace(source, source.held->levels, source.held->changeNumber);
    syncGroups_.remove(source);
    lastHeard_ = now;
}

// Returns whether the looks have to be merged again.
bool MergedUniverse::replace(MergeSource& source, const PacketLevels& levels, std::uint64_t changeNumber) {
    if (cancelsMergeNext_) {
        only_ = &source;
        cancelsMergeNext_ = false;
    } else if (source.isShown && isSame(source.levels, levels)) {
        return false;
    }
    source.levels = levels;
    source.isShown = true;
    source.changeNumber = changeNumber;
    return true;
}

// Returns whether the looks have to be merged again.
bool MergedUniverse::hear(MergeSource& source, TimePoint now) {
    if (!source.isAlive) revive(source, now);
    source.isOverdue = false;
    source.lastLevels = now;
    deadline_ = std::min(deadline_, source.lossDue());
    countPacket(source, now);
    // Per-address priorities end only while levels go on. When both stop, the look must not change before the
    // source is lost.
    const bool losesPriorities = source.hasPriorities() && !hasFreshPriorities(source, now);
    if (losesPriorities) source.priorities->isValid = false;
    return (hasOverdue_ && decideLosses(now)) || losesPriorities;
}

void MergedUniverse::countPacket(MergeSource& source, TimePoint now) {
    ++source.packetCount;
    source.rate.count(now);
    for (Look& look : looks_) {
        if (!look.covers(source.id.transport)) continue;
        ++look.universe.packetCount;
        look.universe.lastReceived = now;
    }
}

void MergedUniverse::revive(MergeSource& source, TimePoint now) {
    const bool isSecond = std::ranges::any_of(sources_, [](const auto& other) { return other->isShown; });
    source.isAlive = true;
    source.isWaiting =
        isSecond && source.id.transport == Transport::kSacn && !hasFreshPriorities(source, now);
    if (!source.isWaiting) return;
    source.waitsUntil = now + rules_.samplingPeriod;
    deadline_ = std::min(deadline_, source.waitsUntil);
}

Verdict MergedUniverse::setPriorities(const SourceId& id, std::span<const std::uint8_t> priorities,
                                      TimePoint now) {
    advance(now);
    MergeSource* const source = place(id, now);
    if (!source) return Verdict::kTooManySources;
    if (!source->priorities) source->priorities = makeDeep<SlotPriorities>();
    SlotPriorities& own = *source->priorities;
    const std::size_t count = std::min(priorities.size(), kSlotCount);
    own.slots.fill(0);
    std::ranges::transform(priorities.first(count), own.slots.begin(),
                           [](std::uint8_t priority) { return std::min(priority, kMaxPriority); });
    own.lastReceived = now;
    own.isValid = true;
    source->isWaiting = false;
    mergeLooks(now);
    return Verdict::kTaken;
}

void MergedUniverse::leave(const SourceId& id, TimePoint now) {
    advance(now);
    MergeSource* const source = find(id);
    if (!source || !source->isAlive) return;
    lose(*source);
    if (source->priorities) source->priorities->isValid = false;
    if (hasOverdue_) decideLosses(now);
    mergeLooks(now);
}

void MergedUniverse::clear(TimePoint now) {
    advance(now);
    for (const auto& source : sources_) source->levels.slots.fill(0);
    for (Look& look : looks_) look.universe.slots.fill(0);
}

void MergedUniverse::advanceTo(TimePoint now) {
    while (deadline_ <= now) {
        const TimePoint at = deadline_;
        const bool isSampled = endSampling(at);
        const bool isLost = decideLosses(at);
        if (isSampled || isLost) mergeLooks(at);
        deadline_ = nextDeadline();
    }
}

TimePoint MergedUniverse::nextDeadline() const {
    TimePoint next = TimePoint::max();
    for (const auto& source : sources_) {
        if (!source->isAlive) continue;
        next = std::min(next, source->isOverdue ? source->lossDue() + source->lossTime() : source->lossDue());
        if (source->isWaiting) next = std::min(next, source->waitsUntil);
    }
    return next;
}

bool MergedUniverse::endSampling(TimePoint at) {
    bool hasEnded = false;
    for (const auto& source : sources_) {
        if (!source->isWaiting || source->waitsUntil > at) continue;
        source->isWaiting = false;
        hasEnded = true;
    }
    return hasEnded;
}

// Gives up everybody who is overdue, or nobody yet. Returns whether anybody was given up.
bool MergedUniverse::decideLosses(TimePoint at) {
    hasOverdue_ = false;
    for (const auto& source : sources_) {
        source->isOverdue = source->isAlive && source->lossDue() <= at;
        hasOverdue_ = hasOverdue_ || source->isOverdue;
    }
    if (!hasOverdue_ || !mayLose(at)) return false;
    for (const auto& source : sources_) {
        if (source->isOverdue) lose(*source);
    }
    hasOverdue_ = false;
    return true;
}

// A pulled cable silences all sources behind it, but they are not overdue at the same moment: each sent its
// last packet at another time. Showing the backup's look for the part of a second by which it lives longer
// would be a flash, and the wrong look to hold. So as long as a source may have been silenced together with
// an overdue one, nobody is given up. A source that was heard half a loss time later was not. Nobody waits
// longer than one loss time.
bool MergedUniverse::mayLose(TimePoint at) const {
    bool isUndecided = false;
    for (const auto& overdue : sources_) {
        if (!overdue->isOverdue) continue;
        if (at >= overdue->lossDue() + overdue->lossTime()) return true;
        const TimePoint apart = overdue->lastLevels + overdue->lossTime() / 2;
        isUndecided = isUndecided || std::ranges::any_of(sources_, [&](const auto& other) {
                          return other->isAlive && !other->isOverdue && other->lastLevels <= apart;
                      });
    }
    return !isUndecided;
}

void MergedUniverse::lose(MergeSource& source) {
    syncGroups_.remove(source);
    source.isAlive = source.isShown = source.isOverdue = source.isWaiting = false;
    ++source.lossCount;
    if (only_ == &source) only_ = nullptr;
}

bool MergedUniverse::counts(const MergeSource& source, const Look& look) const {
    if (!source.isShown || !look.covers(source.id.transport)) return false;
    return !only_ || only_ == &source || !look.covers(only_->id.transport);
}

// The sources that make the look, the one that changed last at the end. Those in their sampling period count
// if there are no others.
void MergedUniverse::gather(const Look& look) const {
    for (const bool waiting : {false, true}) {
        gathered_.clear();
        for (const auto& source : sources_) {
            if (source->isWaiting == waiting && counts(*source, look)) gathered_.push_back(source.get());
        }
        if (!gathered_.empty()) break;
    }
    std::ranges::sort(gathered_, {}, &MergeSource::changeNumber);
    contributions_.clear();
    for (const MergeSource* const source : gathered_) contributions_.push_back(contributionOf(*source));
}

void MergedUniverse::mergeLooks(TimePoint now) {
    for (Look& look : looks_) merge(look, now);
}

void MergedUniverse::merge(Look& look, TimePoint now) {
    gather(look);
    if (gathered_.empty()) {
        if (look.hasShown && !look.universe.isLost) {
            look.universe.isLost = true;
            look.lostAt = now;
        }
        return;
    }
    mergeSlots(contributions_, look.mode, look.universe.slots);
    look.universe.isLost = false;
    look.hasShown = true;
    look.universe.slotCount = 0;
    for (const MergeSource* const source : gathered_) {
        look.universe.slotCount = std::max(look.universe.slotCount, source->levels.slotCount);
    }
}

bool MergedUniverse::hasLiveSource() const {
    return std::ranges::any_of(sources_, [](const auto& source) { return source->isAlive; });
}

bool MergedUniverse::isLive(const Look& look) const {
    return std::ranges::any_of(
        sources_, [&](const auto& source) { return source->isAlive && look.covers(source->id.transport); });
}

bool MergedUniverse::isMerging(const Look& look) const {
    return std::ranges::count_if(sources_, [&](const auto& source) {
               return source->isAlive && look.covers(source->id.transport) &&
                      (!only_ || only_ == source.get());
           }) > 1;
}

Universe MergedUniverse::lookAt(const Look& look, TimePoint now) const {
    Universe universe = look.universe;
    const double factor = fadeFactor(look, now);
    if (factor < 1.0) {
        for (std::uint8_t& slot : universe.slots) slot = static_cast<std::uint8_t>(slot * factor + 0.5);
    }
    return universe;
}

// Whether gathered_[index] has a slot of the look. Where equals give the same level, nobody has it, unless
// it is not 0.
bool MergedUniverse::wins(const Look& look, std::size_t index) const {
    const auto priorityAt = [](const Contribution& contribution, std::size_t slot) -> int {
        if (slot >= contribution.levels.size()) return 0;
        return contribution.slotPriorities ? (*contribution.slotPriorities)[slot] : contribution.priority;
    };
    const Contribution& own = contributions_[index];
    for (std::size_t slot = 0; slot < own.levels.size(); ++slot) {
        const int priority = priorityAt(own, slot);
        if (priority == 0) continue;
        bool isBeaten = false;
        for (std::size_t i = 0; i < contributions_.size() && !isBeaten; ++i) {
            if (i == index) continue;
            const int other = priorityAt(contributions_[i], slot);
            if (other < priority) continue;
            const bool isEqualBeaten =
                look.mode == MergeMode::kLatest
                    ? i > index
                    : own.levels[slot] == 0 || contributions_[i].levels[slot] > own.levels[slot];
            isBeaten = other > priority || isEqualBeaten;
        }
        if (!isBeaten) return true;
    }
    return false;
}

SourceStatus MergedUniverse::statusOf(const MergeSource& source, TimePoint now) const {
    SourceStatus status;
    status.id = source.id;
    status.name = source.name;
    status.address = source.address;
    status.priority = source.levels.priority;
    status.hasSlotPriorities = source.hasPriorities();
    status.isAlive = source.isAlive;
    status.isPreview = source.levels.isPreview;
    status.isSynchronized = source.isSynchronized;
    status.packetsPerS = source.rate.perSecond(now);
    status.packetCount = source.packetCount;
    status.lateCount = source.lateCount;
    status.lossCount = source.lossCount;
    status.lastReceived = source.lastLevels;
    return status;
}

UniverseStatus MergedUniverse::statusOf(const Look& look, TimePoint now) const {
    UniverseStatus status;
    status.universe = look.id;
    status.isAskedFor = isAskedFor;
    status.isLost = look.universe.isLost;
    status.isMerging = isMerging(look);
    status.packetCount = look.universe.packetCount;
    status.refusedSources = refused_;
    status.look = lookAt(look, now);
    gather(look);
    for (const auto& source : sources_) {
        if (!look.covers(source->id.transport)) continue;
        SourceStatus& own = status.sources.emplace_back(statusOf(*source, now));
        const auto found = std::ranges::find(gathered_, source.get());
        own.isWinning =
            found != gathered_.end() && wins(look, static_cast<std::size_t>(found - gathered_.begin()));
    }
    return status;
}

}  // namespace hazer::protocol
