#include "render/passes/ambient_pass.h"

#include "render/gl/texture.h"

namespace hazer::render {

AmbientPass::AmbientPass(const std::filesystem::path& shaderFolder)
    : program_(shaderFolder, "fullscreen.vert", "ambient.frag") {}

void AmbientPass::draw(const Scene& scene, const SurfacePass& surfaces) {
    const gl::Program& program = program_.get();
    program.use();
    gl::bindTexture(0, GL_TEXTURE_2D, surfaces.geometry());
    gl::bindTexture(1, GL_TEXTURE_2D, surfaces.material());
    program.set("geometryBuffer", 0);
    program.set("materialBuffer", 1);
    program.set("ambientIlluminanceLx", scene.ambient.color * scene.ambient.illuminanceLx);
    program.set("backgroundCdPerM2", scene.backgroundCdPerM2);
    program.set("extinctionPerM", scene.haze.extinctionPerM);
    glBindVertexArray(noVertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hazer::render
