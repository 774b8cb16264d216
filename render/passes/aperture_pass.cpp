#include "render/passes/aperture_pass.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/gl/inventory.h"
#include "render/gl/texture.h"
#include "render/gobo_picture.h"

namespace hazer::render {
namespace {

/// SHAPES of shaders/aperture.frag.
int shapeNumber(ApertureShape shape) {
    return shape == ApertureShape::kRectangle ? 1 : shape == ApertureShape::kOval ? 2 : 0;
}

glm::vec3 packed(const ApertureEdge& edge) {
    return glm::vec3(glm::dvec3(edge.normal, edge.distance));
}

glm::vec2 turnOf(double rad) {
    return glm::vec2(glm::dvec2(std::cos(rad), std::sin(rad)));
}

std::string element(const char* array, std::size_t i) {
    return array + ("[" + std::to_string(i) + "]");
}

void setImages(const gl::Program& program, const std::vector<ApertureImage>& images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const ApertureImage& image = images[i];
        program.set(element("imageDisc", i).c_str(),
                    glm::vec4(glm::dvec4(image.center, image.radius, image.gobo)));
        program.set(element("imageTurn", i).c_str(), turnOf(image.rotationRad));
    }
}

/// What the longest axis of a circle becomes when the stretch is undone: 1 or more.
double widening(const glm::dmat2& stretch) {
    return 1.0 / std::max(std::abs(glm::determinant(stretch)), kNarrowestStretch);
}

void setEdges(const gl::Program& program, const Aperture& aperture) {
    std::size_t count = 0;
    for (const ApertureEdge& blade : aperture.blades) {
        if (blade.distance < 1.0) program.set(element("blades", count++).c_str(), packed(blade));
    }
    program.set("bladeCount", static_cast<int>(count));
    // An open iris has no edge that could be soft.
    program.set("irisRadius", aperture.irisRadius < 1.0 ? static_cast<float>(aperture.irisRadius) : 8.0f);
    program.set("shape", shapeNumber(aperture.shape));
    program.set("halfSize", glm::vec2(glm::max(aperture.halfSize, 1e-3)));
    program.set("shapeTurn", turnOf(aperture.shapeTurnRad));
    const glm::dmat2 unstretched = glm::inverse(aperture.stretch);
    program.set("unstretched", glm::vec4(glm::dvec4(unstretched[0], unstretched[1])));
    program.set("widening", static_cast<float>(widening(aperture.stretch)));
    program.set("softness", static_cast<float>(aperture.softness));
    program.set("split", packed(aperture.split));
    program.set("nearColor", aperture.color);
    program.set("farColor", aperture.beyondColor);
}

}  // namespace

AperturePass::AperturePass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& AperturePass::variant(std::size_t images) {
    const auto found = variants_.find(images);
    if (found != variants_.end()) return found->second;
    return variants_
        .try_emplace(images, shaderFolder_, "fullscreen.vert", "aperture.frag", apertureFeatures(images))
        .first->second;
}

std::vector<int> AperturePass::placesOf(std::span<const ComposedAperture> apertures) {
    std::vector<int> places(apertures.size(), -1);
    std::vector<bool> isTaken(held_.size(), false);
    for (std::size_t i = 0; i < apertures.size(); ++i) {
        const auto held = std::ranges::find(held_, std::optional(apertures[i]));
        if (held == held_.end()) continue;
        places[i] = static_cast<int>(held - held_.begin());
        isTaken[static_cast<std::size_t>(places[i])] = true;
    }
    std::size_t free = 0;
    for (int& place : places) {
        if (place >= 0) continue;
        while (isTaken[free]) ++free;
        isTaken[free] = true;
        held_[free].reset();
        place = static_cast<int>(free);
    }
    return places;
}

void AperturePass::compose(const ComposedAperture& aperture, GLuint goboTexture) {
    if (levels_.empty()) {
        noVertices_ = gl::makeVertexArray();
        picture_ = gl::makeTexture2d(GL_RGBA8, kGoboSize, kGoboSize, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, kGoboLevels - 1);
        glGenerateMipmap(GL_TEXTURE_2D);
        for (int level = 0; level < kGoboLevels; ++level) {
            levels_.push_back(gl::makeFramebuffer());
            glBindFramebuffer(GL_FRAMEBUFFER, levels_.back().id());
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.id(), level);
        }
    }
    const std::vector<ApertureImage> images = imagesOf(aperture);
    const gl::Program& program = variant(images.size());
    program.use();
    program.set("goboImages", 0);
    program.set("size", static_cast<float>(kGoboSize));
    setImages(program, images);
    setEdges(program, aperture.aperture);
    glBindFramebuffer(GL_FRAMEBUFFER, levels_.front().id());
    glViewport(0, 0, kGoboSize, kGoboSize);
    gl::bindTexture(0, GL_TEXTURE_2D_ARRAY, goboTexture);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::bindTexture(0, GL_TEXTURE_2D, picture_.id());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void AperturePass::copyTo(GLuint goboTexture, int layer) const {
    gl::bindTexture(0, GL_TEXTURE_2D_ARRAY, goboTexture);
    for (int level = 0; level < kGoboLevels; ++level) {
        const int size = kGoboSize >> level;
        glBindFramebuffer(GL_FRAMEBUFFER, levels_[static_cast<std::size_t>(level)].id());
        glCopyTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, layer, 0, 0, size, size);
    }
}

std::vector<int> AperturePass::draw(std::span<const ComposedAperture> apertures, GoboStore& gobos) {
    if (apertures.empty()) return {};
    const GLuint texture = gobos.texture(static_cast<int>(apertures.size()));
    if (gobos.textureGeneration() != textureGeneration_) held_.clear();
    textureGeneration_ = gobos.textureGeneration();
    held_.resize(static_cast<std::size_t>(gobos.roomForComposed()));
    std::vector<int> layers = placesOf(apertures);
    for (std::size_t i = 0; i < apertures.size(); ++i) {
        std::optional<ComposedAperture>& held = held_[static_cast<std::size_t>(layers[i])];
        layers[i] += gobos.firstComposedLayer();
        if (held) continue;
        compose(apertures[i], texture);
        copyTo(texture, layers[i]);
        held = apertures[i];
    }
    return layers;
}

void AperturePass::list(Resources& resources) const {
    for (const auto& [images, program] : variants_) gl::listProgram(resources, program);
    gl::listTexture(resources, "aperture", GL_TEXTURE_2D, picture_);
}

}  // namespace hazer::render
