#include "app/moment.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace hazer::app {
namespace {

std::optional<double> numberFrom(std::string_view text, bool mayHaveFraction) {
    const std::string_view allowed = mayHaveFraction ? "0123456789." : "0123456789";
    if (text.empty() || text.find_first_not_of(allowed) != std::string_view::npos) return std::nullopt;
    double number = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::chrono::nanoseconds> parseMoment(std::string_view text) {
    constexpr double kLongestS = 100.0 * 24.0 * 3600.0;
    constexpr double kNanosecondsPerS = 1e9;
    double seconds = 0.0;
    for (int part = 0;; ++part) {
        const std::size_t colon = text.find(':');
        const bool isLast = colon == std::string_view::npos;
        const auto number = numberFrom(text.substr(0, colon), isLast);
        if (!number || part > 2 || (part > 0 && *number >= 60.0)) return std::nullopt;
        seconds = seconds * 60.0 + *number;
        if (isLast) break;
        text.remove_prefix(colon + 1);
    }
    if (seconds > kLongestS) return std::nullopt;
    return std::chrono::nanoseconds(std::llround(seconds * kNanosecondsPerS));
}

std::string momentText(std::chrono::nanoseconds moment) {
    const auto tenths =
        std::chrono::duration_cast<std::chrono::duration<std::int64_t, std::deci>>(moment).count();
    const std::int64_t minutes = tenths / 600;
    const double seconds = static_cast<double>(tenths % 600) / 10.0;
    if (minutes < 60) return fmt::format("{}:{:04.1f}", minutes, seconds);
    return fmt::format("{}:{:02}:{:04.1f}", minutes / 60, minutes % 60, seconds);
}

}  // namespace hazer::app
