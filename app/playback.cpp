#include "app/playback.h"

#include <algorithm>
#include <cmath>

namespace hazer::app {
namespace {

using Indexing = protocol::RecordingPlayer::Indexing;

protocol::ReplayRules rulesFor(const ShowRecording& recording,
                               const std::vector<protocol::UniverseId>& asked) {
    protocol::ReplayRules rules;
    rules.asked = asked;
    rules.fileName = recording.file.filename().string();
    return rules;
}

void mergeHighest(protocol::Universe& into, const protocol::Universe& from) {
    std::ranges::transform(into.slots, from.slots, into.slots.begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    into.slotCount = std::max(into.slotCount, from.slotCount);
    into.packetCount += from.packetCount;
    into.lastReceived = std::max(into.lastReceived, from.lastReceived);
    into.isLost = into.isLost && from.isLost;
}

}  // namespace

Playback::Playback(const ShowRecording& recording, const std::vector<protocol::UniverseId>& asked,
                   bool scrubs)
    : loops(recording.loops),
      file_(recording.file),
      player_(recording.file, recording.map, rulesFor(recording, asked),
              scrubs ? Indexing::kBackground : Indexing::kNone) {
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

void Playback::goTo(Time time) {
    player_.goTo(std::max(time, Time(0)));
}

void Playback::mergeInto(protocol::UniverseSet& universes, protocol::TimePoint now) {
    player_.latch(looks_);
    for (auto& [id, look] : looks_) {
        look.lastReceived += now - protocol::ReplayState::timePointOf(player_.time());
        const auto [place, isNew] = universes.try_emplace(id, look);
        if (!isNew) mergeHighest(place->second, look);
    }
}

}  // namespace hazer::app
