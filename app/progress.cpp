#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace hazer::app {

Progress::Progress(std::string what, int total)
    : what_(std::move(what)), total_(total), isTerminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (isTerminal_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(int done) {
    if (!isTerminal_) return;
    fmt::print(stderr, "\r\x1b[K{} {}/{}", what_, done, total_);
    std::fflush(stderr);
}

}  // namespace hazer::app
