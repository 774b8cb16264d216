#include "app/status_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace hazer::app {

StatusLine::StatusLine() : isTerminal_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
    if (isTerminal_) std::fputs("\r\x1b[K", stderr);
}

void StatusLine::show(const std::function<std::string()>& text) {
    const auto now = std::chrono::steady_clock::now();
    if (!isTerminal_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    fmt::print(stderr, "\r\x1b[K{}", text());
    std::fflush(stderr);
}

}  // namespace hazer::app
