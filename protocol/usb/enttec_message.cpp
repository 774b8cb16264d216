#include "protocol/usb/enttec_message.h"

#include <algorithm>
#include <cassert>

namespace hazer::protocol {
namespace {

constexpr std::uint8_t kStart = 0x7E;
constexpr std::uint8_t kEnd = 0xE7;
constexpr std::size_t kHeaderSize = 4;
constexpr std::size_t kOverheadSize = kHeaderSize + 1;

std::size_t dataSizeOf(std::span<const std::uint8_t> header) {
    return static_cast<std::size_t>(header[2] | header[3] << 8);
}

}  // namespace

std::vector<std::uint8_t> packEnttec(EnttecLabel label, std::span<const std::uint8_t> data) {
    assert(data.size() <= kMaxEnttecData);
    std::vector<std::uint8_t> message(data.size() + kOverheadSize, kEnd);
    message[0] = kStart;
    message[1] = static_cast<std::uint8_t>(label);
    message[2] = static_cast<std::uint8_t>(data.size() & 0xFF);
    message[3] = static_cast<std::uint8_t>(data.size() >> 8);
    std::ranges::copy(data, message.begin() + kHeaderSize);
    return message;
}

std::optional<EnttecMessage> EnttecDecoder::next(std::span<const std::uint8_t>& bytes) {
    while (true) {
        if (const auto message = takeKept()) return message;
        if (bytes.empty()) return std::nullopt;
        keep(bytes);
    }
}

std::optional<EnttecMessage> EnttecDecoder::takeKept() {
    while (begin_ < end_) {
        const auto front = kept();
        if (front[0] != kStart) {
            skipFalseStart();
            continue;
        }
        if (front.size() < kHeaderSize) return std::nullopt;
        const std::size_t dataSize = dataSizeOf(front);
        if (dataSize > kMaxEnttecData) {
            skipFalseStart();
            continue;
        }
        if (front.size() < dataSize + kOverheadSize) return std::nullopt;
        if (front[dataSize + kHeaderSize] != kEnd) {
            skipFalseStart();
            continue;
        }
        begin_ += dataSize + kOverheadSize;
        return EnttecMessage{front[1], front.subspan(kHeaderSize, dataSize)};
    }
    return std::nullopt;
}

void EnttecDecoder::skipFalseStart() {
    const auto front = kept();
    const auto start = std::find(front.begin() + 1, front.end(), kStart);
    const auto skipped = static_cast<std::size_t>(start - front.begin());
    begin_ += skipped;
    skippedBytes_ += skipped;
}

// What is kept is always shorter than the longest message, so that there is room for more.
void EnttecDecoder::keep(std::span<const std::uint8_t>& bytes) {
    if (begin_ > kMaxMessage) {
        std::ranges::copy(kept(), buffer_.begin());
        end_ -= begin_;
        begin_ = 0;
    }
    const std::size_t count = std::min(bytes.size(), buffer_.size() - end_);
    std::ranges::copy(bytes.first(count), buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
    end_ += count;
    bytes = bytes.subspan(count);
}

}  // namespace hazer::protocol
