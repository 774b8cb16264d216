#include "app/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/number_list.h"
#include "app/universe_name.h"
#include "app/usb_text.h"

namespace hazer::app {
namespace {

using protocol::SourceStatus;
using protocol::UniverseStatus;

constexpr std::size_t kColumns = 100;
constexpr const char* kRow = "{:<22} {:<8} {:<18} {:<16} {:>5} {:>4} {:>7} {:>6} {:>5}\n";

// At most `columns` characters of a text in UTF-8, which is not cut inside one.
std::string cutTo(const std::string& text, std::size_t columns) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool beginsCharacter = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
        if (beginsCharacter && count++ == columns) return text.substr(0, i);
    }
    return text;
}

const char* stateOf(const UniverseStatus& universe) {
    if (universe.isLost) return "lost";
    if (universe.sources.empty()) return "waiting";
    return universe.isMerging ? "merging" : "live";
}

std::string winnerMark(const SourceStatus& source) {
    if (!source.isAlive) return "gone";
    return source.isWinning ? "wins" : "";
}

std::string priorityText(const SourceStatus& source) {
    return fmt::format("{}{}", source.priority, source.hasSlotPriorities ? "+" : "");
}

std::string sourceRow(const std::string& universe, const char* state, const SourceStatus& source) {
    return fmt::format(kRow, universe, state, cutTo(source.name, 18), cutTo(source.address, 16),
                       priorityText(source), winnerMark(source), fmt::format("{:.0f}/s", source.packetsPerS),
                       source.lateCount, source.lossCount);
}

std::string universeRows(const UniverseStatus& universe) {
    const std::string name = universeLabel(universe.universe);
    if (universe.sources.empty())
        return fmt::format(kRow, name, stateOf(universe), "", "", "", "", "", "", "");
    std::string rows;
    for (const SourceStatus& source : universe.sources) {
        rows += rows.empty() ? sourceRow(name, stateOf(universe), source) : sourceRow("", "", source);
    }
    if (universe.refusedSources > 0) {
        rows += fmt::format("{:<22} {} packets of further sources refused\n", "", universe.refusedSources);
    }
    return rows;
}

std::string slotRows(const UniverseStatus& universe) {
    constexpr std::size_t kPerRow = 16;
    std::string rows = fmt::format("\n{}\n", universeLabel(universe.universe));
    for (std::size_t i = 0; i < protocol::kSlotCount; i += kPerRow) {
        rows += fmt::format("{:>4} ", i + 1);
        for (std::size_t slot = i; slot < i + kPerRow; ++slot) {
            rows += fmt::format(" {:>3}", universe.look.slots[slot]);
        }
        rows += '\n';
    }
    return rows;
}

std::string sacnRows(const protocol::SacnReport& report) {
    const protocol::SacnCounters& counters = report.counters;
    std::string rows = fmt::format(
        "sACN: {} levels, {} late, {} refused, {} syncs, {} ignored, {} malformed\n", counters.levels,
        counters.late, counters.tooMany, counters.syncs, counters.ignored, counters.malformed);
    for (const protocol::SacnDiscoveredSource& source : report.discovered) {
        rows += cutTo(fmt::format("{} at {} announces sACN {}", cutTo(source.name, 30),
                                  cutTo(source.address, 30), numberListText(source.universes)),
                      kColumns) +
                "\n";
    }
    return rows;
}

nlohmann::ordered_json sacnJson(const protocol::SacnReport& report) {
    const protocol::SacnCounters& counters = report.counters;
    nlohmann::ordered_json json{{"levels", counters.levels},
                                {"late", counters.late},
                                {"refused", counters.tooMany},
                                {"malformed", counters.malformed}};
    json["announced"] = nlohmann::ordered_json::array();
    for (const protocol::SacnDiscoveredSource& source : report.discovered) {
        json["announced"].push_back(
            {{"name", source.name}, {"address", source.address}, {"universes", source.universes}});
    }
    return json;
}

bool wantsSlots(const MonitorView& view, protocol::UniverseId universe) {
    return std::ranges::find(view.showSlots, universe) != view.showSlots.end();
}

nlohmann::ordered_json sourceJson(const SourceStatus& source) {
    return {{"name", source.name},
            {"address", source.address},
            {"priority", source.priority},
            {"slot_priorities", source.hasSlotPriorities},
            {"alive", source.isAlive},
            {"winning", source.isWinning},
            {"preview", source.isPreview},
            {"synchronized", source.isSynchronized},
            {"packets_per_s", source.packetsPerS},
            {"packets", source.packetCount},
            {"late", source.lateCount},
            {"losses", source.lossCount}};
}

