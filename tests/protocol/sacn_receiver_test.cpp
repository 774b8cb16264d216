// Over loopback, by unicast, with ports of the system's choice and bounded waits.
#include "protocol/sacn_receiver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "protocol/network_error.h"
#include "protocol/sacn_membership.h"
#include "protocol/sacn_sender.h"
#include "protocol/sacn_sockets.h"
#include "tests/protocol/loopback.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using test::comesTrue;
using test::LoopbackSocket;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

SacnReceiverConfig loopbackConfig() {
    SacnReceiverConfig config;
    config.interface = "lo";
    config.port = 0;
    return config;
}

SacnSenderConfig senderTo(std::uint16_t port, const std::string& address = "127.0.0.1") {
    SacnSenderConfig config;
    config.to = address;
    config.port = port;
    config.source.name = "desk";
    return config;
}

TEST(SacnReceiver, TakesWhatTheSenderSends) {
    UniverseStore store;
    const SacnReceiver receiver(loopbackConfig(), store);
    SacnSender sender(senderTo(receiver.port()));
    sender.setLevels(1, Bytes(512, 17));
    sender.setLevels(63999, Bytes{1, 2, 3});
    sender.sendDue(Clock::now());
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().levels == 2; }));

    UniverseSet set;
    store.latch(set, Clock::now());
    ASSERT_EQ(set.size(), 2U);
    EXPECT_EQ((set[{Transport::kSacn, 1}].slots[511]), 17);
    EXPECT_EQ((set[{Transport::kSacn, 63999}].slotCount), 3);
    ASSERT_TRUE(comesTrue([&] { return receiver.report().discovered.size() == 1; }));
    EXPECT_THAT(receiver.report().discovered[0].universes, ElementsAre(1, 63999));
    EXPECT_EQ(receiver.report().discovered[0].name, "desk");
    EXPECT_EQ(receiver.report().discovered[0].address, "127.0.0.1");
}

TEST(SacnReceiver, HearsTheSenderTerminate) {
    UniverseStore store;
    const SacnReceiver receiver(loopbackConfig(), store);
    {
        SacnSender sender(senderTo(receiver.port()));
        sender.setLevels(1, Bytes{1});
        sender.sendDue(Clock::now());
    }
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().terminations == 3; }));
    EXPECT_TRUE(store.status(Clock::now())[0].isLost);
}

TEST(SacnReceiver, HandsEveryDatagramToTheTap) {
    UniverseStore store;
    SacnReceiverConfig config = loopbackConfig();
    std::mutex mutex;
    std::vector<std::pair<IpEndpoint, Bytes>> tapped;
    WallTime time{};
    config.tap = [&](const Datagram& datagram) {
        const std::lock_guard lock(mutex);
        tapped.emplace_back(datagram.to, Bytes(datagram.bytes.begin(), datagram.bytes.end()));
        time = datagram.time;
    };
    const SacnReceiver receiver(config, store);
    LoopbackSocket desk;
    const WallTime before = std::chrono::system_clock::now();
    desk.sendTo(receiver.port(), test::sacnData({.slots = {9}}));
    desk.sendTo(receiver.port(), Bytes{'x'});
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().malformed == 1; }));
    const std::lock_guard lock(mutex);
    ASSERT_EQ(tapped.size(), 2U);
    EXPECT_EQ(tapped[0].first, (IpEndpoint{.address = {127, 0, 0, 1}, .port = receiver.port()}));
    EXPECT_EQ(tapped[0].second, test::sacnData({.slots = {9}}));
    EXPECT_EQ(tapped[1].second, Bytes{'x'});
    EXPECT_GE(time, before);
    EXPECT_LE(time, std::chrono::system_clock::now());
}

// libe131 #6, e131-node #17 stop at 20 universes. By unicast there is no such limit; by multicast see
// sacn_multicast_test.
TEST(SacnReceiver, Takes64UniversesAndMore) {
    UniverseStore store;
    const SacnReceiver receiver(loopbackConfig(), store);
    SacnSender sender(senderTo(receiver.port()));
    for (std::uint16_t universe = 1; universe <= 600; ++universe) sender.setLevels(universe, Bytes(512, 1));
    // In parts, since a system's default buffer does not hold them all.
    sender.sendDue(Clock::now());
    EXPECT_TRUE(comesTrue([&] {
        sender.sendDue(Clock::now());
        UniverseSet set;
        store.latch(set, Clock::now());
        return set.size() == 600;
    }));
}

