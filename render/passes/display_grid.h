// The picture by blocks of pixels: their light, what they show on the display, and which of them can be
// interpolated, left black, or need to be antialiased. So that the work for the display is done where it is
// seen.
#pragma once

#include <filesystem>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/passes/bloom_pass.h"
#include "render/resources.h"

namespace hazer::render {

/// Pixels along the edge of a block.
inline constexpr int kBlockPx = 4;

/// As many blocks as cover a picture.
glm::ivec2 displayBlocks(int width, int height);

class DisplayGrid {
 public:
    explicit DisplayGrid(const std::filesystem::path& shaderFolder);

    /// Sizes in pixels.
    void resize(int width, int height);

    /// Takes the means of `radiance`, a linearly filtered texture of the picture's size.
    void measure(GLuint radiance, float exposure);

    /// Decides what becomes of each block. `bloom` was drawn from means(), or is null.
    void judge(const BloomPass* bloom, float exposure);

    /// Draws what can be interpolated into colour 0 (alpha: brightness) and colour 1 (the same, opaque) of
    /// the bound framebuffer, whose depth is mask().
    void drawBetween();

    glm::ivec2 blocks() const { return blocks_; }
    glm::vec2 blocksPerPx() const { return 1.0f / glm::vec2(blocks_ * kBlockPx); }
    GLuint means() const { return means_.id(); }  ///< Radiance.
    GLuint bloom() const { return bloom_.id(); }  ///< Radiance.
    GLuint mask() const { return mask_.id(); }    ///< A depth texture of the picture's size.

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

    // What is drawn next into a framebuffer whose depth is mask() comes through where the blocks are such.
    static void onlyExact();  ///< Edges included.
    static void onlyEdges();
    static void everywhere();

 private:
    void allocateBloom();
    void show(const BloomPass* bloom, float exposure);
    void mark();

    gl::Program mean_, mark_, between_;
    gl::LazyProgram shown_, shownWithBloom_;
    gl::VertexArray noVertices_ = gl::makeVertexArray();
    gl::Texture means_, shownColors_, bloom_, marked_, mask_;
    gl::Framebuffer meansTarget_, shownTarget_, markedTarget_;
    glm::ivec2 size_{0}, blocks_{0};
};

}  // namespace hazer::render
