#include "app/show_universes.h"

#include <set>

#include "protocol/artnet.h"
#include "protocol/sacn.h"

namespace hazer::app {
namespace {

bool hasNumber(protocol::Transport transport, std::uint16_t number) {
    if (transport == protocol::Transport::kArtNet) return number <= protocol::kMaxPortAddress;
    return number >= 1 && number <= protocol::kMaxSacnUniverse;
}

}  // namespace

std::vector<protocol::UniverseId> universesOf(const Show& show) {
    std::set<protocol::UniverseId> distinct;
    for (const ShowFixture& fixture : show.fixtures) {
        for (const ShowAddress& address : fixture.addresses)
            distinct.insert(address.universes.begin(), address.universes.end());
    }
    return {distinct.begin(), distinct.end()};
}

std::vector<std::uint16_t> numbersOn(protocol::Transport transport,
                                     std::span<const protocol::UniverseId> universes) {
    std::vector<std::uint16_t> numbers;
    for (const protocol::UniverseId universe : universes) {
        const bool isOurs =
            universe.transport == transport || universe.transport == protocol::Transport::kAny;
        if (isOurs && hasNumber(transport, universe.number)) numbers.push_back(universe.number);
    }
    return numbers;
}

}  // namespace hazer::app
