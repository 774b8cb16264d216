#include "protocol/recording/frame_source.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <new>

namespace hazer::protocol {
namespace {

/// Hands out the compressed bytes of a block in pieces.
class BlockBytes {
 public:
    BlockBytes(std::istream& stream, const FseqBlock& block) : stream_(stream), rest_(block.size) {
        stream_.clear();
        stream_.seekg(static_cast<std::streamoff>(block.offset));
    }

    /// Reads up to out.size() bytes; fewer only at the end of the block or of the file.
    std::size_t read(std::span<std::uint8_t> out) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), rest_));
        stream_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(wanted));
        const auto count = static_cast<std::size_t>(stream_.gcount());
        rest_ = count < wanted ? 0 : rest_ - count;
        return count;
    }

    /// The next piece, empty at the end.
    std::span<std::uint8_t> nextPiece() { return std::span(piece_).first(read(piece_)); }

 private:
    std::istream& stream_;
    std::uint64_t rest_;
    std::array<std::uint8_t, 65536> piece_;
};

class PlainSource : public FrameSource {
 public:
    PlainSource(std::istream& stream, const FseqBlock& block) : bytes_(stream, block) {}

    bool read(std::span<std::uint8_t> out) override { return bytes_.read(out) == out.size(); }

 private:
    BlockBytes bytes_;
};

class ZstdSource : public FrameSource {
 public:
    ZstdSource(std::istream& stream, const FseqBlock& block)
        : bytes_(stream, block), stream_(ZSTD_createDStream()) {
        if (!stream_) throw std::bad_alloc();
        ZSTD_DCtx_setParameter(stream_.get(), ZSTD_d_windowLogMax, kMaxWindowLog);
    }

    bool read(std::span<std::uint8_t> out) override {
        ZSTD_outBuffer output{out.data(), out.size(), 0};
        while (output.pos < output.size) {
            if (input_.pos == input_.size) {
                const std::span<std::uint8_t> piece = bytes_.nextPiece();
                input_ = {piece.data(), piece.size(), 0};
            }
            const std::size_t before = output.pos;
            const bool hadInput = input_.pos < input_.size;
            if (ZSTD_isError(ZSTD_decompressStream(stream_.get(), &output, &input_))) return false;
            if (output.pos == before && !hadInput) return false;
        }
        return true;
    }

 private:
    struct Free {
        void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
    };

    // What the decoder may be told to remember: 128 MiB, its own default, which no encoder of sequences
    // reaches.
    static constexpr int kMaxWindowLog = 27;

    BlockBytes bytes_;
    std::unique_ptr<ZSTD_DStream, Free> stream_;
    ZSTD_inBuffer input_{nullptr, 0, 0};
};

class ZlibSource : public FrameSource {
 public:
    ZlibSource(std::istream& stream, const FseqBlock& block) : bytes_(stream, block) {
        constexpr int kZlibOrGzip = 15 + 32;  // the largest window, kind of header found by itself
        if (inflateInit2(&stream_, kZlibOrGzip) != Z_OK) throw std::bad_alloc();
    }
    ~ZlibSource() override { inflateEnd(&stream_); }
    ZlibSource(const ZlibSource&) = delete;
    ZlibSource& operator=(const ZlibSource&) = delete;

    bool read(std::span<std::uint8_t> out) override {
        stream_.next_out = out.data();
        stream_.avail_out = static_cast<uInt>(out.size());
        while (stream_.avail_out > 0) {
            if (stream_.avail_in == 0) {
                const std::span<std::uint8_t> piece = bytes_.nextPiece();
                stream_.next_in = piece.data();
                stream_.avail_in = static_cast<uInt>(piece.size());
            }
            const int result = inflate(&stream_, Z_NO_FLUSH);
            if (result == Z_STREAM_END) return stream_.avail_out == 0;
            if (result != Z_OK) return false;
        }
        return true;
    }

 private:
    BlockBytes bytes_;
    z_stream stream_{};
};

}  // namespace

std::unique_ptr<FrameSource> openBlock(std::istream& stream, const FseqBlock& block,
                                       FseqCompression compression) {
    switch (compression) {
        case FseqCompression::kZstd:
            return std::make_unique<ZstdSource>(stream, block);
        case FseqCompression::kZlib:
            return std::make_unique<ZlibSource>(stream, block);
        case FseqCompression::kNone:
            break;
    }
    return std::make_unique<PlainSource>(stream, block);
}

}  // namespace hazer::protocol
