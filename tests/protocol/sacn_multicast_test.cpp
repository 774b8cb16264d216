// sACN by multicast, in a network namespace that belongs to this program alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <mutex>

#include "protocol/network_interfaces.h"
#include "protocol/sacn_receiver.h"
#include "protocol/sacn_sender.h"
#include "tests/protocol/loopback.h"
#include "tests/protocol/own_network.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::comesTrue;
using test::ip;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Why there is no network of our own; empty: there is one.
std::string whyNoNetwork;

class SacnMulticast : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!whyNoNetwork.empty()) GTEST_SKIP() << whyNoNetwork;
    }

    std::unique_ptr<SacnReceiver> listenTo(std::vector<std::uint16_t> universes,
                                           const std::string& interface = "", bool joinsAnnounced = false) {
        SacnReceiverConfig config;
        config.universes = std::move(universes);
        config.joinsAnnounced = joinsAnnounced;
        config.interface = interface;
        config.notice = [this](const std::string& sentence) {
            const std::lock_guard lock(mutex_);
            notices_.push_back(sentence);
        };
        return std::make_unique<SacnReceiver>(config, store);
    }

    SacnSenderConfig sender(bool usesIpv6Groups = false) {
        SacnSenderConfig config;
        config.interface = "viz0";
        config.usesIpv6Groups = usesIpv6Groups;
        return config;
    }

    std::vector<std::string> notices() {
        const std::lock_guard lock(mutex_);
        return notices_;
    }

    std::set<std::uint16_t> universesHeard() {
        std::set<std::uint16_t> heard;
        UniverseSet set;
        store.latch(set, Clock::now());
        for (const auto& [id, universe] : set) heard.insert(id.number);
        return heard;
    }

    /// Sends `universes` again and again until `condition` comes true.
    bool comesTrueWhileSending(SacnSender& desk, const std::function<bool()>& condition) {
        std::uint8_t level = 0;
        return comesTrue([&] {
            for (const std::uint16_t universe : sending) desk.setLevels(universe, Bytes(512, ++level));
            desk.sendDue(Clock::now());
            return condition();
        });
    }

    static bool hasIpv6() {
        const auto viz0 = findInterface(networkInterfaces(), "viz0");
        return viz0 && viz0->hasAddress(true);
    }

    UniverseStore store;
    std::vector<std::uint16_t> sending;

 private:
    std::mutex mutex_;
    std::vector<std::string> notices_;
};

// libe131 #6, e131-node #17: a socket takes 20 groups and no more, and programs stopped there.
TEST_F(SacnMulticast, Hears64Universes) {
    for (std::uint16_t universe = 1; universe <= 64; ++universe) sending.push_back(universe * 100);
    const auto receiver = listenTo(sending);
    SacnSender desk(sender());
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return universesHeard().size() == 64; }));
    EXPECT_THAT(notices(), IsEmpty());
    EXPECT_GE(receiver->report().membershipCount, 65U) << "with discovery";
    EXPECT_GE(receiver->report().socketCount, 4U);
    EXPECT_EQ(receiver->report().discovered.size(), 1U);
}

TEST_F(SacnMulticast, HearsEachDatagramOnce) {
    const auto receiver = listenTo({1, 2, 3});
    const auto desk = std::make_unique<SacnSender>(sender());
    for (std::uint16_t universe = 1; universe <= 3; ++universe) desk->setLevels(universe, Bytes(512, 1));
    desk->sendDue(Clock::now());
    ASSERT_TRUE(comesTrue([&] { return receiver->counters().discoveries == 1; }));
    EXPECT_EQ(receiver->counters().levels, 3U);
    EXPECT_EQ(receiver->counters().late, 0U) << "a copy would be";
    EXPECT_THAT(receiver->report().universesOfWrongGroups, IsEmpty());
}

