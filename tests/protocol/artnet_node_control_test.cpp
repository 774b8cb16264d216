// What a node does besides levels and polls: synchronization, remote programming, changes, messages.
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/artnet_node.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::Bytes;
using test::dmxDatagram;

const TimePoint kStart{std::chrono::hours(1)};
const Endpoint kDesk{{10, 0, 0, 1}, kArtNetPort};
const Endpoint kOtherDesk{{10, 0, 0, 2}, kArtNetPort};
const Ipv4Address kOwnAddress{10, 0, 0, 9};

class NodeControlTest : public testing::Test {
 protected:
    void use(ArtNetNodeConfig config) { node = ArtNetNode(std::move(config)); }

    template <class Datagram>
    void receive(const Datagram& datagram, Endpoint from, TimePoint now) {
        node.receive(datagram, from, now, merger);
    }

    void levels(std::uint8_t value, Endpoint from, TimePoint now, std::uint8_t subUni = 0) {
        receive(dmxDatagram({.subUni = subUni, .slots = {value, 0}}), from, now);
    }

    int slot(TimePoint now, std::uint16_t portAddress = 0) {
        node.advance(now, merger);
        merger.expire(now);
        UniverseSet set;
        merger.latch(set, now);
        return set[{Transport::kArtNet, portAddress}].slots[0];
    }

    /// Everything the node has to say at `now`, by desk.
    std::vector<std::pair<Endpoint, Bytes>> said(TimePoint now) {
        node.advance(now, merger);
        std::vector<std::pair<Endpoint, Bytes>> all;
        while (const auto reply = node.takeDueReply(now)) {
            for (const Bytes& datagram : node.packReply(*reply, kOwnAddress))
                all.emplace_back(reply->to, datagram);
        }
        return all;
    }

    UniverseMerger merger;
    ArtNetNode node{ArtNetNodeConfig{}};
};

// ArtSync

TEST_F(NodeControlTest, LevelsShowAtOnceUntilTheFirstSync) {
    levels(10, kDesk, kStart);
    EXPECT_EQ(slot(kStart), 10);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + milliseconds(10));
    levels(21, kDesk, kStart + milliseconds(10), 1);
    EXPECT_EQ(slot(kStart + milliseconds(10)), 10);
    receive(packArtSync(), kDesk, kStart + milliseconds(20));
    EXPECT_EQ(slot(kStart + milliseconds(20)), 20);
    EXPECT_EQ(slot(kStart + milliseconds(20), 1), 21);
    EXPECT_EQ(node.counters().syncs, 2U);
}

TEST_F(NodeControlTest, FourSecondsWithoutSyncShowWhatWaitsAndRunFree) {
    levels(10, kDesk, kStart);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + seconds(3));
    EXPECT_EQ(slot(kStart + milliseconds(3999)), 10);
    EXPECT_EQ(node.nextDeadline(), kStart + seconds(4));
    EXPECT_EQ(slot(kStart + seconds(4)), 20);
    levels(30, kDesk, kStart + seconds(5));
    EXPECT_EQ(slot(kStart + seconds(5)), 30);
}

TEST_F(NodeControlTest, TheTimeOutCountsEvenIfNobodyAdvancesTheNode) {
    levels(10, kDesk, kStart);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + seconds(60));
    UniverseSet set;
    merger.latch(set, kStart + seconds(60));
    EXPECT_EQ((set[{Transport::kArtNet, 0}].slots[0]), 20);
}

TEST_F(NodeControlTest, WhatWaitedIsShownAtTheTimeOutHoweverLateOneAsks) {
    levels(10, kDesk, kStart);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + seconds(3));
    EXPECT_EQ(slot(kStart + seconds(60)), 20) << "the desk was lost only later";
}

TEST_F(NodeControlTest, ASyncOfAStrangerIsIgnored) {
    levels(10, kDesk, kStart);
    receive(packArtSync(), kOtherDesk, kStart);
    EXPECT_EQ(node.counters().ignored, 1U);
    levels(20, kDesk, kStart + milliseconds(10));
    EXPECT_EQ(slot(kStart + milliseconds(10)), 20);
}

TEST_F(NodeControlTest, TwoDesksSynchronizeEachItsOwnUniverses) {
    levels(10, kDesk, kStart, 0);
    levels(11, kOtherDesk, kStart, 1);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + milliseconds(10), 0);
    levels(21, kOtherDesk, kStart + milliseconds(10), 1);
    EXPECT_EQ(slot(kStart + milliseconds(10), 0), 10);
    EXPECT_EQ(slot(kStart + milliseconds(10), 1), 21) << "this one never synchronized";
    receive(packArtSync(), kDesk, kStart + milliseconds(20));
    EXPECT_EQ(slot(kStart + milliseconds(20), 0), 20) << "though the latest ArtDmx was the other's";
}

