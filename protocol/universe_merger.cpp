#include "protocol/universe_merger.h"

#include <algorithm>
#include <bitset>
#include <map>
#include <utility>

#include "protocol/merged_universe.h"
#include "protocol/sync_groups.h"

namespace hazer::protocol {
namespace {

struct UniverseSettings {
    std::optional<MergeMode> mode;
    std::optional<LossRule> loss;
};

}  // namespace

struct UniverseMerger::Impl {
    using Universes = std::map<UniverseId, MergedUniverse>;

    explicit Impl(MergeRules mergeRules) : rules(mergeRules) {}

    Impl(const Impl& other)
        : rules(other.rules),
          settings(other.settings),
          mergesTransports(other.mergesTransports),
          unaskedCount(other.unaskedCount),
          evictedCount(other.evictedCount),
          nextEviction(other.nextEviction) {
        for (const auto& [id, universe] : other.universes)
            universes.try_emplace(id, universe, rules, syncGroups);
    }
    Impl& operator=(const Impl&) = delete;

    // Where the sources of a universe stand.
    UniverseId keyOf(UniverseId id) const {
        return mergesTransports[id.number] ? UniverseId{Transport::kAny, id.number} : id;
    }

    // Under which look the levels of a universe are seen: its own, unless it is only part of Transport::kAny.
    UniverseId shownAs(UniverseId id) {
        const MergedUniverse* const universe = find(id);
        return universe && !universe->findLook(id) ? keyOf(id) : id;
    }

    MergedUniverse* find(UniverseId id) {
        const auto found = universes.find(keyOf(id));
        return found == universes.end() ? nullptr : &found->second;
    }

    const Look* findLook(UniverseId id) {
        MergedUniverse* const universe = find(id);
        return universe ? universe->findLook(id) : nullptr;
    }

    MergedUniverse& make(UniverseId id) {
        const UniverseId key = keyOf(id);
        MergedUniverse& universe = universes.try_emplace(key, rules, syncGroups).first->second;
        applySettings(universe.addLook(key));
        return universe;
    }

    void applySettings(Look& look) const {
        const auto own = settings.find(look.id);
        if (own == settings.end()) return;
        look.mode = own->second.mode.value_or(rules.mode);
        look.loss = own->second.loss.value_or(rules.loss);
    }

    MergedUniverse* findOrMake(UniverseId id, TimePoint now) {
        if (MergedUniverse* const known = find(id)) return known;
        if (unaskedCount >= rules.unaskedUniverses && !evict(now)) return nullptr;
        ++unaskedCount;
        return &make(id);
    }

    // Those that were lost longest ago make room: of many, a sixteenth of all at once, so that a flood of new
    // universes does not buy a walk through all of them with each packet. For the same reason there is none
    // if all are live, until one can be lost.
    bool evict(TimePoint now) {
        constexpr std::size_t kShareAtOnce = 16;
        if (now < nextEviction) return false;
        nextEviction = TimePoint::max();
        std::vector<std::pair<TimePoint, UniverseId>> lost;
        for (auto& [key, universe] : universes) {
            if (universe.isAskedFor) continue;
            universe.advance(now);
            if (universe.hasLiveSource()) {
                nextEviction = std::min(nextEviction, universe.nextDeadline());
            } else {
                lost.emplace_back(universe.lastHeard(), key);
            }
        }
        if (lost.empty()) return false;
        nextEviction = TimePoint::min();
        const std::size_t count =
            std::min(lost.size(), std::max<std::size_t>(1, rules.unaskedUniverses / kShareAtOnce));
        std::ranges::partial_sort(lost, lost.begin() + static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i) universes.erase(lost[i].second);
        unaskedCount -= count;
        evictedCount += count;
        return true;
    }

