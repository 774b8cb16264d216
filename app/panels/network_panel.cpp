#include "app/panels/network_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/monitor.h"
#include "app/universe_name.h"

namespace hazer::app {
namespace {

constexpr int kColumns = 32;
constexpr int kRows = static_cast<int>(protocol::kSlotCount) / kColumns;

void drawCounter(const char* name, std::uint64_t count, const char* meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", meaning);
    ImGui::TableNextColumn();
    ImGui::Text("%llu", static_cast<unsigned long long>(count));
}

void drawCounters(const protocol::ReceiverCounters& counters) {
    if (!ImGui::BeginTable("counters", 2, ImGuiTableFlags_SizingStretchSame)) return;
    drawCounter("DMX packets", counters.dmx, "ArtDmx that was taken");
    drawCounter("late", counters.late, "ArtDmx that came after a newer one");
    drawCounter("refused", counters.refused,
                "ArtDmx of a third source of a universe, or of too many universes");
    drawCounter("syncs", counters.syncs, "ArtSync that was obeyed");
    drawCounter("lost here", counters.droppedBySystem, "Came faster than this machine took them");
    drawCounter("polls", counters.polls, "ArtPoll that was answered");
    drawCounter("ignored", counters.ignored, "Art-Net that asks nothing of a visualizer");
    drawCounter("malformed", counters.malformed, "Not Art-Net, or broken");
    ImGui::EndTable();
}

std::string describe(const protocol::UniverseStatus& status) {
    const std::string name = universeLabel(status.universe);
    double packetsPerS = 0.0;
    for (const protocol::SourceStatus& source : status.sources) packetsPerS += source.packetsPerS;
    const char* const state = status.isLost            ? "lost, held"
                              : status.isMerging       ? "merging"
                              : status.sources.empty() ? "waiting"
                                                       : "live";
    return fmt::format("{}   {}   {:.0f}/s   {} slots###{}", name, state, packetsPerS, status.look.slotCount,
                       name);
}

void drawSource(const protocol::SourceStatus& source) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(source.name.empty() ? "(no name)" : source.name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(source.address.c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%d%s", int{source.priority}, source.hasSlotPriorities ? "+" : "");
    if (source.hasSlotPriorities && ImGui::IsItemHovered())
        ImGui::SetTooltip("slots have priorities of their own");
    ImGui::TableNextColumn();
    ImGui::Text("%.0f/s", source.packetsPerS);
    ImGui::TableNextColumn();
    ImGui::Text("%llu", static_cast<unsigned long long>(source.lossCount));
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(!source.isAlive ? "gone" : source.isWinning ? "wins" : "");
}

void drawSources(const protocol::UniverseStatus& status) {
    if (status.sources.empty()) return;
    if (!ImGui::BeginTable("sources", 6, ImGuiTableFlags_SizingFixedFit)) return;
    for (const char* const column : {"source", "address", "priority", "rate", "losses", ""}) {
        ImGui::TableSetupColumn(column);
    }
    ImGui::TableHeadersRow();
    for (const protocol::SourceStatus& source : status.sources) drawSource(source);
    ImGui::EndTable();
    if (status.refusedSources > 0) {
        ImGui::TextDisabled("%llu packets of further sources refused",
                            static_cast<unsigned long long>(status.refusedSources));
    }
}

void drawShowControl(const protocol::ArtNetStatus& artNet) {
    if (artNet.timeCode) ImGui::TextDisabled("time code %s", timeCodeText(artNet.timeCode->code).c_str());
    if (artNet.trigger) ImGui::TextDisabled("trigger %s", triggerText(*artNet.trigger).c_str());
}

/// Who announces itself, and what is out of order.
void drawSacn(const protocol::SacnReport& report) {
    for (const protocol::SacnDiscoveredSource& source : report.discovered) {
        ImGui::TextDisabled("%s at %s announces %d sACN universes", source.name.c_str(),
                            source.address.c_str(), static_cast<int>(source.universes.size()));
    }
    for (const protocol::SacnSyncStatus& sync : report.syncs) {
        if (sync.isLost)
            ImGui::Text("synchronization address %d of sACN is lost", static_cast<int>(sync.address));
    }
    for (const std::uint16_t universe : report.universesOfWrongGroups) {
        ImGui::Text("sACN universe %d comes by the multicast group of another", static_cast<int>(universe));
    }
}

/// Tells the slot under the mouse.
void describeHovered(const protocol::Slots& slots, const ImVec2& corner, const ImVec2& cell) {
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 mouse = ImGui::GetMousePos();
    const int column = std::clamp(static_cast<int>((mouse.x - corner.x) / cell.x), 0, kColumns - 1);
    const int row = std::clamp(static_cast<int>((mouse.y - corner.y) / cell.y), 0, kRows - 1);
    const int index = row * kColumns + column;
    ImGui::SetTooltip("slot %d: %d", index + 1, static_cast<int>(slots[static_cast<std::size_t>(index)]));
}

/// The 512 slots as a grid from dark (0) to light (255), slot 1 in the left upper corner.
void drawSlots(const protocol::Slots& slots) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float edge = ImGui::GetContentRegionAvail().x / static_cast<float>(kColumns);
    const ImVec2 cell(edge, edge);
    constexpr float kGap = 1.0f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int index = 0; index < kColumns * kRows; ++index) {
        const int value = slots[static_cast<std::size_t>(index)];
        constexpr int kDarkest = 40;
        const int grey = kDarkest + value * (255 - kDarkest) / 255;
        const ImVec2 low(corner.x + static_cast<float>(index % kColumns) * cell.x,
                         corner.y + static_cast<float>(index / kColumns) * cell.y);
        list.AddRectFilled(low, {low.x + cell.x - kGap, low.y + cell.y - kGap},
                           IM_COL32(grey, grey, grey, 255));
    }
    ImGui::InvisibleButton("slots", {cell.x * kColumns, cell.y * kRows});
    describeHovered(slots, corner, cell);
}

}  // namespace

void drawNetwork(Session& session) {
    const std::string listening = session.inputs().description();
    ImGui::TextDisabled("%s", listening.empty() ? "nothing listens" : listening.c_str());
    for (const protocol::SacnReport& report : session.inputs().sacn()) drawSacn(report);
    if (session.port() != 0) {
        const protocol::ArtNetStatus artNet = session.inputs().artNet();
        drawShowControl(artNet);
        drawCounters(artNet.counters);
    }
    for (const protocol::UniverseStatus& status : session.inputs().status(protocol::Clock::now())) {
        if (!ImGui::TreeNodeEx(describe(status).c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen)) continue;
        ImGui::PushID(static_cast<int>(status.universe.transport));
        ImGui::PushID(status.universe.number);
        drawSources(status);
        drawSlots(status.look.slots);
        ImGui::PopID();
        ImGui::PopID();
    }
}

}  // namespace hazer::app
