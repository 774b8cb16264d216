#include "render/gobo_store.h"

#include <algorithm>
#include <utility>

#include "render/aperture_plan.h"
#include "render/gl/inventory.h"

namespace hazer::render {
namespace {

/// Every level comes from the picture itself, so that the GPU and the CPU look at the same texels.
void uploadLevel(const std::vector<std::shared_ptr<const GoboPicture>>& pictures, int furtherLayers,
                 int level) {
    const int size = kGoboSize >> level;
    const GLsizei layers = static_cast<GLsizei>(pictures.size()) + furtherLayers;
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_RGBA8, size, size, layers, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, static_cast<GLint>(i), size, size, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, pictures[i]->levels[static_cast<std::size_t>(level)].data());
    }
}

}  // namespace

GoboId GoboStore::add(const std::uint8_t* rgba, int width, int height) {
    pictures_.push_back(std::make_shared<const GoboPicture>(makeGoboPicture(rgba, width, height)));
    return static_cast<GoboId>(pictures_.size()) - 1;
}

GLuint GoboStore::texture(int composed) {
    if (uploaded_ == pictures_.size() && composed <= roomForComposed_) return texture_.id();
    if (composed > roomForComposed_)
        roomForComposed_ = std::min(std::max(composed, 2 * roomForComposed_), kMostComposedApertures);
    ++textureGeneration_;
    texture_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
    for (int level = 0; level < kGoboLevels; ++level) uploadLevel(pictures_, roomForComposed_, level);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kGoboLevels - 1);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    // The border is dark, as the holder is: the edge of a blurred level is not.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    uploaded_ = pictures_.size();
    return texture_.id();
}

void GoboStore::request(const GoboTableKey& key) {
    if (key.gobo < 0 || slots_.use(key)) return;
    const std::shared_ptr<const GoboPicture>& picture = pictures_[static_cast<std::size_t>(key.gobo)];
    if (slots_.place(key, picture->grey ? 1 : 3)) queue_.request(key, picture);
}

std::vector<GoboTableSlot> GoboStore::tables(std::span<const GoboTableKey> keys, bool waits) {
    slots_.beginFrame();
    for (const GoboTableKey& key : keys) request(key);
    if (waits) queue_.wait();
    upload(queue_.take());
    std::vector<GoboTableSlot> result;
    result.reserve(keys.size());
    for (const GoboTableKey& key : keys) result.push_back(slots_.filled(key).value_or(GoboTableSlot{}));
    return result;
}

void GoboStore::upload(const std::vector<GoboTableQueue::Finished>& finished) {
    for (const auto& [key, table] : finished) {
        const std::optional<GoboTableSlot> slot = slots_.fill(key);
        if (!slot) continue;
        growTables();
        glBindTexture(GL_TEXTURE_2D_ARRAY, tables_.id());
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, slot->firstLayer, kGoboTableWidth, kGoboTableHeight,
                        slot->layers, GL_RGBA, GL_HALF_FLOAT, table.halves.data());
    }
}

void GoboStore::growTables() {
    if (slots_.layersInUse() <= tableLayers_) return;
    const int before = tableLayers_;
    tableLayers_ = std::min(std::max(slots_.layersInUse(), 2 * before), mostTableLayers_);
    const gl::Texture old = std::exchange(tables_, gl::makeTexture());
    glBindTexture(GL_TEXTURE_2D_ARRAY, tables_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, kGoboTableWidth, kGoboTableHeight, tableLayers_, 0,
                 GL_RGBA, GL_HALF_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    if (before == 0) return;
    // OpenGL 4.1 has no copy from texture to texture.
    std::vector<std::uint16_t> halves(static_cast<std::size_t>(before) * kGoboTableLayerHalves);
    glBindTexture(GL_TEXTURE_2D_ARRAY, old.id());
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_HALF_FLOAT, halves.data());
    glBindTexture(GL_TEXTURE_2D_ARRAY, tables_.id());
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, kGoboTableWidth, kGoboTableHeight, before, GL_RGBA,
                    GL_HALF_FLOAT, halves.data());
}

void GoboStore::list(Resources& resources) const {
    gl::listTexture(resources, "gobos", GL_TEXTURE_2D_ARRAY, texture_);
    gl::listTexture(resources, "gobo tables", GL_TEXTURE_2D_ARRAY, tables_);
}

}  // namespace hazer::render
