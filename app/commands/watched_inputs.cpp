#include "app/commands/watched_inputs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "app/commands/port_options.h"
#include "app/number_list.h"
#include "protocol/sacn.h"

namespace hazer::app {
namespace {

std::optional<std::vector<std::uint16_t>> parseUniverses(const std::string& text) {
    return parseNumberList(text, 1, protocol::kMaxSacnUniverse);
}

std::string checkUniverses(const std::string& text) {
    if (parseUniverses(text)) return {};
    return fmt::format("'{}' is no list such as 1-64,70 of sACN universes 1..{}", text,
                       protocol::kMaxSacnUniverse);
}

}  // namespace

void addWatchedInputs(CLI::App& command, WatchedInputs& watched) {
    command.add_option("SHOW", watched.show,
                       "The show whose inputs are heard; Art-Net, sACN and USB, all there is, unless given");
    command
        .add_option("--universe,--universes", watched.sacnUniverses,
                    "sACN universes to join the multicast groups of, such as 1-64,70; may be repeated")
        ->check(checkUniverses);
    addPortOptions(command, watched.ports);
}

Show showToWatch(const WatchedInputs& watched) {
    Show show = watched.show.empty() ? Show{} : loadShow(watched.show);
    if (show.inputs.empty()) show.inputs = everyInput();
    const bool hearsSacn = std::ranges::find(show.inputs, protocol::Transport::kSacn,
                                             &ShowInput::transport) != show.inputs.end();
    if (!watched.sacnUniverses.empty() && !hearsSacn)
        show.inputs.push_back(inputOf(protocol::Transport::kSacn));
    return show;
}

ListenOptions listenOptionsOf(const WatchedInputs& watched) {
    ListenOptions options;
    options.ports = watched.ports;
    options.joinsAnnounced = watched.show.empty();
    for (const std::string& text : watched.sacnUniverses) {
        std::ranges::copy(*parseUniverses(text), std::back_inserter(options.sacnUniverses));
    }
    return options;
}

}  // namespace hazer::app
