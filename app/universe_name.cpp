#include "app/universe_name.h"

#include <fmt/format.h>

namespace hazer::app {
namespace {

struct Names {
    std::string_view protocol;
    std::string_view universe;
    std::string_view label;
};

Names namesOf(protocol::Transport transport) {
    switch (transport) {
        case protocol::Transport::kArtNet:
            return {"artnet", "Port-Address", "Art-Net"};
        case protocol::Transport::kSacn:
            return {"sacn", "sACN universe", "sACN"};
        case protocol::Transport::kDmx:
            return {"dmx", "DMX line", "DMX"};
        case protocol::Transport::kAny:
            break;
    }
    return {"any", "universe", "any"};
}

}  // namespace

std::string_view protocolName(protocol::Transport transport) {
    return namesOf(transport).protocol;
}

std::string describeUniverse(protocol::UniverseId universe) {
    return fmt::format("{} {}", namesOf(universe.transport).universe, universe.number);
}

std::string universeLabel(protocol::UniverseId universe) {
    const std::string label = fmt::format("{} {}", namesOf(universe.transport).label, universe.number);
    if (universe.transport != protocol::Transport::kArtNet) return label;
    // Desks show a Port-Address as Net, Sub-Net and Universe, or as one number.
    return fmt::format("{} ({}:{}:{})", label, universe.number >> 8, (universe.number >> 4) & 0x0F,
                       universe.number & 0x0F);
}

}  // namespace hazer::app
