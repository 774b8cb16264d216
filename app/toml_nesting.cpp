#include "app/toml_nesting.h"

#include <algorithm>
#include <string>

namespace hazer::app {
namespace {

constexpr int kMostDots = 16;

/// Where the string that begins with the quote at `start` ends: behind its last quote, or where a TOML parser
/// would give up.
std::size_t endOfString(std::string_view toml, std::size_t start) {
    const char quote = toml[start];
    const std::string threeQuotes(3, quote);
    const bool isMultiLine = toml.substr(start, 3) == threeQuotes;
    for (std::size_t i = start + (isMultiLine ? 3 : 1); i < toml.size(); ++i) {
        if (toml[i] == '\\' && quote == '"') {
            ++i;
        } else if (toml[i] == quote && !isMultiLine) {
            return i + 1;
        } else if (toml[i] == '\n' && !isMultiLine) {
            return i;
        } else if (isMultiLine && toml.substr(i, 3) == threeQuotes) {
            // One or two quotes before the closing three belong to the text.
            return std::min(toml.find_first_not_of(quote, i), i + 5);
        }
    }
    return toml.size();
}

std::size_t endOfComment(std::string_view toml, std::size_t start) {
    return std::min(toml.find('\n', start), toml.size());
}

}  // namespace

std::optional<std::size_t> lineOfDeepKey(std::string_view toml) {
    constexpr std::string_view kEndOfKey = "=,[]{}\n";
    int dots = 0;
    for (std::size_t i = 0; i < toml.size();) {
        const char letter = toml[i];
        if (letter == '"' || letter == '\'') {
            i = endOfString(toml, i);
            continue;
        }
        if (letter == '#') {
            i = endOfComment(toml, i);
            continue;
        }
        if (kEndOfKey.find(letter) != std::string_view::npos) dots = 0;
        if (letter == '.' && ++dots > kMostDots) {
            const auto before = toml.substr(0, i);
            return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
        }
        ++i;
    }
    return std::nullopt;
}

}  // namespace hazer::app
