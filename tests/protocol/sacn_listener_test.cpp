// Evenings of sACN without sockets or clocks, through the listener into a merger.
#include "protocol/sacn_listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/sacn_group.h"
#include "tests/protocol/allocation_counter.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::sacnData;
using test::SacnDataFields;
using ::testing::ElementsAre;

constexpr std::uint8_t kPreview = 0x80;
constexpr std::uint8_t kTerminated = 0x40;
constexpr std::uint8_t kForceSync = 0x20;

/// A visualizer on a network, and the desks that talk to it. Packets of a desk are numbered as they are sent
/// unless a test says otherwise.
class Network {
 public:
    explicit Network(PreviewRule preview = PreviewRule::kBoth) : listener(preview) {
        for (std::uint16_t universe = 1; universe <= 4; ++universe) merger.ask({Transport::kSacn, universe});
    }

    void send(SacnDataFields fields) {
        fields.sequence = sequences_[{fields.cid, fields.universe}]++;
        sendAs(fields);
    }

    void sendAs(const SacnDataFields& fields) {
        receive(sacnData(fields), sacnGroupV4(fields.universe, kSacnPort));
    }

    void sync(std::uint16_t address) {
        receive(test::sacnSync(address, syncSequence_++), sacnGroupV4(address, kSacnPort));
    }

    void receive(const Bytes& datagram,
                 const IpEndpoint& to = {.address = {10, 0, 0, 1}, .port = kSacnPort}) {
        listener.receive(datagram, {.address = {10, 0, 0, 5}, .port = kSacnPort}, to, now, merger);
    }

    void wait(TimePoint::duration time) {
        now += time;
        merger.expire(now);
    }

    /// The first `count` slots as they stand.
    Bytes slots(std::size_t count, std::uint16_t universe = 1) {
        merger.expire(now);
        UniverseSet set;
        merger.latch(set, now);
        const Slots& all = set[{Transport::kSacn, universe}].slots;
        return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
    }

    UniverseStatus status(std::uint16_t universe = 1) {
        for (const UniverseStatus& one : merger.status(now)) {
            if (one.universe == UniverseId{Transport::kSacn, universe}) return one;
        }
        return {};
    }

    SourceStatus source(std::uint8_t cid) {
        SourceId id{Transport::kSacn, {}};
        id.id.fill(cid);
        for (const SourceStatus& one : status().sources) {
            if (one.id == id) return one;
        }
        ADD_FAILURE() << "no source " << int{cid};
        return {};
    }

    TimePoint now{std::chrono::hours(1)};
    UniverseMerger merger;
    SacnListener listener;

 private:
    std::map<std::pair<std::uint8_t, std::uint16_t>, std::uint8_t> sequences_;
    std::uint8_t syncSequence_ = 0;
};

TEST(SacnListener, ShowsWhatADeskSends) {
    Network network;
    network.send({.name = "Desk", .slots = {10, 20, 30}});
    EXPECT_THAT(network.slots(4), ElementsAre(10, 20, 30, 0));
    EXPECT_EQ(network.source(1).name, "Desk");
    EXPECT_EQ(network.source(1).address, "10.0.0.5");
    EXPECT_EQ(network.source(1).priority, 100);
    EXPECT_TRUE(network.source(1).isWinning);
    EXPECT_EQ(network.listener.counters().levels, 1U);
}

TEST(SacnListener, TakesANewNameAndMakesItPrintable) {
    Network network;
    network.send({.name = "Desk"});
    network.send({.name = "Desk \xE9"});
    EXPECT_EQ(network.source(1).name, "Desk \xEF\xBF\xBD");
}

// k-yle/sACN #37: one number for all senders breaks with the second of them and at the wrap.
TEST(SacnListener, KeepsTheOrderOfEachSourceAndUniverse) {
    Network network;
    network.sendAs({.cid = 1, .sequence = 250, .slots = {50}});
    network.sendAs({.cid = 2, .sequence = 3, .slots = {60}});
    network.sendAs({.cid = 1, .sequence = 3, .universe = 2, .slots = {70}});
    network.wait(2s);
    network.sendAs({.cid = 1, .sequence = 249, .slots = {99}});
    network.sendAs({.cid = 2, .sequence = 3, .slots = {99}});
    network.sendAs({.cid = 1, .sequence = 2, .universe = 2, .slots = {99}});
    EXPECT_EQ(network.listener.counters().late, 3U);
    EXPECT_EQ(network.source(1).lateCount, 1U);
    EXPECT_THAT(network.slots(1), ElementsAre(60));
    EXPECT_THAT(network.slots(1, 2), ElementsAre(70));
    network.sendAs({.cid = 1, .sequence = 4, .slots = {80}});  // through 255 and 0
    EXPECT_THAT(network.slots(1), ElementsAre(80));
}

