#include "protocol/recording/ola_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tests/protocol/recording/capture_builder.h"
#include "tests/support/temporary_folder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class OlaReader : public ::testing::Test {
 protected:
    std::unique_ptr<RecordingReader> open(const std::string& text, const FrameMap& map = {}) {
        return openRecording(folder_.write("a.show", text), map);
    }

    std::vector<RecordingTime> timesOf(const std::string& text) {
        std::vector<RecordingTime> times;
        const auto reader = open(text);
        for (const ReadPacket& packet : readAll(*reader)) times.push_back(packet.time);
        times.push_back(*reader->duration());
        return times;
    }

    /// The sentence with which a file is refused.
    std::string refusalOf(const std::string& text, const FrameMap& map = {}) {
        try {
            open(text, map);
        } catch (const RecordingError& error) {
            return error.what();
        }
        return "taken";
    }

    hazer::test::TemporaryFolder folder_;
};

TEST_F(OlaReader, ReadsFramesAndDelays) {
    const auto reader = open("OLA Show\n1 255,128,64\n5\n2 1,2,3\n515\n1 0,0,0\n");
    const auto packets = readAll(*reader);
    ASSERT_THAT(packets, SizeIs(3));
    EXPECT_EQ(packets[0].universe, (UniverseId{Transport::kDmx, 1}));
    EXPECT_THAT(packets[0].bytes, ElementsAre(255, 128, 64));
    EXPECT_EQ(packets[1].universe.number, 2);
    EXPECT_EQ(packets[1].time, 5ms);
    EXPECT_EQ(packets[2].time, 520ms);
    EXPECT_EQ(reader->duration(), 520ms);
    EXPECT_THAT(reader->warnings(), IsEmpty());
}

TEST_F(OlaReader, TakesLineEndsOfDos) {
    EXPECT_THAT(timesOf("OLA Show\r\n1 1\r\n10\r\n1 2\r\n"), ElementsAre(0ms, 10ms, 10ms));
}

TEST_F(OlaReader, FrameWithoutValuesIsAFrame) {
    const auto packets = readAll(*open("OLA Show\n1 \n10\n1 7\n"));
    ASSERT_THAT(packets, SizeIs(2));
    EXPECT_THAT(packets[0].bytes, IsEmpty());
}

TEST_F(OlaReader, LastDelayLengthensTheShow) {
    EXPECT_THAT(timesOf("OLA Show\n1 1\n463\n1 2\n1006\n"), ElementsAre(0ms, 463ms, 1469ms));
}

TEST_F(OlaReader, EmptyLineEndsTheShow) {
    EXPECT_THAT(timesOf("OLA Show\n1 1\n10\n1 2\n\nanything at all"), ElementsAre(0ms, 10ms, 10ms));
    EXPECT_THAT(timesOf("OLA Show\n1 1\n\n1 2\n"), ElementsAre(0ms, 0ms));
    EXPECT_THAT(timesOf("OLA Show\n"), ElementsAre(0ms));
    EXPECT_THAT(timesOf("OLA Show"), ElementsAre(0ms));
}

TEST_F(OlaReader, Version2HasTimesFromTheStart) {
    EXPECT_THAT(timesOf("OLA Show V2\n1 1\n0 500\n1 2\n1 250\n2 3\n1 250\n2 4\n3 0\n"),
                ElementsAre(0ms, 500ms, 1250ms, 1250ms, 3000ms));
}

// One draft of version 2 writes microseconds. Any number above 999 proves it for the whole file.
TEST_F(OlaReader, Version2InMicrosecondsIsRecognised) {
    EXPECT_THAT(timesOf("OLA Show V2\n1 1\n0 999\n1 2\n0 1500\n2 3\n1 20\n2 4\n"),
                ElementsAre(0us, 999us, 1500us, 1'000'020us, 1'000'020us));
}

TEST_F(OlaReader, Version2MustNotGoBack) {
    EXPECT_THAT(refusalOf("OLA Show V2\n1 1\n1 500\n1 2\n1 499\n1 3\n"), HasSubstr("a.show:5: "));
    EXPECT_THAT(refusalOf("OLA Show V2\n1 1\n1 5000\n1 2\n1 4999\n1 3\n"), HasSubstr("a.show:5: "));
    EXPECT_THAT(refusalOf("OLA Show V2\n1 1\n1 1000000\n1 2\n"), HasSubstr("seconds and milliseconds"));
    EXPECT_THAT(refusalOf("OLA Show V2\n1 1\n500\n1 2\n"), HasSubstr("seconds and milliseconds"));
}

