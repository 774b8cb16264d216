// Gobos on the GPU: their pictures, and the tables of those that light the haze.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/gl/handle.h"
#include "render/gobo_picture.h"
#include "render/gobo_table_queue.h"
#include "render/gobo_table_slots.h"
#include "render/resources.h"
#include "render/scene.h"

namespace hazer::render {

class GoboStore {
 public:
    /// Tables never take more layers than this.
    explicit GoboStore(int mostTableLayers = kMostGoboTableLayers)
        : mostTableLayers_(mostTableLayers), slots_(mostTableLayers) {}

    /// See Renderer::addGobo.
    GoboId add(const std::uint8_t* rgba, int width, int height);

    /// What a gobo lets through: the sharp level of its picture.
    const std::vector<std::uint8_t>& texels(GoboId gobo) const {
        return pictures_[static_cast<std::size_t>(gobo)]->levels[0];
    }

    /// A GL_TEXTURE_2D_ARRAY with mip levels, a gobo a layer, with room for `composed` further pictures
    /// behind them; 0 while there is neither. Room stays once there was a need for it.
    GLuint texture(int composed = 0);

    /// Where composed pictures lie in the texture, and how many may.
    int firstComposedLayer() const { return static_cast<int>(pictures_.size()); }
    int roomForComposed() const { return roomForComposed_; }

    /// Another number when the texture is another one: then composed pictures are lost.
    int textureGeneration() const { return textureGeneration_; }

    /// Where the tables that a frame wants lie, one slot a key. Those that do not exist yet are built in the
    /// background: their slots are empty until a later call, or, if `waits`, the call takes until they exist.
    /// Slots are also empty where a frame wants more layers than there may be.
    std::vector<GoboTableSlot> tables(std::span<const GoboTableKey> keys, bool waits);

    /// A GL_TEXTURE_2D_ARRAY of tables; 0 before there are any.
    GLuint tableTexture() const { return tables_.id(); }

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    void request(const GoboTableKey& key);
    void upload(const std::vector<GoboTableQueue::Finished>& finished);
    void growTables();

    std::vector<std::shared_ptr<const GoboPicture>> pictures_;
    gl::Texture texture_;
    std::size_t uploaded_ = 0;
    int roomForComposed_ = 0;
    int textureGeneration_ = 0;
    int mostTableLayers_;
    GoboTableSlots slots_;
    gl::Texture tables_;
    int tableLayers_ = 0;  ///< That tables_ has room for.
    GoboTableQueue queue_;
};

}  // namespace hazer::render
