#include "app/playback.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {
namespace {

using Indexing = protocol::RecordingPlayer::Indexing;

protocol::ReplayRules rulesFor(const ShowRecording& recording,
                               const std::vector<protocol::UniverseId>& asked) {
    protocol::ReplayRules rules;
    rules.merge = recording.merging;
    rules.asked = asked;
    rules.fileName = recording.file.filename().string();
    return rules;
}

// What has to be played on the way to a place that is not indexed yet would hold up a picture; so much of it
// is played with each.
constexpr Playback::Time kMostPlayedAtOnce = std::chrono::seconds(5);

}  // namespace

Playback::Playback(const ShowRecording& recording, const std::vector<protocol::UniverseId>& asked,
                   bool scrubs)
    : loops(recording.loops),
      followsTimeCode(recording.clock == PlaybackClock::kTimeCode),
      file_(recording.file),
      player_(recording.file, recording.map, rulesFor(recording, asked),
              scrubs ? Indexing::kBackground : Indexing::kNone),
      mergeMode_(recording.merging.mode),
      timeCodeStart_(recording.timeCodeStart) {
    player_.goTo(recording.from);
}

void Playback::advance(double dtS) {
    if (!isPlaying) return;
    constexpr double kNanosecondsPerS = 1e9;
    const Time next = player_.time() + Time(std::llround(dtS * kNanosecondsPerS));
    player_.goTo(next);
    const std::optional<Time> end = player_.duration();
    if (!loops || !end || next < *end) return;
    // A recording of no length has nothing to begin again with.
    player_.goTo(end->count() > 0 ? next % *end : Time(0));
}

void Playback::follow(const std::optional<protocol::ReceivedTimeCode>& code, protocol::TimePoint now) {
    if (code) follower_.take(*code);
    const auto position = follower_.position(now);
    if (!position) return;
    goTo(std::min(*position - timeCodeStart_,
                  std::max(player_.indexedEnd(), player_.time() + kMostPlayedAtOnce)));
}

void Playback::goTo(Time time) {
    player_.goTo(std::max(time, Time(0)));
}

void Playback::mergeInto(protocol::UniverseSet& universes, protocol::TimePoint now) {
    player_.latch(looks_);
    for (auto& [id, look] : looks_) {
        look.lastReceived += now - protocol::ReplayState::timePointOf(player_.time());
        const auto [place, isNew] = universes.try_emplace(id, look);
        if (!isNew) merge(id, look, place->second);
    }
}

void Playback::merge(protocol::UniverseId id, const protocol::Universe& look, protocol::Universe& others) {
    if (mergeMode_ == protocol::MergeMode::kHighest) {
        std::ranges::transform(others.slots, look.slots, others.slots.begin(),
                               [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    } else if (isLatest(id, look, others)) {
        others.slots = look.slots;
    }
    others.slotCount = std::max(others.slotCount, look.slotCount);
    others.packetCount += look.packetCount;
    others.lastReceived = std::max(others.lastReceived, look.lastReceived);
    others.isLost = others.isLost && look.isLost;
}

/// As in protocol::MergeMode::kLatest; a look without a live source gives way to one that has any.
bool Playback::isLatest(protocol::UniverseId id, const protocol::Universe& look,
                        const protocol::Universe& others) {
    Contest& contest = contests_.try_emplace(id, Contest{look.slots, others.slots}).first->second;
    if (others.slots != contest.ofOthers) contest.isFileLatest = false;
    if (look.slots != contest.ofFile) contest.isFileLatest = true;
    contest.ofFile = look.slots;
    contest.ofOthers = others.slots;
    return look.isLost == others.isLost ? contest.isFileLatest : others.isLost;
}

}  // namespace hazer::app
