#include "render/passes/shadow_pass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/gtc/matrix_transform.hpp>

#include "render/gl/inventory.h"

namespace hazer::render {
namespace {

glm::dmat4 clipFromWorld(const Beam& beam, const BeamShape& shape, const ShadowProjection& projection) {
    const glm::dmat4 clipFromLamp =
        glm::perspective(2.0 * projection.halfAngleRad, 1.0, projection.nearM, projection.farM);
    const glm::dmat4 lampFromWorld(glm::transpose(beam.worldFromBeam));
    return clipFromLamp * lampFromWorld * glm::translate(glm::dmat4(1.0), -apexPosition(beam, shape));
}

}  // namespace

ShadowPass::ShadowPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "shadow.vert", "shadow.frag") {}

void ShadowPass::allocate(int size, int layers) {
    if (size == size_ && layers <= static_cast<int>(contents_.size())) return;
    // Growing in powers of two keeps a show that fades lamps in one by one from allocating every frame.
    const int rounded = static_cast<int>(std::bit_ceil(static_cast<unsigned>(layers)));
    size_ = size;
    contents_.assign(static_cast<std::size_t>(rounded), Content{});
    maps_ = gl::makeTexture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, size, size, rounded, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // Outside the map nothing casts.
    static constexpr std::array<float, 4> kLit{1.0f, 1.0f, 1.0f, 1.0f};
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, kLit.data());
    framebuffer_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glDrawBuffer(GL_NONE);
}

void ShadowPass::drawMap(int layer, const Content& content, const gl::Program& program,
                         const MeshStore& meshes) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_.id(), 0, layer);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
    for (const auto& [mesh, worldFromMesh] : content.casters) {
        program.set("clipFromMesh", glm::mat4(content.clipFromWorld * worldFromMesh));
        meshes.draw(mesh);
    }
}

void ShadowPass::draw(const Scene& scene, const ScenePlan& plan, const MeshStore& meshes) {
    if (plan.shadowMaps.empty()) return;
    allocate(plan.shadowMapSize, static_cast<int>(plan.shadowMaps.size()));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_, size_);
    glEnable(GL_DEPTH_TEST);
    // Pushes the casters away from the lamp by their slope, so that a lit face does not shadow itself.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2.0f, 2.0f);
    const gl::Program& program = program_.get();
    program.use();
    for (std::size_t layer = 0; layer < plan.shadowMaps.size(); ++layer) {
        const ShadowMapPlan& map = plan.shadowMaps[layer];
        const auto beam = static_cast<std::size_t>(map.beam);
        Content content{clipFromWorld(scene.beams[beam], plan.shapes[beam], map.projection), {}};
        for (const int caster : map.casters) {
            const MeshInstance& instance = scene.instances[static_cast<std::size_t>(caster)];
            content.casters.emplace_back(instance.mesh, instance.worldFromMesh);
        }
        if (content == contents_[layer]) continue;
        drawMap(static_cast<int>(layer), content, program, meshes);
        contents_[layer] = std::move(content);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_TEST);
}

void ShadowPass::list(Resources& resources) const {
    gl::listProgram(resources, program_);
    gl::listTexture(resources, "shadow maps", GL_TEXTURE_2D_ARRAY, maps_);
}

}  // namespace hazer::render
