// Over loopback, by unicast.
#include "protocol/sacn_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/network_error.h"
#include "protocol/network_interfaces.h"
#include "tests/protocol/loopback.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;

SacnSenderConfig configTo(const std::string& address, std::uint16_t port = kSacnPort) {
    SacnSenderConfig config;
    config.to = address;
    config.port = port;
    return config;
}
using ::testing::HasSubstr;

TEST(SacnSender, SendsByUnicastAndTerminatesWhenItGoes) {
    test::LoopbackSocket listener;
    Cid cid{};
    {
        SacnSender sender(configTo("127.0.0.1", listener.port()));
        cid = sender.cid();
        EXPECT_NE(cid, Cid{});
        sender.setLevels(9, Bytes{1, 2, 3});
        sender.sendDue(Clock::now());
        EXPECT_EQ(sender.packetCount(), 2U) << "levels and discovery";
    }
    const Bytes levels = listener.receive().value();
    const SacnPacket packet = parseSacn(levels);
    const SacnData& data = std::get<SacnData>(packet);
    EXPECT_EQ(data.cid, cid);
    EXPECT_EQ(data.universe, 9);
    EXPECT_THAT(data.slots, ::testing::ElementsAre(1, 2, 3));
    EXPECT_TRUE(std::holds_alternative<SacnDiscovery>(parseSacn(listener.receive().value())));
    for (int copy = 0; copy < 3; ++copy) {
        const Bytes last = listener.receive().value();
        EXPECT_TRUE(std::get<SacnData>(parseSacn(last)).isTerminated);
    }
}

std::string messageOf(const SacnSenderConfig& config) {
    try {
        const SacnSender sender(config);
    } catch (const NetworkError& error) {
        return error.what();
    }
    return "no NetworkError";
}

TEST(SacnSender, RefusesWhatIsNoAddressAndNoInterface) {
    EXPECT_THAT(messageOf(configTo("desk")), HasSubstr("not an IP address"));
    SacnSenderConfig multicast;
    multicast.interface = "no-such-0";
    EXPECT_THAT(messageOf(multicast), HasSubstr("this machine has lo"));
}

TEST(NetworkInterfaces, FindLoopbackByNameAndByAnyOfItsAddresses) {
    const auto all = networkInterfaces();
    for (const char* name : {"lo", "127.0.0.1", "127.0.0.2"}) {
        const auto found = findInterface(all, name);
        ASSERT_TRUE(found) << name;
        EXPECT_TRUE(found->isLoopback);
        EXPECT_TRUE(found->hasAddress(false));
    }
    EXPECT_FALSE(findInterface(all, "192.0.2.77"));
    EXPECT_FALSE(findInterface(all, ""));
}

}  // namespace
}  // namespace hazer::protocol
