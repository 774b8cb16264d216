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

/// A radius that is out of the picture, whatever it is scaled by.
constexpr float kOutOfTheWay = 1e3f;

glm::vec3 packed(const ApertureEdge& edge) {
    return glm::vec3(glm::dvec3(edge.normal, edge.distance));
}

glm::vec2 turnOf(double rad) {
    return glm::vec2(glm::dvec2(std::cos(rad), std::sin(rad)));
}

std::string element(const char* array, std::size_t i) {
    return array + ("[" + std::to_string(i) + "]");
}

/// The layer of a place of a wheel; open ones have none.
double layerOf(int gobo) {
    return std::max(gobo, -1);
}

void setImages(const gl::Program& program, const std::vector<ApertureImage>& images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const ApertureImage& image = images[i];
        const bool hasNeighbor = image.neighbor != -1;
        const glm::dvec2 toNeighbor = hasNeighbor ? image.toNeighbor : glm::dvec2(kOutOfTheWay);
        program.set(element("imageDisc", i).c_str(),
                    glm::vec4(glm::dvec4(image.center, image.radius, layerOf(image.gobo))));
        program.set(element("imageTurn", i).c_str(), turnOf(image.rotationRad));
        program.set(element("imageNeighbor", i).c_str(),
                    glm::vec3(glm::dvec3(toNeighbor, layerOf(image.neighbor))));
    }
}

/// From places on the picture to those of the aperture.
void setPlaces(const gl::Program& program, const ComposedAperture& aperture) {
    const glm::dmat2 onField = glm::inverse(aperture.aperture.stretch) / aperture.fieldRadius;
    program.set("onField", glm::vec4(glm::dvec4(onField[0], onField[1])));
    const double shortest =
        std::max(std::abs(glm::determinant(aperture.aperture.stretch)), kNarrowestStretch);
    program.set("widening", static_cast<float>(1.0 / (shortest * aperture.fieldRadius)));
    program.set("gateRadius", hasGate(aperture) ? 1.0f : kOutOfTheWay);
    if (aperture.profile)
        program.set("profile",
                    glm::vec3(glm::dvec3(aperture.profile->fieldTangent, aperture.profile->beamHalfAngleRad,
                                         aperture.profile->exponent)));
}

void setEdges(const gl::Program& program, const Aperture& aperture) {
    std::size_t count = 0;
    for (const ApertureEdge& blade : aperture.blades) {
        if (blade.distance < 1.0) program.set(element("blades", count++).c_str(), packed(blade));
    }
    program.set("bladeCount", static_cast<int>(count));
    // An open iris has no edge that could be soft.
    program.set("irisRadius",
                aperture.irisRadius < 1.0 ? static_cast<float>(aperture.irisRadius) : kOutOfTheWay);
    glm::dvec3 rectangle(kOutOfTheWay, kOutOfTheWay, 0.0);
    if (aperture.rectangle) {
        const double ramp = aperture.rectangle->softness;
        rectangle = glm::dvec3(glm::max(aperture.rectangle->halfSize - 0.5 * ramp, 1e-3), ramp);
    }
    program.set("rectangle", glm::vec3(rectangle));
    program.set("softness", static_cast<float>(aperture.softness));
    program.set("split", packed(aperture.split));
    program.set("nearColor", aperture.color);
    program.set("farColor", aperture.beyondColor);
}

}  // namespace

AperturePass::AperturePass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& AperturePass::variant(const std::vector<std::string>& features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_.try_emplace(features, shaderFolder_, "fullscreen.vert", "aperture.frag", features)
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
    const gl::Program& program = variant(apertureFeatures(aperture));
    program.use();
    program.set("goboImages", 0);
    program.set("size", static_cast<float>(kGoboSize));
    setPlaces(program, aperture);
    setImages(program, imagesOf(aperture));
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
    for (const auto& [features, program] : variants_) gl::listProgram(resources, program);
    gl::listTexture(resources, "aperture", GL_TEXTURE_2D, picture_);
}

}  // namespace hazer::render
