#include "app/commands/max_error_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace hazer::app {
namespace {

constexpr double kSmallest = 1e-4;
constexpr double kLargest = 0.5;

std::optional<double> parseShare(std::string text) {
    const bool isPercent = !text.empty() && text.back() == '%';
    if (isPercent) text.pop_back();
    double share = 0.0;
    if (!CLI::detail::lexical_cast(text, share)) return std::nullopt;
    if (isPercent) share /= 100.0;
    // A comparison that NaN fails.
    return share >= kSmallest && share <= kLargest ? std::optional(share) : std::nullopt;
}

std::string checkShare(const std::string& text) {
    return parseShare(text) ? std::string()
                            : fmt::format("'{}' must be a share from 0.01% to 50%, such as 1% or 0.01", text);
}

}  // namespace

void addMaxErrorOption(CLI::App& command, double& maxError) {
    const auto take = [&maxError](const std::string& text) {
        maxError = parseShare(text).value_or(maxError);
    };
    command
        .add_option_function<std::string>(
            "--max-error", take,
            "Cheapest integration of the light in the air within this error, such as 1%: root mean square, "
            "of that of the light")
        ->check(checkShare);
}

}  // namespace hazer::app
