#include "app/window_packet_rates.h"

namespace hazer::app {

void WindowPacketRates::update(const protocol::UniverseSet& universes, protocol::TimePoint now) {
    for (const auto& [id, universe] : universes) {
        const auto [entry, isNew] = watched_.try_emplace(id, Watched{now, universe.packetCount, 0.0});
        Watched& watched = entry->second;
        const double elapsedS = std::chrono::duration<double>(now - watched.since).count();
        if (isNew || elapsedS < 1.0) continue;
        const auto packets = static_cast<double>(universe.packetCount - watched.packetCount);
        watched = {now, universe.packetCount, packets / elapsedS};
    }
}

double WindowPacketRates::packetsPerS(protocol::UniverseId universe) const {
    const auto found = watched_.find(universe);
    return found == watched_.end() ? 0.0 : found->second.packetsPerS;
}

}  // namespace hazer::app
