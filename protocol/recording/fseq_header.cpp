#include "protocol/recording/fseq_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "protocol/byte_reader.h"

namespace hazer::protocol {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeaderSizeV2 = 32;
constexpr std::size_t kBlockEntrySize = 8;
constexpr std::size_t kRangeEntrySize = 6;

// Far beyond any show.
constexpr std::chrono::hours kLongest{2400};

/// A parser throws this within the file only; parseFseqHeader makes it a value.
struct Fault {
    std::string sentence;
};

std::uint32_t u24(ByteReader& reader) {
    const std::uint32_t low = reader.u16LittleEndian();
    return low | static_cast<std::uint32_t>(reader.u8()) << 16;
}

std::uint32_t u32(ByteReader& reader) {
    const std::uint32_t low = reader.u16LittleEndian();
    return low | static_cast<std::uint32_t>(reader.u16LittleEndian()) << 16;
}

/// The fields that both versions have.
struct CommonFields {
    std::size_t dataOffset;
    int major;
};

void readMagic(ByteReader& reader) {
    const Bytes magic = reader.take(4);
    const std::string_view text(reinterpret_cast<const char*>(magic.data()), magic.size());
    if (text == "ESEQ") throw Fault{"an effect (ESEQ) is no whole sequence; export the sequence as FSEQ"};
    if (text != "PSEQ" && text != "FSEQ") throw Fault{"an FSEQ file begins with PSEQ"};
}

CommonFields readCommon(ByteReader& reader, FseqHeader& header) {
    readMagic(reader);
    CommonFields common{};
    common.dataOffset = reader.u16LittleEndian();
    reader.u8();  // minor version: only adds to what is skipped
    common.major = reader.u8();
    reader.u16LittleEndian();  // where names and the like begin
    header.channelsPerFrame = u32(reader);
    header.frameCount = u32(reader);
    header.step = std::chrono::milliseconds(reader.u8());
    reader.u8();  // flags
    if (reader.failed()) throw Fault{"the file ends within its header"};
    if (common.major != 1 && common.major != 2) {
        throw Fault{fmt::format("version {} is not known; 1 and 2 are", common.major)};
    }
    if (header.channelsPerFrame == 0 || header.channelsPerFrame > kMaxFseqChannels) {
        throw Fault{fmt::format("{} channels in a frame; 1..{} are possible", header.channelsPerFrame,
                                kMaxFseqChannels)};
    }
    if (header.frameCount * header.step > kLongest)
        throw Fault{"a sequence of more than a hundred days is refused"};
    if (header.step.count() == 0) throw Fault{"a step of 0 ms between frames would never end"};
    return common;
}

std::vector<FseqRange> readRanges(ByteReader& reader, std::size_t count, std::uint32_t channelsPerFrame) {
    if (count == 0) return {{0, channelsPerFrame}};
    std::vector<FseqRange> ranges;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        FseqRange range;
        range.firstChannel = u24(reader);
        range.channelCount = u24(reader);
        if (std::uint64_t{range.firstChannel} + range.channelCount > kMaxFseqChannels) {
            throw Fault{fmt::format("sparse range {} ends beyond channel {}", i + 1, kMaxFseqChannels)};
        }
        sum += range.channelCount;
        if (range.channelCount > 0) ranges.push_back(range);
    }
    if (sum != channelsPerFrame) {
        throw Fault{
            fmt::format("the sparse ranges have {} channels, but a frame has {}", sum, channelsPerFrame)};
    }
    return ranges;
}

/// The table as it stands, without the entries of no length, which only pad it.
std::vector<FseqBlock> readBlockTable(ByteReader& reader, std::size_t count) {
    std::vector<FseqBlock> blocks;
    for (std::size_t i = 0; i < count; ++i) {
        FseqBlock block;
        block.firstFrame = u32(reader);
        block.size = u32(reader);
        if (block.size > 0) blocks.push_back(block);
    }
    return blocks;
}

