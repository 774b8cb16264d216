#include "protocol/artnet_node.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using std::chrono::milliseconds;
using test::Bytes;
using test::dmxDatagram;
using test::pollDatagram;
using test::targetedPollDatagram;

const TimePoint kStart{std::chrono::hours(1)};
const Endpoint kDesk{{10, 0, 0, 1}, 6454};
const Ipv4Address kOwnAddress{10, 0, 0, 9};

class ArtNetNodeTest : public testing::Test {
 protected:
    Universe universe(std::uint16_t portAddress) const {
        UniverseSet set;
        merger.latch(set, kStart);
        return set[{Transport::kArtNet, portAddress}];
    }

    std::vector<Bytes> answersTo(ArtNetNode& node, const Bytes& poll) {
        node.receive(poll, kDesk, kStart, merger);
        node.advance(kStart, merger);
        const auto reply = node.takeDueReply(kStart);
        return reply ? node.packReply(*reply, kOwnAddress) : std::vector<Bytes>{};
    }

    UniverseMerger merger;
};

std::uint16_t portAddressOf(const Bytes& reply) {
    return static_cast<std::uint16_t>(reply[18] << 8 | reply[19] << 4 | reply[190]);
}

std::uint64_t total(const ReceiverCounters& c) {
    return c.dmx + c.late + c.refused + c.polls + c.syncs + c.control + c.ignored + c.malformed;
}

TEST_F(ArtNetNodeTest, PutsLevelsIntoTheStore) {
    ArtNetNode node({});
    node.receive(dmxDatagram({.subUni = 0xFF, .net = 0x7F, .slots = {10, 200}}), kDesk, kStart, merger);
    const Universe taken = universe(0x7FFF);
    EXPECT_EQ(taken.slotCount, 2);
    EXPECT_EQ(taken.slots[0], 10);
    EXPECT_EQ(taken.slots[1], 200);
    EXPECT_EQ(taken.lastReceived, kStart);
    EXPECT_EQ(node.counters().dmx, 1U);
}

TEST_F(ArtNetNodeTest, AShorterPacketTakesTheMissingSlotsToZero) {
    ArtNetNode node({});
    node.receive(dmxDatagram({.slots = Bytes(512, 255)}), kDesk, kStart, merger);
    node.receive(dmxDatagram({.slots = {1, 2, 3}}), kDesk, kStart, merger);
    EXPECT_EQ(universe(0).slotCount, 3);
    EXPECT_EQ(universe(0).slots[2], 3);
    EXPECT_EQ(universe(0).slots[3], 0);
    EXPECT_EQ(universe(0).slots[511], 0);
}

TEST_F(ArtNetNodeTest, APacketOvertakenByANewerOneIsDropped) {
    ArtNetNode node({});
    node.receive(dmxDatagram({.sequence = 2, .slots = {20}}), kDesk, kStart, merger);
    node.receive(dmxDatagram({.sequence = 1, .slots = {10}}), kDesk, kStart, merger);
    EXPECT_EQ(universe(0).slots[0], 20);
    EXPECT_EQ(node.counters().late, 1U);
    EXPECT_EQ(node.counters().dmx, 1U);
}

TEST_F(ArtNetNodeTest, TwoSourcesAreMergedAndNumberTheirPacketsEachForThemselves) {
    ArtNetNode node({});
    const Endpoint otherDesk{{10, 0, 0, 2}, 6454};
    node.receive(dmxDatagram({.sequence = 50, .slots = {50}}), kDesk, kStart, merger);
    node.receive(dmxDatagram({.sequence = 49, .slots = {49, 7}}), otherDesk, kStart, merger);
    EXPECT_EQ(universe(0).slots[0], 50);
    EXPECT_EQ(universe(0).slots[1], 7);
    EXPECT_EQ(node.counters().dmx, 2U);
}

