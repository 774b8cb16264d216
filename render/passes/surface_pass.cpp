#include "render/passes/surface_pass.h"

#include <array>

#include "render/camera.h"
#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {

/// SKY_DISTANCE_M of shaders/include/surface.glsl.
constexpr std::array<float, 4> kSky{0.0f, 0.0f, 1.0e5f, 0.0f};

}  // namespace

SurfacePass::SurfacePass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "surface.vert", "surface.frag") {}

void SurfacePass::resize(int width, int height, bool hasBodies) {
    if (!hasBodies) {
        geometry_ = gl::makeTexture2d(GL_RGBA32F, 1, 1, GL_NEAREST);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, kSky.data());
        material_ = {};
        depth_ = {};
        framebuffer_ = {};
        return;
    }
    geometry_ = gl::makeTexture2d(GL_RGBA32F, width, height, GL_NEAREST);
    material_ = gl::makeTexture2d(GL_RGBA16F, width, height, GL_NEAREST);
    depth_ = gl::makeTexture2d(GL_DEPTH_COMPONENT32F, width, height, GL_NEAREST);
    framebuffer_ = gl::makeFramebufferFor({geometry_.id(), material_.id()}, depth_.id());
    aspect_ = static_cast<double>(width) / height;
}

void SurfacePass::draw(const Scene& scene, const Camera& camera, const MeshStore& meshes) {
    static constexpr std::array<float, 4> kBlack{};
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glClearBufferfv(GL_COLOR, 0, kSky.data());
    glClearBufferfv(GL_COLOR, 1, kBlack.data());
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
    glEnable(GL_DEPTH_TEST);
    const gl::Program& program = program_.get();
    program.use();
    program.set("clipFromView", glm::mat4(clipFromView(camera, aspect_)));
    const glm::dmat3 viewFromWorld = glm::transpose(worldFromView(camera));
    for (const MeshInstance& instance : scene.instances) {
        glm::dmat4 cameraFromMesh = instance.worldFromMesh;
        cameraFromMesh[3] -= glm::dvec4(camera.positionM, 0.0);
        const glm::dmat4 viewFromMesh = glm::dmat4(viewFromWorld) * cameraFromMesh;
        program.set("viewFromMesh", glm::mat4(viewFromMesh));
        program.set("viewFromMeshNormal", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(viewFromMesh)))));
        program.set("albedo", instance.material.albedo);
        program.set("specular", instance.material.specular);
        program.set("shininess", instance.material.shininess);
        meshes.draw(instance.mesh);
    }
    glDisable(GL_DEPTH_TEST);
}

void SurfacePass::list(Resources& resources) const {
    gl::listProgram(resources, program_);
    gl::listTexture(resources, material_.id() != 0 ? "geometry" : "sky", GL_TEXTURE_2D, geometry_);
    gl::listTexture(resources, "material", GL_TEXTURE_2D, material_);
    gl::listTexture(resources, "depth", GL_TEXTURE_2D, depth_);
}

}  // namespace hazer::render
