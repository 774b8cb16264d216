// Which table of a gobo lies in which layers of the texture array. Pure bookkeeping: no OpenGL, no thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "render/gobo_table.h"

namespace hazer::render {

/// Bounds the memory of tables: 2.4 MB a layer.
inline constexpr int kMostGoboTableLayers = 48;

class GoboTableSlots {
 public:
    /// Never uses more layers than this.
    explicit GoboTableSlots(int mostLayers) : isTaken_(static_cast<std::size_t>(mostLayers)) {}

    /// What is used from here on is of a new frame.
    void beginFrame() { ++frame_; }

    /// The slot of a key that has one, which counts as used in this frame.
    std::optional<GoboTableSlot> use(const GoboTableKey& key);

    /// Gives a key a slot, for use in this frame: the first free layers, or those of the tables that have not
    /// been used for longest. None if all are in use in this frame.
    std::optional<GoboTableSlot> place(const GoboTableKey& key, int layers);

    /// The slot's layers hold the table. Empty if the key has lost its slot meanwhile.
    std::optional<GoboTableSlot> fill(const GoboTableKey& key);

    /// The slot of a key if its layers hold the table.
    std::optional<GoboTableSlot> filled(const GoboTableKey& key) const;

    /// One more than the highest layer that was ever given away.
    int layersInUse() const { return layersInUse_; }

 private:
    struct Entry {
        GoboTableSlot slot;
        std::uint64_t lastFrame = 0;
        bool isFilled = false;
    };
    std::optional<int> freeLayers(int count) const;
    bool dropOldest();

    std::vector<bool> isTaken_;  ///< Layers that belong to a key.
    std::map<GoboTableKey, Entry> entries_;
    std::uint64_t frame_ = 0;
    int layersInUse_ = 0;
};

}  // namespace hazer::render