TEST_F(ArtNetNodeTest, EveryDatagramIsCountedOnce) {
    ArtNetNode node({.portAddresses = {1}});
    Bytes sync = pollDatagram();
    sync[9] = 0x52;
    Bytes timeCode = pollDatagram();
    timeCode[9] = 0x97;
    Bytes unused = pollDatagram();
    unused[9] = 0xF2;
    Bytes oldVersion = dmxDatagram({});
    oldVersion[11] = 13;
    const Bytes datagrams[] = {{},
                               {0xFF},
                               dmxDatagram({}),
                               dmxDatagram({.slots = {}}),
                               pollDatagram(),
                               targetedPollDatagram(2, 9),
                               sync,
                               timeCode,
                               unused,
                               oldVersion};
    for (const Bytes& datagram : datagrams) node.receive(datagram, kDesk, kStart, merger);
    const ReceiverCounters& counters = node.counters();
    EXPECT_EQ(counters.dmx, 1U);
    EXPECT_EQ(counters.polls, 1U);
    EXPECT_EQ(counters.syncs, 1U);
    EXPECT_EQ(counters.control, 0U);
    EXPECT_EQ(counters.ignored, 4U);    // no slots, a poll for others, a further time code stream, firmware
    EXPECT_EQ(counters.malformed, 3U);  // empty, one byte, version 13
    EXPECT_EQ(total(counters), std::size(datagrams));
}

TEST_F(ArtNetNodeTest, AnswersWithOneReplyForEachPortAddress) {
    ArtNetNode node({.portAddresses = {0x7FFF, 0, 0x123, 0}, .shortName = "stage"});
    const auto replies = answersTo(node, pollDatagram());
    ASSERT_EQ(replies.size(), 3U);
    EXPECT_EQ(portAddressOf(replies[0]), 0);
    EXPECT_EQ(portAddressOf(replies[1]), 0x123);
    EXPECT_EQ(portAddressOf(replies[2]), 0x7FFF);
    for (std::size_t i = 0; i < replies.size(); ++i) {
        EXPECT_EQ(replies[i][211], i + 1) << "BindIndex";
        EXPECT_EQ(replies[i][173], 1) << "NumPorts";
        EXPECT_EQ(replies[i][10], kOwnAddress[0]);
        EXPECT_EQ(replies[i][26], 's');
    }
}

TEST_F(ArtNetNodeTest, WithoutPortAddressesItStillShowsItself) {
    ArtNetNode node({});
    const auto replies = answersTo(node, pollDatagram());
    ASSERT_EQ(replies.size(), 1U);
    EXPECT_EQ(replies[0][173], 0) << "NumPorts";
    EXPECT_EQ(replies[0][211], 1) << "BindIndex";
}

TEST_F(ArtNetNodeTest, BindIndexNeverBecomesZero) {
    ArtNetNodeConfig config;
    for (std::uint16_t i = 0; i < 300; ++i) config.portAddresses.push_back(i);
    ArtNetNode node(config);
    const auto replies = answersTo(node, pollDatagram());
    ASSERT_EQ(replies.size(), 300U);
    EXPECT_EQ(replies[254][211], 255);
    EXPECT_EQ(replies[255][211], 1);
}

TEST_F(ArtNetNodeTest, ATargetedPollIsAnsweredWithTheAddressesItNames) {
    ArtNetNode node({.portAddresses = {1, 2, 3, 4}});
    const auto replies = answersTo(node, targetedPollDatagram(2, 3));
    ASSERT_EQ(replies.size(), 2U);
    EXPECT_EQ(portAddressOf(replies[0]), 2);
    EXPECT_EQ(portAddressOf(replies[1]), 3);
    EXPECT_EQ(replies[0][211], 2) << "BindIndex stays that of the port";
    EXPECT_TRUE(answersTo(node, targetedPollDatagram(5, 9)).empty());
    EXPECT_TRUE(answersTo(node, targetedPollDatagram(3, 2)).empty());
}

TEST_F(ArtNetNodeTest, RepliesGoToWhereThePollCameFrom) {
    ArtNetNode node({});
    const Endpoint onAnEphemeralPort{{127, 0, 0, 1}, 40123};
    node.receive(pollDatagram(), onAnEphemeralPort, kStart, merger);
    const auto reply = node.takeDueReply(kStart);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->to, onAnEphemeralPort);
}

TEST_F(ArtNetNodeTest, RepliesWaitARandomTimeUpToTheMaximum) {
    std::set<TimePoint> times;
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        ArtNetNode node({.maxPollReplyDelay = milliseconds(1000), .randomSeed = seed});
        EXPECT_FALSE(node.nextDeadline());
        node.receive(pollDatagram(), kDesk, kStart, merger);
        TimePoint due = kStart;
        while (!node.takeDueReply(due) && due < kStart + milliseconds(2000)) due += milliseconds(1);
        EXPECT_LE(due, kStart + milliseconds(1000));
        EXPECT_FALSE(node.takeDueReply(due));
        times.insert(due);
    }
    EXPECT_GT(times.size(), 10U);
}

