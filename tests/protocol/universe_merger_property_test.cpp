// Random evenings against a merger that is slow and obvious: it lives through every twentieth of a second and
// asks the rules of docs/protocols.md slot by slot.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <sstream>

#include "protocol/universe_merger.h"

namespace hazer::protocol {
namespace {

constexpr int kTickMs = 50;
constexpr int kSlots = 6;  // slots beyond are never sent
constexpr std::uint16_t kNumber = 5;

TimePoint timeOf(int tick) {
    return TimePoint(std::chrono::hours(1)) + std::chrono::milliseconds(tick * kTickMs);
}

int lossTicks(Transport transport) {
    if (transport == Transport::kArtNet) return 10000 / kTickMs;
    return (transport == Transport::kSacn ? 2500 : 1250) / kTickMs;
}

struct Packet {
    std::vector<int> levels;
    int priority = 100;
};

/// What is known of one source. Ticks in place of times.
struct Desk {
    std::optional<Packet> shown;
    std::optional<std::pair<SyncGroup, Packet>> held;
    int heldChange = 0;
    std::optional<std::vector<int>> priorities;
    int prioritiesAt = 0;
    bool isAlive = false;
    int heardAt = 0;
    int waitsUntil = 0;
    int changedAt = 0;
};

struct Rules {
    bool isAny = false;
    bool isLatest = false;
    bool fades = false;
};

class ObviousMerger {
 public:
    explicit ObviousMerger(Rules rules) : rules_(rules) {}

    void liveUntil(int tick) {
        while (tick_ < tick) {
            ++tick_;
            giveUpTheOverdue();
            remember();
        }
    }

    bool show(SourceId id, const Packet& packet) {
        Desk* const desk = hear(id);
        if (!desk) return false;
        desk->held.reset();
        put(*desk, packet, ++changes_);
        giveUpTheOverdue();
        remember();
        return true;
    }

    bool hold(SourceId id, const Packet& packet, SyncGroup group) {
        Desk* const desk = hear(id);
        if (!desk) return false;
        desk->held = {group, packet};
        desk->heldChange = ++changes_;
        giveUpTheOverdue();
        remember();
        return true;
    }

    void showHeld(SyncGroup group) {
        for (auto& [id, desk] : desks_) {
            if (!desk.held || desk.held->first != group) continue;
            put(desk, desk.held->second, desk.heldChange);
            desk.held.reset();
        }
        remember();
    }

    bool setPriorities(SourceId id, const std::vector<int>& priorities) {
        if (!hasPlaceFor(id)) return false;
        Desk& desk = desks_[id];
        desk.priorities = priorities;
        desk.prioritiesAt = tick_;
        desk.waitsUntil = tick_;
        remember();
        return true;
    }

    void leave(SourceId id) {
        const auto found = desks_.find(id);
        if (found == desks_.end() || !found->second.isAlive) return;
        silence(found->second);
        found->second.priorities.reset();
        giveUpTheOverdue();
        remember();
    }

    /// The look under `id`: slots, and whether it is lost. Nothing if nothing was ever shown.
    struct Look {
        std::vector<int> slots;
        bool isLost = false;
        int lostAt = 0;
    };
    std::optional<Look> look(Transport transport) const {
        const auto found = looks_.find(transport);
        if (found == looks_.end()) return std::nullopt;
        Look seen = found->second;
        if (!seen.isLost || !rules_.fades) return seen;
        const double left = std::max(0.0, 1.0 - (tick_ - seen.lostAt) * kTickMs / 2000.0);
        for (int& slot : seen.slots) slot = static_cast<int>(std::floor(slot * left + 0.5));
        return seen;
    }

 private:
    // Everybody who can be merged with, or lost together with, a source of this transport.
    bool areTogether(Transport a, Transport b) const { return rules_.isAny || a == b; }

    bool hasPlaceFor(SourceId id) {
        if (desks_.contains(id)) return true;
        std::vector<SourceId> sameTransport;
        for (const auto& [other, desk] : desks_) {
            if (other.transport == id.transport) sameTransport.push_back(other);
        }
        if (sameTransport.size() < (id.transport == Transport::kArtNet ? 2U : 3U)) return true;
        std::optional<SourceId> oldest;
        for (const SourceId& other : sameTransport) {
            const Desk& desk = desks_[other];
            const bool freshPriorities = desk.priorities && tick_ - desk.prioritiesAt < 50;
            if (desk.isAlive || freshPriorities) continue;
            if (!oldest || desk.heardAt < desks_[*oldest].heardAt) oldest = other;
        }
        if (!oldest) return false;
        desks_.erase(*oldest);
        return true;
    }

