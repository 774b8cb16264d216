#include "app/window_held_faders.h"

#include <optional>

namespace hazer::app {

HeldFaders::HeldFaders(const Show& show) {
    for (const ShowFixture& fixture : show.fixtures) {
        for (const auto& [attribute, value] : fixture.held) byShow_[{fixture.name, attribute}] = value;
    }
}

void HeldFaders::hold(fixtures::Fixture& fixture, const std::string& attribute, double value) {
    if (fixture.hold(attribute, value)) byHand_.insert({fixture.name(), attribute});
}

void HeldFaders::release(fixtures::Fixture& fixture, const std::string& attribute) {
    const Key key{fixture.name(), attribute};
    if (byHand_.erase(key) == 0) return;
    const auto show = byShow_.find(key);
    fixture.hold(attribute, show == byShow_.end() ? std::nullopt : std::optional(show->second));
}

void HeldFaders::releaseAll(Patch& patch) {
    const std::set<Key> held = byHand_;
    for (const auto& [name, attribute] : held) {
        if (PatchedFixture* patched = patch.find(name)) release(patched->fixture, attribute);
    }
}

bool HeldFaders::isHeld(const fixtures::Fixture& fixture, const std::string& attribute) const {
    return byHand_.contains({fixture.name(), attribute});
}

bool HeldFaders::holdsAny(const fixtures::Fixture& fixture) const {
    const auto first = byHand_.lower_bound({fixture.name(), std::string()});
    return first != byHand_.end() && first->first == fixture.name();
}

}  // namespace hazer::app
