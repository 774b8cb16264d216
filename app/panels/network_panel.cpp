#include "app/panels/network_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

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
    drawCounter("polls", counters.polls, "ArtPoll that was answered");
    drawCounter("ignored", counters.ignored, "Art-Net that asks nothing of a visualizer");
    drawCounter("malformed", counters.malformed, "Not Art-Net, or broken");
    ImGui::EndTable();
}

const char* transportName(protocol::Transport transport) {
    switch (transport) {
        case protocol::Transport::kArtNet:
            return "Art-Net";
        case protocol::Transport::kSacn:
            return "sACN";
        case protocol::Transport::kDmx:
            return "DMX";
        case protocol::Transport::kAny:
            return "any";
    }
    return "";
}

std::string describe(protocol::UniverseId id, const protocol::Universe& universe,
                     const WindowPacketRates& rates) {
    constexpr double kSilentS = 2.0;
    const double ageS = std::chrono::duration<double>(protocol::Clock::now() - universe.lastReceived).count();
    const std::string now = ageS > kSilentS ? fmt::format("silent for {:.0f} s", ageS)
                                            : fmt::format("{:.0f}/s", rates.packetsPerS(id));
    return fmt::format("{} {}   {}   {} slots###{} {}", transportName(id.transport), id.number, now,
                       universe.slotCount, transportName(id.transport), id.number);
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

void drawNetwork(const Session& session, const WindowPacketRates& rates) {
    if (session.port() == 0) {
        ImGui::TextDisabled("nothing listens");
        return;
    }
    ImGui::TextDisabled("listening on UDP port %d", static_cast<int>(session.port()));
    drawCounters(session.counters());
    for (const auto& [id, universe] : session.universes()) {
        if (!ImGui::TreeNodeEx(describe(id, universe, rates).c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen))
            continue;
        ImGui::PushID(static_cast<int>(id.transport));
        ImGui::PushID(id.number);
        drawSlots(universe.slots);
        ImGui::PopID();
        ImGui::PopID();
    }
}

}  // namespace hazer::app
