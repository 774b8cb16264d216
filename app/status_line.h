// A line at a terminal that tells how work without a known end goes on.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace hazer::app {

/// Rewrites one line on stderr, at most ten times a second, and clears it at the end. Silent if stderr is no
/// terminal.
class StatusLine {
 public:
    StatusLine();
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// `text` is only asked for when the line is rewritten.
    void show(const std::function<std::string()>& text);

 private:
    bool isTerminal_;
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace hazer::app
