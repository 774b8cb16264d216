// Every beam, in the air and on surfaces: instanced hulls, added up. Also the lenses, which share the beams'
// data.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/passes/surface_pass.h"
#include "render/scene_plan.h"

namespace hazer::render {

class LightPass {
 public:
    explicit LightPass(std::filesystem::path shaderFolder);

    /// What the lights are drawn over and with. Textures may be 0 where the plan does not use them.
    struct Inputs {
        const Scene& scene;
        const Camera& camera;
        const Settings& settings;
        const ScenePlan& plan;
        const SurfacePass& surfaces;
        GLuint gobos = 0;
        GLuint shadowMaps = 0;
    };

    /// Packs and uploads the beams of this frame; call before the two draws.
    void upload(const Inputs& in);

    /// Adds the plan's groups to the bound framebuffer.
    void drawBeams(const Inputs& in);

    /// Adds lit lenses to the bound framebuffer, behind what stands before them (its depth buffer).
    void drawLenses(const Inputs& in);

    /// Compiles a variant if it is not yet; tests call it for all of them.
    const gl::Program& variant(LightFeatures features);

 private:
    void setCommon(const gl::Program& program, const Inputs& in);
    void setIntegrator(const gl::Program& program, const Inputs& in, LightFeatures features);
    void setNoise(const gl::Program& program, const Inputs& in);
    void bindBeams(std::size_t firstBeam);

    std::filesystem::path shaderFolder_;
    std::map<LightFeatures, gl::Program> variants_;
    std::optional<gl::Program> lensProgram_;
    gl::VertexArray vertexArray_ = gl::makeVertexArray();
    gl::Buffer corners_ = gl::makeBuffer();
    gl::Buffer hullIndices_ = gl::makeBuffer();
    gl::Buffer beams_ = gl::makeBuffer();
    gl::Texture noise_;
    GLsizei hullIndexCount_ = 0;
    std::size_t beamCount_ = 0;
};

}  // namespace hazer::render