TEST(SacnReceiver, SharesItsPortWithAnotherOfItsKind) {
    UniverseStore store;
    const SacnReceiver first(loopbackConfig(), store);
    SacnReceiverConfig config = loopbackConfig();
    config.port = first.port();
    const SacnReceiver second(config, store);
    EXPECT_EQ(second.port(), first.port());
}

std::string messageOf(const SacnReceiverConfig& config) {
    UniverseStore store;
    try {
        const SacnReceiver receiver(config, store);
    } catch (const NetworkError& error) {
        return error.what();
    }
    return "no NetworkError";
}

TEST(SacnReceiver, SaysWhatIsWrongWithInterfaceAndPort) {
    SacnReceiverConfig config = loopbackConfig();
    const LoopbackSocket holder;
    config.port = holder.port();
    EXPECT_THAT(messageOf(config), HasSubstr("close the program that keeps this port for itself"));
    config = loopbackConfig();
    config.interface = "no-such-0";
    EXPECT_THAT(messageOf(config), HasSubstr("this machine has lo"));
}

TEST(SacnReceiver, HearsIpv6Loopback) {
    UniverseStore store;
    SacnReceiverConfig config = loopbackConfig();
    config.interface = "::1";
    const auto interfaces = networkInterfaces();
    if (!findInterface(interfaces, "::1")) GTEST_SKIP() << "this machine has no IPv6";
    const SacnReceiver receiver(config, store);
    SacnSender sender(senderTo(receiver.port(), "::1"));
    sender.setLevels(1, Bytes{1});
    sender.sendDue(Clock::now());
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().levels == 1; }));
    EXPECT_EQ(store.status(Clock::now())[0].sources[0].address, "::1");
}

TEST(SacnReceiver, StopsWhileAFloodGoesOn) {
    std::atomic<bool> stop = false;
    UniverseStore store;
    auto receiver = std::make_unique<SacnReceiver>(loopbackConfig(), store);
    std::jthread flood([&, port = receiver->port()] {
        LoopbackSocket socket;
        const Bytes garbage(638, 0xEE);
        while (!stop) {
            try {
                socket.sendTo(port, garbage);
            } catch (const std::exception&) {
                // The port is closed by now.
            }
        }
    });
    EXPECT_TRUE(comesTrue([&] { return receiver->counters().malformed > 10'000; }));
    receiver.reset();
    stop = true;
}

TEST(SacnSockets, GoOnWithIpv4AloneAndSaySo) {
    asio::io_context context;
    std::vector<std::string> notices;
    const SacnSockets sockets(
        context, asio::ip::address_v4::loopback(), asio::ip::make_address_v6("2001:db8::77"), 0,
        [](asio::ip::udp::socket&) {}, [&](const std::string& sentence) { notices.push_back(sentence); });
    EXPECT_NE(sockets.port(), 0);
    EXPECT_FALSE(sockets.hasIpv6());
    EXPECT_THAT(notices, ElementsAre(HasSubstr("sACN is received over IPv4 alone: cannot listen on")));
}

NetworkInterface runningInterface(unsigned index, const std::string& name) {
    NetworkInterface one;
    one.name = name;
    one.index = index;
    one.isRunning = one.hasMulticast = true;
    one.addresses = {{.address = {10, 0, 0, static_cast<std::uint8_t>(index)}}};
    return one;
}

TEST(SacnMemberships, AreEveryGroupAtEveryInterfaceThatCanHearIt) {
    std::vector<NetworkInterface> all{runningInterface(1, "lo"), runningInterface(2, "eth0"),
                                      runningInterface(3, "eth1"), runningInterface(4, "unplugged"),
                                      runningInterface(5, "tunnel")};
    all[0].isLoopback = true;
    all[2].addresses.push_back({.address = {0xFE, 0x80}, .isIpv6 = true});
    all[3].isRunning = false;
    all[4].hasMulticast = false;
    using Set = std::set<SacnMembership>;
    EXPECT_EQ(sacnMemberships(all, "", {7}, false), (Set{{2, false, 7}, {3, false, 7}}));
    EXPECT_EQ(sacnMemberships(all, "", {7}, true), (Set{{2, false, 7}, {3, false, 7}, {3, true, 7}}));
    EXPECT_EQ(sacnMemberships(all, "eth1", {7, 8}, false), (Set{{3, false, 7}, {3, false, 8}}));
    EXPECT_EQ(sacnMemberships(all, "10.0.0.2", {7}, false), (Set{{2, false, 7}}));
    EXPECT_EQ(sacnMemberships(all, "unplugged", {7}, false), Set{});
    EXPECT_EQ(sacnMemberships(all, "gone", {7}, false), Set{});
}

}  // namespace
}  // namespace hazer::protocol
