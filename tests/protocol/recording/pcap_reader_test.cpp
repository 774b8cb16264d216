#include "protocol/recording/pcap_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/protocol/recording/capture_builder.h"
#include "tests/protocol/sacn_packets.h"
#include "tests/support/temporary_folder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::chrono::nanoseconds kStart = std::chrono::seconds(1'700'000'000);

CapturedFrame dmxAt(std::chrono::nanoseconds time, std::uint8_t sequence) {
    return {kStart + time, ethernetFrame(ipv4Packet({.payload = dmxDatagram({.sequence = sequence})}))};
}

class PcapReader : public ::testing::Test {
 protected:
    std::unique_ptr<RecordingReader> open(const Bytes& bytes) {
        return openRecording(folder_.write("a.pcap", textOf(bytes)));
    }

    hazer::test::TemporaryFolder folder_;
};

TEST_F(PcapReader, ReadsEveryKindOfFile) {
    const std::vector<CapturedFrame> frames{dmxAt(0ns, 1), dmxAt(1'234'567us, 2)};
    std::vector<Bytes> files;
    for (const PcapKind kind : {PcapKind::kMicroseconds, PcapKind::kNanoseconds,
                                PcapKind::kBigEndianMicroseconds, PcapKind::kBigEndianNanoseconds}) {
        files.push_back(pcapFile(frames, 1, kind));
    }
    for (const int resolution : {6, 9}) files.push_back(pcapngFile(frames, 1, resolution));
    for (const Bytes& file : files) {
        const auto reader = open(file);
        const std::vector<ReadPacket> packets = readAll(*reader);
        ASSERT_THAT(packets, SizeIs(2));
        EXPECT_EQ(packets[0].time, 0ns);
        EXPECT_EQ(packets[1].time, 1'234'567us);
        EXPECT_EQ(packets[1].bytes, dmxDatagram({.sequence = 2}));
        EXPECT_EQ(packets[1].from, (IpEndpoint{{10, 0, 0, 1}, false, 6454}));
        EXPECT_EQ(reader->duration(), 1'234'567us);
        EXPECT_EQ(reader->refusedCount(), 0u);
        EXPECT_THAT(reader->warnings(), IsEmpty());
    }
}

TEST_F(PcapReader, KeepsNanoseconds) {
    const auto reader = open(pcapFile({dmxAt(0ns, 1), dmxAt(1ns, 2), dmxAt(999'999'999ns, 3)}));
    const auto packets = readAll(*reader);
    ASSERT_THAT(packets, SizeIs(3));
    EXPECT_EQ(packets[1].time, 1ns);
    EXPECT_EQ(packets[2].time, 999'999'999ns);
}

TEST_F(PcapReader, TimeNeverGoesBack) {
    const auto reader =
        open(pcapFile({dmxAt(5s, 1), dmxAt(7s, 2), dmxAt(6s, 3), dmxAt(1s, 4), dmxAt(8s, 5)}));
    std::vector<RecordingTime> times;
    for (const ReadPacket& packet : readAll(*reader)) times.push_back(packet.time);
    EXPECT_THAT(times, ElementsAre(0s, 2s, 2s, 2s, 3s));
}

TEST_F(PcapReader, TakesLightingByPortOrByItsFirstBytes) {
    const Bytes artNet = dmxDatagram({});
    const Bytes sacn = sacnData({});
    std::vector<CapturedFrame> frames;
    for (const UdpFields& fields :
         {UdpFields{.port = 6454, .payload = {1, 2, 3}}, UdpFields{.port = 7000, .payload = artNet},
          UdpFields{.port = 5568, .payload = {1}}, UdpFields{.port = 7001, .payload = sacn},
          UdpFields{.sourcePort = 6454, .port = 53, .payload = {1, 2, 3}}}) {
        frames.push_back({kStart, ethernetFrame(ipv4Packet(fields))});
    }
    const auto packets = readAll(*open(pcapFile(frames)));
    ASSERT_THAT(packets, SizeIs(4));
    EXPECT_EQ(packets[1].bytes, artNet);
    EXPECT_EQ(packets[3].bytes, sacn);
}

