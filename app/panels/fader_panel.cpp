#include "app/panels/fader_panel.h"

#include <imgui.h>

#include <array>
#include <optional>

#include "app/panels/fader_row.h"
#include "app/panels/wheel_row.h"
#include "app/window_faders.h"

namespace hazer::app {
namespace {

/// Red, green and blue as the three faders of a mixer make them.
std::array<float, 3> mixedColor(const ColorMixer& mixer, const fixtures::Fixture& fixture) {
    std::array<float, 3> color{};
    const std::array attributes{mixer.red, mixer.green, mixer.blue};
    for (std::size_t i = 0; i < color.size(); ++i) {
        const double value = fixture.value(attributes[i]).value_or(0.0);
        color[i] = static_cast<float>(mixerValue(mixer.mixing, value));
    }
    return color;
}

void holdColor(const ColorMixer& mixer, const std::array<float, 3>& color, fixtures::Fixture& fixture,
               HeldFaders& held) {
    const std::array attributes{mixer.red, mixer.green, mixer.blue};
    for (std::size_t i = 0; i < color.size(); ++i) {
        const double value = mixerValue(mixer.mixing, static_cast<double>(color[i]));
        held.hold(fixture, std::string(attributes[i]), value);
    }
}

/// One field that moves three faders.
void drawColorMixer(fixtures::Fixture& fixture, HeldFaders& held) {
    const ColorMixer mixer = colorMixerOf(fixture);
    if (mixer.mixing == ColorMixing::kNone) return;
    std::array<float, 3> color = mixedColor(mixer, fixture);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::ColorEdit3("##mixed colour", color.data(), ImGuiColorEditFlags_PickerHueWheel)) {
        holdColor(mixer, color, fixture, held);
    }
}

void drawFader(const Fader& fader, fixtures::Fixture& fixture, WindowState& state,
               WindowThumbnails& thumbnails) {
    if (!fader.names.empty()) {
        drawNameRow(fader, fixture, state.held);
    } else if (fader.wheel == nullptr) {
        drawSliderRow(fader, fixture, state.held);
    } else if (fader.group == FaderGroup::kGobo) {
        drawGoboWheelRow(fader, fixture, state.held, thumbnails, state.lastGobos);
    } else {
        drawColorWheelRow(fader, fixture, state.held, thumbnails);
    }
}

void drawGroup(FaderGroup group, const std::vector<Fader>& faders, fixtures::Fixture& fixture,
               WindowState& state, WindowThumbnails& thumbnails) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", groupName(group).data());
    if (group == FaderGroup::kColor) drawColorMixer(fixture, state.held);
    drawFaderTable(groupName(group).data(), [&] {
        for (const Fader& fader : faders) {
            if (fader.group == group) drawFader(fader, fixture, state, thumbnails);
        }
    });
}

}  // namespace

void drawFaderPanel(fixtures::Fixture& fixture, WindowState& state, WindowThumbnails& thumbnails) {
    const std::vector<Fader> faders = fadersOf(fixture);
    std::optional<FaderGroup> last;
    ImGui::PushID(fixture.name().c_str());
    for (const Fader& fader : faders) {
        if (fader.group != last) drawGroup(fader.group, faders, fixture, state, thumbnails);
        last = fader.group;
    }
    ImGui::PopID();
}

}  // namespace hazer::app