nlohmann::ordered_json universeJson(const UniverseStatus& universe, bool withSlots) {
    nlohmann::ordered_json json{{"protocol", protocolName(universe.universe.transport)},
                                {"universe", universe.universe.number},
                                {"asked", universe.isAskedFor},
                                {"lost", universe.isLost},
                                {"merging", universe.isMerging},
                                {"packets", universe.packetCount},
                                {"refused_sources", universe.refusedSources}};
    json["sources"] = nlohmann::ordered_json::array();
    for (const SourceStatus& source : universe.sources) json["sources"].push_back(sourceJson(source));
    if (withSlots) json["slots"] = universe.look.slots;
    return json;
}

}  // namespace

std::string timeCodeText(const protocol::ArtTimeCode& code) {
    constexpr const char* kRates[] = {"24", "25", "29.97 drop", "30"};
    return fmt::format("{:02}:{:02}:{:02}:{:02} at {} fps", code.hours, code.minutes, code.seconds,
                       code.frames, kRates[static_cast<std::size_t>(code.type)]);
}

std::string triggerText(const protocol::ReceivedTrigger& trigger) {
    constexpr const char* kKeys[] = {"key", "macro", "soft key", "show"};
    if (trigger.key >= std::size(kKeys)) return fmt::format("{} {}", trigger.key, trigger.subKey);
    const bool isPrintable = trigger.key == 0 && trigger.subKey > ' ' && trigger.subKey < 0x7F;
    if (isPrintable) return fmt::format("key '{}'", static_cast<char>(trigger.subKey));
    return fmt::format("{} {}", kKeys[trigger.key], trigger.subKey);
}

std::string monitorTable(const MonitorView& view) {
    std::string table =
        fmt::format(kRow, "universe", "state", "source", "address", "prio", "", "rate", "late", "lost");
    for (const UniverseStatus& universe : view.universes) table += universeRows(universe);
    const protocol::ReceiverCounters& counters = view.artNet.counters;
    table += fmt::format(
        "\nArt-Net: {} DMX, {} late, {} refused, {} polls, {} syncs, {} ignored, {} malformed, {} lost "
        "here\n",
        counters.dmx, counters.late, counters.refused, counters.polls, counters.syncs, counters.ignored,
        counters.malformed, counters.droppedBySystem);
    if (view.artNet.timeCode)
        table += fmt::format("time code {}\n", timeCodeText(view.artNet.timeCode->code));
    if (view.artNet.trigger) table += fmt::format("trigger {}\n", triggerText(*view.artNet.trigger));
    for (const protocol::SacnReport& report : view.sacn) table += sacnRows(report);
    for (const protocol::UsbLineStatus& line : view.usbDevices) table += usbLineText(line) + "\n";
    for (const UniverseStatus& universe : view.universes) {
        if (wantsSlots(view, universe.universe)) table += slotRows(universe);
    }
    return table;
}

nlohmann::ordered_json monitorJson(const MonitorView& view) {
    const protocol::ReceiverCounters& counters = view.artNet.counters;
    nlohmann::ordered_json json{{"time_s", view.timeS},
                                {"packets", counters.dmx},
                                {"late", counters.late},
                                {"refused", counters.refused},
                                {"polls", counters.polls},
                                {"syncs", counters.syncs},
                                {"ignored", counters.ignored},
                                {"malformed", counters.malformed},
                                {"dropped_by_system", counters.droppedBySystem},
                                {"timecode", nullptr},
                                {"trigger", nullptr}};
    if (view.artNet.timeCode) {
        const protocol::ReceivedTimeCode& received = *view.artNet.timeCode;
        json["timecode"] = {{"text", timeCodeText(received.code)},
                            {"seconds", received.code.timeS()},
                            {"age_s", std::chrono::duration<double>(view.now - received.time).count()}};
    }
    if (view.artNet.trigger) {
        json["trigger"] = {{"key", view.artNet.trigger->key}, {"sub_key", view.artNet.trigger->subKey}};
    }
    json["universes"] = nlohmann::ordered_json::array();
    for (const UniverseStatus& universe : view.universes) {
        json["universes"].push_back(universeJson(universe, wantsSlots(view, universe.universe)));
    }
    json["sacn"] = nlohmann::ordered_json::array();
    for (const protocol::SacnReport& report : view.sacn) json["sacn"].push_back(sacnJson(report));
    json["usb"] = nlohmann::ordered_json::array();
    for (const protocol::UsbLineStatus& line : view.usbDevices) json["usb"].push_back(usbLineJson(line));
    return json;
}

}  // namespace hazer::app