    void ask(UniverseId id) {
        if (id.transport == Transport::kAny && !mergesTransports[id.number]) mergeTransports(id.number);
        MergedUniverse* const known = find(id);
        if (known && !known->isAskedFor) --unaskedCount;
        MergedUniverse& universe = known ? *known : make(id);
        universe.isAskedFor = true;
        applySettings(universe.addLook(id));
        universe.mergeLooks(universe.lastHeard());
    }

    void mergeTransports(std::uint16_t number) {
        mergesTransports.set(number);
        MergedUniverse& all = make({Transport::kAny, number});
        all.isAskedFor = true;
        for (const Transport transport : {Transport::kArtNet, Transport::kSacn, Transport::kDmx}) {
            const auto found = universes.find({transport, number});
            if (found == universes.end()) continue;
            if (!found->second.isAskedFor) --unaskedCount;
            all.absorb(found->second);
            universes.erase(found);
        }
    }

    MergeRules rules;
    SyncGroups syncGroups;  // before universes: their sources leave it when they go
    Universes universes;
    std::map<UniverseId, UniverseSettings> settings;
    std::bitset<65536> mergesTransports;   // the numbers that Transport::kAny was asked for
    std::vector<MergedUniverse*> touched;  // scratch of showHeld
    std::size_t unaskedCount = 0;
    std::uint64_t evictedCount = 0;
    TimePoint nextEviction = TimePoint::min();
};

UniverseMerger::UniverseMerger(MergeRules rules) : impl_(std::make_unique<Impl>(rules)) {}

UniverseMerger::~UniverseMerger() = default;
UniverseMerger::UniverseMerger(const UniverseMerger& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
UniverseMerger& UniverseMerger::operator=(const UniverseMerger& other) {
    return *this = UniverseMerger(other);
}
UniverseMerger::UniverseMerger(UniverseMerger&&) noexcept = default;
UniverseMerger& UniverseMerger::operator=(UniverseMerger&&) noexcept = default;

const MergeRules& UniverseMerger::rules() const {
    return impl_->rules;
}

void UniverseMerger::ask(UniverseId universe) {
    impl_->ask(universe);
}

Verdict UniverseMerger::show(const Levels& levels, TimePoint now) {
    MergedUniverse* const universe = impl_->findOrMake(levels.universe, now);
    return universe ? universe->show(levels, now) : Verdict::kTooManyUniverses;
}

Verdict UniverseMerger::hold(const Levels& levels, SyncGroup group, TimePoint now) {
    MergedUniverse* const universe = impl_->findOrMake(levels.universe, now);
    return universe ? universe->hold(levels, group, now) : Verdict::kTooManyUniverses;
}

std::size_t UniverseMerger::showHeld(SyncGroup group, TimePoint now) {
    std::vector<MergedUniverse*>& touched = impl_->touched;
    touched.clear();
    while (MergeSource* const source = impl_->syncGroups.next(group)) {
        MergedUniverse& universe = *source->owner;
        universe.advance(now);
        if (!source->isHolding()) continue;  // was overdue
        universe.commitHeld(*source, now);
        touched.push_back(&universe);
    }
    std::ranges::sort(touched);
    // clang 14 cannot compile std::ranges::unique of g++ 12's library.
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (MergedUniverse* const universe : touched) universe->mergeLooks(now);
    return touched.size();
}

Verdict UniverseMerger::setSlotPriorities(UniverseId id, const SourceId& source,
                                          std::span<const std::uint8_t> priorities, TimePoint now) {
    MergedUniverse* const universe = impl_->findOrMake(id, now);
    return universe ? universe->setPriorities(source, priorities, now) : Verdict::kTooManyUniverses;
}

void UniverseMerger::leave(UniverseId id, const SourceId& source, TimePoint now) {
    if (MergedUniverse* const universe = impl_->find(id)) universe->leave(source, now);
    impl_->nextEviction = TimePoint::min();
}

void UniverseMerger::describe(UniverseId id, const SourceId& source, std::string_view name,
                              std::string_view address) {
    MergedUniverse* const universe = impl_->find(id);
    MergeSource* const described = universe ? universe->find(source) : nullptr;
    if (!described) return;
    described->describe(name, address);
}

void UniverseMerger::countLate(UniverseId id, const SourceId& source) {
    MergedUniverse* const universe = impl_->find(id);
    MergeSource* const late = universe ? universe->find(source) : nullptr;
    if (late) ++late->lateCount;
}

void UniverseMerger::setMode(UniverseId id, MergeMode mode) {
    const UniverseId shown = impl_->shownAs(id);
    impl_->settings[shown].mode = mode;
    MergedUniverse* const universe = impl_->find(shown);
    Look* const look = universe ? universe->findLook(shown) : nullptr;
    if (!look) return;
    look->mode = mode;
    universe->mergeLooks(universe->lastHeard());
}

MergeMode UniverseMerger::mode(UniverseId id) const {
    const auto own = impl_->settings.find(impl_->shownAs(id));
    return own == impl_->settings.end() ? impl_->rules.mode : own->second.mode.value_or(impl_->rules.mode);
}

void UniverseMerger::setLoss(UniverseId id, LossRule loss) {
    const UniverseId shown = impl_->shownAs(id);
    impl_->settings[shown].loss = loss;
    MergedUniverse* const universe = impl_->find(shown);
    if (Look* const look = universe ? universe->findLook(shown) : nullptr) look->loss = loss;
}

void UniverseMerger::cancelMerge(UniverseId id) {
    if (MergedUniverse* const universe = impl_->find(id)) universe->cancelMerge();
}

void UniverseMerger::clear(UniverseId id, TimePoint now) {
    if (MergedUniverse* const universe = impl_->find(id)) universe->clear(now);
}

bool UniverseMerger::isLive(UniverseId id, TimePoint now) {
    MergedUniverse* const universe = impl_->find(id);
    if (!universe) return false;
    universe->advance(now);
    const Look* const look = universe->findLook(impl_->shownAs(id));
    return look && universe->isLive(*look);
}

bool UniverseMerger::isMerging(UniverseId id, TimePoint now) {
    MergedUniverse* const universe = impl_->find(id);
    if (!universe) return false;
    universe->advance(now);
    const Look* const look = universe->findLook(impl_->shownAs(id));
    return look && universe->isMerging(*look);
}

std::optional<TimePoint> UniverseMerger::nextDeadline() const {
    TimePoint next = TimePoint::max();
    for (const auto& [id, universe] : impl_->universes) next = std::min(next, universe.nextDeadline());
    if (next == TimePoint::max()) return std::nullopt;
    return next;
}

void UniverseMerger::expire(TimePoint now) {
    for (auto& [id, universe] : impl_->universes) universe.advance(now);
}

void UniverseMerger::latch(UniverseSet& out, TimePoint now) const {
    std::size_t count = 0;
    for (const auto& [id, universe] : impl_->universes) {
        for (const Look& look : universe.looks()) {
            if (!look.hasShown) continue;
            out[look.id] = universe.lookAt(look, now);
            ++count;
        }
    }
    if (out.size() == count) return;
    std::erase_if(out, [&](const auto& item) {
        const Look* const look = impl_->findLook(item.first);
        return !look || !look->hasShown;
    });
}

std::uint64_t UniverseMerger::evictedUniverses() const {
    return impl_->evictedCount;
}

std::size_t UniverseMerger::sourceCount() const {
    std::size_t count = 0;
    for (const auto& [id, universe] : impl_->universes) count += universe.sourceCount();
    return count;
}

std::vector<UniverseStatus> UniverseMerger::status(TimePoint now) const {
    std::vector<UniverseStatus> all;
    for (const auto& [id, universe] : impl_->universes) {
        for (const Look& look : universe.looks()) all.push_back(universe.statusOf(look, now));
    }
    std::ranges::sort(all, {}, &UniverseStatus::universe);
    return all;
}

}  // namespace hazer::protocol
