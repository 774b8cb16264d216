#include "app/universe_name.h"

#include <fmt/format.h>

namespace hazer::app {
namespace {

struct Names {
    std::string_view protocol;
    std::string_view universe;
};

Names namesOf(protocol::Transport transport) {
    switch (transport) {
        case protocol::Transport::kArtNet:
            return {"artnet", "Port-Address"};
        case protocol::Transport::kSacn:
            return {"sacn", "sACN universe"};
        case protocol::Transport::kDmx:
            return {"dmx", "DMX line"};
        case protocol::Transport::kAny:
            break;
    }
    return {"any", "universe"};
}

}  // namespace

std::string_view protocolName(protocol::Transport transport) {
    return namesOf(transport).protocol;
}

std::string describeUniverse(protocol::UniverseId universe) {
    return fmt::format("{} {}", namesOf(universe.transport).universe, universe.number);
}

}  // namespace hazer::app
