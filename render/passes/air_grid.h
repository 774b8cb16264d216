// Light in the air, which is mostly smooth: integrated on a coarse grid, interpolated where that is good
// enough, and integrated pixel by pixel where it is not (edges of beams, shadows and bodies).
#pragma once

#include <filesystem>

#include "render/passes/air_pass.h"
#include "render/passes/texel_sum.h"

namespace hazer::render {

class AirGrid {
 public:
    explicit AirGrid(const std::filesystem::path& shaderFolder);

    /// Adds the plan's light in the air to `radiance`, a texture of the picture's size. `in.pixelStep` is not
    /// looked at; `step` >= 2 is the distance of the grid's nodes in pixels.
    void draw(AirPass& air, const LightInputs& in, GLuint radiance, int step);

    /// Adds to the bound picture how many integrals each pixel took in the last draw(): those of a node are
    /// shared out among the pixels around it.
    void count(AirPass& air, const LightInputs& in, int step);

    /// Adds what there is on the GPU.
    void list(Resources& resources) const;

 private:
    void allocate(const Settings& settings, GLuint radiance, int step);
    void splitBeams(const LightInputs& in, int step);
    void drawNodes(AirPass& air, LightInputs in, int step);
    static void beginMask();
    void judge(AirPass& air, LightInputs in, int step);
    void markLenses(const LightInputs& in, int step);
    void interpolate(AirPass& air, const LightInputs& in, int step);
    void refine(AirPass& air, const LightInputs& in);

    std::vector<BeamGroup> wide_;  ///< Beams that the grid cannot miss.
    std::vector<BeamGroup> thin_;  ///< The others; these are integrated at every pixel.
    gl::LazyProgram judge_;
    gl::LazyProgram interpolate_;
    TexelSum nodeSum_;
    gl::Texture nodes_, judged_;
    gl::Texture seen_;  ///< Depth: 0 where a node has been judged.
    gl::Texture done_;  ///< Depth: 0 where a pixel has its light, 1 where it needs the integral.
    gl::Framebuffer nodeTarget_, judgeTarget_, pictureTarget_;
    GLuint radiance_ = 0;
    int width_ = 0, height_ = 0, step_ = 0;
};

}  // namespace hazer::render
