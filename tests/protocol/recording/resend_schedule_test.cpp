#include "protocol/recording/resend_schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/artnet.h"
#include "protocol/sacn.h"
#include "tests/protocol/packets.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct TapedPacket {
    RecordingTime time{};
    Bytes bytes;
    std::uint16_t port = 6454;
    std::optional<UniverseId> frameOf{};  ///< Present: no datagram, but slots of a file without network.
};

/// A recording in memory.
class Tape : public RecordingReader {
 public:
    explicit Tape(std::vector<TapedPacket> packets) : packets_(std::move(packets)) {}

    std::optional<RecordedPacket> next() override {
        if (place_ == packets_.size()) return std::nullopt;
        const TapedPacket& packet = packets_[place_++];
        if (packet.frameOf) return RecordedPacket{packet.time, RecordedFrame{*packet.frameOf, packet.bytes}};
        RecordedDatagram datagram{.from = {.port = packet.port}, .to = {.port = packet.port}};
        datagram.bytes = packet.bytes;
        return RecordedPacket{packet.time, datagram};
    }
    RecordingMarkPtr mark() const override { return std::make_shared<Mark>(place_); }
    void goTo(const RecordingMark& mark) override { place_ = static_cast<const Mark&>(mark).place; }
    std::optional<RecordingTime> duration() const override {
        return packets_.empty() ? RecordingTime(0) : packets_.back().time;
    }
    double readShare() const override { return 1.0; }
    std::uint64_t refusedCount() const override { return 0; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
    struct Mark : RecordingMark {
        explicit Mark(std::size_t at) : place(at) {}
        std::size_t place;
    };

    std::vector<TapedPacket> packets_;
    std::size_t place_ = 0;
    std::vector<std::string> warnings_;
};

struct Sent {
    Clock::duration due{};
    RecordingTime time{};
    Transport transport{};
    Bytes bytes;
};

/// What goes out of a tape, at most `most` datagrams of it.
std::vector<Sent> sentFrom(std::vector<TapedPacket> tape, const ResendRules& rules, std::size_t most = 1000) {
    ResendSchedule schedule(std::make_unique<Tape>(std::move(tape)), rules);
    EXPECT_TRUE(schedule.skipToStart([] { return false; }));
    std::vector<Sent> all;
    while (all.size() < most) {
        const auto datagram = schedule.next();
        if (!datagram) break;
        all.push_back({datagram->due,
                       datagram->time,
                       datagram->transport,
                       {datagram->bytes.begin(), datagram->bytes.end()}});
    }
    return all;
}

std::vector<Clock::duration> duesOf(const std::vector<Sent>& all) {
    std::vector<Clock::duration> dues;
    for (const Sent& one : all) dues.push_back(one.due);
    return dues;
}

std::uint8_t sequenceOf(const Sent& sent) {
    const ArtNetPacket artNet = parseArtNet(sent.bytes);
    if (const auto* dmx = std::get_if<ArtDmx>(&artNet)) return dmx->sequence;
    const SacnPacket sacn = parseSacn(sent.bytes);
    return std::get<SacnData>(sacn).sequence;
}

std::vector<int> sequencesOf(const std::vector<Sent>& all) {
    std::vector<int> sequences;
    for (const Sent& one : all) sequences.push_back(sequenceOf(one));
    return sequences;
}

std::vector<TapedPacket> threeLevels() {
    return {{0s, dmxDatagram({.sequence = 7})},
            {1s, dmxDatagram({.sequence = 8})},
            {3s, dmxDatagram({.sequence = 9})}};
}

TEST(ResendSchedule, SendsEachDatagramAsItWasAtItsTime) {
    const auto sent = sentFrom(threeLevels(), {});
    EXPECT_THAT(duesOf(sent), ElementsAre(0s, 1s, 3s));
    EXPECT_EQ(sent[1].bytes, dmxDatagram({.sequence = 8}));
    EXPECT_EQ(sent[1].time, 1s);
}

TEST(ResendSchedule, RateStretchesTime) {
    EXPECT_THAT(duesOf(sentFrom(threeLevels(), {.rate = 4.0})), ElementsAre(0s, 250ms, 750ms));
    EXPECT_THAT(duesOf(sentFrom(threeLevels(), {.rate = 0.01})), ElementsAre(0s, 100s, 300s));
    EXPECT_THAT(duesOf(sentFrom(threeLevels(), {.rate = 2.0, .from = 1s})), ElementsAre(0s, 0s, 1s))
        << "what stood at the beginning, then the packets from there on";
}

TEST(ResendSchedule, TellsArtNetFromSacn) {
    const auto sent = sentFrom(
        {{0s, dmxDatagram({}), 7000}, {0s, sacnData({}), 7000}, {0s, {1, 2, 3}, 5568}, {0s, {1, 2, 3}, 6454}},
        {});
    std::vector<Transport> transports;
    for (const Sent& one : sent) transports.push_back(one.transport);
    EXPECT_THAT(transports,
                ElementsAre(Transport::kArtNet, Transport::kSacn, Transport::kSacn, Transport::kArtNet));
}

TEST(ResendSchedule, BeginsInTheMiddleWithWhatStoodThere) {
    const std::vector<TapedPacket> tape{
        {0s, dmxDatagram({.sequence = 1, .subUni = 1, .slots = {1, 1}})},
        {1s, dmxDatagram({.sequence = 2, .subUni = 1, .slots = {2, 2}})},
        {1s, pollDatagram()},
        {1s, sacnData({.sequence = 4, .universe = 9}), 5568},
        {1s, sacnData({.sequence = 5, .universe = 9, .startCode = 0xDD}), 5568},
        {1s, sacnData({.sequence = 1, .universe = 10}), 5568},
        {2s, sacnData({.sequence = 2, .options = 0x40, .universe = 10}), 5568},  // ends
        {5s, dmxDatagram({.sequence = 3, .subUni = 1, .slots = {3, 3}})}};
    const auto sent = sentFrom(tape, {.from = 4s});
    ASSERT_THAT(sent, SizeIs(4));
    std::vector<Bytes> standing;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(sent[i].due, 0s);
        EXPECT_EQ(sent[i].time, 4s);
        standing.push_back(sent[i].bytes);
    }
    EXPECT_THAT(standing, ::testing::UnorderedElementsAre(tape[1].bytes, tape[3].bytes, tape[4].bytes));
    EXPECT_EQ(sent[3].due, 1s);
    EXPECT_EQ(sent[3].bytes, tape[7].bytes);
}

