#include "protocol/recording/replay_index.h"

#include <algorithm>
#include <utility>

namespace hazer::protocol {

bool ReplayIndex::wants(std::uint64_t packetCount) const {
    const std::lock_guard lock(mutex_);
    return packetCount % distance_ == 0;
}

void ReplayIndex::add(KeyFrame frame) {
    const std::size_t frameBytes = frame.state->approximateBytes();
    const std::lock_guard lock(mutex_);
    frames_.push_back(std::move(frame));
    const std::size_t most = std::clamp<std::size_t>(kMostBytes / frameBytes, 2, mostKeyFrames_);
    if (frames_.size() <= most) return;
    distance_ *= 2;
    std::erase_if(frames_, [&](const KeyFrame& kept) { return kept.state->packetCount() % distance_ != 0; });
}

std::optional<KeyFrame> ReplayIndex::before(RecordingTime time) const {
    const std::lock_guard lock(mutex_);
    const auto after = std::ranges::upper_bound(frames_, time, {}, &KeyFrame::time);
    if (after == frames_.begin()) return std::nullopt;
    return *std::prev(after);
}

void ReplayIndex::finish(RecordingTime duration) {
    const std::lock_guard lock(mutex_);
    duration_ = duration;
}

RecordingTime ReplayIndex::end() const {
    const std::lock_guard lock(mutex_);
    if (duration_) return *duration_;
    return frames_.empty() ? RecordingTime(0) : frames_.back().time;
}

std::optional<RecordingTime> ReplayIndex::duration() const {
    const std::lock_guard lock(mutex_);
    return duration_;
}

std::size_t ReplayIndex::size() const {
    const std::lock_guard lock(mutex_);
    return frames_.size();
}

}  // namespace hazer::protocol
