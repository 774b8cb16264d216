#include "app/commands/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace hazer::app {
namespace {

/// CLI11's help with examples above everything else.
class ExamplesFirst : public CLI::Formatter {
 public:
    explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) {}

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        // In the list of commands each stands with its description alone.
        const std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
        return mode == CLI::AppFormatMode::Sub ? help : "Examples:\n" + examples_ + "\n" + help;
    }

 private:
    std::string examples_;
};

}  // namespace

void beginHelpWith(CLI::App& command, const std::string& examples) {
    command.formatter(std::make_shared<ExamplesFirst>(examples));
}

CLI::Validator numberFrom(double smallest, double largest) {
    const auto check = [smallest, largest](const std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= smallest && value <= largest) {
            return std::string();
        }
        return fmt::format("'{}' must be a number from {} to {}", text, smallest, largest);
    };
    return CLI::Validator(check, fmt::format("in [{} - {}]", smallest, largest));
}

}  // namespace hazer::app