TEST(SacnListener, CountsAllStartCodesOfAUniverseInOneOrder) {
    Network network;
    network.sendAs({.sequence = 10, .slots = {1}});
    network.sendAs({.sequence = 11, .startCode = 0xDD, .slots = {100}});
    network.sendAs({.sequence = 12, .startCode = 0x17, .slots = {'h', 'i'}});
    network.sendAs({.sequence = 11, .slots = {2}});
    network.sendAs({.sequence = 12, .slots = {3}});
    EXPECT_EQ(network.listener.counters().late, 2U);
    EXPECT_EQ(network.listener.counters().otherStartCodes, 1U);
    network.sendAs({.sequence = 13, .slots = {4}});
    EXPECT_THAT(network.slots(1), ElementsAre(4));
}

// sACNView #198.
TEST(SacnListener, ShowsLevelsWithASynchronizationAddressThatNobodySynchronizes) {
    Network network;
    network.send({.syncAddress = 7000, .slots = {10}});
    network.send({.syncAddress = 65535, .slots = {11}});
    EXPECT_THAT(network.slots(1), ElementsAre(11));
}

// sACNView #212: priorities that came before the first levels left the levels "unpatched".
TEST(SacnListener, TakesSlotPrioritiesBeforeTheFirstLevels) {
    Network network;
    network.send({.startCode = 0xDD, .slots = {100, 100}});
    EXPECT_THAT(network.slots(2), ElementsAre(0, 0));
    network.send({.slots = {0, 0}});
    network.send({.slots = {5, 6, 7}});
    EXPECT_THAT(network.slots(3), ElementsAre(5, 6, 0)) << "slot 3 has no priority";
    EXPECT_TRUE(network.source(1).hasSlotPriorities);
}

// sACNView #252, Hundemeier/sacn #49.
TEST(SacnListener, TakesTheUniverseFromThePacketAndFlagsAWrongGroup) {
    Network network;
    network.receive(sacnData({.universe = 1, .slots = {10}}), sacnGroupV4(2, kSacnPort));
    EXPECT_THAT(network.slots(1, 1), ElementsAre(10));
    EXPECT_THAT(network.slots(1, 2), ElementsAre(0));
    EXPECT_THAT(network.listener.universesOfWrongGroups(), ElementsAre(1));
    network.receive(sacnData({.universe = 3, .slots = {10}}),
                    {.address = {239, 255, 255, 3}, .port = kSacnPort});
    EXPECT_THAT(network.listener.universesOfWrongGroups(), ElementsAre(1, 3));
    network.receive(sacnData({.universe = 4, .slots = {10}}));
    EXPECT_THAT(network.listener.universesOfWrongGroups(), ElementsAre(1, 3)) << "unicast is in no group";
}

// sACNView #258: a source was shown as present after it had left.
TEST(SacnListener, LosesEachSourceAfterTwoAndAHalfSeconds) {
    Network network;
    network.send({.cid = 1, .slots = {10}});
    network.send({.cid = 2, .priority = 120, .slots = {20}});
    network.wait(1600ms);  // the sampling period
    network.send({.cid = 2, .priority = 120, .slots = {20}});
    EXPECT_THAT(network.slots(1), ElementsAre(20));
    network.wait(1s);
    EXPECT_FALSE(network.source(1).isAlive);
    EXPECT_TRUE(network.source(2).isAlive);
    EXPECT_FALSE(network.status().isLost);
}

TEST(SacnListener, LosesSlotPrioritiesByThemselves) {
    Network network;
    network.send({.startCode = 0xDD, .slots = {100}});
    for (int i = 0; i < 6; ++i) {
        network.send({.slots = {7, 8}});
        network.wait(500ms);
    }
    EXPECT_THAT(network.slots(2), ElementsAre(7, 8)) << "all slots by the packet's priority again";
    EXPECT_FALSE(network.source(1).hasSlotPriorities);
    EXPECT_TRUE(network.source(1).isAlive);
}

