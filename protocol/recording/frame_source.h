// Bytes of an FSEQ block, decompressed in pieces: memory stays small whatever the file claims.
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <span>

#include "protocol/recording/fseq_header.h"

namespace hazer::protocol {

/// Reads one block from its beginning to its end.
class FrameSource {
 public:
    virtual ~FrameSource() = default;

    /// Fills all of `out`. False if the block ends before or is damaged.
    virtual bool read(std::span<std::uint8_t> out) = 0;
};

/// `stream` must outlive the source and not be read by others meanwhile.
std::unique_ptr<FrameSource> openBlock(std::istream& stream, const FseqBlock& block,
                                       FseqCompression compression);

}  // namespace hazer::protocol
