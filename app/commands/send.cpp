// hazer send: synthetic DMX over Art-Net or sACN.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "app/commands/command.h"
#include "app/interrupt.h"
#include "app/number_list.h"
#include "app/send_output.h"
#include "protocol/artnet.h"
#include "protocol/pattern.h"

namespace hazer::app {
namespace {

struct SendOptions {
    std::string protocol = "artnet";
    std::string universes;  // "1-64"; empty: the first one there is
    std::string pattern;
    std::vector<std::string> levels;  // "SLOT=VALUE"
    double framesPerS = 44.0;
    std::string address;  // empty: sACN by multicast, Art-Net to this machine
    std::string interface;
    bool usesIpv6 = false;
    std::optional<std::uint16_t> port;
    double seconds = 0.0;  // 0: until Ctrl-C
    std::string name = "hazer";
    std::uint8_t priority = protocol::kDefaultPriority;
    std::vector<std::string> slotPriorities;  // "SLOT=PRIORITY"
    bool synchronizes = false;
    std::uint16_t syncAddress = 0;  // of sACN, where it is needed
    bool isPreview = false;

    bool isSacn() const { return protocol == "sacn"; }
};

/// One slot by hand. `index` is 0-based.
struct Level {
    std::size_t index;
    std::uint8_t value;
};

std::optional<Level> parseLevel(const std::string& text, int highest = 255) {
    int slot = 0;
    int value = 0;
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return std::nullopt;
    if (!CLI::detail::lexical_cast(text.substr(0, equals), slot)) return std::nullopt;
    if (!CLI::detail::lexical_cast(text.substr(equals + 1), value)) return std::nullopt;
    if (slot < 1 || slot > static_cast<int>(protocol::kSlotCount) || value < 0 || value > highest)
        return std::nullopt;
    return Level{static_cast<std::size_t>(slot - 1), static_cast<std::uint8_t>(value)};
}

std::string checkLevel(const std::string& text) {
    if (parseLevel(text)) return {};
    return fmt::format("'{}' is no level; write SLOT=VALUE with a slot 1..512 and a value 0..255", text);
}

std::string checkSlotPriority(const std::string& text) {
    if (parseLevel(text, protocol::kMaxPriority)) return {};
    return fmt::format("'{}' is no priority of a slot; write SLOT=PRIORITY with 1..512 and 0..200", text);
}

std::vector<Level> parseLevels(const std::vector<std::string>& texts) {
    std::vector<Level> levels;
    for (const std::string& text : texts) levels.push_back(*parseLevel(text));
    return levels;
}

/// Those of the universe, changed where slots have their own. Empty: no slot has.
std::vector<std::uint8_t> slotPrioritiesOf(const SendOptions& options) {
    if (options.slotPriorities.empty()) return {};
    std::vector<std::uint8_t> priorities(protocol::kSlotCount, options.priority);
    for (const Level& level : parseLevels(options.slotPriorities)) priorities[level.index] = level.value;
    return priorities;
}

std::vector<std::uint16_t> universesOf(const SendOptions& options) {
    const std::uint16_t first = options.isSacn() ? 1 : 0;
    const std::uint16_t last = options.isSacn() ? protocol::kMaxSacnUniverse : protocol::kMaxPortAddress;
    if (options.universes.empty()) return {first};
    if (const auto universes = parseNumberList(options.universes, first, last)) return *universes;
    throw CLI::ValidationError("--universes", fmt::format("'{}' is no list such as 1-64,70 of numbers {}..{}",
                                                          options.universes, first, last));
}

/// Without a word about what to send, a chase shows best that something arrives.
std::optional<protocol::Pattern> patternOf(const SendOptions& options) {
    if (options.pattern.empty() && !options.levels.empty()) return std::nullopt;
    return protocol::patternFromName(options.pattern.empty() ? "chase" : options.pattern);
}

using Seconds = std::chrono::duration<double>;

protocol::TimePoint timeOf(protocol::TimePoint start, double timeS) {
    return start + std::chrono::duration_cast<protocol::Clock::duration>(Seconds(timeS));
}

/// Sleeps until `end`, and sends what is due meanwhile.
void sendUntil(protocol::TimePoint end, SendOutput& output) {
    for (auto due = output.nextDue(); due && *due < end; due = output.nextDue()) {
        std::this_thread::sleep_until(*due);
        output.sendDue(protocol::Clock::now());
    }
    std::this_thread::sleep_until(end);
}

void sendUntilDone(const SendOptions& options, SendOutput& output) {
    const std::optional<protocol::Pattern> pattern = patternOf(options);
    const std::vector<Level> levels = parseLevels(options.levels);
    const Interrupt interrupt;
    const protocol::TimePoint start = protocol::Clock::now();
    protocol::Slots slots{};
    std::uint64_t frame = 0;
    for (double timeS = 0.0; options.seconds == 0.0 || timeS < options.seconds;
         timeS = static_cast<double>(++frame) / options.framesPerS) {
        sendUntil(timeOf(start, timeS), output);
        if (interrupt.asked()) break;
        if (pattern) protocol::fillPattern(*pattern, timeS, slots);
        for (const Level& level : levels) slots[level.index] = level.value;
        output.sendFrame(slots, protocol::Clock::now());
    }
    output.finish();
}

protocol::SacnSenderConfig sacnConfigOf(const SendOptions& options) {
    protocol::SacnSenderConfig config;
    config.source.name = options.name;
    config.source.priority = options.priority;
    config.source.syncAddress = options.syncAddress;
    config.source.isPreview = options.isPreview;
    config.to = options.address;
    config.interface = options.interface;
    config.usesIpv6Groups = options.usesIpv6;
    config.port = options.port.value_or(protocol::kSacnPort);
    return config;
}

std::string artNetAddressOf(const SendOptions& options) {
    return options.address.empty() ? "127.0.0.1" : options.address;
}

std::unique_ptr<SendOutput> outputOf(const SendOptions& options) {
    const std::vector<std::uint16_t> universes = universesOf(options);
    if (options.isSacn()) return sacnOutput(sacnConfigOf(options), universes, slotPrioritiesOf(options));
    return artNetOutput(artNetAddressOf(options), options.port.value_or(protocol::kArtNetPort), universes,
                        options.synchronizes);
}

std::string destinationOf(const SendOptions& options) {
    if (!options.isSacn()) return artNetAddressOf(options);
    if (!options.address.empty()) return options.address;
    return options.interface.empty() ? "multicast" : fmt::format("multicast on {}", options.interface);
}

int runSend(const SendOptions& options) {
    const std::unique_ptr<SendOutput> output = outputOf(options);
    const std::string universes =
        options.universes.empty() ? (options.isSacn() ? "1" : "0") : options.universes;
    fmt::print(stderr, "sending {} {} to {}{}\n", options.isSacn() ? "sACN universe" : "Art-Net Port-Address",
               universes, destinationOf(options), options.seconds == 0.0 ? "; Ctrl-C ends it" : "");
    sendUntilDone(options, *output);
    fmt::print("{} packets sent\n", output->packetCount());
    return kExitOk;
}

/// What only sACN can say must not be left out in silence.
void refuseSacnOptionsOfArtNet(const CLI::App& command, const SendOptions& options) {
    if (options.isSacn()) return;
    for (const char* name :
         {"--priority", "--slot-priority", "--preview", "--name", "--interface", "--ipv6"}) {
        if (command.count(name) > 0) throw CLI::ValidationError(name, "needs --protocol sacn");
    }
}

/// Empty: --sync stood alone.
void readSync(const std::string& address, SendOptions& options) {
    options.synchronizes = true;
    if (address.empty()) return;
    const auto number = parseNumberList(address, 1, protocol::kMaxSacnUniverse);
    if (!number || number->size() != 1)
        throw CLI::ValidationError("--sync", fmt::format("'{}' is no address 1..63999", address));
    options.syncAddress = number->front();
}

void checkSync(const SendOptions& options) {
    if (!options.synchronizes) return;
    if (options.isSacn() && options.syncAddress == 0)
        throw CLI::ValidationError("--sync", "needs an address 1..63999 with --protocol sacn");
    if (!options.isSacn() && options.syncAddress != 0)
        throw CLI::ValidationError("--sync", "takes no address without --protocol sacn");
}

void addWhatOptions(CLI::App& command, SendOptions& options) {
    command.add_option("--protocol", options.protocol, "artnet (unless given) or sacn")
        ->check(CLI::IsMember({"artnet", "sacn"}));
    command.add_option(
        "--universe,--universes", options.universes,
        "Art-Net Port-Addresses 0..32767 or sACN universes 1..63999, such as 1-64,70; the first "
        "there is unless given");
    command.add_option("--pattern", options.pattern, "What to send; chase unless slots are given")
        ->check(CLI::IsMember({"chase", "sine", "strobe", "full"}));
    command
        .add_option("--slot", options.levels, "A slot by hand, SLOT=VALUE: 1..512, 0..255; may be repeated")
        ->check(checkLevel);
    command.add_option("--rate,--fps", options.framesPerS, "Frames a second, 1..1000; 44 unless given")
        ->check(numberFrom(1.0, 1000.0));
    command.add_option("--seconds", options.seconds, "How long; until Ctrl-C unless given")
        ->check(numberFrom(0.001, 1e6));
}

void addWhereOptions(CLI::App& command, SendOptions& options) {
    command.add_option("--to", options.address,
                       "IP address of the receiver; unless given 127.0.0.1 for Art-Net, multicast for sACN");
    command.add_option("--port", options.port, "UDP port; unless given 6454 for Art-Net, 5568 for sACN")
        ->check(CLI::Range(1, 65535));
    command.add_option("--interface", options.interface,
                       "sACN: name or address of the one to multicast from");
    command.add_flag("--ipv6", options.usesIpv6, "sACN: multicast groups of IPv6");
}

void addSourceOptions(CLI::App& command, SendOptions& options) {
    command.add_option("--name", options.name, "sACN: what the source calls itself; hazer unless given");
    command.add_option("--priority", options.priority, "sACN: 0..200; 100 unless given")
        ->check(CLI::Range(0, 200));
    command
        .add_option(
            "--slot-priority", options.slotPriorities,
            "sACN: per-address priority of a slot, SLOT=PRIORITY: 0 is not controlled; may be repeated")
        ->check(checkSlotPriority);
    command
        .add_option_function<std::string>(
            "--sync", [&options](const std::string& address) { readSync(address, options); },
            "Receivers show all universes of a frame at once. Art-Net: by ArtSync; sACN: by this address, "
            "1..63999")
        ->type_name("[ADDRESS]")
        ->expected(0, 1);
    command.add_flag("--preview", options.isPreview, "sACN: mark as preview data, not meant for live output");
}

}  // namespace

void addSendCommand(CLI::App& program, Command& chosen) {
    auto options = std::make_shared<SendOptions>();
    CLI::App* command = program.add_subcommand("send", "Send synthetic DMX over Art-Net or sACN.");
    beginHelpWith(*command,
                  "  hazer send --universe 1 --pattern chase     a chase to this machine until Ctrl-C\n"
                  "  hazer send --slot 1=255 --slot 5=128        two slots by hand, sent steadily\n"
                  "  hazer send --pattern full --to 2.0.0.5 --seconds 10\n"
                  "  hazer send --universes 0-63 --sync          64 universes, shown at once\n"
                  "  hazer send --protocol sacn --universes 1-64 --priority 120 --interface eth0\n"
                  "  hazer replay night.pcap --to 2.0.0.5        is how a recording is sent\n");
    command
        ->add_option_function<std::string>(
            "FILE",
            [](const std::string& file) {
                throw CLI::ValidationError(fmt::format("to send a recording, write: hazer replay {}", file));
            })
        ->group("");  // not shown in --help
    addWhatOptions(*command, *options);
    addWhereOptions(*command, *options);
    addSourceOptions(*command, *options);
    command->callback([options, command, &chosen] {
        refuseSacnOptionsOfArtNet(*command, *options);
        checkSync(*options);
        universesOf(*options);  // so that a wrong list is wrong usage
        chosen = [options] { return runSend(*options); };
    });
}

}  // namespace hazer::app