TEST(SacnListener, LosesASourceWhoseLevelsStopThoughPrioritiesGoOn) {
    Network network;
    network.send({.slots = {7}});
    for (int i = 0; i < 6; ++i) {
        network.send({.startCode = 0xDD, .slots = {100}});
        network.wait(500ms);
    }
    EXPECT_FALSE(network.source(1).isAlive);
    EXPECT_TRUE(network.status().isLost);
}

// sACNView #253: a universe's new priority was not looked at.
TEST(SacnListener, DecidesAnewWhenAPriorityChanges) {
    Network network;
    network.send({.cid = 1, .priority = 100, .slots = {10}});
    network.send({.cid = 2, .priority = 90, .slots = {20}});
    network.wait(1600ms);
    network.send({.cid = 1, .priority = 100, .slots = {10}});
    network.send({.cid = 2, .priority = 90, .slots = {20}});
    EXPECT_THAT(network.slots(1), ElementsAre(10));
    network.send({.cid = 1, .priority = 80, .slots = {10}});
    EXPECT_THAT(network.slots(1), ElementsAre(20));
    network.send({.cid = 1, .priority = 150, .slots = {10}});
    EXPECT_THAT(network.slots(1), ElementsAre(10));
}

// sACNView #375.
TEST(SacnListener, TakesShortAndOddSlotPriorities) {
    Network network;
    network.send({.startCode = 0xDD, .slots = {100, 0, 100}});
    network.send({.slots = {1, 2, 3, 4, 5}});
    EXPECT_THAT(network.slots(5), ElementsAre(1, 0, 3, 0, 0));
    network.send({.startCode = 0xDD, .slots = {0}});
    EXPECT_THAT(network.slots(5), ElementsAre(0, 0, 0, 0, 0));
    network.send({.startCode = 0xDD, .slots = {201, 255, 200}});
    EXPECT_THAT(network.slots(5), ElementsAre(0, 0, 3, 0, 0)) << "above 200 is no priority";
}

// ETCLabs/sACN #67.
TEST(SacnListener, TakesDiscoveryOfAFewUniverses) {
    Network network;
    network.receive(test::sacnDiscovery({.name = "node", .universes = {3}}));
    const auto discovered = network.listener.discovered(network.now);
    ASSERT_EQ(discovered.size(), 1U);
    EXPECT_EQ(discovered[0].name, "node");
    EXPECT_THAT(discovered[0].universes, ElementsAre(3));
    EXPECT_EQ(network.listener.counters().discoveries, 1U);
    network.receive(test::olaDraftDiscovery());
    EXPECT_EQ(network.listener.counters().ignored, 1U);
    EXPECT_EQ(network.listener.discovered(network.now + 21s).size(), 0U);
}

// ESPixelStick #62, WLED #3067: other start codes flashed as levels; priority and CID were not looked at.
TEST(SacnListener, ShowsLevelsAlone) {
    Network network;
    network.send({.slots = {10}});
    for (const std::uint8_t code : Bytes{0x01, 0x17, 0x55, 0xCC, 0xCF, 0xFF}) {
        network.send({.startCode = code, .slots = Bytes(512, 255)});
    }
    network.send({.startCode = 0xDD, .slots = Bytes(512, 200)});
    EXPECT_THAT(network.slots(2), ElementsAre(10, 0));
    EXPECT_EQ(network.listener.counters().otherStartCodes, 6U);
    EXPECT_EQ(network.listener.counters().slotPriorities, 1U);
}

TEST(SacnListener, TakesPreviewAsItIsTold) {
    for (const PreviewRule rule : {PreviewRule::kBoth, PreviewRule::kLiveOnly, PreviewRule::kPreviewOnly}) {
        Network network(rule);
        network.send({.cid = 1, .slots = {10}});
        network.send({.cid = 2, .options = kPreview, .universe = 2, .slots = {20}});
        EXPECT_EQ(network.slots(1, 1)[0], rule == PreviewRule::kPreviewOnly ? 0 : 10);
        EXPECT_EQ(network.slots(1, 2)[0], rule == PreviewRule::kLiveOnly ? 0 : 20);
        EXPECT_EQ(network.listener.counters().otherPreview, rule == PreviewRule::kBoth ? 0U : 1U);
    }
}

