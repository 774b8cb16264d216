#include "render/passes/ambient_pass.h"

#include "render/gl/texture.h"

namespace hazer::render {

AmbientPass::AmbientPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "fullscreen.vert", "ambient.frag") {}

void AmbientPass::draw(const Scene& scene, const SurfacePass& surfaces) {
    program_.use();
    gl::bindTexture(0, GL_TEXTURE_2D, surfaces.geometry());
    gl::bindTexture(1, GL_TEXTURE_2D, surfaces.material());
    program_.set("geometryBuffer", 0);
    program_.set("materialBuffer", 1);
    program_.set("ambientIlluminanceLx", scene.ambient.color * scene.ambient.illuminanceLx);
    program_.set("backgroundCdPerM2", scene.backgroundCdPerM2);
    program_.set("extinctionPerM", scene.haze.extinctionPerM);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hazer::render