    Desk* hear(SourceId id) {
        if (!hasPlaceFor(id)) return nullptr;
        Desk& desk = desks_[id];
        const bool freshPriorities = desk.priorities && tick_ - desk.prioritiesAt < 50;
        if (!desk.isAlive) {
            bool hasCompany = false;
            for (const auto& [other, otherDesk] : desks_) {
                hasCompany = hasCompany || (areTogether(other.transport, id.transport) && otherDesk.shown);
            }
            const bool waits = hasCompany && id.transport == Transport::kSacn && !freshPriorities;
            desk.waitsUntil = waits ? tick_ + 1500 / kTickMs : tick_;
        }
        if (!freshPriorities) desk.priorities.reset();
        desk.isAlive = true;
        desk.heardAt = tick_;
        return &desk;
    }

    static void put(Desk& desk, const Packet& packet, int change) {
        const bool isRepeated =
            desk.shown && desk.shown->levels == packet.levels && desk.shown->priority == packet.priority;
        if (!isRepeated) desk.changedAt = change;
        desk.shown = packet;
    }

    static void silence(Desk& desk) {
        desk.shown.reset();
        desk.held.reset();
        desk.isAlive = false;
    }

    void giveUpTheOverdue() {
        for (const Transport transport : {Transport::kArtNet, Transport::kSacn, Transport::kDmx}) {
            giveUpTheOverdueWith(transport);
        }
    }

    void giveUpTheOverdueWith(Transport transport) {
        std::vector<Desk*> overdue;
        bool mustGo = false;
        bool mayGo = true;
        for (auto& [id, desk] : desks_) {
            if (!areTogether(id.transport, transport) || !desk.isAlive) continue;
            const int silentFor = tick_ - desk.heardAt;
            if (silentFor < lossTicks(id.transport)) continue;
            overdue.push_back(&desk);
            mustGo = mustGo || silentFor >= 2 * lossTicks(id.transport);
            for (auto& [other, otherDesk] : desks_) {
                if (!areTogether(other.transport, transport) || !otherDesk.isAlive) continue;
                if (tick_ - otherDesk.heardAt >= lossTicks(other.transport)) continue;
                if (2 * (otherDesk.heardAt - desk.heardAt) <= lossTicks(id.transport)) mayGo = false;
            }
        }
        if (!mustGo && !mayGo) return;
        for (Desk* const desk : overdue) silence(*desk);
    }

    void remember() {
        if (rules_.isAny) return rememberLook(Transport::kAny);
        for (const Transport transport : {Transport::kArtNet, Transport::kSacn, Transport::kDmx}) {
            rememberLook(transport);
        }
    }

    void rememberLook(Transport transport) {
        std::vector<const Desk*> counting;
        std::vector<const Desk*> waiting;
        for (const auto& [id, desk] : desks_) {
            if (!areTogether(id.transport, transport) || !desk.shown) continue;
            (tick_ < desk.waitsUntil ? waiting : counting).push_back(&desk);
        }
        if (counting.empty()) counting = waiting;
        if (counting.empty()) {
            const auto known = looks_.find(transport);
            if (known != looks_.end() && !known->second.isLost) {
                known->second.isLost = true;
                known->second.lostAt = tick_;
            }
            return;
        }
        Look look;
        for (int slot = 0; slot < kSlots; ++slot) look.slots.push_back(slotOf(counting, slot));
        looks_[transport] = look;
    }

    int slotOf(const std::vector<const Desk*>& counting, int slot) const {
        int best = 0;
        int level = 0;
        int changedAt = 0;
        for (const Desk* const desk : counting) {
            if (slot >= static_cast<int>(desk->shown->levels.size())) continue;
            int priority = std::max(1, desk->shown->priority);
            if (desk->priorities) {
                const auto& own = *desk->priorities;
                priority = slot < static_cast<int>(own.size()) ? own[static_cast<std::size_t>(slot)] : 0;
            }
            const int own = desk->shown->levels[static_cast<std::size_t>(slot)];
            if (priority == 0 || priority < best) continue;
            const bool wins =
                priority > best || (rules_.isLatest ? desk->changedAt > changedAt : own > level);
            best = priority;
            if (!wins) continue;
            level = own;
            changedAt = desk->changedAt;
        }
        return level;
    }