// WLED #768, ESPixelStick #758, OLA #257: two sources flickered against each other.
TEST(SacnListener, MergesTwoSourcesOfOnePriorityWithoutFlicker) {
    Network network;
    network.send({.cid = 1, .slots = {200, 0}});
    network.send({.cid = 2, .slots = {0, 100}});
    network.wait(1600ms);
    for (int i = 0; i < 100; ++i) {
        network.send({.cid = 1, .slots = {200, 0}});
        network.wait(20ms);
        EXPECT_THAT(network.slots(2), ElementsAre(200, 100)) << i;
        network.send({.cid = 2, .slots = {0, 100}});
        network.wait(20ms);
        EXPECT_THAT(network.slots(2), ElementsAre(200, 100)) << i;
    }
    EXPECT_TRUE(network.status().isMerging);
}

// k-yle/sACN #19.
TEST(SacnListener, KeepsUniversesThatNobodyAskedForApart) {
    Network network;
    network.send({.universe = 1, .slots = {10}});
    network.send({.universe = 999, .slots = {20}});
    EXPECT_THAT(network.slots(1, 1), ElementsAre(10));
    EXPECT_TRUE(network.status(1).isAskedFor);
    EXPECT_FALSE(network.status(999).isAskedFor);
}

// OLA #1288: OLA sends a static look once. Silence is a status, not a blackout.
TEST(SacnListener, HoldsTheLastLookThroughSilence) {
    Network network;
    network.send({.slots = {10, 20}});
    network.wait(1h);
    EXPECT_THAT(network.slots(2), ElementsAre(10, 20));
    EXPECT_TRUE(network.status().isLost);
    EXPECT_FALSE(network.source(1).isAlive);
}

TEST(SacnListener, LetsASourceGoThatSaysSo) {
    Network network;
    network.send({.cid = 1, .priority = 120, .slots = {10}});
    network.send({.cid = 2, .slots = {20}});
    network.wait(1600ms);
    network.send({.cid = 1, .priority = 120, .slots = {10}});
    network.send({.cid = 2, .slots = {20}});
    for (int copy = 0; copy < 3; ++copy)
        network.send({.cid = 1, .priority = 120, .options = kTerminated, .slots = Bytes(512, 255)});
    EXPECT_THAT(network.slots(2), ElementsAre(20, 0)) << "its last slots mean nothing";
    EXPECT_EQ(network.listener.counters().terminations, 3U);
    EXPECT_FALSE(network.source(1).isAlive);
}

TEST(SacnListener, TakesASourceThatComesBackAtOnceFromAnyNumber) {
    Network network;
    network.sendAs({.sequence = 7, .slots = {10}});
    network.sendAs({.sequence = 8, .options = kTerminated, .slots = {}});
    network.sendAs({.sequence = 0, .slots = {30}});
    EXPECT_THAT(network.slots(1), ElementsAre(30));
}

TEST(SacnListener, ShowsSynchronizedUniversesTogether) {
    Network network;
    network.send({.syncAddress = 7000, .universe = 1, .slots = {1}});
    network.sync(7000);
    network.send({.syncAddress = 7000, .universe = 1, .slots = {11}});
    network.send({.syncAddress = 7000, .universe = 2, .slots = {12}});
    EXPECT_THAT(network.slots(1, 1), ElementsAre(1));
    EXPECT_THAT(network.slots(1, 2), ElementsAre(0));
    network.send({.syncAddress = 7000, .universe = 1, .slots = {21}});
    network.sync(7001);
    EXPECT_THAT(network.slots(1, 1), ElementsAre(1)) << "another address";
    network.sync(7000);
    EXPECT_THAT(network.slots(1, 1), ElementsAre(21)) << "newer levels replace older ones";
    EXPECT_THAT(network.slots(1, 2), ElementsAre(12));
    EXPECT_EQ(network.listener.counters().syncs, 2U);
    EXPECT_EQ(network.listener.counters().ignored, 1U);
}

