#include "protocol/recording/recording_player.h"

#include <thread>

namespace hazer::protocol {

/// Reads the file once from start to end on a thread of its own.
class RecordingPlayer::Indexer {
 public:
    Indexer(const std::filesystem::path& file, const FrameMap& map, const ReplayRules& rules,
            std::shared_ptr<ReplayIndex> index)
        : reader_(openRecording(file, map)), state_(rules), index_(std::move(index)) {
        thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }

    void await() {
        if (thread_.joinable()) thread_.join();
    }

 private:
    /// A file that cannot be read on has as much of an index as it has. The player meets the same fault.
    void run(const std::stop_token& stop) {
        try {
            build(stop);
        } catch (const RecordingError&) {
        }
    }

    void build(const std::stop_token& stop) {
        RecordingTime last{};
        while (const auto packet = reader_->next()) {
            if (stop.stop_requested()) return;
            state_.play(*packet);
            last = packet->time;
            if (index_->wants(state_.packetCount())) {
                index_->add({last, reader_->mark(), std::make_shared<ReplayState>(state_)});
            }
        }
        index_->finish(reader_->duration().value_or(last));
    }

    std::unique_ptr<RecordingReader> reader_;
    ReplayState state_;
    std::shared_ptr<ReplayIndex> index_;
    std::jthread thread_;
};

RecordingPlayer::RecordingPlayer(const std::filesystem::path& file, const FrameMap& map,
                                 const ReplayRules& rules, Indexing indexing)
    : rules_(rules),
      reader_(openRecording(file, map)),
      start_(reader_->mark()),
      state_(rules),
      index_(std::make_shared<ReplayIndex>()) {
    if (indexing == Indexing::kBackground) indexer_ = std::make_unique<Indexer>(file, map, rules, index_);
}

RecordingPlayer::~RecordingPlayer() = default;

void RecordingPlayer::goTo(RecordingTime time) {
    const std::optional<KeyFrame> frame = index_->before(time);
    const bool isNearer = frame && frame->state->packetCount() > state_.packetCount();
    if (frame && (time < time_ || isNearer)) {
        restore(*frame);
    } else if (time < time_) {
        restart();
    }
    playUpTo(time);
    time_ = time;
}

void RecordingPlayer::goToEnd() {
    RecordingTime last = time_;
    for (fetch(); upcoming_; fetch()) {
        state_.play(*upcoming_);
        last = upcoming_->time;
        hasFetched_ = false;
    }
    time_ = reader_->duration().value_or(last);
}

std::optional<RecordingTime> RecordingPlayer::duration() const {
    const std::optional<RecordingTime> known = reader_->duration();
    return known ? known : index_->duration();
}

void RecordingPlayer::awaitIndex() {
    if (indexer_) indexer_->await();
}

void RecordingPlayer::restart() {
    reader_->goTo(*start_);
    state_ = ReplayState(rules_);
    hasFetched_ = false;
}

void RecordingPlayer::restore(const KeyFrame& frame) {
    reader_->goTo(*frame.mark);
    state_ = *frame.state;
    hasFetched_ = false;
}

void RecordingPlayer::fetch() {
    if (hasFetched_) return;
    upcoming_ = reader_->next();
    hasFetched_ = true;
}

void RecordingPlayer::playUpTo(RecordingTime time) {
    for (fetch(); upcoming_ && upcoming_->time <= time; fetch()) {
        state_.play(*upcoming_);
        hasFetched_ = false;
    }
}

}  // namespace hazer::protocol
