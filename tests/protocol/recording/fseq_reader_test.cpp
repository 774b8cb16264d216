#include "protocol/recording/fseq_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/recording/fseq_header.h"
#include "tests/protocol/recording/capture_builder.h"
#include "tests/protocol/recording/fseq_builder.h"
#include "tests/support/temporary_folder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class FseqReader : public ::testing::Test {
 protected:
    std::unique_ptr<RecordingReader> open(const Bytes& bytes, const FrameMap& map = {}) {
        return openRecording(folder_.write("a.fseq", textOf(bytes)), map);
    }

    std::string refusalOf(const Bytes& bytes, const FrameMap& map = {}) {
        try {
            open(bytes, map);
        } catch (const RecordingError& error) {
            return error.what();
        }
        return "taken";
    }

    hazer::test::TemporaryFolder folder_;
};

Bytes stored(std::uint32_t frame, std::uint32_t first, std::uint32_t count) {
    Bytes bytes;
    for (std::uint32_t channel = first; channel < first + count; ++channel)
        bytes.push_back(fseqValue(frame, channel));
    return bytes;
}

TEST_F(FseqReader, ReadsEveryVersionAndPacking) {
    for (const FseqFields& fields :
         {FseqFields{.major = 1}, FseqFields{}, FseqFields{.packing = FseqPacking::kZstd},
          FseqFields{.packing = FseqPacking::kZlib},
          FseqFields{.packing = FseqPacking::kZstd, .blockStarts = {0, 1, 2}, .paddingBlocks = 2},
          FseqFields{.packing = FseqPacking::kZlib, .blockStarts = {0, 2}}}) {
        const auto reader = open(fseqFile(fields));
        const auto packets = readAll(*reader);
        ASSERT_THAT(packets, SizeIs(3));
        for (std::uint32_t frame = 0; frame < 3; ++frame) {
            EXPECT_EQ(packets[frame].time, frame * 25ms);
            EXPECT_EQ(packets[frame].universe, (UniverseId{Transport::kDmx, 1}));
            EXPECT_EQ(packets[frame].bytes, stored(frame, 0, 4));
        }
        EXPECT_EQ(reader->duration(), 75ms);
        EXPECT_THAT(reader->warnings(), IsEmpty());
    }
}

TEST_F(FseqReader, CutsChannelsIntoUniverses) {
    const FseqFields fields{.channels = 1100, .frames = 1};
    const auto wide = readAll(*open(fseqFile(fields), {.transport = Transport::kSacn, .firstUniverse = 11}));
    ASSERT_THAT(wide, SizeIs(3));
    EXPECT_EQ(wide[2].universe, (UniverseId{Transport::kSacn, 13}));
    EXPECT_EQ(wide[1].bytes, stored(0, 512, 512));
    EXPECT_EQ(wide[2].bytes, stored(0, 1024, 76));
    const auto narrow = readAll(*open(fseqFile(fields), {.slotsPerUniverse = 510}));
    EXPECT_EQ(narrow[1].bytes, stored(0, 510, 510));
    EXPECT_THAT(narrow[2].bytes, SizeIs(80));
}

TEST_F(FseqReader, PlacesSparseRanges) {
    const FseqFields fields{.channels = 7, .frames = 1, .ranges = {{510, 4}, {2, 2}, {2048, 1}}};
    const auto packets = readAll(*open(fseqFile(fields)));
    ASSERT_THAT(packets, SizeIs(3));
    Bytes first(512);
    first[510] = fseqValue(0, 0);
    first[511] = fseqValue(0, 1);
    first[2] = fseqValue(0, 4);
    first[3] = fseqValue(0, 5);
    EXPECT_EQ(packets[0].bytes, first);
    EXPECT_EQ(packets[1].universe.number, 2);
    EXPECT_EQ(packets[1].bytes, stored(0, 2, 2));
    EXPECT_EQ(packets[2].universe.number, 5);
    EXPECT_EQ(packets[2].bytes, stored(0, 6, 1));
}

// FPP treats the rest of the file as one block where no block has a length.
TEST_F(FseqReader, TableWithoutLengthsMeansOneBlock) {
    FseqFields fields{.packing = FseqPacking::kZstd};
    Bytes bytes = fseqFile(fields);
    for (std::size_t i = 36; i < 40; ++i) bytes[i] = 0;
    EXPECT_THAT(readAll(*open(bytes)), SizeIs(3));
}

TEST_F(FseqReader, GoesToAnyFrame) {
    for (const FseqFields& fields :
         {FseqFields{.channels = 600, .frames = 40},
          FseqFields{
              .channels = 600, .frames = 40, .packing = FseqPacking::kZstd, .blockStarts = {0, 10, 25}},
          FseqFields{
              .channels = 600, .frames = 40, .packing = FseqPacking::kZlib, .blockStarts = {0, 10, 25}}}) {
        const auto reader = open(fseqFile(fields));
        std::vector<RecordingMarkPtr> marks{reader->mark()};
        std::vector<ReadPacket> packets;
        while (const auto packet = reader->next()) {
            packets.push_back(copyOf(*packet));
            marks.push_back(reader->mark());
        }
        ASSERT_THAT(packets, SizeIs(80));
        for (const std::size_t place : {61u, 3u, 0u, 80u, 79u, 20u, 19u, 50u, 51u}) {
            reader->goTo(*marks[place]);
            EXPECT_EQ(readAll(*reader), std::vector(packets.begin() + place, packets.end())) << place;
        }
    }
}

