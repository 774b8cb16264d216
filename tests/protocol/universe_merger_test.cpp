// The situations of docs/protocols.md, one test each. Every time is an argument.
#include "protocol/universe_merger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/protocol/allocation_counter.h"

namespace hazer::protocol {
namespace {

using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;
using testing::ElementsAre;

const UniverseId kSacn{Transport::kSacn, 5};
const UniverseId kArtNet{Transport::kArtNet, 5};
const UniverseId kDmx{Transport::kDmx, 5};
const UniverseId kAny{Transport::kAny, 5};
const SyncGroup kGroup{Transport::kSacn, 7000};

TimePoint at(double seconds) {
    return TimePoint(std::chrono::hours(1)) +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// A source called by a letter.
SourceId source(Transport transport, char letter) {
    SourceId id;
    id.transport = transport;
    id.id[0] = static_cast<std::uint8_t>(letter);
    return id;
}

/// Plays packets into a merger and looks at the first four slots.
class MergerTest : public testing::Test {
 protected:
    Levels levels(UniverseId universe, char letter, const Bytes& slots, int priority) const {
        return {.universe = universe,
                .source = source(universe.transport, letter),
                .priority = static_cast<std::uint8_t>(priority),
                .slots = slots};
    }

    Verdict show(double s, UniverseId universe, char letter, const Bytes& slots, int priority = 100) {
        return merger.show(levels(universe, letter, slots, priority), at(s));
    }

    Verdict hold(double s, UniverseId universe, char letter, const Bytes& slots, SyncGroup group = kGroup) {
        return merger.hold(levels(universe, letter, slots, 100), group, at(s));
    }

    void priorities(double s, UniverseId universe, char letter, const Bytes& values) {
        EXPECT_EQ(merger.setSlotPriorities(universe, source(universe.transport, letter), values, at(s)),
                  Verdict::kTaken);
    }

    Universe universeAt(double s, UniverseId universe) {
        merger.expire(at(s));
        UniverseSet set;
        merger.latch(set, at(s));
        return set[universe];
    }

    Bytes look(double s, UniverseId universe) {
        const Universe seen = universeAt(s, universe);
        return {seen.slots.begin(), seen.slots.begin() + 4};
    }

    bool isLost(double s, UniverseId universe) { return universeAt(s, universe).isLost; }

    UniverseStatus statusAt(double s, UniverseId universe) {
        merger.expire(at(s));
        for (const UniverseStatus& status : merger.status(at(s))) {
            if (status.universe == universe) return status;
        }
        ADD_FAILURE() << "no such universe";
        return {};
    }

    UniverseMerger merger;
};

// Art-Net: OLA 0.10.9 as an oracle. Each row was measured on it.

class AsOlaMeasured : public MergerTest {
 protected:
    void SetUp() override {
        show(0, kArtNet, 'A', {10, 200, 0, 0});
        show(0, kArtNet, 'B', {50, 100, 0, 7});
    }
};

TEST_F(AsOlaMeasured, ASourceAloneIsTheLook) {
    UniverseMerger alone;
    alone.show(levels(kArtNet, 'A', {10, 200, 0, 0}, 100), at(0));
    std::swap(merger, alone);
    EXPECT_THAT(look(0, kArtNet), ElementsAre(10, 200, 0, 0));
}

TEST_F(AsOlaMeasured, TwoSourcesMergeByTheHighest) {
    EXPECT_THAT(look(0, kArtNet), ElementsAre(50, 200, 0, 7));
}

TEST_F(AsOlaMeasured, TheThirdIsRefused) {
    EXPECT_EQ(show(1, kArtNet, 'C', {255, 255, 255, 255}), Verdict::kTooManySources);
    EXPECT_THAT(look(1, kArtNet), ElementsAre(50, 200, 0, 7));
    EXPECT_EQ(statusAt(1, kArtNet).refusedSources, 1U);
    EXPECT_EQ(statusAt(1, kArtNet).sources.size(), 2U);
}

TEST_F(AsOlaMeasured, SlotsThatAShortPacketLacksContributeNothing) {
    show(1, kArtNet, 'A', {1, 1});
    EXPECT_THAT(look(1, kArtNet), ElementsAre(50, 100, 0, 7));
}

TEST_F(AsOlaMeasured, ASilentSourceLeavesTheMergeAfterTenSeconds) {
    show(6, kArtNet, 'B', {5, 5, 5, 5});
    EXPECT_THAT(look(9.999, kArtNet), ElementsAre(10, 200, 5, 5));
    EXPECT_THAT(look(10, kArtNet), ElementsAre(5, 5, 5, 5));
}

TEST_F(AsOlaMeasured, AfterTheTimeOutAThirdFindsAPlace) {
    show(6, kArtNet, 'B', {5, 5, 5, 5});
    EXPECT_EQ(show(10, kArtNet, 'C', {9, 0, 0, 0}), Verdict::kTaken);
    EXPECT_THAT(look(10, kArtNet), ElementsAre(9, 5, 5, 5));
}

TEST_F(MergerTest, BothVanishedTheLastLookStands) {
    show(0, kArtNet, 'A', {10, 200, 0, 0});
    show(0, kArtNet, 'B', {50, 100, 0, 7});
    EXPECT_FALSE(isLost(9.9, kArtNet));
    EXPECT_TRUE(isLost(10, kArtNet));
    EXPECT_THAT(look(3600, kArtNet), ElementsAre(50, 200, 0, 7));
}

// Priorities

TEST_F(MergerTest, TheHigherPriorityTakesOverAndGivesBack) {
    show(0, kSacn, 'A', {10, 20, 30, 40}, 100);
    show(0.1, kSacn, 'B', {1, 2, 3, 4}, 120);
    EXPECT_THAT(look(1.5, kSacn), ElementsAre(10, 20, 30, 40)) << "sampling period";
    show(1.5, kSacn, 'A', {10, 20, 30, 40}, 100);
    EXPECT_THAT(look(1.6, kSacn), ElementsAre(1, 2, 3, 4));
    show(1.7, kSacn, 'A', {90, 90, 90, 90}, 100);
    EXPECT_THAT(look(1.8, kSacn), ElementsAre(1, 2, 3, 4));
    merger.leave(kSacn, source(Transport::kSacn, 'B'), at(1.9));
    EXPECT_THAT(look(1.9, kSacn), ElementsAre(90, 90, 90, 90));
}

TEST_F(MergerTest, APriorityThatChangesIsArbitratedAnew) {
    show(0, kSacn, 'A', {10, 0, 0, 0}, 100);
    show(0, kSacn, 'B', {0, 20, 0, 0}, 110);
    EXPECT_THAT(look(1.5, kSacn), ElementsAre(0, 20, 0, 0));
    show(1.6, kSacn, 'A', {10, 0, 0, 0}, 120);
    EXPECT_THAT(look(1.6, kSacn), ElementsAre(10, 0, 0, 0));
    show(1.7, kSacn, 'A', {10, 0, 0, 0}, 110);
    EXPECT_THAT(look(1.7, kSacn), ElementsAre(10, 20, 0, 0));
}

TEST_F(MergerTest, PriorityZeroStillControls) {
    show(0, kSacn, 'A', {10, 0, 0, 0}, 0);
    EXPECT_THAT(look(0, kSacn), ElementsAre(10, 0, 0, 0));
    show(0, kSacn, 'B', {20, 0, 0, 0}, 1);
    show(1.5, kSacn, 'A', {30, 0, 0, 0}, 0);
    EXPECT_THAT(look(1.5, kSacn), ElementsAre(30, 0, 0, 0)) << "0 and 1 are equals";
}

TEST_F(MergerTest, AHigherPriorityLeavesTheSlotsItDoesNotSend) {
    show(0, kSacn, 'A', {10, 20, 30, 40}, 100);
    show(0, kSacn, 'B', {1, 2}, 120);
    EXPECT_THAT(look(1.5, kSacn), ElementsAre(1, 2, 30, 40));
}

// Per-address priorities

TEST_F(MergerTest, SlotsGoByTheirOwnPriorities) {
    show(0, kSacn, 'A', {10, 10, 10, 10}, 100);
    priorities(0, kSacn, 'B', {0, 99, 100, 101});
    show(0, kSacn, 'B', {50, 50, 50, 50}, 200);
    EXPECT_THAT(look(0, kSacn), ElementsAre(10, 10, 50, 50)) << "no sampling with priorities at hand";
}

TEST_F(MergerTest, ASlotOfPriorityZeroIsNotControlled) {
    priorities(0, kSacn, 'A', {100, 0, 100});
    show(0, kSacn, 'A', {10, 20, 30, 40});
    EXPECT_THAT(look(0, kSacn), ElementsAre(10, 0, 30, 0)) << "a missing priority is 0, too";
}

TEST_F(MergerTest, PrioritiesMayComeBeforeLevelsOrAfter) {
    priorities(0, kSacn, 'A', {100, 0});
    EXPECT_TRUE(merger.status(at(0)).front().sources.front().hasSlotPriorities);
    EXPECT_FALSE(merger.status(at(0)).front().sources.front().isAlive);
    UniverseSet set;
    merger.latch(set, at(0));
    EXPECT_TRUE(set.empty()) << "nothing to show yet";
    show(0.1, kSacn, 'A', {10, 20});
    EXPECT_THAT(look(0.1, kSacn), ElementsAre(10, 0, 0, 0));
    priorities(0.2, kSacn, 'A', {0, 100});
    EXPECT_THAT(look(0.2, kSacn), ElementsAre(0, 20, 0, 0));
}

TEST_F(MergerTest, PrioritiesThatStopGiveWayToThePacketsPriorityWhileLevelsGoOn) {
    priorities(0, kSacn, 'A', {0, 150});
    for (const double s : {0.0, 1.0, 2.0, 2.4}) show(s, kSacn, 'A', {10, 20});
    EXPECT_THAT(look(2.49, kSacn), ElementsAre(0, 20, 0, 0));
    show(2.5, kSacn, 'A', {10, 20});
    EXPECT_THAT(look(2.5, kSacn), ElementsAre(10, 20, 0, 0));
    EXPECT_FALSE(statusAt(2.5, kSacn).sources[0].hasSlotPriorities);
}

TEST_F(MergerTest, PrioritiesAndLevelsThatStopTogetherLeaveTheLookAsItIs) {
    priorities(0, kSacn, 'A', {0, 150});
    show(0.9, kSacn, 'A', {10, 20});
    EXPECT_THAT(look(3.0, kSacn), ElementsAre(0, 20, 0, 0));
    EXPECT_THAT(look(10, kSacn), ElementsAre(0, 20, 0, 0));
    EXPECT_TRUE(isLost(10, kSacn));
}

TEST_F(MergerTest, WithoutLevelsASourceIsGoneWhateverPrioritiesItSends) {
    show(0, kSacn, 'A', {10, 20}, 200);
    show(0, kSacn, 'B', {5, 5}, 100);
    for (const double s : {0.0, 1.0, 2.0, 3.0}) {
        priorities(s, kSacn, 'A', {200, 200});
        show(s, kSacn, 'B', {5, 5}, 100);
        EXPECT_THAT(look(s, kSacn), s < 2.5 ? ElementsAre(10, 20, 0, 0) : ElementsAre(5, 5, 0, 0));
    }
}

TEST_F(MergerTest, ReservedPrioritiesAreNotAboveTheHighest) {
    priorities(0, kSacn, 'A', {255, 201});
    show(0, kSacn, 'A', {10, 10});
    priorities(0, kSacn, 'B', {200, 200});
    show(0, kSacn, 'B', {20, 20});
    EXPECT_THAT(look(0, kSacn), ElementsAre(20, 20, 0, 0));
}

// Loss

TEST_F(MergerTest, SilenceIsAStatusAndTheLookStands) {
    show(0, kSacn, 'A', {10, 20});
    EXPECT_FALSE(isLost(2.499, kSacn));
    EXPECT_TRUE(isLost(2.5, kSacn));
    EXPECT_THAT(look(1e6, kSacn), ElementsAre(10, 20, 0, 0));
    EXPECT_EQ(statusAt(1e6, kSacn).sources[0].lossCount, 1U);
}

TEST_F(MergerTest, EachTransportHasItsOwnLossTime) {
    show(0, kSacn, 'A', {1});
    show(0, kArtNet, 'A', {1});
    show(0, kDmx, 'A', {1});
    EXPECT_FALSE(isLost(1.249, kDmx));
    EXPECT_TRUE(isLost(1.25, kDmx));
    EXPECT_FALSE(isLost(2.499, kSacn));
    EXPECT_TRUE(isLost(2.5, kSacn));
    EXPECT_FALSE(isLost(9.999, kArtNet));
    EXPECT_TRUE(isLost(10, kArtNet));
}

TEST_F(MergerTest, ALostLookFadesOutIfTheRuleSaysSo) {
    merger = UniverseMerger({.loss = {.fadesOut = true, .fadeTime = milliseconds(2000)}});
    show(0, kSacn, 'A', {200, 1});
    EXPECT_THAT(look(2.5, kSacn), ElementsAre(200, 1, 0, 0));
    EXPECT_THAT(look(3.0, kSacn), ElementsAre(150, 1, 0, 0));
    EXPECT_THAT(look(3.5, kSacn), ElementsAre(100, 1, 0, 0));
    EXPECT_THAT(look(4.5, kSacn), ElementsAre(0, 0, 0, 0));
    show(5, kSacn, 'A', {200, 1});
    EXPECT_THAT(look(5, kSacn), ElementsAre(200, 1, 0, 0));
}

TEST_F(MergerTest, AFadeBeginsAtTheLossAndNotWhenSomebodyLooks) {
    merger = UniverseMerger({.loss = {.fadesOut = true, .fadeTime = milliseconds(2000)}});
    show(0, kSacn, 'A', {200});
    EXPECT_THAT(look(3.5, kSacn), ElementsAre(100, 0, 0, 0));
}

TEST_F(MergerTest, APulledCableDoesNotFlashTheBackup) {
    for (const double s : {0.0, 1.0, 2.0}) {
        show(s, kSacn, 'A', {10, 10}, 120);
        show(s + 0.7, kSacn, 'B', {99, 99}, 100);
    }
    // The cable is pulled at 2.8. A is overdue at 4.5, B at 5.2.
    for (double s = 2.8; s < 12; s += 0.05) {
        EXPECT_THAT(look(s, kSacn), ElementsAre(10, 10, 0, 0)) << s;
        EXPECT_EQ(isLost(s, kSacn), s >= 5.2) << s;
    }
}

TEST_F(MergerTest, TheBackupTakesOverAtOnceWhereOnlyOneDeskFailed) {
    show(0, kSacn, 'A', {10, 10}, 120);
    for (const double s : {0.0, 0.8, 1.6, 2.4}) show(s, kSacn, 'B', {99, 99}, 100);
    EXPECT_THAT(look(2.499, kSacn), ElementsAre(10, 10, 0, 0));
    EXPECT_THAT(look(2.5, kSacn), ElementsAre(99, 99, 0, 0)) << "it was heard long after A";
}

TEST_F(MergerTest, AnUndecidedLossEndsWhenTheBackupSpeaks) {
    show(0, kSacn, 'A', {10, 10}, 120);
    show(1.0, kSacn, 'B', {99, 99}, 100);
    EXPECT_THAT(look(2.6, kSacn), ElementsAre(10, 10, 0, 0));
    show(3.0, kSacn, 'B', {99, 99}, 100);
    EXPECT_THAT(look(3.0, kSacn), ElementsAre(99, 99, 0, 0));
}

TEST_F(MergerTest, NobodyWaitsLongerThanOneLossTime) {
    // Each falls silent just before the one before it could be decided.
    show(0, kSacn, 'A', {1}, 130);
    show(1.2, kSacn, 'B', {2}, 120);
    show(2.4, kSacn, 'C', {3}, 110);
    show(3.6, kSacn, 'D', {4}, 100);
    show(4.8, kSacn, 'E', {5}, 90);
    EXPECT_TRUE(statusAt(4.99, kSacn).sources[0].isAlive);
    EXPECT_FALSE(statusAt(5.0, kSacn).sources[0].isAlive);
}

TEST_F(MergerTest, TheResultDoesNotDependOnHowOftenOneAsks) {
    const auto play = [&](bool asksOften) {
        merger = UniverseMerger({.loss = {.fadesOut = true, .fadeTime = milliseconds(5000)}});
        show(0, kSacn, 'A', {200, 0}, 120);
        show(0.5, kSacn, 'B', {0, 100}, 100);
        for (double s = 0.5; asksOften && s < 6.0; s += 0.01) merger.expire(at(s));
        return look(6.0, kSacn);
    };
    EXPECT_EQ(play(true), play(false));
}

TEST_F(MergerTest, ARestartedDeskIsHeardAtOnce) {
    show(0, kSacn, 'A', {10});
    show(60, kSacn, 'A', {20});
    EXPECT_THAT(look(60, kSacn), ElementsAre(20, 0, 0, 0));
    EXPECT_FALSE(isLost(60, kSacn));
    EXPECT_EQ(statusAt(60, kSacn).sources[0].lossCount, 1U);
}

TEST_F(MergerTest, ASourceThatLeavesIsGoneAtOnceAndTheLastLookStands) {
    show(0, kSacn, 'A', {10});
    merger.leave(kSacn, source(Transport::kSacn, 'A'), at(1));
    EXPECT_TRUE(isLost(1, kSacn));
    EXPECT_THAT(look(1, kSacn), ElementsAre(10, 0, 0, 0));
    EXPECT_FALSE(statusAt(1, kSacn).sources[0].isAlive);
}

// Sampling

TEST_F(MergerTest, TheFirstSourceIsShownAtOnce) {
    show(0, kSacn, 'A', {10});
    EXPECT_THAT(look(0, kSacn), ElementsAre(10, 0, 0, 0));
}

TEST_F(MergerTest, ASecondSourceWaitsForItsPriorities) {
    show(0, kSacn, 'A', {10, 10});
    show(0.5, kSacn, 'B', {99, 99});
    EXPECT_THAT(look(0.5, kSacn), ElementsAre(10, 10, 0, 0));
    EXPECT_EQ(merger.nextDeadline(), at(2.0)) << "end of its sampling period";
    priorities(0.7, kSacn, 'B', {0, 100});
    EXPECT_THAT(look(0.7, kSacn), ElementsAre(10, 99, 0, 0));
}

TEST_F(MergerTest, ASecondSourceWithoutPrioritiesCountsAfterTheSamplingPeriod) {
    show(0, kSacn, 'A', {10, 10});
    show(0.5, kSacn, 'B', {99, 99});
    EXPECT_THAT(look(1.999, kSacn), ElementsAre(10, 10, 0, 0));
    EXPECT_THAT(look(2.0, kSacn), ElementsAre(99, 99, 0, 0));
}

TEST_F(MergerTest, WhoWaitsCountsWhenNobodyElseIsLeft) {
    show(0, kSacn, 'A', {10, 10});
    show(0.5, kSacn, 'B', {99, 99});
    merger.leave(kSacn, source(Transport::kSacn, 'A'), at(0.6));
    EXPECT_THAT(look(0.6, kSacn), ElementsAre(99, 99, 0, 0));
}

TEST_F(MergerTest, ArtNetKnowsNoPrioritiesAndDoesNotWait) {
    show(0, kArtNet, 'A', {10, 10});
    show(0, kArtNet, 'B', {99, 0});
    EXPECT_THAT(look(0, kArtNet), ElementsAre(99, 10, 0, 0));
}

// Latest takes precedence

TEST_F(MergerTest, TheLatestChangeTakesTheWholeUniverse) {
    merger = UniverseMerger({.mode = MergeMode::kLatest});
    show(0, kArtNet, 'A', {10, 200});
    show(1, kArtNet, 'B', {50, 100});
    EXPECT_THAT(look(1, kArtNet), ElementsAre(50, 100, 0, 0));
    show(2, kArtNet, 'A', {11, 200});
    EXPECT_THAT(look(2, kArtNet), ElementsAre(11, 200, 0, 0));
}

TEST_F(MergerTest, TwoDesksThatRepeatThemselvesDoNotFlicker) {
    for (const MergeMode mode : {MergeMode::kHighest, MergeMode::kLatest}) {
        merger = UniverseMerger({.mode = mode});
        show(0, kArtNet, 'A', {10, 200});
        show(0, kArtNet, 'B', {50, 100});
        const Bytes before = look(0, kArtNet);
        for (double s = 0; s < 5; s += 0.023) {
            show(s, kArtNet, 'A', {10, 200});
            EXPECT_EQ(look(s, kArtNet), before);
            show(s, kArtNet, 'B', {50, 100});
            EXPECT_EQ(look(s, kArtNet), before);
        }
    }
}

TEST_F(MergerTest, TheModeOfOneUniverseCanBeSet) {
    show(0, kArtNet, 'A', {10, 200});
    show(0, kArtNet, 'B', {50, 100});
    merger.setMode(kArtNet, MergeMode::kLatest);
    EXPECT_EQ(merger.mode(kArtNet), MergeMode::kLatest);
    EXPECT_EQ(merger.mode({Transport::kArtNet, 6}), MergeMode::kHighest);
    EXPECT_THAT(look(0, kArtNet), ElementsAre(50, 100, 0, 0));
    merger.setMode(kArtNet, MergeMode::kHighest);
    EXPECT_THAT(look(0, kArtNet), ElementsAre(50, 200, 0, 0));
}

// Synchronization

TEST_F(MergerTest, HeldLevelsAreShownTogether) {
    const UniverseId other{Transport::kSacn, 6};
    show(0, kSacn, 'A', {1});
    show(0, other, 'A', {1});
    hold(0.1, kSacn, 'A', {2});
    hold(0.1, other, 'A', {3});
    hold(0.2, kSacn, 'A', {4});
    EXPECT_THAT(look(0.2, kSacn), ElementsAre(1, 0, 0, 0));
    EXPECT_EQ(merger.showHeld({Transport::kSacn, 7001}, at(0.25)), 0U);
    EXPECT_EQ(merger.showHeld(kGroup, at(0.3)), 2U);
    EXPECT_THAT(look(0.3, kSacn), ElementsAre(4, 0, 0, 0));
    EXPECT_THAT(look(0.3, other), ElementsAre(3, 0, 0, 0));
    EXPECT_EQ(merger.showHeld(kGroup, at(0.4)), 0U);
    EXPECT_TRUE(statusAt(0.4, kSacn).sources[0].isSynchronized);
}

TEST_F(MergerTest, LevelsThatShowAtOnceDropWhatIsHeld) {
    hold(0, kSacn, 'A', {2});
    show(0.1, kSacn, 'A', {3});
    EXPECT_EQ(merger.showHeld(kGroup, at(0.2)), 0U);
    EXPECT_THAT(look(0.2, kSacn), ElementsAre(3, 0, 0, 0));
}

TEST_F(MergerTest, ANewGroupTakesTheLevelsAlong) {
    hold(0, kSacn, 'A', {2});
    hold(0.1, kSacn, 'A', {3}, {Transport::kSacn, 7001});
    EXPECT_EQ(merger.showHeld(kGroup, at(0.2)), 0U);
    EXPECT_EQ(merger.showHeld({Transport::kSacn, 7001}, at(0.2)), 1U);
    EXPECT_THAT(look(0.2, kSacn), ElementsAre(3, 0, 0, 0));
}

TEST_F(MergerTest, HoldingIsASignOfLife) {
    show(0, kSacn, 'A', {1});
    for (const double s : {1.0, 2.0, 3.0, 4.0}) hold(s, kSacn, 'A', {2});
    EXPECT_FALSE(isLost(6.4, kSacn));
    EXPECT_THAT(look(6.4, kSacn), ElementsAre(1, 0, 0, 0));
    EXPECT_TRUE(isLost(6.5, kSacn));
    EXPECT_EQ(merger.showHeld(kGroup, at(6.6)), 0U) << "held levels go with their source";
}

TEST_F(MergerTest, HeldLevelsOfALostSourceAreNotShownEvenIfNobodyExpiredIt) {
    show(0, kSacn, 'A', {1});
    hold(1, kSacn, 'A', {2});
    EXPECT_EQ(merger.showHeld(kGroup, at(60)), 0U);
    EXPECT_THAT(look(60, kSacn), ElementsAre(1, 0, 0, 0));
}

TEST_F(MergerTest, ASourceThatComesBackHoldingDoesNotBringItsOldLevels) {
    show(0, kSacn, 'A', {200}, 120);
    for (const double s : {0.0, 1.5, 3.0}) show(s, kSacn, 'B', {5}, 100);
    EXPECT_THAT(look(3, kSacn), ElementsAre(5, 0, 0, 0));
    hold(3.1, kSacn, 'A', {60});
    EXPECT_THAT(look(3.1, kSacn), ElementsAre(5, 0, 0, 0));
}

// The same universe on several transports

TEST_F(MergerTest, AnyTransportMergesTheSameNumberOfAll) {
    merger.ask(kAny);
    show(0, kArtNet, 'A', {10, 0, 0, 0});
    show(0, kDmx, 'A', {0, 20, 0, 0});
    show(0, kSacn, 'A', {0, 0, 30, 0});
    EXPECT_THAT(look(1.2, kAny), ElementsAre(10, 20, 0, 0)) << "sampling period";
    show(1.2, kDmx, 'A', {0, 20, 0, 0});
    EXPECT_THAT(look(1.5, kAny), ElementsAre(10, 20, 30, 0));
    EXPECT_EQ(statusAt(1.5, kAny).sources.size(), 3U);
    EXPECT_TRUE(merger.isMerging(kAny, at(1.5)));
    show(1.6, kSacn, 'A', {0, 0, 30, 0}, 150);
    EXPECT_THAT(look(1.6, kAny), ElementsAre(0, 0, 30, 0)) << "Art-Net and DMX count with 100";
}

TEST_F(MergerTest, AnyTakesOverWhatHadArrivedBefore) {
    show(0, kArtNet, 'A', {10});
    show(0, kDmx, 'A', {0, 20});
    merger.ask(kAny);
    EXPECT_THAT(look(0.1, kAny), ElementsAre(10, 20, 0, 0));
    UniverseSet set;
    merger.latch(set, at(0.1));
    EXPECT_EQ(set.size(), 1U);
}

TEST_F(MergerTest, AUniverseThatIsOnlyPartOfAnyIsSpokenOfAsTheWhole) {
    merger.ask(kAny);
    show(0, kArtNet, 'A', {10});
    show(0, kDmx, 'A', {0, 20});
    EXPECT_TRUE(merger.isLive(kArtNet, at(0)));
    EXPECT_TRUE(merger.isMerging(kArtNet, at(0)));
    merger.setMode(kArtNet, MergeMode::kLatest);
    EXPECT_EQ(merger.mode(kArtNet), MergeMode::kLatest);
    EXPECT_THAT(look(0, kAny), ElementsAre(0, 20, 0, 0));
}

TEST_F(MergerTest, AUniverseThatIsAskedForBesidesAnyHasItsOwnLook) {
    merger.ask(kAny);
    merger.ask(kArtNet);
    show(0, kArtNet, 'A', {10});
    show(0, kDmx, 'A', {0, 20});
    EXPECT_THAT(look(0, kAny), ElementsAre(10, 20, 0, 0));
    EXPECT_THAT(look(0, kArtNet), ElementsAre(10, 0, 0, 0));
    EXPECT_FALSE(merger.isMerging(kArtNet, at(0)));
    EXPECT_EQ(statusAt(0, kArtNet).sources.size(), 1U);
}

// Cancel merge, clear

TEST_F(MergerTest, CancelledMergingLeavesTheNextSenderAlone) {
    show(0, kArtNet, 'A', {10, 200});
    show(0, kArtNet, 'B', {50, 100});
    merger.cancelMerge(kArtNet);
    EXPECT_THAT(look(0, kArtNet), ElementsAre(50, 200, 0, 0));
    show(1, kArtNet, 'B', {50, 100});
    EXPECT_THAT(look(1, kArtNet), ElementsAre(50, 100, 0, 0));
    EXPECT_FALSE(merger.isMerging(kArtNet, at(1)));
    show(2, kArtNet, 'A', {255, 255});
    EXPECT_THAT(look(2, kArtNet), ElementsAre(50, 100, 0, 0));
    for (const double s : {8.0, 12.0}) show(s, kArtNet, 'A', {255, 255});
    EXPECT_THAT(look(12, kArtNet), ElementsAre(255, 255, 0, 0)) << "B vanished";
}

TEST_F(MergerTest, AClearedUniverseIsDarkUntilTheNextLevels) {
    show(0, kArtNet, 'A', {10, 200});
    show(0, kArtNet, 'B', {50, 100});
    merger.clear(kArtNet, at(1));
    EXPECT_THAT(look(1, kArtNet), ElementsAre(0, 0, 0, 0));
    show(2, kArtNet, 'A', {10, 200});
    EXPECT_THAT(look(2, kArtNet), ElementsAre(10, 200, 0, 0)) << "B has not spoken yet";
}

// Status

TEST_F(MergerTest, TheStatusSaysWhoWins) {
    show(0, kSacn, 'A', {10, 0, 0, 0}, 100);
    show(0, kSacn, 'B', {0, 20, 0, 0}, 100);
    show(0, kSacn, 'C', {99, 99, 99, 99}, 90);
    const UniverseStatus status = statusAt(1.5, kSacn);
    ASSERT_EQ(status.sources.size(), 3U);
    EXPECT_TRUE(status.sources[0].isWinning);
    EXPECT_TRUE(status.sources[1].isWinning);
    EXPECT_FALSE(status.sources[2].isWinning);
    EXPECT_TRUE(status.isMerging);
    EXPECT_EQ(status.sources[2].priority, 90);
}

TEST_F(MergerTest, TheStatusHasNamesRatesAndCounts) {
    for (int i = 0; i < 200; ++i) show(i * 0.025, kSacn, 'A', {1});
    merger.describe(kSacn, source(Transport::kSacn, 'A'), "desk", "10.0.0.5");
    merger.countLate(kSacn, source(Transport::kSacn, 'A'));
    const SourceStatus status = statusAt(5, kSacn).sources.at(0);
    EXPECT_EQ(status.name, "desk");
    EXPECT_EQ(status.address, "10.0.0.5");
    EXPECT_EQ(status.lateCount, 1U);
    EXPECT_EQ(status.packetCount, 200U);
    EXPECT_NEAR(status.packetsPerS, 40.0, 4.0);
    EXPECT_EQ(statusAt(30, kSacn).sources.at(0).packetsPerS, 0.0);
}

TEST_F(MergerTest, AskedForUniversesAreInTheStatusBeforeTheyAreHeard) {
    merger.ask(kSacn);
    EXPECT_TRUE(statusAt(0, kSacn).isAskedFor);
    EXPECT_TRUE(statusAt(0, kSacn).sources.empty());
    EXPECT_FALSE(statusAt(0, kSacn).isLost) << "what never came is not lost";
}

// Bounds

TEST_F(MergerTest, SacnTakesAsManySourcesAsTheRulesSay) {
    merger = UniverseMerger({.sacnSourcesPerUniverse = 3});
    for (const char letter : {'A', 'B', 'C'}) EXPECT_EQ(show(0, kSacn, letter, {1}), Verdict::kTaken);
    EXPECT_EQ(show(0, kSacn, 'D', {255}, 200), Verdict::kTooManySources);
    EXPECT_EQ(merger.setSlotPriorities(kSacn, source(Transport::kSacn, 'D'), Bytes{1}, at(0)),
              Verdict::kTooManySources);
    EXPECT_EQ(show(60, kSacn, 'D', {7}), Verdict::kTaken) << "lost ones give way";
    EXPECT_EQ(statusAt(60, kSacn).sources.size(), 3U);
}

TEST_F(MergerTest, TheUniverseThatWasLostLongestAgoMakesRoom) {
    merger = UniverseMerger({.unaskedUniverses = 2});
    const auto sacn = [](int number) {
        return UniverseId{Transport::kSacn, static_cast<std::uint16_t>(number)};
    };
    merger.ask(sacn(9));
    show(0, sacn(1), 'A', {1});
    show(1, sacn(2), 'A', {2});
    EXPECT_EQ(show(2, sacn(3), 'A', {3}), Verdict::kTooManyUniverses) << "both are live";
    EXPECT_EQ(show(2, sacn(9), 'A', {9}), Verdict::kTaken) << "asked for";
    EXPECT_EQ(show(3.4, sacn(3), 'A', {3}), Verdict::kTaken);
    EXPECT_EQ(merger.evictedUniverses(), 1U);
    UniverseSet set;
    merger.latch(set, at(3.4));
    EXPECT_EQ(set.count(sacn(1)), 0U);
    EXPECT_EQ(set.count(sacn(2)), 1U);
    EXPECT_EQ(set.count(sacn(3)), 1U);
}

// Or each packet of a flood of new universes would search all of them for one to forget.
TEST_F(MergerTest, OfManyLostUniversesASixteenthMakesRoomAtOnce) {
    merger = UniverseMerger({.unaskedUniverses = 64});
    const auto showNumber = [&](double atS, int number) {
        return show(atS, {Transport::kSacn, static_cast<std::uint16_t>(number)}, 'A', {1});
    };
    for (int number = 1; number <= 64; ++number) showNumber(0.01 * number, number);
    EXPECT_EQ(showNumber(10, 100), Verdict::kTaken);
    EXPECT_EQ(merger.evictedUniverses(), 4U);
    UniverseSet set;
    merger.latch(set, at(10));
    EXPECT_EQ(set.size(), 61U);
    EXPECT_EQ(set.begin()->first.number, 5) << "the oldest went";
    for (int number = 101; number <= 103; ++number) showNumber(10, number);
    EXPECT_EQ(merger.evictedUniverses(), 4U) << "their places are taken first";
}

TEST_F(MergerTest, AskingForAUniverseFreesItsPlaceAmongTheOthers) {
    merger = UniverseMerger({.unaskedUniverses = 1});
    show(0, kSacn, 'A', {1});
    merger.ask(kSacn);
    EXPECT_EQ(show(0, {Transport::kSacn, 6}, 'A', {1}), Verdict::kTaken);
    EXPECT_EQ(show(0, {Transport::kSacn, 7}, 'A', {1}), Verdict::kTooManyUniverses);
}

TEST_F(MergerTest, NothingIsAllocatedOnceEverybodyWasSeen) {
    const Slots slots{};
    const auto play = [&](double start) {
        for (int frame = 0; frame < 40; ++frame) {
            const TimePoint now = at(start + frame * 0.1);
            for (std::uint16_t number = 1; number <= 8; ++number) {
                for (const char letter : {'A', 'B', 'C'}) {
                    Levels packet;
                    packet.universe = {Transport::kSacn, number};
                    packet.source = source(Transport::kSacn, letter);
                    packet.slots = slots;
                    merger.show(packet, now);
                    merger.setSlotPriorities(packet.universe, packet.source, slots, now);
                    merger.hold(packet, kGroup, now);
                    merger.describe(packet.universe, packet.source,
                                    "a name that is too long for the string itself", "10.0.0.1");
                }
            }
            merger.showHeld(kGroup, now);
            merger.expire(now);
        }
    };
    const std::size_t before = test::allocationCount();
    play(0);
    const std::size_t warm = test::allocationCount();
    EXPECT_GT(warm, before) << "the counter does not count";
    play(4);
    play(60);
    EXPECT_EQ(test::allocationCount(), warm);
}

}  // namespace
}  // namespace hazer::protocol
