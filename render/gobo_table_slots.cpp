#include "render/gobo_table_slots.h"

#include <algorithm>

namespace hazer::render {

std::optional<GoboTableSlot> GoboTableSlots::use(const GoboTableKey& key) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    found->second.lastFrame = frame_;
    return found->second.slot;
}

std::optional<int> GoboTableSlots::freeLayers(int count) const {
    const auto found = std::search_n(isTaken_.begin(), isTaken_.end(), count, false);
    if (found == isTaken_.end()) return std::nullopt;
    return static_cast<int>(found - isTaken_.begin());
}

bool GoboTableSlots::dropOldest() {
    const auto oldest = std::min_element(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) {
        return a.second.lastFrame < b.second.lastFrame;
    });
    if (oldest == entries_.end() || oldest->second.lastFrame == frame_) return false;
    const GoboTableSlot slot = oldest->second.slot;
    std::fill_n(isTaken_.begin() + slot.firstLayer, slot.layers, false);
    entries_.erase(oldest);
    return true;
}

std::optional<GoboTableSlot> GoboTableSlots::place(const GoboTableKey& key, int layers) {
    std::optional<int> first = freeLayers(layers);
    while (!first && dropOldest()) first = freeLayers(layers);
    if (!first) return std::nullopt;
    std::fill_n(isTaken_.begin() + *first, layers, true);
    layersInUse_ = std::max(layersInUse_, *first + layers);
    const GoboTableSlot slot{*first, layers};
    entries_[key] = {slot, frame_, false};
    return slot;
}

std::optional<GoboTableSlot> GoboTableSlots::fill(const GoboTableKey& key) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    found->second.isFilled = true;
    return found->second.slot;
}

std::optional<GoboTableSlot> GoboTableSlots::filled(const GoboTableKey& key) const {
    const auto found = entries_.find(key);
    if (found == entries_.end() || !found->second.isFilled) return std::nullopt;
    return found->second.slot;
}

}  // namespace hazer::render
