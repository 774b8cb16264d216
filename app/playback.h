// A recording that stands in for a desk: it plays in the time of the show, and can be stopped and scrubbed.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/show.h"
#include "app/time_code_follower.h"
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

    /// Goes where a time code says that the show is at `now`; `code` is what arrived last, if anything has.
    /// Stays where it is before the first code.
    void follow(const std::optional<protocol::ReceivedTimeCode>& code, protocol::TimePoint now);

    /// Whether the time code ran when follow() was last called.
    bool isCodeRunning() const { return follower_.isRunning(); }

    void goTo(Time time);

    /// Lays what stands now into `universes`. Of universes that others give as well, the highest level of
    /// each slot counts, or (merge = "ltp") all levels of whoever changed any last.
    void mergeInto(protocol::UniverseSet& universes, protocol::TimePoint now);

    Time time() const { return player_.time(); }
    std::optional<Time> duration() const { return player_.duration(); }

    /// How far going anywhere takes a moment only.
    Time scrubEnd() const { return player_.indexedEnd(); }

    std::string name() const { return file_.filename().string(); }

    bool isPlaying = true;
    bool loops = false;
    bool followsTimeCode = false;  ///< Whether to follow() rather than to advance().

 private:
    /// The levels of a universe that others give as well.
    struct Contest {
        protocol::Slots ofFile{};
        protocol::Slots ofOthers{};
        bool isFileLatest = true;
    };

    bool isLatest(protocol::UniverseId id, const protocol::Universe& look, const protocol::Universe& others);
    void merge(protocol::UniverseId id, const protocol::Universe& look, protocol::Universe& others);

    std::filesystem::path file_;
    protocol::RecordingPlayer player_;
    protocol::UniverseSet looks_;
    protocol::MergeMode mergeMode_;
    std::map<protocol::UniverseId, Contest> contests_;  ///< With MergeMode::kLatest.
    TimeCodeFollower follower_;
    Time timeCodeStart_;  ///< The time code at which the recording begins.
};

}  // namespace hazer::app