TEST(SacnListener, RefusesLateSynchronization) {
    Network network;
    network.send({.syncAddress = 7000, .slots = {1}});
    network.receive(test::sacnSync(7000, 10));
    network.send({.syncAddress = 7000, .slots = {2}});
    network.receive(test::sacnSync(7000, 10));
    EXPECT_THAT(network.slots(1), ElementsAre(1));
    EXPECT_EQ(network.listener.counters().late, 1U);
    network.receive(test::sacnSync(7000, 11));
    EXPECT_THAT(network.slots(1), ElementsAre(2));
}

TEST(SacnListener, DropsWhatIsHeldWhenLevelsComeWithoutAddress) {
    Network network;
    network.send({.syncAddress = 7000, .slots = {1}});
    network.sync(7000);
    network.send({.syncAddress = 7000, .slots = {2}});
    network.send({.syncAddress = 0, .slots = {3}});
    EXPECT_THAT(network.slots(1), ElementsAre(3));
    network.sync(7000);
    EXPECT_THAT(network.slots(1), ElementsAre(3));
}

TEST(SacnListener, GoesOnWithoutSynchronizationOnlyIfForced) {
    Network network;
    network.send({.syncAddress = 7000, .universe = 1, .slots = {1}});
    network.send({.syncAddress = 7000, .options = kForceSync, .universe = 2, .slots = {1}});
    network.sync(7000);
    for (int i = 0; i < 6; ++i) {
        network.wait(500ms);
        network.send({.syncAddress = 7000, .universe = 1, .slots = {2}});
        network.send({.syncAddress = 7000, .options = kForceSync, .universe = 2, .slots = {2}});
    }
    EXPECT_THAT(network.slots(1, 1), ElementsAre(1)) << "holds its last look";
    EXPECT_THAT(network.slots(1, 2), ElementsAre(2));
    network.sync(7000);
    EXPECT_THAT(network.slots(1, 1), ElementsAre(2)) << "synchronization resumed";
}

TEST(SacnListener, RefusesSourcesBeyondTheLimitAndSaysSo) {
    Network network;
    for (std::uint8_t cid = 1; cid <= 20; ++cid) network.send({.cid = cid, .slots = {cid}});
    EXPECT_EQ(network.listener.counters().levels, 16U);
    EXPECT_EQ(network.listener.counters().tooMany, 4U);
    EXPECT_EQ(network.status().refusedSources, 4U);
    EXPECT_EQ(network.status().sources.size(), 16U);
}

TEST(SacnListener, IsNotMovedByGarbage) {
    Network network;
    network.send({.slots = {10}});
    network.receive({});
    network.receive(Bytes(2000, 0xFF));
    network.receive(sacnData({.priority = 201, .sequence = 5, .slots = {99}}));
    EXPECT_EQ(network.listener.counters().malformed, 3U);
    EXPECT_THAT(network.slots(1), ElementsAre(10));
}

TEST(SacnListener, AllocatesNothingOnceSourcesAreKnown) {
    Network network;
    const auto round = [&](std::uint8_t sequence) {
        for (std::uint16_t universe = 1; universe <= 4; ++universe) {
            for (std::uint8_t cid = 1; cid <= 3; ++cid) {
                network.sendAs({.cid = cid, .syncAddress = 9, .sequence = sequence, .universe = universe});
            }
        }
    };
    round(0);
    network.receive(test::sacnSync(9, 1));
    network.wait(2s);
    round(1);
    network.receive(test::sacnSync(9, 2));

    std::vector<Bytes> datagrams;
    for (std::uint8_t sequence = 2; sequence < 40; ++sequence) {
        for (std::uint8_t cid = 1; cid <= 3; ++cid) {
            datagrams.push_back(sacnData({.cid = cid, .syncAddress = 9, .sequence = sequence}));
            datagrams.push_back(sacnData({.cid = cid, .sequence = ++sequence, .startCode = 0xDD}));
        }
        datagrams.push_back(test::sacnSync(9, sequence));
    }
    for (std::size_t i = 0; i < 14; ++i) network.receive(datagrams[i]);
    const std::size_t before = hazer::test::allocationCount();
    for (const Bytes& datagram : datagrams) network.receive(datagram);
    EXPECT_EQ(hazer::test::allocationCount() - before, 0U);
}

}  // namespace
}  // namespace hazer::protocol
