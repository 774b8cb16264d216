// Follows a time code as a tape machine would: where to be at any moment, between its frames and without it.
#pragma once

#include <chrono>
#include <optional>

#include "protocol/artnet_node.h"

namespace hazer::app {

/// Codes and the time go in, a position comes out; neither sockets nor a clock. Not thread-safe; times handed
/// in must not go back.
///
/// While the code runs, the position runs with it evenly: the network delivers codes some milliseconds early
/// or late, and that is smoothed away. When the code stands, the position is exactly that of the last code.
/// When it jumps, so does the position.
class TimeCodeFollower {
 public:
    using Time = std::chrono::nanoseconds;

    /// Without another code for so long, the code stands. A desk that pauses either falls silent or repeats
    /// one code; a few lost packets must not stop a show.
    static constexpr std::chrono::milliseconds kStandsAfter{250};

    /// A code that is farther off is a jump: two to three frames of every rate.
    static constexpr std::chrono::milliseconds kJumpsBeyond{100};

    /// Takes the code that arrived last; handing in one again does nothing. As long as one machine's code
    /// runs, those of others are left alone.
    void take(const protocol::ReceivedTimeCode& received);

    /// Where to be at `now`, since 0:00:00:00; nothing before the first code.
    std::optional<Time> position(protocol::TimePoint now);

    /// Whether the code runs, as of the last call of position().
    bool isRunning() const { return clockAtZero_.has_value(); }

 private:
    struct Code {
        Time time{};
        protocol::TimePoint arrival{};
        protocol::Ipv4Address from{};
    };

    void run(const Code& code);
    void jump(const Code& code);

    std::optional<Code> last_;
    /// When the code that runs was or would have been at 0; nothing: it stands.
    std::optional<protocol::TimePoint> clockAtZero_;
    Time position_{};
};

}  // namespace hazer::app