    Rules rules_;
    std::map<SourceId, Desk> desks_;
    std::map<Transport, Look> looks_;
    int tick_ = 0;
    int changes_ = 0;
};

std::vector<std::uint8_t> bytesOf(const std::vector<int>& values) {
    return {values.begin(), values.end()};
}

class Evening {
 public:
    explicit Evening(std::uint32_t seed)
        : random_(seed),
          rules_{.isAny = chance(0.5), .isLatest = chance(0.3), .fades = chance(0.3)},
          merger_({.mode = rules_.isLatest ? MergeMode::kLatest : MergeMode::kHighest,
                   .loss = {.fadesOut = rules_.fades},
                   .sacnSourcesPerUniverse = 3}),
          obvious_(rules_) {
        if (rules_.isAny) merger_.ask({Transport::kAny, kNumber});
    }

    void play(int events) {
        for (int i = 0; i < events && !testing::Test::HasFailure(); ++i) {
            tick_ += pauses_[pick(std::size(pauses_))];
            obvious_.liveUntil(tick_);
            act();
            if (chance(0.7)) compare();
        }
    }

 private:
    std::size_t pick(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }
    int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool chance(double probability) { return std::bernoulli_distribution(probability)(random_); }

    std::vector<int> values(std::initializer_list<int> choices) {
        std::vector<int> all(static_cast<std::size_t>(number(0, kSlots)));
        for (int& value : all) value = choices.begin()[pick(choices.size())];
        return all;
    }

    void act() {
        static constexpr Transport kTransports[] = {Transport::kArtNet, Transport::kSacn, Transport::kDmx};
        const Transport transport = kTransports[pick(3)];
        SourceId id;
        id.transport = transport;
        id.id[0] = static_cast<std::uint8_t>(number(1, transport == Transport::kDmx ? 1 : 4));
        const UniverseId universe{transport, kNumber};
        const SyncGroup group{Transport::kSacn, static_cast<std::uint32_t>(number(1, 2))};
        Packet packet{values({0, 1, 50, 200, 255}), 100};
        if (transport == Transport::kSacn) packet.priority = std::vector{0, 1, 100, 100, 100, 150}[pick(6)];
        const auto slots = bytesOf(packet.levels);
        Levels levels;
        levels.universe = universe;
        levels.source = id;
        levels.priority = static_cast<std::uint8_t>(packet.priority);
        levels.slots = slots;
        const int kind = number(0, 99);
        log_ << tick_ << ": " << kind << " by " << static_cast<int>(transport) << "/" << int{id.id[0]}
             << "\n";
        if (kind < 60) {
            same(merger_.show(levels, now()), obvious_.show(id, packet));
        } else if (kind < 70) {
            same(merger_.hold(levels, group, now()), obvious_.hold(id, packet, group));
        } else if (kind < 76) {
            merger_.showHeld(group, now());
            obvious_.showHeld(group);
        } else if (kind < 90 && transport == Transport::kSacn) {
            const std::vector<int> priorities = values({0, 1, 100, 150, 200});
            same(merger_.setSlotPriorities(universe, id, bytesOf(priorities), now()),
                 obvious_.setPriorities(id, priorities));
        } else if (kind < 93) {
            merger_.leave(universe, id, now());
            obvious_.leave(id);
        }
    }

    static void same(Verdict verdict, bool isTaken) { EXPECT_EQ(verdict == Verdict::kTaken, isTaken); }

    void compare() {
        merger_.expire(now());
        UniverseSet set;
        merger_.latch(set, now());
        for (const Transport transport :
             {Transport::kArtNet, Transport::kSacn, Transport::kDmx, Transport::kAny}) {
            const auto expected = obvious_.look(transport);
            const auto seen = set.find({transport, kNumber});
            ASSERT_EQ(seen != set.end(), expected.has_value()) << log_.str();
            if (!expected) continue;
            const std::vector<int> slots(seen->second.slots.begin(), seen->second.slots.begin() + kSlots);
            ASSERT_EQ(slots, expected->slots) << log_.str();
            ASSERT_EQ(seen->second.isLost, expected->isLost) << log_.str();
        }
    }

    TimePoint now() const { return timeOf(tick_); }

    // Mostly streaming; now and then long enough for each of the loss times.
    static constexpr int pauses_[] = {0, 0, 1, 1, 1, 2, 3, 5, 10, 20, 26, 51};

    std::mt19937 random_;
    Rules rules_;
    UniverseMerger merger_;
    ObviousMerger obvious_;
    int tick_ = 0;
    std::ostringstream log_;
};

TEST(UniverseMergerProperty, AgreesWithAnObviousMergerOnRandomEvenings) {
    for (std::uint32_t seed = 0; seed < 1000 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        Evening(seed).play(60);
    }
}

}  // namespace
}  // namespace hazer::protocol