TEST_F(PcapReader, JoinsFragments) {
    const UdpFields fields{.payload = sacnData({.slots = Bytes(512, 9)})};
    std::vector<CapturedFrame> frames;
    for (const Bytes& fragment : ipv4Fragments(fields, 400))
        frames.push_back({kStart, ethernetFrame(fragment)});
    const auto packets = readAll(*open(pcapFile(frames)));
    ASSERT_THAT(packets, SizeIs(1));
    EXPECT_EQ(packets[0].bytes, fields.payload);
}

TEST_F(PcapReader, CountsWhatTheCaptureCutShort) {
    CapturedFrame cut = dmxAt(0ns, 1);
    cut.bytes.resize(cut.bytes.size() - 2);
    const auto reader = open(pcapFile({cut, dmxAt(1s, 2)}));
    EXPECT_THAT(readAll(*reader), SizeIs(1));
    EXPECT_EQ(reader->refusedCount(), 1u);
}

TEST_F(PcapReader, ReadsWhatIsWholeOfACutFile) {
    const Bytes whole = pcapFile({dmxAt(0ns, 1), dmxAt(1s, 2)});
    const Bytes first = pcapFile({dmxAt(0ns, 1)});
    for (std::size_t size = first.size() + 1; size < whole.size(); ++size) {
        const auto reader = open(prefixOf(whole, size));
        EXPECT_THAT(readAll(*reader), SizeIs(1)) << size;
        EXPECT_THAT(reader->warnings(),
                    ElementsAre(HasSubstr("read up to packet 1, where the capture is cut")));
    }
}

TEST_F(PcapReader, EveryTruncatedPrefixIsReadOrRefused) {
    for (const Bytes& whole : {pcapFile({dmxAt(0ns, 1)}), pcapngFile({dmxAt(0ns, 1)})}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            try {
                EXPECT_THAT(readAll(*open(prefixOf(whole, size))), IsEmpty());
            } catch (const RecordingError& error) {
                EXPECT_THAT(error.what(), HasSubstr("a.pcap"));
            }
        }
    }
}

TEST_F(PcapReader, GoesOnFromAnyMark) {
    std::vector<CapturedFrame> frames;
    for (int i = 0; i < 50; ++i) frames.push_back(dmxAt(i * 10ms, static_cast<std::uint8_t>(i + 1)));
    const auto fragments =
        ipv4Fragments({.payload = dmxDatagram({.sequence = 77, .slots = Bytes(512, 3)})}, 400);
    frames.insert(frames.begin() + 20, {kStart + 195ms, ethernetFrame(fragments[0])});
    frames.insert(frames.begin() + 30, {kStart + 285ms, ethernetFrame(fragments[1])});
    for (const Bytes& file : {pcapFile(frames), pcapngFile(frames)}) {
        const auto reader = open(file);
        std::vector<RecordingMarkPtr> marks{reader->mark()};
        std::vector<ReadPacket> packets;
        while (const auto packet = reader->next()) {
            packets.push_back(copyOf(*packet));
            marks.push_back(reader->mark());
        }
        ASSERT_THAT(packets, SizeIs(51));
        const auto another = openRecording(folder_.path() / "a.pcap");
        for (const std::size_t place : {25u, 0u, 51u, 50u, 21u, 22u, 1u}) {
            another->goTo(*marks[place]);
            EXPECT_EQ(readAll(*another), std::vector(packets.begin() + place, packets.end())) << place;
            EXPECT_EQ(another->duration(), 490ms);
        }
    }
}