struct Lie {
    std::size_t offset;
    Bytes bytes;
    const char* sentence;
};

TEST_F(FseqReader, NamesEveryLieOfAHeader) {
    const FseqFields packed{.packing = FseqPacking::kZstd, .blockStarts = {0, 1, 2}};
    for (const Lie& lie :
         {Lie{0, {'E'}, "effect (ESEQ)"}, Lie{7, {3}, "version 3 is not known"},
          Lie{10, {0, 0, 0, 0}, "0 channels"}, Lie{10, {1, 0, 0, 1}, "channels in a frame"},
          Lie{18, {0}, "step of 0 ms"}, Lie{20, {3}, "compression 3"},
          Lie{4, {255, 255}, "begin beyond its end"}, Lie{4, {40, 0}, "tables reach into"},
          Lie{21, {255}, "tables reach into"}, Lie{32, {1}, "does not begin with frame 0"},
          Lie{48, {1}, "block 2 begins at frame 1, which is not before the next at 1"},
          Lie{48, {200}, "block 3 begins at frame 200"}, Lie{36, {255, 255, 1, 0}, "its blocks need"},
          Lie{14, {255, 255, 255, 255}, "a hundred days"}}) {
        Bytes bytes = fseqFile(packed);
        std::ranges::copy(lie.bytes, bytes.begin() + static_cast<std::ptrdiff_t>(lie.offset));
        EXPECT_THAT(refusalOf(bytes), HasSubstr(lie.sentence)) << lie.offset;
    }
    Bytes plain = fseqFile({});
    plain[14] = 4;
    EXPECT_THAT(refusalOf(plain), HasSubstr("4 frames of 4 channels need 16 bytes, but only 12 follow"));
    EXPECT_THAT(refusalOf(fseqFile({.ranges = {{0, 5}}})), HasSubstr("have 5 channels, but a frame has 4"));
    EXPECT_THAT(refusalOf(fseqFile({.ranges = {{0xFFFFFF, 4}}})), HasSubstr("ends beyond channel"));
    EXPECT_THAT(refusalOf(fseqFile({.major = 2}), {.transport = Transport::kSacn, .firstUniverse = 0}),
                HasSubstr("would become 0"));
}

TEST_F(FseqReader, DamagedBlockEndsWithAWarning) {
    FseqFields fields{.channels = 100, .frames = 4, .packing = FseqPacking::kZstd, .blockStarts = {0, 2}};
    Bytes bytes = fseqFile(fields);
    bytes[bytes.size() - 60] ^= 0x55;
    bytes[bytes.size() - 100] ^= 0xFF;
    const auto reader = open(bytes);
    const std::size_t count = readAll(*reader).size();
    EXPECT_LT(count, 5u);
    if (count < 4) {
        EXPECT_THAT(reader->warnings(), ElementsAre(HasSubstr("block ends too early or is damaged")));
    }
}

TEST_F(FseqReader, BlockThatHoldsLessThanItSaysEndsWithAWarning) {
    for (const FseqPacking packing : {FseqPacking::kZstd, FseqPacking::kZlib}) {
        Bytes bytes = fseqFile({.packing = packing});
        bytes[14] = 5;  // frames, of which three are there
        const auto reader = open(bytes);
        EXPECT_THAT(readAll(*reader), SizeIs(3));
        EXPECT_THAT(reader->warnings(), ElementsAre(HasSubstr("read up to frame 3 of 5")));
        EXPECT_EQ(reader->duration(), 75ms);
    }
}

// As many channels as three bytes can count, which a few bytes of a packed file may really hold.
TEST_F(FseqReader, TakesTheMostChannelsThereCanBe) {
    Bytes bytes = fseqFile({.packing = FseqPacking::kZstd});
    const Bytes most{0, 0, 0, 1};
    std::ranges::copy(most, bytes.begin() + 10);
    const auto reader = open(bytes);
    EXPECT_THAT(readAll(*reader), IsEmpty());
    EXPECT_THAT(reader->warnings(), ElementsAre(HasSubstr("read up to frame 0 of 3")));
}

TEST(FseqHeader, RefusesEveryTruncatedPrefix) {
    for (const FseqFields& fields :
         {FseqFields{.major = 1}, FseqFields{.packing = FseqPacking::kZstd, .ranges = {{0, 4}}}}) {
        const Bytes whole = fseqFile(fields);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Bytes prefix = prefixOf(whole, size);
            EXPECT_TRUE(std::holds_alternative<std::string>(parseFseqHeader(prefix, size))) << size;
        }
        EXPECT_TRUE(std::holds_alternative<FseqHeader>(parseFseqHeader(whole, whole.size())));
    }
}

}  // namespace
}  // namespace hazer::protocol::test
