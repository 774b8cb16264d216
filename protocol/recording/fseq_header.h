// The head of an FSEQ file: what its frames are, where they lie, which channels they hold.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace hazer::protocol {

enum class FseqCompression : std::uint8_t { kNone, kZstd, kZlib };

/// Frames that are compressed together. Uncompressed files have one block with all frames.
struct FseqBlock {
    std::uint32_t firstFrame = 0;
    std::uint32_t frameCount = 0;  ///< Never 0.
    std::uint64_t offset = 0;      ///< In the file.
    std::uint64_t size = 0;        ///< As compressed.
};

/// Channels that stand side by side in a frame. Channel 0 is the first of the whole rig.
struct FseqRange {
    std::uint32_t firstChannel = 0;
    std::uint32_t channelCount = 0;  ///< Never 0.
};

struct FseqHeader {
    std::uint32_t channelsPerFrame = 0;  ///< Stored in the file, 1..kMaxFseqChannels.
    std::uint32_t frameCount = 0;
    std::chrono::milliseconds step{};  ///< From frame to frame, 1..255.
    FseqCompression compression = FseqCompression::kNone;
    std::vector<FseqBlock> blocks;  ///< Ascending and without gaps.
    std::vector<FseqRange> ranges;  ///< In the order of the file; together channelsPerFrame.
};

/// More than any rig has; three bytes count channels in the file.
inline constexpr std::uint32_t kMaxFseqChannels = 1u << 24;

/// A header is smaller than its 16-bit offset of the data says.
inline constexpr std::size_t kMaxFseqHeaderBytes = 65536;

/// Reads the header of FSEQ 1.x and 2.x from the first bytes of a file of `fileSize` bytes: at most
/// kMaxFseqHeaderBytes of them, or all there are. Gives a sentence about what is wrong if it is not sound.
std::variant<FseqHeader, std::string> parseFseqHeader(std::span<const std::uint8_t> bytes,
                                                      std::uint64_t fileSize);

}  // namespace hazer::protocol
