// hazer send: synthetic DMX over Art-Net.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "app/commands/command.h"
#include "app/interrupt.h"
#include "protocol/pattern.h"
#include "protocol/sender.h"

namespace hazer::app {
namespace {

struct SendOptions {
    std::uint16_t portAddress = 0;
    std::string pattern;
    std::vector<std::string> levels;  // "SLOT=VALUE"
    double packetsPerS = 44.0;
    std::string address = "127.0.0.1";
    std::uint16_t port = 6454;
    double seconds = 0.0;  // 0: until Ctrl-C
};

/// One slot by hand. `index` is 0-based.
struct Level {
    std::size_t index;
    std::uint8_t value;
};

std::optional<Level> parseLevel(const std::string& text) {
    int slot = 0;
    int value = 0;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return std::nullopt;
    if (!CLI::detail::lexical_cast(text.substr(0, equals), slot)) return std::nullopt;
    if (!CLI::detail::lexical_cast(text.substr(equals + 1), value)) return std::nullopt;
    if (slot < 1 || slot > static_cast<int>(protocol::kSlotCount) || value < 0 || value > 255)
        return std::nullopt;
    return Level{static_cast<std::size_t>(slot - 1), static_cast<std::uint8_t>(value)};
}

std::string checkLevel(const std::string& text) {
    if (parseLevel(text)) return {};
    return fmt::format("'{}' is no level; write SLOT=VALUE with a slot 1..512 and a value 0..255", text);
}

std::vector<Level> parseLevels(const std::vector<std::string>& texts) {
    std::vector<Level> levels;
    for (const std::string& text : texts) levels.push_back(*parseLevel(text));
    return levels;
}

/// Without a word about what to send, a chase shows best that something arrives.
std::optional<protocol::Pattern> patternOf(const SendOptions& options) {
    if (options.pattern.empty() && !options.levels.empty()) return std::nullopt;
    return protocol::patternFromName(options.pattern.empty() ? "chase" : options.pattern);
}

long sendUntilDone(const SendOptions& options, protocol::ArtNetSender& sender) {
    using Seconds = std::chrono::duration<double>;
    const std::optional<protocol::Pattern> pattern = patternOf(options);
    const std::vector<Level> levels = parseLevels(options.levels);
    const Interrupt interrupt;
    const protocol::TimePoint start = protocol::Clock::now();
    protocol::Slots slots{};
    long sent = 0;
    for (double timeS = 0.0; options.seconds == 0.0 || timeS < options.seconds;
         timeS = static_cast<double>(sent) / options.packetsPerS) {
        std::this_thread::sleep_until(start +
                                      std::chrono::duration_cast<protocol::Clock::duration>(Seconds(timeS)));
        if (interrupt.asked()) break;
        if (pattern) protocol::fillPattern(*pattern, timeS, slots);
        for (const Level& level : levels) slots[level.index] = level.value;
        sender.send(options.portAddress, slots);
        ++sent;
    }
    return sent;
}

int runSend(const SendOptions& options) {
    protocol::ArtNetSender sender(options.address, options.port);
    fmt::print(stderr, "sending ArtDmx for Port-Address {} to {}:{}{}\n", options.portAddress,
               options.address, options.port, options.seconds == 0.0 ? "; Ctrl-C ends it" : "");
    fmt::print("{} packets sent\n", sendUntilDone(options, sender));
    return kExitOk;
}

}  // namespace

void addSendCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<SendOptions>();
    CLI::App* command = program.add_subcommand("send", "Send synthetic DMX over Art-Net.");
    beginHelpWith(*command,
                  "  hazer send --universe 1 --pattern chase     a chase to this machine until Ctrl-C\n"
                  "  hazer send --slot 1=255 --slot 5=128        two slots by hand, sent steadily\n"
                  "  hazer send --pattern full --to 2.0.0.5 --seconds 10\n");
    command->add_option("--universe", options->portAddress, "Art-Net Port-Address, 0..32767")
        ->check(CLI::Range(0, 32767));
    command->add_option("--pattern", options->pattern, "What to send; chase unless slots are given")
        ->check(CLI::IsMember({"chase", "sine", "strobe", "full"}));
    command
        ->add_option("--slot", options->levels, "A slot by hand, SLOT=VALUE: 1..512, 0..255; may be repeated")
        ->check(checkLevel);
    command->add_option("--fps", options->packetsPerS, "Packets a second, 1..1000; 44 unless given")
        ->check(numberFrom(1.0, 1000.0));
    command->add_option("--to", options->address, "IPv4 address of the receiver; 127.0.0.1 unless given");
    command->add_option("--port", options->port, "UDP port; 6454 unless given")->check(CLI::Range(1, 65535));
    command->add_option("--seconds", options->seconds, "How long; until Ctrl-C unless given")
        ->check(numberFrom(0.001, 1e6));
    command->callback([options, &chosen] { chosen = [options] { return runSend(*options); }; });
}

}  // namespace hazer::app