TEST_F(NodeControlTest, AUniverseThatMergesIsNotSynchronized) {
    levels(10, kDesk, kStart);
    levels(5, kOtherDesk, kStart);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + milliseconds(10));
    EXPECT_EQ(slot(kStart + milliseconds(10)), 20);
}

// ArtAddress

TEST_F(NodeControlTest, UnlessAllowedArtAddressChangesNothingButIsAnswered) {
    use({.portAddresses = {0x123}, .shortName = "mine"});
    ArtAddress address;
    address.shortName = "yours";
    address.netSwitch = 0x85;
    address.command = AddressCommand::kMergeLatest;
    receive(packArtAddress(address), kDesk, kStart);
    const auto all = said(kStart);
    ASSERT_EQ(all.size(), 1U);
    const auto reply = std::get<PeerPollReply>(parseArtNet(all[0].second));
    EXPECT_EQ(reply.shortName, "mine");
    EXPECT_EQ(reply.wanted[0], 0x123);
    EXPECT_EQ(all[0].second[182] & 0x02, 0) << "LTP";
    EXPECT_EQ(merger.mode({Transport::kArtNet, 0x123}), MergeMode::kHighest);
    EXPECT_EQ(all[0].second[23], 0xD0) << "Status1: addresses set here";
}

TEST_F(NodeControlTest, NamesAndAddressesCanBeProgrammed) {
    use({.portAddresses = {0x123, 0x200}, .shortName = "mine", .isProgrammable = true});
    ArtAddress address;
    address.bindIndex = 1;
    address.shortName = "yours";
    address.netSwitch = 0x85;
    address.subSwitch = 0x84;
    address.swOut[0] = 0x83;
    receive(packArtAddress(address), kDesk, kStart);
    const auto all = said(kStart);
    ASSERT_EQ(all.size(), 2U);
    const auto reply = std::get<PeerPollReply>(parseArtNet(all[0].second));
    EXPECT_EQ(reply.shortName, "yours");
    EXPECT_EQ(reply.wanted[0], 0x543);
    EXPECT_EQ(all[0].second[23], 0xE0) << "Status1: addresses set by the network";
    EXPECT_EQ(std::get<PeerPollReply>(parseArtNet(all[1].second)).wanted[0], 0x200);
    receive(dmxDatagram({.subUni = 0x43, .net = 5, .slots = {9}}), kDesk, kStart);
    EXPECT_EQ(slot(kStart, 0x123), 9) << "the patch keeps its number";
    receive(dmxDatagram({.subUni = 0x23, .net = 1, .slots = {8}}), kDesk, kStart);
    EXPECT_EQ(slot(kStart, 0x123), 9) << "the old address is nobody's";

    address = {};
    address.netSwitch = address.subSwitch = address.swOut[0] = kSwitchReset;
    receive(packArtAddress(address), kDesk, kStart);
    EXPECT_EQ(std::get<PeerPollReply>(parseArtNet(said(kStart)[0].second)).wanted[0], 0x123);
}

TEST_F(NodeControlTest, MergingCanBeSetCancelledAndCleared) {
    use({.portAddresses = {0}, .isProgrammable = true});
    const auto order = [&](AddressCommand command, TimePoint now) {
        ArtAddress address;
        address.bindIndex = 1;
        address.command = command;
        receive(packArtAddress(address), kDesk, now);
    };
    levels(50, kDesk, kStart);
    levels(40, kOtherDesk, kStart);
    EXPECT_EQ(slot(kStart), 50);
    order(AddressCommand::kMergeLatest, kStart);
    EXPECT_EQ(slot(kStart), 40);
    EXPECT_NE(said(kStart).at(0).second[182] & 0x02, 0) << "GoodOutputA: LTP";
    order(AddressCommand::kMergeHighest, kStart);
    EXPECT_EQ(slot(kStart), 50);
    order(AddressCommand::kCancelMerge, kStart);
    levels(40, kOtherDesk, kStart);
    EXPECT_EQ(slot(kStart), 40);
    order(AddressCommand::kClear, kStart);
    EXPECT_EQ(slot(kStart), 0);
}

TEST_F(NodeControlTest, LocateShowsInTheReplies) {
    use({.portAddresses = {0}, .isProgrammable = true});
    ArtAddress address;
    address.command = AddressCommand::kIndicatorsLocate;
    receive(packArtAddress(address), kDesk, kStart);
    EXPECT_EQ(said(kStart).at(0).second[23] >> 6, 1);
    EXPECT_EQ(node.status().indicators, Indicators::kLocate);
}

// Replies to changes

Bytes poll(bool wantsChanges, bool wantsDiagnostics = false, std::uint8_t priority = kDiagLow) {
    const auto packed = packArtPoll(
        {.wantsChanges = wantsChanges, .wantsDiagnostics = wantsDiagnostics, .diagPriority = priority});
    return {packed.begin(), packed.end()};
}

