// How far long work has come, for a person who waits at a terminal.
#pragma once

#include <string>

namespace hazer::app {

/// Rewrites one line on stderr while work goes on, and clears it at the end. Silent if stderr is no terminal.
class Progress {
 public:
    /// `total` > 0 steps of `what`, such as "drawing frame".
    Progress(std::string what, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` steps are behind us.
    void show(int done);

 private:
    std::string what_;
    int total_;
    bool isTerminal_;
};

}  // namespace hazer::app
