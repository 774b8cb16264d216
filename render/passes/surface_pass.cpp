#include "render/passes/surface_pass.h"

#include <array>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "render/camera.h"
#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {

/// SKY_DISTANCE_M of shaders/include/surface.glsl.
constexpr std::array<float, 4> kSky{1.0e5f, 0.0f, 0.0f, 0.0f};

}  // namespace

SurfacePass::SurfacePass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "surface.vert", "surface.frag") {}

void SurfacePass::resize(int width, int height, GLuint radiance, bool hasBodies) {
    if (!hasBodies) {
        distance_ = gl::makeTexture2d(GL_R32F, 1, 1, GL_NEAREST);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, kSky.data());
        shape_ = {};
        depth_ = {};
        materials_ = {};
        framebuffer_ = {};
        return;
    }
    distance_ = gl::makeTexture2d(GL_R32F, width, height, GL_NEAREST);
    shape_ = gl::makeTexture2d(GL_RGBA16, width, height, GL_NEAREST);
    depth_ = gl::makeTexture2d(GL_DEPTH_COMPONENT32F, width, height, GL_NEAREST);
    framebuffer_ = gl::makeFramebufferFor({radiance, distance_.id(), shape_.id()}, depth_.id());
    aspect_ = static_cast<double>(width) / height;
}

/// The background is what one sees through haze already; only bodies stand in it at a known distance.
void SurfacePass::begin(const Scene& scene) {
    // Where the sky is, nobody asks for the shape.
    const glm::vec4 background(scene.backgroundCdPerM2, 1.0f);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glClearBufferfv(GL_COLOR, 0, &background[0]);
    glClearBufferfv(GL_COLOR, 1, kSky.data());
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

glm::ivec2 materialTableSize(std::size_t bodies) {
    constexpr int kRow = 1024;
    return {kRow, (static_cast<int>(bodies) + kRow - 1) / kRow};
}

void SurfacePass::uploadMaterials(const Scene& scene) {
    const glm::ivec2 size = materialTableSize(scene.instances.size());
    std::vector<glm::vec4> table(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Material& material = scene.instances[i].material;
        table[i] = glm::vec4(material.albedo, material.specular);
    }
    if (materials_.id() == 0) materials_ = gl::makeTexture2d(GL_RGBA32F, size.x, size.y, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, materials_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, table.data());
}

void SurfacePass::drawInstance(std::size_t index, const Camera& camera, const Scene& scene,
                               const MeshStore& meshes) {
    const gl::Program& program = program_.get();
    const MeshInstance& instance = scene.instances[index];
    glm::dmat4 cameraFromMesh = instance.worldFromMesh;
    cameraFromMesh[3] -= glm::dvec4(camera.positionM, 0.0);
    const glm::dmat4 viewFromMesh = glm::dmat4(glm::transpose(worldFromView(camera))) * cameraFromMesh;
    const glm::vec3 ambientLx = scene.ambient.color * scene.ambient.illuminanceLx;
    program.set("viewFromMesh", glm::mat4(viewFromMesh));
    program.set("viewFromMeshNormal", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(viewFromMesh)))));
    program.set("materialIndex", static_cast<float>(index));
    program.set("shininess", instance.material.shininess);
    program.set("ambientCdPerM2", instance.material.albedo * ambientLx * glm::one_over_pi<float>());
    meshes.draw(instance.mesh);
}

void SurfacePass::draw(const Scene& scene, float extinctionPerM, const Camera& camera,
                       const MeshStore& meshes) {
    begin(scene);
    uploadMaterials(scene);
    glEnable(GL_DEPTH_TEST);
    const gl::Program& program = program_.get();
    program.use();
    program.set("clipFromView", glm::mat4(clipFromView(camera, aspect_)));
    program.set("extinctionPerM", extinctionPerM);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) drawInstance(i, camera, scene, meshes);
    glDisable(GL_DEPTH_TEST);
}

void SurfacePass::list(Resources& resources) const {
    gl::listProgram(resources, program_);
    gl::listTexture(resources, framebuffer_.id() != 0 ? "distance" : "sky", GL_TEXTURE_2D, distance_);
    gl::listTexture(resources, "shape", GL_TEXTURE_2D, shape_);
    gl::listTexture(resources, "depth", GL_TEXTURE_2D, depth_);
    gl::listTexture(resources, "materials", GL_TEXTURE_2D, materials_);
}

}  // namespace hazer::render
