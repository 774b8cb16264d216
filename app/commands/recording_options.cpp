#include "app/commands/recording_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

#include "app/moment.h"

namespace hazer::app {

CLI::Option* addMomentOption(CLI::App& command, const std::string& name,
                             std::optional<std::chrono::nanoseconds>& moment,
                             const std::string& description) {
    const auto take = [&moment](const std::string& text) {
        const auto parsed = parseMoment(text);
        if (!parsed)
            throw CLI::ValidationError(fmt::format("'{}' is no time; write 80, 1:20 or 1:02:03.5", text));
        moment = *parsed;
    };
    return command.add_option_function<std::string>(name, take, description)->type_name("TIME");
}

void addFrameMapOptions(CLI::App& command, protocol::FrameMap& map, protocol::Transport otherwise,
                        bool mayBeDmx) {
    map.transport = otherwise;
    std::map<std::string, protocol::Transport> names{{"artnet", protocol::Transport::kArtNet},
                                                     {"sacn", protocol::Transport::kSacn}};
    if (mayBeDmx) names["dmx"] = protocol::Transport::kDmx;
    command
        .add_option_function<std::string>(
            "--as", [&map, names](const std::string& name) { map.transport = names.at(name); },
            fmt::format("What the universes of OLA shows and FSEQ become; {} unless given",
                        otherwise == protocol::Transport::kDmx ? "dmx" : "artnet"))
        ->check(CLI::IsMember(names));
    command
        .add_option(
            "--first-universe", map.firstUniverse,
            "What universe 1 of an OLA show, or the first channels of an FSEQ, is called; 1 unless given")
        ->check(CLI::Range(0, 65535));
    command
        .add_option("--slots-per-universe", map.slotsPerUniverse,
                    "Channels of an FSEQ that make a universe, 1..512; 512 unless given")
        ->check(CLI::Range(1, 512));
}

}  // namespace hazer::app
