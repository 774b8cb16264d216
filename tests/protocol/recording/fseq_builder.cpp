#include "tests/protocol/recording/fseq_builder.h"

#include <zlib.h>
#include <zstd.h>

#include "tests/protocol/recording/capture_builder.h"

namespace hazer::protocol::test {
namespace {

Bytes littleEndian24(std::uint32_t value) {
    const Bytes four = littleEndian32(value);
    return {four[0], four[1], four[2]};
}

Bytes framesFrom(const FseqFields& fields, std::uint32_t first, std::uint32_t end) {
    Bytes bytes;
    for (std::uint32_t frame = first; frame < end; ++frame) {
        for (std::uint32_t channel = 0; channel < fields.channels; ++channel) {
            bytes.push_back(fseqValue(frame, channel));
        }
    }
    return bytes;
}

Bytes packed(const Bytes& bytes, FseqPacking packing) {
    if (packing == FseqPacking::kZstd) {
        Bytes out(ZSTD_compressBound(bytes.size()));
        out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1));
        return out;
    }
    uLongf size = compressBound(bytes.size());
    Bytes out(size);
    compress(out.data(), &size, bytes.data(), bytes.size());
    out.resize(size);
    return out;
}

Bytes commonHeader(const FseqFields& fields, std::size_t dataOffset) {
    return joined({{'P', 'S', 'E', 'Q'},
                   littleEndian16(dataOffset),
                   {0, static_cast<std::uint8_t>(fields.major)},
                   littleEndian16(fields.major == 1 ? 28 : 32),
                   littleEndian32(fields.channels),
                   littleEndian32(fields.frames),
                   {fields.stepMs, 0}});
}

}  // namespace

std::uint8_t fseqValue(std::uint32_t frame, std::uint32_t channel) {
    return static_cast<std::uint8_t>(31 * frame + channel + 1);
}

Bytes fseqFile(const FseqFields& fields) {
    if (fields.major == 1) {
        return joined({commonHeader(fields, 28), Bytes(8), framesFrom(fields, 0, fields.frames)});
    }
    std::vector<Bytes> blocks;
    if (fields.packing == FseqPacking::kPlain) {
        blocks.push_back(framesFrom(fields, 0, fields.frames));
    } else {
        for (std::size_t i = 0; i < fields.blockStarts.size(); ++i) {
            const std::uint32_t end =
                i + 1 < fields.blockStarts.size() ? fields.blockStarts[i + 1] : fields.frames;
            blocks.push_back(packed(framesFrom(fields, fields.blockStarts[i], end), fields.packing));
        }
    }
    Bytes table;
    std::size_t entries = 0;
    if (fields.packing != FseqPacking::kPlain) {
        for (std::size_t i = 0; i < blocks.size(); ++i, ++entries) {
            table = joined({table, littleEndian32(fields.blockStarts[i]), littleEndian32(blocks[i].size())});
        }
        for (std::size_t i = 0; i < fields.paddingBlocks; ++i, ++entries) table = joined({table, Bytes(8)});
    }
    for (const auto& [first, count] : fields.ranges) {
        table = joined({table, littleEndian24(first), littleEndian24(count)});
    }
    const Bytes producer = {9,   0,   's', 'p', 't', 'e',
                            's', 't', 0,   0,   0,   0};  // a variable header, then padding
    const std::size_t dataOffset = 32 + table.size() + producer.size();
    return joined(
        {commonHeader(fields, dataOffset),
         {static_cast<std::uint8_t>(static_cast<int>(fields.packing) | entries >> 8 << 4),
          static_cast<std::uint8_t>(entries & 0xFF), static_cast<std::uint8_t>(fields.ranges.size()), 0},
         Bytes(8),
         table,
         producer,
         joined(blocks)});
}

}  // namespace hazer::protocol::test