TEST(ResendSchedule, EndsWithTheRecording) {
    ResendSchedule schedule(std::make_unique<Tape>(threeLevels()), {.rate = 2.0});
    ASSERT_TRUE(schedule.skipToStart([] { return false; }));
    while (schedule.next()) {
    }
    EXPECT_EQ(schedule.roundEnd(), 1500ms);
    EXPECT_EQ(schedule.rounds(), 1U);
    EXPECT_THAT(sentFrom({}, {}), IsEmpty());
    EXPECT_THAT(sentFrom({}, {.loops = true}), IsEmpty());
}

TEST(ResendSchedule, LoopsWithoutEndAndWithoutAGap) {
    const auto sent = sentFrom(threeLevels(), {.rate = 0.5, .loops = true}, 7);
    EXPECT_THAT(duesOf(sent), ElementsAre(0s, 2s, 6s, 6s, 8s, 12s, 12s));
    EXPECT_THAT(sequencesOf(sent), ElementsAre(7, 8, 9, 10, 11, 12, 13)) << "none of them is late";
    EXPECT_EQ(sent[3].time, 0s);
}

TEST(ResendSchedule, LoopsFromWhereItBegan) {
    const auto sent = sentFrom(threeLevels(), {.loops = true, .from = 1s}, 6);
    EXPECT_THAT(duesOf(sent), ElementsAre(0s, 0s, 2s, 2s, 4s, 4s));
    EXPECT_THAT(sequencesOf(sent), ElementsAre(7, 8, 9, 10, 11, 12));
}