TEST_F(OlaReader, NamesTheLineAtFault) {
    for (const char* line : {"x 1", "1", "1  1", " 1 1", "1 256", "1 -1", "1 1,,2", "1 1,", "1 ,1", "1 1 2",
                             "1 1;2", "-1 1", "4294967296 1", "1 0x10", "1 1.5"}) {
        EXPECT_THAT(refusalOf(fmt::format("OLA Show\n1 1\n5\n{}\n", line)), HasSubstr("a.show:4: ")) << line;
    }
    for (const char* delay : {"x", "-1", "1.5", "4294967296", "5 5"}) {
        EXPECT_THAT(refusalOf(fmt::format("OLA Show\n1 1\n{}\n1 2\n", delay)),
                    HasSubstr("a.show:3: between two frames there must be a delay"))
            << delay;
    }
    EXPECT_THAT(refusalOf("OLA Show V3\n1 1\n"), HasSubstr("a.show:1: a show file of OLA begins with"));
}

std::string values(std::size_t count) {
    std::string text = "7";
    for (std::size_t i = 1; i < count; ++i) text += ",7";
    return text;
}

TEST_F(OlaReader, RefusesMoreThan512Values) {
    EXPECT_THAT(readAll(*open("OLA Show\n1 " + values(512) + "\n"))[0].bytes, SizeIs(512));
    EXPECT_THAT(refusalOf("OLA Show\n1 " + values(513) + "\n"), HasSubstr("up to 512 values"));
}

TEST_F(OlaReader, BoundsLinesAndLengths) {
    EXPECT_THAT(refusalOf("OLA Show\n1 " + std::string(1'000'000, '1')),
                HasSubstr("a.show:2: a line of more than"));
    std::string endless = "OLA Show\n";
    for (int i = 0; i < 3; ++i) endless += "1 1\n4000000000\n";
    EXPECT_THAT(refusalOf(endless), HasSubstr("more than a hundred days"));
}

TEST_F(OlaReader, CutLastLineIsLeftOut) {
    const auto reader = open("OLA Show\n1 1\n5\n1 255,");
    EXPECT_THAT(readAll(*reader), SizeIs(1));
    EXPECT_THAT(reader->warnings(), ElementsAre(HasSubstr("a.show:4: the last line is cut")));
    EXPECT_THAT(timesOf("OLA Show\n1 1\n5\n1 255"), ElementsAre(0ms, 5ms, 5ms));
}

TEST_F(OlaReader, MapsUniverses) {
    const FrameMap map{.transport = Transport::kArtNet, .firstUniverse = 100};
    EXPECT_EQ(readAll(*open("OLA Show\n3 1\n", map))[0].universe, (UniverseId{Transport::kArtNet, 102}));
    EXPECT_THAT(refusalOf("OLA Show\n40000 1\n", map),
                HasSubstr("would become 40099, but Art-Net universes are"));
    EXPECT_THAT(refusalOf("OLA Show\n0 1\n", {.transport = Transport::kSacn}), HasSubstr("would become 0"));
    EXPECT_EQ(readAll(*open("OLA Show\n0 1\n", {.transport = Transport::kArtNet}))[0].universe.number, 0);
}

TEST_F(OlaReader, EveryTruncatedPrefixIsReadOrRefused) {
    const std::string text = "OLA Show V2\n1 1,2\n0 500\n12 255,254\n1 0\n3 9\n";
    for (std::size_t size = 0; size < text.size(); ++size) {
        try {
            EXPECT_LE(readAll(*open(text.substr(0, size))).size(), 3u);
        } catch (const RecordingError& error) {
            EXPECT_LT(size, 12u) << error.what();
        }
    }
}

TEST_F(OlaReader, GoesOnFromAnyMark) {
    std::string text = "OLA Show\n";
    for (int i = 0; i < 30; ++i) text += fmt::format("{} {}\n{}\n", i % 3, i, 7 * i);
    const auto reader = open(text);
    std::vector<RecordingMarkPtr> marks{reader->mark()};
    std::vector<ReadPacket> packets;
    while (const auto packet = reader->next()) {
        packets.push_back(copyOf(*packet));
        marks.push_back(reader->mark());
    }
    for (const std::size_t place : {20u, 0u, 30u, 29u, 1u}) {
        reader->goTo(*marks[place]);
        EXPECT_EQ(readAll(*reader), std::vector(packets.begin() + place, packets.end()));
    }
}

TEST(RealOlaShow, HoldsWhatItsReadMeSays) {
    const std::filesystem::path captures = capturesFolder();
    if (captures.empty()) GTEST_SKIP() << "no captures beside the source tree; set HAZER_SHARED_DATA";
    const auto reader = openRecording(captures / "ola_recorder_sample.show");
    const auto packets = readAll(*reader);
    ASSERT_THAT(packets, SizeIs(8));
    EXPECT_EQ(reader->duration(), 992ms);
    EXPECT_THAT(packets[0].bytes, ElementsAre(255, 128, 64));
    EXPECT_THAT(packets[1].bytes, ElementsAre(1, 2, 3));
    EXPECT_THAT(packets[2].bytes, ElementsAre(0, 0, 0));
    for (std::size_t k = 0; k < 5; ++k) {
        Bytes expected(512);
        std::iota(expected.begin(), expected.end(), static_cast<std::uint8_t>(k));
        EXPECT_EQ(packets[3 + k].bytes, expected);
    }
}

}  // namespace
}  // namespace hazer::protocol::test
