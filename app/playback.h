// A recording that stands in for a desk: it plays in the time of the show, and can be stopped and scrubbed.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/show.h"
#include "protocol/recording/recording_player.h"

namespace hazer::app {

/// Not thread-safe. The same calls give the same universes, whatever the speed of the machine.
class Playback {
 public:
    using Time = protocol::RecordingTime;

    /// `asked` are the universes of the patch. With `scrubs`, an index is built in the background, so that
    /// going anywhere takes a moment only. Throws protocol::RecordingError.
    Playback(const ShowRecording& recording, const std::vector<protocol::UniverseId>& asked, bool scrubs);

    /// Lets `dtS` >= 0 seconds of the show pass.
    void advance(double dtS);

    void goTo(Time time);

    /// Lays what stands now into `universes`: of universes that others give as well, the highest level of
    /// each slot counts.
    void mergeInto(protocol::UniverseSet& universes, protocol::TimePoint now);

    Time time() const { return player_.time(); }
    std::optional<Time> duration() const { return player_.duration(); }

    /// How far going anywhere takes a moment only.
    Time scrubEnd() const { return player_.indexedEnd(); }

    std::string name() const { return file_.filename().string(); }

    bool isPlaying = true;
    bool loops = false;

 private:
    std::filesystem::path file_;
    protocol::RecordingPlayer player_;
    protocol::UniverseSet looks_;
};

}  // namespace hazer::app
