#include "protocol/recording/fseq_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "protocol/recording/frame_source.h"
#include "protocol/recording/fseq_header.h"
#include "protocol/recording/universe_range.h"

namespace hazer::protocol {
namespace {

/// Bytes of a stored frame that go side by side into one universe.
struct Piece {
    std::size_t inFrame = 0;
    std::size_t inSlots = 0;
    std::size_t count = 0;
};

struct MappedUniverse {
    UniverseId id{};
    std::vector<Piece> pieces{};
    std::size_t slotCount = 0;
};

struct FseqMark : RecordingMark {
    FseqMark(std::uint32_t nextFrame, std::size_t nextUniverse) : frame(nextFrame), universe(nextUniverse) {}
    std::uint32_t frame;
    std::size_t universe;
};

FseqHeader readHeader(const std::filesystem::path& file, std::istream& stream, std::uint64_t fileSize) {
    std::vector<std::uint8_t> bytes(
        static_cast<std::size_t>(std::min<std::uint64_t>(fileSize, kMaxFseqHeaderBytes)));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream) throw RecordingError(fmt::format("{}: the sequence cannot be read", file.string()));
    auto parsed = parseFseqHeader(bytes, fileSize);
    if (const auto* fault = std::get_if<std::string>(&parsed)) {
        throw RecordingError(fmt::format("{}: {}", file.string(), *fault));
    }
    return std::get<FseqHeader>(std::move(parsed));
}

/// Where each channel goes. Universes in ascending order, those without any channel left out.
std::vector<MappedUniverse> mapChannels(const FseqHeader& header, const FrameMap& map,
                                        const std::filesystem::path& file) {
    std::map<std::uint32_t, MappedUniverse> universes;  // by index from 0
    std::size_t inFrame = 0;
    for (const FseqRange& range : header.ranges) {
        const std::uint32_t end = range.firstChannel + range.channelCount;
        for (std::uint32_t channel = range.firstChannel; channel < end;) {
            const std::uint32_t index = channel / map.slotsPerUniverse;
            const std::uint32_t slot = channel % map.slotsPerUniverse;
            const std::uint32_t count = std::min(end - channel, map.slotsPerUniverse - slot);
            MappedUniverse& universe = universes[index];
            universe.pieces.push_back({inFrame, slot, count});
            universe.slotCount = std::max<std::size_t>(universe.slotCount, slot + count);
            inFrame += count;
            channel += count;
        }
    }
    std::vector<MappedUniverse> mapped;
    for (auto& [index, universe] : universes) {
        const auto id = universeAt(map, index + 1);
        if (!id) throw RecordingError(fmt::format("{}: {}", file.string(), outOfRange(map, index + 1)));
        universe.id = *id;
        mapped.push_back(std::move(universe));
    }
    return mapped;
}

class FseqReader : public RecordingReader {
 public:
    FseqReader(const std::filesystem::path& file, const FrameMap& map)
        : file_(file),
          stream_(file, std::ios::binary),
          header_(readHeader(file, stream_, std::filesystem::file_size(file))),
          universes_(mapChannels(header_, map, file)),
          frame_(header_.channelsPerFrame) {}

    std::optional<RecordedPacket> next() override {
        if (isDamaged_ || nextFrame_ >= header_.frameCount) return std::nullopt;
        if (loadedFrame_ != nextFrame_ && !load(nextFrame_)) {
            isDamaged_ = true;
            warnOfDamage();
            return std::nullopt;
        }
        const RecordedPacket packet{timeOf(nextFrame_), fill(universes_[nextUniverse_])};
        if (++nextUniverse_ == universes_.size()) {
            nextUniverse_ = 0;
            ++nextFrame_;
        }
        return packet;
    }

    RecordingMarkPtr mark() const override { return std::make_shared<FseqMark>(nextFrame_, nextUniverse_); }

    void goTo(const RecordingMark& mark) override {
        const auto& there = static_cast<const FseqMark&>(mark);
        nextFrame_ = there.frame;
        nextUniverse_ = there.universe;
        isDamaged_ = false;
    }

    /// The last frame stands as long as every other.
    std::optional<RecordingTime> duration() const override {
        return isDamaged_ ? timeOf(nextFrame_) : timeOf(header_.frameCount);
    }

    double readShare() const override {
        if (isDamaged_ || header_.frameCount == 0) return 1.0;
        return static_cast<double>(nextFrame_) / header_.frameCount;
    }

    std::uint64_t refusedCount() const override { return 0; }
    const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
    RecordingTime timeOf(std::uint32_t frame) const { return std::int64_t{frame} * header_.step; }

    /// Brings frame `wanted` into frame_. A block can only be read from its beginning.
    bool load(std::uint32_t wanted) {
        const auto after = std::ranges::upper_bound(header_.blocks, wanted, {}, &FseqBlock::firstFrame);
        const FseqBlock& block = *std::prev(after);
        const bool isAhead =
            loadedFrame_ && source_ && *loadedFrame_ >= block.firstFrame && *loadedFrame_ < wanted;
        std::uint32_t frame = isAhead ? *loadedFrame_ + 1 : block.firstFrame;
        if (!isAhead) frame = openAt(block, wanted);
        for (; frame <= wanted; ++frame) {
            loadedFrame_.reset();
            if (!source_->read(frame_)) return false;
        }
        loadedFrame_ = wanted;
        return true;
    }

    /// The frame that the source gives first. Frames that are not compressed can be reached at once.
    std::uint32_t openAt(FseqBlock block, std::uint32_t wanted) {
        std::uint32_t first = block.firstFrame;
        if (header_.compression == FseqCompression::kNone) {
            const std::uint64_t skipped = std::uint64_t{wanted} * header_.channelsPerFrame;
            block.offset += skipped;
            block.size -= skipped;
            first = wanted;
        }
        source_ = openBlock(stream_, block, header_.compression);
        return first;
    }

    RecordedFrame fill(const MappedUniverse& universe) {
        slots_.fill(0);
        for (const Piece& piece : universe.pieces) {
            std::copy_n(frame_.begin() + static_cast<std::ptrdiff_t>(piece.inFrame), piece.count,
                        slots_.begin() + static_cast<std::ptrdiff_t>(piece.inSlots));
        }
        return {universe.id, std::span(slots_).first(universe.slotCount)};
    }

    void warnOfDamage() {
        if (!warnings_.empty()) return;
        warnings_.push_back(
            fmt::format("{}: read up to frame {} of {}, where its block ends too early or is damaged",
                        file_.string(), nextFrame_, header_.frameCount));
    }

    std::filesystem::path file_;
    std::ifstream stream_;
    FseqHeader header_;
    std::vector<MappedUniverse> universes_;
    std::vector<std::uint8_t> frame_;           ///< As stored.
    std::optional<std::uint32_t> loadedFrame_;  ///< Which one it is.
    std::unique_ptr<FrameSource> source_;       ///< Stands behind the loaded frame.
    Slots slots_{};
    std::uint32_t nextFrame_ = 0;
    std::size_t nextUniverse_ = 0;
    bool isDamaged_ = false;
    std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<RecordingReader> openFseq(const std::filesystem::path& file, const FrameMap& map) {
    return std::make_unique<FseqReader>(file, map);
}

}  // namespace hazer::protocol
