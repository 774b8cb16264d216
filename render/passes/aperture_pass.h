// Composes what stands in a beam's way to one picture, which light then passes like a gobo.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/aperture_plan.h"
#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/gobo_store.h"
#include "render/resources.h"

namespace hazer::render {

class AperturePass {
 public:
    explicit AperturePass(std::filesystem::path shaderFolder);

    /// Draws those pictures that did not exist in an earlier frame, with their mip levels, among the gobos.
    /// The layer of each comes back. Leaves another framebuffer and viewport bound.
    std::vector<int> draw(std::span<const ComposedAperture> apertures, GoboStore& gobos);

    void list(Resources& resources) const;

 private:
    const gl::Program& variant(const std::vector<std::string>& features);
    std::vector<int> placesOf(std::span<const ComposedAperture> apertures);
    void compose(const ComposedAperture& aperture, GLuint goboTexture);
    void copyTo(GLuint goboTexture, int layer) const;

    std::filesystem::path shaderFolder_;
    std::map<std::vector<std::string>, gl::Program> variants_;  ///< By features.
    gl::VertexArray noVertices_;
    gl::Texture picture_;
    std::vector<gl::Framebuffer> levels_;                ///< Of picture_.
    std::vector<std::optional<ComposedAperture>> held_;  ///< What the layers after the gobos show.
    int textureGeneration_ = 0;                          ///< Of the store's texture that they lie in.
};

}  // namespace hazer::render
