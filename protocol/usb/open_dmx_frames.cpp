#include "protocol/usb/open_dmx_frames.h"

#include <algorithm>

namespace hazer::protocol {

std::optional<std::span<const std::uint8_t>> OpenDmxFrames::receive(const FtdiPacket& packet) {
    if ((packet.lineStatus & kFtdiOverrun) != 0) isBroken_ = true;
    const auto payload = packet.payload;
    const bool endsWithBreak =
        (packet.lineStatus & kFtdiBreak) != 0 && (payload.empty() || payload.back() == 0);
    if (endsWithBreak) return takeBreak(payload);
    breaksInARow_ = 0;
    return append(payload);
}

void OpenDmxFrames::interrupt() {
    isCollecting_ = false;
    size_ = 0;
    breaksInARow_ = 0;
}

OpenDmxFrames::Frame OpenDmxFrames::takeBreak(std::span<const std::uint8_t> payload) {
    if (payload.empty()) {  // a long break, or one that comes without its character
        breaksInARow_ = std::max(breaksInARow_, 1);
        return finish();
    }
    ++breaksInARow_;
    // The second in a row may be the flag of the first that is still up. Then more of the frame follows.
    if (breaksInARow_ == 2 && size_ == 0) return append(payload);
    // The flag does not stay up for longer, so the second was a break as well: frames of one packet each.
    if (breaksInARow_ == 3) begin();
    const Frame full = append(payload.first(payload.size() - 1));
    const Frame ended = finish();
    return full ? full : ended;
}

OpenDmxFrames::Frame OpenDmxFrames::append(std::span<const std::uint8_t> bytes) {
    if (!isCollecting_) return std::nullopt;
    const std::size_t count = std::min(bytes.size(), frame_.size() - size_);
    std::ranges::copy(bytes.first(count), frame_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += count;
    if (size_ < frame_.size()) return std::nullopt;
    const Frame frame = finish();
    isCollecting_ = false;
    return frame;
}

// The bytes stay where they are until the next packet.
OpenDmxFrames::Frame OpenDmxFrames::finish() {
    const bool isWhole = isCollecting_ && size_ > 0;
    const bool isBroken = isBroken_;
    const std::size_t size = size_;
    begin();
    if (!isWhole) return std::nullopt;
    if (isBroken) {
        ++counters_.broken;
        return std::nullopt;
    }
    if (frame_[0] != 0) {
        ++counters_.otherCodes;
        return std::nullopt;
    }
    if (!isKnownLength(size)) {
        ++counters_.doubtful;
        return std::nullopt;
    }
    ++counters_.frames;
    return std::span(frame_).subspan(1, size - 1);
}

void OpenDmxFrames::begin() {
    size_ = 0;
    isCollecting_ = true;
    isBroken_ = false;
}

bool OpenDmxFrames::isKnownLength(std::size_t size) {
    const bool isKnown = std::ranges::find(lengths_, size) != lengths_.end();
    lengths_[nextLength_] = size;
    nextLength_ = (nextLength_ + 1) % lengths_.size();
    return isKnown;
}

}  // namespace hazer::protocol