// libpcap remembers the interfaces of the section that it is in. A place in another section must be found all
// the same.
TEST_F(PcapReader, FindsPlacesInFilesOfSeveralSections) {
    std::vector<Bytes> sections;
    for (int i = 0; i < 4; ++i) {
        const auto sequence = static_cast<std::uint8_t>(i + 1);
        sections.push_back(
            pcapngFile({dmxAt(i * 1s, sequence), dmxAt(i * 1s + 1ms, sequence)}, 1, i % 2 ? 6 : 9));
    }
    const auto reader = open(joined(sections));
    std::vector<RecordingMarkPtr> marks{reader->mark()};
    std::vector<ReadPacket> packets;
    while (const auto packet = reader->next()) {
        packets.push_back(copyOf(*packet));
        marks.push_back(reader->mark());
    }
    ASSERT_THAT(packets, SizeIs(8));
    EXPECT_EQ(packets.back().time, 3001ms);
    for (const std::size_t place : {7u, 2u, 5u, 1u, 4u, 3u}) {
        reader->goTo(*marks[place]);
        EXPECT_EQ(readAll(*reader), std::vector(packets.begin() + place, packets.end())) << place;
    }
}

TEST_F(PcapReader, RefusesCapturesOfNoNetwork) {
    try {
        open(pcapFile({{kStart, Bytes(64)}}, 220));
        FAIL();
    } catch (const RecordingError& error) {
        EXPECT_THAT(error.what(), HasSubstr("link type 220"));
    }
}

TEST_F(PcapReader, AbsurdTimesDoNoHarm) {
    Bytes file = pcapFile({dmxAt(0ns, 1), dmxAt(1s, 2), dmxAt(2s, 3)});
    const std::size_t secondRecord = 24 + 16 + dmxAt(0ns, 1).bytes.size();
    for (std::size_t i = 0; i < 8; ++i) file[secondRecord + i] = 0xFF;
    const auto packets = readAll(*open(file));
    ASSERT_THAT(packets, SizeIs(3));
    EXPECT_GE(packets[1].time, 0ns);
    EXPECT_GE(packets[2].time, packets[1].time);
}

TEST_F(PcapReader, SaysWhatAFileIsNot) {
    const auto messageOf = [&](const std::filesystem::path& file) {
        try {
            openRecording(file);
            return std::string();
        } catch (const RecordingError& error) {
            return std::string(error.what());
        }
    };
    EXPECT_THAT(messageOf(folder_.write("a.txt", "hello")), HasSubstr("not a recording; pcap, pcapng, OLA"));
    EXPECT_THAT(messageOf(folder_.write("empty", "")), HasSubstr("not a recording"));
    EXPECT_THAT(messageOf(folder_.path() / "absent"), HasSubstr("No such file"));
    EXPECT_THAT(messageOf(folder_.path()), HasSubstr("not a file"));
    EXPECT_FALSE(isRecording(folder_.path()));
    EXPECT_FALSE(isRecording(folder_.path() / "a.txt"));
}

TEST(RealCaptures, HoldWhatTheirReadMeSays) {
    const std::filesystem::path captures = capturesFolder();
    if (captures.empty()) GTEST_SKIP() << "no captures beside the source tree; set HAZER_SHARED_DATA";
    struct Expected {
        const char* file;
        std::size_t packets;
        std::chrono::milliseconds duration;
    };
    for (const Expected& expected :
         {Expected{"ola_artnet_lo.pcapng", 6, 7060ms}, Expected{"ola_artnet_unicast.pcapng", 16, 8210ms},
          Expected{"ola_artnet_bcast.pcapng", 300, 1060ms}, Expected{"ola_e131_veth.pcapng", 12, 17940ms},
          Expected{"qlc_lo.pcapng", 24, 480ms}}) {
        const auto reader = openRecording(captures / expected.file);
        EXPECT_THAT(readAll(*reader), SizeIs(expected.packets)) << expected.file;
        ASSERT_TRUE(reader->duration());
        EXPECT_NEAR(std::chrono::duration<double>(*reader->duration()).count(),
                    std::chrono::duration<double>(expected.duration).count(), 0.006)
            << expected.file;
        EXPECT_EQ(reader->refusedCount(), 0u);
        EXPECT_THAT(reader->warnings(), IsEmpty());
    }
}

}  // namespace
}  // namespace hazer::protocol::test