// A recording of one packet must not become a flood, and one of none no endless loop.
TEST(ResendSchedule, ShortestRoundsTakeTheirTime) {
    const auto sent = sentFrom({{0s, dmxDatagram({})}}, {.loops = true}, 4);
    EXPECT_THAT(duesOf(sent), ElementsAre(0ms, 100ms, 200ms, 300ms));
    EXPECT_THAT(sentFrom(threeLevels(), {.loops = true, .from = 10s}), SizeIs(1))
        << "what stands, and no more";
}

TEST(ResendSchedule, NumbersWrapAsTheirProtocolDoes) {
    const std::vector<TapedPacket> artNet{{0s, dmxDatagram({.sequence = 254})},
                                          {1s, dmxDatagram({.sequence = 255})}};
    EXPECT_THAT(sequencesOf(sentFrom(artNet, {.loops = true}, 6)), ElementsAre(254, 255, 1, 2, 3, 4));
    const std::vector<TapedPacket> sacn{{0s, sacnData({.sequence = 254}), 5568},
                                        {1s, sacnData({.sequence = 255}), 5568}};
    EXPECT_THAT(sequencesOf(sentFrom(sacn, {.loops = true}, 6)), ElementsAre(254, 255, 0, 1, 2, 3));
    const auto all = sentFrom(artNet, {.loops = true}, 1000);
    EXPECT_TRUE(std::ranges::none_of(all, [](const Sent& one) { return sequenceOf(one) == 0; }))
        << "0 would say that there is no order";
}

TEST(ResendSchedule, WithoutNumbersThereAreNone) {
    const auto sent = sentFrom({{0s, dmxDatagram({})}, {1s, pollDatagram()}}, {.loops = true}, 4);
    EXPECT_EQ(sequenceOf(sent[2]), 0);
    EXPECT_EQ(sent[3].bytes, pollDatagram());
}

TEST(ResendSchedule, StreamsAreNumberedApart) {
    const auto sent = sentFrom({{0s, dmxDatagram({.sequence = 10, .subUni = 1})},
                                {1s, dmxDatagram({.sequence = 200, .subUni = 2})},
                                {2s, dmxDatagram({.sequence = 11, .subUni = 1})}},
                               {.loops = true}, 6);
    EXPECT_THAT(sequencesOf(sent), ElementsAre(10, 200, 11, 12, 201, 13));
}

TEST(ResendSchedule, LooksOfFilesWithoutNetworkBecomePackets) {
    const UniverseId artNet{Transport::kArtNet, 300};
    const auto sent = sentFrom({{0s, {9, 8, 7}, 0, artNet}, {1s, {}, 0, artNet}}, {.loops = true}, 3);
    const ArtNetPacket first = parseArtNet(sent[0].bytes);
    EXPECT_EQ(std::get<ArtDmx>(first).portAddress, 300);
    EXPECT_EQ(std::get<ArtDmx>(first).slots[1], 8);
    EXPECT_TRUE(std::holds_alternative<ArtDmx>(parseArtNet(sent[1].bytes))) << "a look of no slots";
    EXPECT_THAT(sequencesOf(sent), ElementsAre(1, 2, 3));

    const auto sacn = sentFrom({{0s, {9, 8, 7}, 0, UniverseId{Transport::kSacn, 5}}}, {});
    const SacnPacket packet = parseSacn(sacn.at(0).bytes);
    EXPECT_EQ(std::get<SacnData>(packet).universe, 5);
    EXPECT_THAT(std::get<SacnData>(packet).slots, ElementsAre(9, 8, 7));
}

TEST(ResendSchedule, StopsOnTheWayToItsStart) {
    ResendSchedule schedule(std::make_unique<Tape>(threeLevels()), {.from = 3s});
    EXPECT_FALSE(schedule.skipToStart([] { return true; }));
}

}  // namespace
}  // namespace hazer::protocol::test
