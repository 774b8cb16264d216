// FSEQ files written out by hand.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tests/protocol/packets.h"

namespace hazer::protocol::test {

enum class FseqPacking : std::uint8_t { kPlain, kZstd, kZlib };

struct FseqFields {
    int major = 2;
    std::uint32_t channels = 4;
    std::uint32_t frames = 3;
    std::uint8_t stepMs = 25;
    FseqPacking packing = FseqPacking::kPlain;
    std::vector<std::uint32_t> blockStarts{0};                      // first frames; of packed files
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges{};  // first channel, count
    std::size_t paddingBlocks = 0;  // entries without length at the end of the table
};

/// What stored channel `channel` of frame `frame` holds.
std::uint8_t fseqValue(std::uint32_t frame, std::uint32_t channel);

Bytes fseqFile(const FseqFields& fields);

}  // namespace hazer::protocol::test
