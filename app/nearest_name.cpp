#include "app/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <vector>

namespace hazer::app {
namespace {

/// Longer lists would hide the sentence that they end.
constexpr std::size_t kMostNamesListed = 40;

/// Keys and fixture names are short; what is longer is no misspelling of one, and the distance costs its
/// square.
constexpr std::size_t kLongestNameCompared = 64;

bool sameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (sameLetter(a[i], b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearestName(std::string_view wanted, std::span<const std::string> names) {
    if (wanted.size() > kLongestNameCompared) return {};
    std::string nearest;
    std::size_t fewest = wanted.size() / 2 + 1;
    for (const std::string& name : names) {
        if (name.size() > kLongestNameCompared) continue;
        const std::size_t distance = editDistance(wanted, name);
        if (distance < fewest) {
            fewest = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string listNames(std::span<const std::string> names) {
    if (names.size() > kMostNamesListed) {
        const auto shown = names.first(kMostNamesListed);
        return fmt::format("{} and {} more", fmt::join(shown, ", "), names.size() - kMostNamesListed);
    }
    if (names.size() < 2) return names.empty() ? std::string() : names.front();
    return fmt::format("{} and {}", fmt::join(names.first(names.size() - 1), ", "), names.back());
}

std::string suggestName(std::string_view wanted, std::span<const std::string> names) {
    if (names.empty()) return " There are none.";
    const std::string nearest = nearestName(wanted, names);
    const std::string list = fmt::format(" There {} {}.", names.size() == 1 ? "is" : "are", listNames(names));
    return nearest.empty() ? list : fmt::format(" Did you mean '{}'?{}", nearest, list);
}

}  // namespace hazer::app
