// Plays a recording into the receiver's own state machines, and goes to any moment of it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/recording/recording.h"
#include "protocol/recording/replay_index.h"
#include "protocol/recording/replay_state.h"

namespace hazer::protocol {

/// Not thread-safe. Whatever way leads to a moment, the state there is the same.
class RecordingPlayer {
 public:
    enum class Indexing : std::uint8_t {
        kNone,        ///< Going back plays from the start.
        kBackground,  ///< A thread reads the whole file once and leaves key frames behind.
    };

    /// Throws RecordingError if the file cannot be used.
    RecordingPlayer(const std::filesystem::path& file, const FrameMap& map, const ReplayRules& rules,
                    Indexing indexing);
    ~RecordingPlayer();
    RecordingPlayer(const RecordingPlayer&) = delete;
    RecordingPlayer& operator=(const RecordingPlayer&) = delete;

    /// Goes to the moment `time` >= 0: every packet up to and at it is played, none after it. Beyond the end
    /// the state ages on without packets. Throws RecordingError if the file changed meanwhile.
    void goTo(RecordingTime time);

    /// Plays the rest and goes to the time of the last packet.
    void goToEnd();

    RecordingTime time() const { return time_; }
    void latch(UniverseSet& out) { state_.latch(out, time_); }
    std::vector<UniverseStatus> status() { return state_.status(time_); }
    const ReplayState& state() const { return state_; }

    /// Packets of lighting up to now, those that the recording could not give whole included.
    std::uint64_t packetCount() const { return reader_->refusedCount() + state_.packetCount(); }

    /// Packets up to now that the recording could not give, or the receiver would not take.
    std::uint64_t refusedCount() const { return reader_->refusedCount() + state_.refusedCount(); }

    /// Nothing as long as the file has not been read to its end.
    std::optional<RecordingTime> duration() const;

    /// Up to where going anywhere takes a moment only.
    RecordingTime indexedEnd() const { return index_->end(); }

    /// Waits until the index is whole; for tests and measurements.
    void awaitIndex();

    std::vector<std::string> warnings() const { return reader_->warnings(); }
    const ReplayIndex& index() const { return *index_; }

 private:
    void restart();
    void restore(const KeyFrame& frame);
    void fetch();
    void playUpTo(RecordingTime time);

    ReplayRules rules_;
    std::unique_ptr<RecordingReader> reader_;
    RecordingMarkPtr start_;
    ReplayState state_;
    RecordingTime time_{};
    std::optional<RecordedPacket> upcoming_;  ///< Read but not yet due.
    bool hasFetched_ = false;
    std::shared_ptr<ReplayIndex> index_;
    class Indexer;
    std::unique_ptr<Indexer> indexer_;
};

}  // namespace hazer::protocol