TEST_F(ArtNetNodeTest, PollsOfOneDeskBeforeItsReplyShareIt) {
    ArtNetNode node({.portAddresses = {1, 5, 9}});
    node.receive(targetedPollDatagram(1, 1), kDesk, kStart, merger);
    node.receive(targetedPollDatagram(5, 5), kDesk, kStart, merger);
    const auto reply = node.takeDueReply(kStart);
    ASSERT_TRUE(reply);
    EXPECT_EQ(node.packReply(*reply, kOwnAddress).size(), 2U);
    EXPECT_FALSE(node.takeDueReply(kStart));
    EXPECT_EQ(node.counters().polls, 2U);
}

TEST_F(ArtNetNodeTest, AFloodOfPollersIsOwedABoundedNumberOfReplies) {
    ArtNetNode node({});
    for (std::uint16_t port = 1; port <= 1000; ++port) {
        node.receive(pollDatagram(), {{10, 0, 0, 1}, port}, kStart, merger);
    }
    EXPECT_EQ(node.counters().polls, ArtNetNode::kMaxPendingReplies);
    EXPECT_EQ(node.counters().ignored, 1000 - ArtNetNode::kMaxPendingReplies);
    std::size_t replies = 0;
    while (node.takeDueReply(kStart)) ++replies;
    EXPECT_EQ(replies, ArtNetNode::kMaxPendingReplies);
}

TEST_F(ArtNetNodeTest, APollFromOurOwnAddressIsAnswered) {
    ArtNetNode node({.portAddresses = {1}});
    node.receive(pollDatagram(), {kOwnAddress, kArtNetPort}, kStart, merger);
    EXPECT_TRUE(node.takeDueReply(kStart)) << "a desk on this machine";
}

TEST_F(ArtNetNodeTest, EveryPortAddressIsAnnouncedAsItself) {
    ArtNetNodeConfig config;
    for (unsigned i = 0; i <= kMaxPortAddress; ++i)
        config.portAddresses.push_back(static_cast<std::uint16_t>(i));
    ArtNetNode node(config);
    const auto replies = answersTo(node, pollDatagram());
    ASSERT_EQ(replies.size(), kMaxPortAddress + 1U);
    for (std::size_t i = 0; i < replies.size(); ++i) {
        ASSERT_EQ(portAddressOf(replies[i]), i);
        const auto peer = std::get<PeerPollReply>(parseArtNet(replies[i]));
        ASSERT_EQ(peer.wanted[0], i) << "as a desk reads it";
    }
}

TEST_F(ArtNetNodeTest, SourcesAreCalledAsTheyCallThemselves) {
    ArtNetNode node({});
    const ArtPollReplyBytes reply = packArtPollReply({.ownAddress = kDesk.address,
                                                      .shortName = "big\x01"
                                                                   "desk"});
    node.receive(reply, kDesk, kStart, merger);
    node.receive(dmxDatagram({}), kDesk, kStart, merger);
    const auto status = merger.status(kStart);
    EXPECT_EQ(status.at(0).sources.at(0).address, "10.0.0.1");
    EXPECT_EQ(status.at(0).sources.at(0).name,
              "big\xEF\xBF\xBD"
              "desk")
        << "fit for a terminal";
}

TEST_F(ArtNetNodeTest, LevelsFarTooManyAreRefusedAndCounted) {
    ArtNetNode node({});
    for (std::uint8_t desk = 1; desk <= 3; ++desk) {
        node.receive(dmxDatagram({.slots = {desk}}), {{10, 0, 0, desk}, 6454}, kStart, merger);
    }
    EXPECT_EQ(node.counters().dmx, 2U);
    EXPECT_EQ(node.counters().refused, 1U);
    EXPECT_EQ(universe(0).slots[0], 2);
}

TEST_F(ArtNetNodeTest, OtherStartCodesAreNoLevels) {
    ArtNetNode node({});
    Bytes nzs = dmxDatagram({.physical = 0xDD, .slots = {255, 255}});
    nzs[9] = 0x51;
    node.receive(nzs, kDesk, kStart, merger);
    EXPECT_EQ(node.counters().ignored, 1U);
    EXPECT_TRUE(merger.status(kStart).empty());
}

TEST_F(ArtNetNodeTest, TheNodeReportCountsReplies) {
    ArtNetNode node({});
    const auto first = answersTo(node, pollDatagram());
    const auto second = answersTo(node, pollDatagram());
    EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(&first[0][108])), "#0001 [0001] Listening");
    EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(&second[0][108])), "#0001 [0002] Listening");
}

}  // namespace
}  // namespace hazer::protocol
