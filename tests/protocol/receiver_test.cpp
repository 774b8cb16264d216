// Over loopback and real sockets, with ports of the system's choice and bounded waits.
#include "protocol/receiver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <thread>

#include "protocol/network_error.h"
#include "protocol/sender.h"
#include "tests/protocol/loopback.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using test::Bytes;
using test::comesTrue;
using test::LoopbackSocket;

ReceiverConfig loopbackConfig() {
    ReceiverConfig config;
    config.address = "127.0.0.1";
    config.port = 0;
    config.maxPollReplyDelay = std::chrono::milliseconds(0);
    return config;
}

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const NetworkError& error) {
        return error.what();
    }
    return "no NetworkError";
}

TEST(Receiver, TakesWhatTheSenderSends) {
    UniverseStore store;
    const Receiver receiver(loopbackConfig(), store);
    ArtNetSender sender("127.0.0.1", receiver.port());
    sender.send(0, Bytes(512, 17));
    sender.send(32767, Bytes{1, 2, 3});
    sender.send(0, Bytes(512, 18));
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().dmx == 3; }));

    UniverseSet set;
    store.latch(set, Clock::now());
    ASSERT_EQ(set.size(), 2U);
    const Universe& lowest = set[{Transport::kArtNet, 0}];
    EXPECT_EQ(lowest.slotCount, 512);
    EXPECT_EQ(lowest.slots[511], 18);
    const Universe& highest = set[{Transport::kArtNet, 32767}];
    EXPECT_EQ(highest.slotCount, 4) << "an odd count is padded";
    EXPECT_EQ(highest.slots[2], 3);
}

TEST(Sender, NumbersItsPacketsFrom1To255PerPortAddress) {
    LoopbackSocket listener;
    ArtNetSender sender("127.0.0.1", listener.port());
    for (int i = 0; i < 256; ++i) {
        sender.send(1, Bytes{0, 0});
        const auto datagram = listener.receive();
        ASSERT_TRUE(datagram);
        EXPECT_EQ(int{(*datagram)[12]}, i % 255 + 1);
    }
    sender.send(2, Bytes{0, 0});
    EXPECT_EQ(listener.receive().value()[12], 1);
}

TEST(Receiver, TakesASecondSenderThatStartsItsNumbersAgain) {
    UniverseStore store;
    const Receiver receiver(loopbackConfig(), store);
    for (int run = 0; run < 3; ++run) {
        ArtNetSender sender("127.0.0.1", receiver.port());
        sender.send(0, Bytes{1, 1});
    }
    EXPECT_TRUE(comesTrue([&] { return receiver.counters().dmx == 3; }));
}

TEST(Receiver, AnswersAPollWithItsPortAddresses) {
    ReceiverConfig config = loopbackConfig();
    config.portAddresses = {0x123, 0};
    UniverseStore store;
    const Receiver receiver(config, store);
    LoopbackSocket desk;
    desk.sendTo(receiver.port(), test::pollDatagram());
    for (const std::uint8_t universe : Bytes{0, 3}) {
        const auto reply = desk.receive();
        ASSERT_TRUE(reply);
        ASSERT_EQ(reply->size(), 239U);
        EXPECT_EQ((*reply)[9], 0x21) << "OpCode";
        EXPECT_EQ(Bytes(reply->begin() + 10, reply->begin() + 14), (Bytes{127, 0, 0, 1})) << "IpAddress";
        EXPECT_EQ((*reply)[190], universe) << "SwOut";
    }
    EXPECT_EQ(receiver.counters().polls, 1U);
}

TEST(Receiver, AnswersAPollLaterWhenADelayIsAskedFor) {
    ReceiverConfig config = loopbackConfig();
    config.maxPollReplyDelay = std::chrono::milliseconds(50);
    UniverseStore store;
    const Receiver receiver(config, store);
    LoopbackSocket desk;
    desk.sendTo(receiver.port(), test::pollDatagram());
    EXPECT_TRUE(desk.receive());
}

TEST(Receiver, NamesItsAddressOnTheNetworkOfTheDeskWhenBoundToAll) {
    ReceiverConfig config = loopbackConfig();
    config.address = "0.0.0.0";
    UniverseStore store;
    const Receiver receiver(config, store);
    LoopbackSocket desk;
    desk.sendTo(receiver.port(), test::pollDatagram());
    const auto reply = desk.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(Bytes(reply->begin() + 10, reply->begin() + 14), (Bytes{127, 0, 0, 1})) << "IpAddress";
}

TEST(Receiver, GarbageIsCountedAndChangesNothing) {
    UniverseStore store;
    const Receiver receiver(loopbackConfig(), store);
    LoopbackSocket stranger;
    const Bytes garbage[] = {
        {}, {1}, Bytes(2000, 0xA5), Bytes(9000, 'A'), {'A', 'r', 't', '-', 'N', 'e', 't', 0}};
    for (const Bytes& datagram : garbage) stranger.sendTo(receiver.port(), datagram);
    stranger.sendTo(receiver.port(), test::dmxDatagram({}));
    ASSERT_TRUE(comesTrue([&] { return receiver.counters().dmx == 1; }));
    EXPECT_EQ(receiver.counters().malformed, std::size(garbage));
}

