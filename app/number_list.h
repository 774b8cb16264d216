// Lists of numbers as people write them: 1-64,70.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hazer::app {

/// The numbers of "1-64,70", ascending, each once. Nothing if the text is no such list or holds a number
/// outside first..last.
std::optional<std::vector<std::uint16_t>> parseNumberList(std::string_view text, std::uint16_t first,
                                                          std::uint16_t last);

/// "1-64,70" of ascending numbers, or "none".
std::string numberListText(std::span<const std::uint16_t> numbers);

}  // namespace hazer::app