TEST_F(NodeControlTest, AChangeIsToldToThoseWhoAskedForChanges) {
    use({.portAddresses = {0, 1}});
    receive(poll(true), kDesk, kStart);
    receive(poll(false), kOtherDesk, kStart);
    EXPECT_EQ(said(kStart).size(), 4U);
    EXPECT_TRUE(said(kStart + seconds(1)).empty()) << "nothing changed";
    levels(1, kDesk, kStart + seconds(2), 1);
    levels(2, kOtherDesk, kStart + seconds(2), 1);
    const auto all = said(kStart + seconds(2));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].first, kDesk);
    EXPECT_EQ(all[0].second[190], 1) << "SwOut";
    EXPECT_EQ(all[0].second[182], 0x88) << "GoodOutputA: data, merging";
    merger.expire(kStart + seconds(13));
    const auto end = said(kStart + seconds(13));
    ASSERT_EQ(end.size(), 1U);
    EXPECT_EQ(end[0].second[182], 0x00);
}

TEST_F(NodeControlTest, ADeskThatStoppedPollingIsForgotten) {
    use({.portAddresses = {0}});
    receive(poll(true), kDesk, kStart);
    said(kStart);
    levels(1, kDesk, kStart + seconds(31));
    EXPECT_TRUE(said(kStart + seconds(31)).empty());
}

TEST_F(NodeControlTest, APollIsAnsweredWithWhatThePortsDoNow) {
    use({.portAddresses = {0}});
    levels(1, kDesk, kStart);
    receive(poll(false), kDesk, kStart);
    EXPECT_EQ(said(kStart).at(0).second[182], 0x80);
}

// ArtDiagData

TEST_F(NodeControlTest, MessagesGoToThoseWhoWantThemByPriority) {
    receive(poll(false, true, kDiagMedium), kDesk, kStart);
    receive(poll(false, true, 0x80), kOtherDesk, kStart);
    said(kStart);
    for (std::uint8_t desk = 1; desk <= 3; ++desk) {
        levels(desk, {{10, 0, 0, desk}, kArtNetPort}, kStart + milliseconds(10));
        levels(desk, {{10, 0, 0, desk}, kArtNetPort}, kStart + milliseconds(20));
    }
    const auto all = said(kStart + milliseconds(30));
    ASSERT_EQ(all.size(), 1U) << "once, however often it is refused";
    EXPECT_EQ(all[0].first, kDesk);
    const auto message = std::get<ArtDiagData>(parseArtNet(all[0].second));
    EXPECT_EQ(message.priority, kDiagMedium);
    EXPECT_EQ(message.text, "Port-Address 0: a third source is refused");
}

// ArtIpProg, ArtTimeCode, ArtTrigger

TEST_F(NodeControlTest, ItsAddressIsNotForTheNetworkToSet) {
    Bytes prog = test::pollDatagram();
    prog[9] = 0xF8;
    prog.resize(34);
    prog[14] = 0x84;
    receive(prog, kDesk, kStart);
    const auto all = said(kStart);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].second[9], 0xF9);
    EXPECT_EQ(all[0].second[16], kOwnAddress[0]);
    EXPECT_EQ(all[0].second[19], kOwnAddress[3]);
}

TEST_F(NodeControlTest, TheLastTimeCodeAndTriggerAreKept) {
    EXPECT_FALSE(node.status().timeCode);
    receive(packArtTimeCode({.hours = 1, .frames = 5}), kDesk, kStart);
    receive(packArtTimeCode({.streamId = 1, .hours = 9}), kDesk, kStart + seconds(1));
    ASSERT_TRUE(node.status().timeCode);
    EXPECT_EQ(node.status().timeCode->code.hours, 1);
    EXPECT_EQ(node.status().timeCode->time, kStart);
    receive(packArtTrigger({.key = 3, .subKey = 7}), kDesk, kStart);
    receive(packArtTrigger({.oem = 0x1234, .key = 1, .subKey = 1}), kDesk, kStart);
    ASSERT_TRUE(node.status().trigger);
    EXPECT_EQ(node.status().trigger->key, 3);
    EXPECT_EQ(node.status().trigger->subKey, 7);
    EXPECT_EQ(node.counters().control, 2U);
    EXPECT_EQ(node.counters().ignored, 2U);
}

// Floods

TEST_F(NodeControlTest, MadeUpSendersNeitherGrowMemoryNorSilenceTheDesk) {
    for (unsigned i = 0; i < 5000; ++i) {
        const Endpoint stranger{{11, 0, static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)}, 1};
        const auto reply = packArtPollReply({.ownAddress = stranger.address, .shortName = "flood"});
        receive(reply, stranger, kStart);
        receive(packArtSync(), stranger, kStart);
    }
    levels(10, kDesk, kStart);
    receive(packArtSync(), kDesk, kStart);
    levels(20, kDesk, kStart + milliseconds(1));
    EXPECT_EQ(slot(kStart + milliseconds(1)), 10) << "it can still synchronize";
}

}  // namespace
}  // namespace hazer::protocol