TEST(Receiver, TheTapHearsEverythingAsItArrived) {
    ReceiverConfig config = loopbackConfig();
    std::mutex mutex;
    std::vector<Bytes> heard;
    Datagram last;
    config.tap = [&](const Datagram& datagram) {
        const std::lock_guard lock(mutex);
        heard.emplace_back(datagram.bytes.begin(), datagram.bytes.end());
        last = datagram;
    };
    UniverseStore store;
    const Receiver receiver(config, store);
    LoopbackSocket desk;
    const Bytes packets[] = {{1, 2, 3}, test::dmxDatagram({}), {}};
    const WallTime before = std::chrono::system_clock::now();
    for (const Bytes& packet : packets) desk.sendTo(receiver.port(), packet);
    ASSERT_TRUE(
        comesTrue([&] { return receiver.counters().malformed == 2 && receiver.counters().dmx == 1; }));
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(std::ranges::equal(heard, packets));
    EXPECT_EQ(last.from.port, desk.port());
    EXPECT_EQ(last.to.port, receiver.port());
    EXPECT_EQ(last.to.address[0], 127);
    EXPECT_GE(last.time, before - std::chrono::seconds(1));
    EXPECT_LE(last.time, std::chrono::system_clock::now() + std::chrono::seconds(1));
}

TEST(Receiver, TellsTimeCodeAndTrigger) {
    UniverseStore store;
    const Receiver receiver(loopbackConfig(), store);
    LoopbackSocket desk;
    desk.sendTo(receiver.port(), packArtTimeCode({.minutes = 7}));
    desk.sendTo(receiver.port(), packArtTrigger({.key = 3, .subKey = 1}));
    ASSERT_TRUE(comesTrue([&] { return receiver.status().trigger.has_value(); }));
    EXPECT_EQ(receiver.status().timeCode.value().code.minutes, 7);
    EXPECT_EQ(receiver.status().trigger.value().key, 3);
}

TEST(Receiver, WhatTheSystemLosesIsCounted) {
    UniverseStore store;
    std::promise<void> go;
    std::shared_future<void> mayGo = go.get_future().share();
    ReceiverConfig config = loopbackConfig();
    config.tap = [&](const Datagram&) { mayGo.wait(); };
    const Receiver receiver(config, store);
    LoopbackSocket flood;
    const Bytes large(2000, 0);
    const int sent = 50000;  // 100 MB, more than any receive buffer here
    for (int i = 0; i < sent; ++i) flood.sendTo(receiver.port(), large);
    go.set_value();
    const auto malformed = [&] { return receiver.counters().malformed; };
    ASSERT_TRUE(comesTrue([&] {
        flood.sendTo(receiver.port(), Bytes{});
        return receiver.counters().droppedBySystem > 0;
    }));
    EXPECT_LT(malformed(), static_cast<std::uint64_t>(sent));
}

TEST(Receiver, TwoOnOnePortBothHearBroadcasts) {
    ReceiverConfig config = loopbackConfig();
    config.address = "0.0.0.0";
    UniverseStore firstStore;
    const Receiver first(config, firstStore);
    config.port = first.port();
    UniverseStore secondStore;
    const Receiver second(config, secondStore);
    ArtNetSender sender("127.255.255.255", first.port());
    sender.send(0, Bytes{1, 2});
    EXPECT_TRUE(comesTrue([&] { return first.counters().dmx == 1 && second.counters().dmx == 1; }));
}

TEST(Receiver, APortKeptByAnotherProgramIsOneSentenceWithARemedy) {
    const LoopbackSocket other;
    ReceiverConfig config = loopbackConfig();
    config.port = other.port();
    UniverseStore store;
    const std::string message = messageOf([&] { const Receiver receiver(config, store); });
    EXPECT_NE(message.find("127.0.0.1:" + std::to_string(other.port())), std::string::npos) << message;
    EXPECT_NE(message.find("choose another port"), std::string::npos) << message;
}

TEST(Receiver, AnAddressOfAnotherMachineIsOneSentenceWithARemedy) {
    ReceiverConfig config = loopbackConfig();
    config.address = "192.0.2.1";  // kept for documentation by RFC 5737, so nobody's
    UniverseStore store;
    const std::string message = messageOf([&] { const Receiver receiver(config, store); });
    EXPECT_NE(message.find("192.0.2.1:0"), std::string::npos) << message;
    EXPECT_NE(message.find("address of this machine"), std::string::npos) << message;
}

TEST(NetworkErrors, WhatIsNotAnIpv4AddressIsNamed) {
    for (const char* address : {"", "desk", "10.0.0", "10.0.0.256", "::1"}) {
        ReceiverConfig config = loopbackConfig();
        config.address = address;
        UniverseStore store;
        for (const std::string& message : {messageOf([&] { const Receiver receiver(config, store); }),
                                           messageOf([&] { const ArtNetSender sender(address); })}) {
            EXPECT_NE(message.find(std::string(address) + ":"), std::string::npos) << message;
            EXPECT_NE(message.find("not an IPv4 address"), std::string::npos) << message;
        }
    }
}

TEST(Receiver, StopsAtOnceUnderAFlood) {
    UniverseStore store;
    auto receiver = std::make_unique<Receiver>(loopbackConfig(), store);
    const std::uint16_t port = receiver->port();
    std::atomic<bool> stop = false;
    std::thread flood([&] {
        LoopbackSocket socket;
        while (!stop) socket.sendTo(port, Bytes(100, 0));
    });
    EXPECT_TRUE(comesTrue([&] { return receiver->counters().malformed > 100; }));
    const auto start = std::chrono::steady_clock::now();
    receiver.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    stop = true;
    flood.join();
}

TEST(Receiver, StopsWithAReplyStillOwed) {
    ReceiverConfig config = loopbackConfig();
    config.maxPollReplyDelay = std::chrono::hours(1);
    UniverseStore store;
    auto receiver = std::make_unique<Receiver>(config, store);
    LoopbackSocket desk;
    desk.sendTo(receiver->port(), test::pollDatagram());
    EXPECT_TRUE(comesTrue([&] { return receiver->counters().polls == 1; }));
    const auto start = std::chrono::steady_clock::now();
    receiver.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace
}  // namespace hazer::protocol
