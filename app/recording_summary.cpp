#include "app/recording_summary.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/universe_name.h"

namespace hazer::app {
namespace {

using nlohmann::ordered_json;

/// Art-Net names its sources by their address alone.
std::string addressOf(const protocol::SourceStatus& source) {
    if (!source.address.empty() || source.id.transport != protocol::Transport::kArtNet) return source.address;
    const auto& id = source.id.id;
    return fmt::format("{}.{}.{}.{}", id[0], id[1], id[2], id[3]);
}

ordered_json describeStatus(const protocol::UniverseStatus& universe) {
    ordered_json sources = ordered_json::array();
    for (const protocol::SourceStatus& source : universe.sources) {
        sources.push_back(
            {{"name", source.name}, {"address", addressOf(source)}, {"priority", source.priority}});
    }
    return {{"protocol", protocolName(universe.universe.transport)},
            {"universe", universe.universe.number},
            {"packets", universe.packetCount},
            {"sources", sources},
            {"slots", universe.look.slots}};
}

std::string summarizeSource(const protocol::SourceStatus& source) {
    return fmt::format("    {}{}{}, priority {}, {} packets{}{}\n", source.name,
                       source.name.empty() ? "" : " at ", addressOf(source), source.priority,
                       source.packetCount,
                       source.lateCount > 0 ? fmt::format(", {} late", source.lateCount) : "",
                       source.isAlive ? "" : ", silent");
}

}  // namespace

nlohmann::ordered_json describeRecording(protocol::RecordingPlayer& player, double durationS) {
    ordered_json universes = ordered_json::array();
    for (const protocol::UniverseStatus& universe : player.status()) {
        universes.push_back(describeStatus(universe));
    }
    return {{"duration_s", durationS},
            {"packets", player.packetCount()},
            {"refused", player.refusedCount()},
            {"universes", universes}};
}

std::string summarizeRecording(protocol::RecordingPlayer& player, double durationS) {
    std::string text =
        fmt::format("{:.3f} s; {} packets, {} refused by {:.3f} s\n", durationS, player.packetCount(),
                    player.refusedCount(), std::chrono::duration<double>(player.time()).count());
    for (const protocol::UniverseStatus& universe : player.status()) {
        text += fmt::format("  {} {}: {} packets, {} slots\n", protocolName(universe.universe.transport),
                            universe.universe.number, universe.packetCount, universe.look.slotCount);
        for (const protocol::SourceStatus& source : universe.sources) text += summarizeSource(source);
    }
    return text;
}

}  // namespace hazer::app
