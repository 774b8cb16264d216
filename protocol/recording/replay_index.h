// States of a recording at regular places, from which any moment is near.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "protocol/recording/recording.h"
#include "protocol/recording/replay_state.h"

namespace hazer::protocol {

/// The whole state after `state->packetCount()` packets, the last of which came at `time`.
struct KeyFrame {
    RecordingTime time{};
    RecordingMarkPtr mark;  ///< Where the next packet is.
    std::shared_ptr<const ReplayState> state;
};

/// Thread-safe: one thread adds, another one looks up. Keeps so many key frames that they stay within a bound
/// of memory: when there are too many, every second one goes and the distance doubles.
class ReplayIndex {
 public:
    /// Packets from key frame to key frame at first. Playing so many takes a few milliseconds.
    static constexpr std::uint64_t kFirstDistance = 4096;

    static constexpr std::size_t kMostKeyFrames = 4096;
    static constexpr std::size_t kMostBytes = 512u * 1024u * 1024u;

    /// `mostKeyFrames` >= 2.
    explicit ReplayIndex(std::size_t mostKeyFrames = kMostKeyFrames) : mostKeyFrames_(mostKeyFrames) {}

    /// Whether a key frame is due after so many packets.
    bool wants(std::uint64_t packetCount) const;

    /// Key frames come in the order of the recording.
    void add(KeyFrame frame);

    /// The last one at or before `time`; nothing: begin at the start.
    std::optional<KeyFrame> before(RecordingTime time) const;

    /// Everything is in; `duration` is that of the recording.
    void finish(RecordingTime duration);

    /// How far the index reaches by now.
    RecordingTime end() const;
    std::optional<RecordingTime> duration() const;  ///< Once it is finished.
    std::size_t size() const;

 private:
    const std::size_t mostKeyFrames_;
    mutable std::mutex mutex_;
    std::vector<KeyFrame> frames_;
    std::uint64_t distance_ = kFirstDistance;
    std::optional<RecordingTime> duration_;
};

}  // namespace hazer::protocol