TEST_F(SacnMulticast, HearsIpv6) {
    if (!hasIpv6()) GTEST_SKIP() << "this system has no IPv6";
    sending = {1, 300};
    const auto receiver = listenTo(sending);
    SacnSender desk(sender(true));
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return universesHeard().size() == 2; }));
    EXPECT_EQ(store.status(Clock::now())[0].sources[0].address, "fd77::1");
    EXPECT_THAT(receiver->report().universesOfWrongGroups, IsEmpty());
}

// k-yle/sACN #19: what another program of this machine has joined reached everybody.
TEST_F(SacnMulticast, DoesNotHearWhatOthersHaveJoined) {
    UniverseStore otherStore;
    SacnReceiverConfig config;
    config.universes = {2};
    const SacnReceiver other(config, otherStore);
    const auto receiver = listenTo({1});
    sending = {1, 2};
    SacnSender desk(sender());
    ASSERT_TRUE(comesTrueWhileSending(
        desk, [&] { return other.counters().levels > 5 && receiver->counters().levels > 5; }));
    EXPECT_THAT(universesHeard(), ElementsAre(1));
}

// sACNView #252.
TEST_F(SacnMulticast, FlagsAUniverseThatComesByTheGroupOfAnother) {
    const auto receiver = listenTo({1, 2});
    asio::io_context context;
    asio::ip::udp::socket raw(context, asio::ip::udp::v4());
    const Bytes datagram = test::sacnData({.universe = 1, .slots = {5}});
    raw.send_to(asio::buffer(datagram), {asio::ip::make_address("239.255.0.2"), kSacnPort});
    ASSERT_TRUE(comesTrue([&] { return receiver->counters().levels == 1; }));
    EXPECT_THAT(receiver->report().universesOfWrongGroups, ElementsAre(1));
    EXPECT_THAT(universesHeard(), ElementsAre(1));
}

TEST_F(SacnMulticast, JoinsTheSynchronizationGroupsThatDataNames) {
    const auto receiver = listenTo({1});
    sending = {1};
    SacnSenderConfig config = sender();
    config.source.syncAddress = 7000;
    SacnSender desk(config);
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return receiver->counters().syncs > 3; }));
    EXPECT_EQ(receiver->report().syncs.at(0).address, 7000);
}

TEST_F(SacnMulticast, JoinsWhatIsAnnouncedIfItShall) {
    const auto receiver = listenTo({}, "", true);
    sending = {5, 300};
    SacnSender desk(sender());
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return universesHeard().size() == 2; }));
}

TEST_F(SacnMulticast, JoinsNoMoreThanABoundHoweverManyAreAnnounced) {
    const auto receiver = listenTo({}, "viz0", true);
    asio::io_context context;
    asio::ip::udp::socket raw(context, asio::ip::udp::v4());
    std::vector<std::uint16_t> announced;
    for (std::uint16_t universe = 1; universe <= 400; ++universe) announced.push_back(universe);
    const Bytes page = test::sacnDiscovery({.universes = announced});
    raw.send_to(asio::buffer(page), {asio::ip::make_address("239.255.250.214"), kSacnPort});
    EXPECT_TRUE(comesTrue([&] { return !notices().empty(); }));
    EXPECT_THAT(notices(), ElementsAre(HasSubstr("more sACN universes than the 256")));
    const std::size_t versions = hasIpv6() ? 2 : 1;
    EXPECT_TRUE(comesTrue([&] { return receiver->report().membershipCount == versions * (256 + 1); }));
}

// e131-node #6: only the first interface was joined, and only once.
TEST_F(SacnMulticast, JoinsAnInterfaceThatComesLater) {
    const auto receiver = listenTo({1});
    const std::size_t before = receiver->report().membershipCount;
    ASSERT_TRUE(ip("link add late0 type veth peer name late1") && ip("addr add 10.78.0.1/24 dev late0") &&
                ip("link set late0 up") && ip("link set late1 up"));
    EXPECT_TRUE(comesTrue([&] { return receiver->report().membershipCount > before; }));
    sending = {1};
    SacnSenderConfig config = sender();
    config.interface = "late0";
    {
        SacnSender desk(config);
        EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return receiver->counters().levels > 0; }));
        EXPECT_EQ(store.status(Clock::now())[0].sources[0].address, "10.78.0.1");
    }
    ip("link del late0");
    EXPECT_TRUE(comesTrue([&] { return receiver->report().membershipCount == before; }));
}