void placeBlocks(std::vector<FseqBlock>& blocks, std::uint32_t frameCount, std::uint64_t dataOffset,
                 std::uint64_t fileSize) {
    if (blocks.empty()) blocks.push_back({0, 0, 0, fileSize - dataOffset});
    if (blocks.front().firstFrame != 0) throw Fault{"the first block does not begin with frame 0"};
    std::uint64_t offset = dataOffset;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const std::uint32_t end = i + 1 < blocks.size() ? blocks[i + 1].firstFrame : frameCount;
        if (end <= blocks[i].firstFrame) {
            throw Fault{fmt::format("block {} begins at frame {}, which is not before the next at {}", i + 1,
                                    blocks[i].firstFrame, end)};
        }
        blocks[i].frameCount = end - blocks[i].firstFrame;
        blocks[i].offset = offset;
        offset += blocks[i].size;
    }
    if (offset > fileSize) {
        throw Fault{fmt::format("its blocks need {} bytes, but the file has {}", offset, fileSize)};
    }
}

void placeUncompressed(FseqHeader& header, std::uint64_t dataOffset, std::uint64_t fileSize) {
    const std::uint64_t size = std::uint64_t{header.frameCount} * header.channelsPerFrame;
    if (size > fileSize - dataOffset) {
        throw Fault{fmt::format("{} frames of {} channels need {} bytes, but only {} follow the header",
                                header.frameCount, header.channelsPerFrame, size, fileSize - dataOffset)};
    }
    if (header.frameCount > 0) header.blocks = {{0, header.frameCount, dataOffset, size}};
}

FseqCompression compressionFrom(unsigned code) {
    switch (code) {
        case 0:
            return FseqCompression::kNone;
        case 1:
            return FseqCompression::kZstd;
        case 2:
            return FseqCompression::kZlib;
        default:
            throw Fault{fmt::format("compression {} is not known; 0, 1 (zstd) and 2 (zlib) are", code)};
    }
}

void readV2(ByteReader& reader, FseqHeader& header, std::uint64_t dataOffset, std::uint64_t fileSize) {
    const std::uint8_t packed = reader.u8();
    const std::size_t blockCount = static_cast<std::size_t>(packed >> 4) << 8 | reader.u8();
    const std::size_t rangeCount = reader.u8();
    reader.u8();     // flags
    reader.take(8);  // unique number
    header.compression = compressionFrom(packed & 0x0F);
    const std::size_t tableEnd = kHeaderSizeV2 + kBlockEntrySize * blockCount + kRangeEntrySize * rangeCount;
    if (tableEnd > dataOffset) throw Fault{"its tables reach into its frames"};
    header.blocks = readBlockTable(reader, blockCount);
    header.ranges = readRanges(reader, rangeCount, header.channelsPerFrame);
    if (reader.failed()) throw Fault{"the file ends within its header"};
    if (header.compression == FseqCompression::kNone) {
        placeUncompressed(header, dataOffset, fileSize);
    } else if (header.frameCount == 0) {
        header.blocks.clear();
    } else {
        placeBlocks(header.blocks, header.frameCount, dataOffset, fileSize);
    }
}

FseqHeader readHeader(Bytes bytes, std::uint64_t fileSize) {
    ByteReader reader(bytes);
    FseqHeader header;
    const CommonFields common = readCommon(reader, header);
    if (common.dataOffset > fileSize) throw Fault{"its frames would begin beyond its end"};
    if (common.major == 1) {
        constexpr std::size_t kHeaderSizeV1 = 28;
        if (common.dataOffset < kHeaderSizeV1) throw Fault{"its frames would begin within its header"};
        header.ranges = {{0, header.channelsPerFrame}};
        placeUncompressed(header, common.dataOffset, fileSize);
    } else {
        readV2(reader, header, common.dataOffset, fileSize);
    }
    return header;
}

}  // namespace

std::variant<FseqHeader, std::string> parseFseqHeader(std::span<const std::uint8_t> bytes,
                                                      std::uint64_t fileSize) {
    try {
        return readHeader(bytes, fileSize);
    } catch (const Fault& fault) {
        return fault.sentence;
    }
}

}  // namespace hazer::protocol
