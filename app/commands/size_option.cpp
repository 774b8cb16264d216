#include "app/commands/size_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

namespace hazer::app {
namespace {

std::optional<Size> parseSize(const std::string& text) {
    const std::size_t cross = text.find('x');
    Size size{};
    if (cross == std::string::npos || !CLI::detail::lexical_cast(text.substr(0, cross), size.width) ||
        !CLI::detail::lexical_cast(text.substr(cross + 1), size.height)) {
        return std::nullopt;
    }
    const auto fits = [](int edge) { return edge >= 1 && edge <= 8192; };
    return fits(size.width) && fits(size.height) ? std::optional(size) : std::nullopt;
}

std::string checkSize(const std::string& text) {
    return parseSize(text)
               ? std::string()
               : fmt::format("'{}' must read WIDTHxHEIGHT, each 1 to 8192, such as 1280x720", text);
}

}  // namespace

void addSizeOption(CLI::App& command, Size& size) {
    const auto take = [&size](const std::string& text) { size = parseSize(text).value_or(size); };
    command
        .add_option_function<std::string>(
            "--size", take,
            fmt::format("WIDTHxHEIGHT in pixels; {}x{} unless given", size.width, size.height))
        ->check(checkSize);
}

}  // namespace hazer::app