TEST_F(SacnMulticast, JoinsAnewWhenTheCableIsBack) {
    const auto receiver = listenTo({1});
    ASSERT_TRUE(comesTrue([&] { return receiver->report().membershipCount > 0; }));
    ASSERT_TRUE(ip("link set viz1 down"));
    EXPECT_TRUE(comesTrue([&] { return receiver->report().membershipCount == 0; }));
    EXPECT_THAT(notices(), ElementsAre(HasSubstr("until one is, sACN is heard by unicast alone")));
    ASSERT_TRUE(ip("link set viz1 up"));
    EXPECT_TRUE(comesTrue([&] { return receiver->report().membershipCount > 0; }));
    sending = {1};
    SacnSender desk(sender());
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return receiver->counters().levels > 0; }));
    EXPECT_EQ(notices().size(), 1U) << "said once";
}

TEST_F(SacnMulticast, ListensOnTheChosenInterfaceOnly) {
    ASSERT_TRUE(ip("link add side0 type veth peer name side1") && ip("addr add 10.79.0.1/24 dev side0") &&
                ip("link set side0 up") && ip("link set side1 up"));
    for (const char* chosen : {"side0", "10.79.0.1"}) {
        const auto receiver = listenTo({1}, chosen);
        sending = {1};
        SacnSender wrong(sender());
        SacnSenderConfig config = sender();
        config.interface = "side0";
        SacnSender right(config);
        EXPECT_TRUE(comesTrueWhileSending(wrong, [&] {
            right.setLevels(1, Bytes{3});
            right.sendDue(Clock::now());
            return receiver->counters().levels > 3;
        }));
        const std::vector<UniverseStatus> status = store.status(Clock::now());
        for (const SourceStatus& source : status[0].sources) EXPECT_EQ(source.address, "10.79.0.1");
    }
    ip("link del side0");
}

TEST_F(SacnMulticast, GoesOnByUnicastWhereGroupsCannotBeJoined) {
    std::ofstream("/proc/sys/net/ipv4/igmp_max_memberships") << 0;
    const auto receiver = listenTo({1, 2, 3});
    EXPECT_LE(receiver->report().socketCount, 2U);
    test::LoopbackSocket desk;
    desk.sendTo(kSacnPort, test::sacnData({.slots = {5}}));
    EXPECT_TRUE(comesTrue([&] { return receiver->counters().levels == 1; }));
    EXPECT_THAT(notices(), ElementsAre(HasSubstr("cannot be joined")));
    std::ofstream("/proc/sys/net/ipv4/igmp_max_memberships") << 20;
}

TEST_F(SacnMulticast, WorksWhereIpv6IsSwitchedOff) {
    std::ofstream("/proc/sys/net/ipv6/conf/all/disable_ipv6") << 1;
    sending = {1};
    const auto receiver = listenTo(sending);
    SacnSender desk(sender());
    EXPECT_TRUE(comesTrueWhileSending(desk, [&] { return receiver->counters().levels > 0; }));
    std::ofstream("/proc/sys/net/ipv6/conf/all/disable_ipv6") << 0;
}

}  // namespace
}  // namespace hazer::protocol

int main(int argumentCount, char** arguments) {
    ::testing::InitGoogleMock(&argumentCount, arguments);
    if (!::testing::GTEST_FLAG(list_tests))
        hazer::protocol::whyNoNetwork = hazer::protocol::test::enterOwnNetwork();
    return RUN_ALL_TESTS();
}
