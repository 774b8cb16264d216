// The beams that one pass draws: their data on the GPU, one instance a beam, and the hull around each.
#pragma once

#include <span>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/gpu_beam.h"
#include "render/passes/shadow_pass.h"
#include "render/passes/surface_pass.h"
#include "render/resources.h"
#include "render/scene_plan.h"

namespace hazer::render {

/// What lights are drawn over and with. Textures may be 0 where the plan does not use them.
struct LightInputs {
    const Scene& scene;
    const Camera& camera;
    const Settings& settings;
    const ScenePlan& plan;
    const SurfacePass& surfaces;
    const std::vector<GpuBeam>& beams;  ///< One per beam of the scene, see packBeams.
    GLuint gobos = 0;
    GLuint goboTables = 0;
    ShadowTextures shadows;
    GLuint webs = 0;
    int pixelStep = 1;  ///< Draws only every so many pixels, into a target of nodeCount().
};

/// How many nodes of a grid cover the picture, `step` pixels apart: the first at its corner pixel, the last
/// at or beyond the opposite one.
glm::ivec2 nodeCount(const Settings& settings, int step);

/// Texture units of the shaders that draw beams.
enum LightTextureUnit : int {
    kDistanceUnit,
    kShapeUnit,
    kMaterialUnit,
    kGoboUnit,
    kShadowAtlasUnit,
    kShadowFacesUnit,
    kNoiseUnit,
    kNodeUnit,
    kNodeSumUnit,
    kWebUnit,
    kGoboTableUnit,
    kProfileUnit
};

/// Every beam of the scene as seen by the camera; `goboTables` has one slot a beam, `composedLayers` one
/// layer a composed aperture of the plan.
std::vector<GpuBeam> packBeams(const Scene& scene, const ScenePlan& plan, const Camera& camera,
                               const Settings& settings, const std::vector<int>& composedLayers,
                               const std::vector<GoboTableSlot>& goboTables);

/// Bytes of the hull that the beams of a pass share.
std::size_t beamHullBytes();

/// Sets what every shader that draws beams knows, and binds the textures it looks up.
void setLightUniforms(const gl::Program& program, const LightInputs& in);

/// Nothing of it exists before the first upload().
class BeamBatch {
 public:
    /// Takes the beams of these groups, group after group.
    void upload(std::span<const BeamGroup> groups, const std::vector<GpuBeam>& beams);

    /// Draws the back faces of the hulls of one group with the current program, adding to the bound
    /// framebuffer: they cover a beam from outside and from inside, and clamped depth keeps the near plane
    /// from cutting them.
    void drawHulls(std::size_t group);

    /// Draws the lenses of one group as discs.
    void drawLenses(std::size_t group);

    /// Adds what there is on the GPU: the beams under `name`, and the hull that they share.
    void list(Resources& resources, const char* name) const;

 private:
    struct Range {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    void makeHull();
    void bind(const Range& range);

    gl::VertexArray vertexArray_;
    gl::Buffer corners_;
    gl::Buffer hullIndices_;
    gl::Buffer beams_;
    GLsizei hullIndexCount_ = 0;
    std::vector<Range> ranges_;
};

}  // namespace hazer::render
