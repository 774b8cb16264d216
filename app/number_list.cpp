#include "app/number_list.h"

#include <fmt/format.h>

#include <charconv>
#include <set>

namespace hazer::app {
namespace {

std::optional<std::uint16_t> parseNumber(std::string_view text) {
    std::uint16_t number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::vector<std::uint16_t>> parseNumberList(std::string_view text, std::uint16_t first,
                                                          std::uint16_t last) {
    std::set<std::uint16_t> numbers;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        const std::size_t dash = part.find('-');
        const auto from = parseNumber(part.substr(0, dash));
        const auto to = dash == std::string_view::npos ? from : parseNumber(part.substr(dash + 1));
        if (!from || !to || *from < first || *to > last || *from > *to) return std::nullopt;
        for (std::uint32_t number = *from; number <= *to; ++number) {
            numbers.insert(static_cast<std::uint16_t>(number));
        }
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
    }
    return std::vector<std::uint16_t>(numbers.begin(), numbers.end());
}

std::string numberListText(std::span<const std::uint16_t> numbers) {
    std::string text;
    for (std::size_t first = 0; first < numbers.size();) {
        std::size_t last = first;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        if (!text.empty()) text += ',';
        text += last == first ? fmt::format("{}", numbers[first])
                              : fmt::format("{}-{}", numbers[first], numbers[last]);
        first = last + 1;
    }
    return text.empty() ? "none" : text;
}

}  // namespace hazer::app
