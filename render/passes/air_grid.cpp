#include "render/passes/air_grid.h"

#include <array>

#include "render/air_quality.h"
#include "render/beam_width.h"
#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {

AirGrid::AirGrid(const std::filesystem::path& shaderFolder)
    : judge_(shaderFolder, "beam.vert", "air_nodes.frag"),
      interpolate_(shaderFolder, "beam.vert", "air_between.frag"),
      nodeSum_(shaderFolder) {}

void AirGrid::allocate(const Settings& settings, GLuint radiance, int step) {
    if (settings.width == width_ && settings.height == height_ && radiance == radiance_ && step == step_)
        return;
    width_ = settings.width;
    height_ = settings.height;
    radiance_ = radiance;
    step_ = step;
    const glm::ivec2 count = nodeCount(settings, step);
    nodes_ = gl::makeTexture2d(GL_RGBA32F, count.x, count.y, GL_NEAREST);
    nodeSum_.resize(count);
    judged_ = gl::makeTexture2d(GL_RGBA32F, count.x, count.y, GL_LINEAR);
    done_ = gl::makeTexture2d(GL_DEPTH_COMPONENT16, width_, height_, GL_NEAREST);
    nodeTarget_ = gl::makeFramebufferFor({nodes_.id()});
    seen_ = gl::makeTexture2d(GL_DEPTH_COMPONENT16, count.x, count.y, GL_NEAREST);
    judgeTarget_ = gl::makeFramebufferFor({judged_.id()}, seen_.id());
    pictureTarget_ = gl::makeFramebufferFor({radiance}, done_.id());
}

void AirGrid::splitBeams(const LightInputs& in, int step) {
    wide_.clear();
    thin_.clear();
    const auto isThin = [&](int beam) {
        const auto index = static_cast<std::size_t>(beam);
        return isThinOnScreen(in.scene.beams[index], in.plan.shapes[index], in.camera, in.settings.height,
                              step);
    };
    for (const BeamGroup& group : in.plan.airGroups) {
        BeamGroup wide{group.features, {}};
        BeamGroup thin{group.features, {}};
        for (const int beam : group.beams) (isThin(beam) ? thin : wide).beams.push_back(beam);
        if (!wide.beams.empty()) wide_.push_back(std::move(wide));
        if (!thin.beams.empty()) thin_.push_back(std::move(thin));
    }
}

void AirGrid::drawNodes(AirPass& air, LightInputs in, int step) {
    static constexpr std::array<float, 4> kDark{};
    glBindFramebuffer(GL_FRAMEBUFFER, nodeTarget_.id());
    glClearBufferfv(GL_COLOR, 0, kDark.data());
    in.pixelStep = step;
    air.draw(in, wide_);
}

/// Draws the beams' hulls, but each texel once: every fragment has the same depth, whatever its shape, so
/// that the depth buffer is a mask.
void AirGrid::beginMask() {
    static constexpr float kToDo = 1.0f;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClearBufferfv(GL_DEPTH, 0, &kToDo);
    glDepthRange(0.0, 0.0);
}

/// Cells that no hull is drawn on stay as they are: not to be interpolated.
void AirGrid::judge(AirPass& air, LightInputs in, int step) {
    static constexpr std::array<float, 4> kRefined{};
    const glm::ivec2 count = nodeCount(in.settings, step);
    nodeSum_.draw(nodes_.id());
    glViewport(0, 0, count.x, count.y);
    glBindFramebuffer(GL_FRAMEBUFFER, judgeTarget_.id());
    glClearBufferfv(GL_COLOR, 0, kRefined.data());
    beginMask();
    const gl::Program& judge = judge_.get();
    judge.use();
    in.pixelStep = step;
    setLightUniforms(judge, in);
    gl::bindTexture(kNodeUnit, GL_TEXTURE_2D, nodes_.id());
    gl::bindTexture(kNodeSumUnit, GL_TEXTURE_2D, nodeSum_.texture());
    judge.set("nodes", kNodeUnit);
    judge.set("nodeSum", kNodeSumUnit);
    judge.set("nodeStep", step);
    judge.set("tolerance", static_cast<float>(airQuality(in.settings).gridTolerance));
    air.drawHulls(in, wide_);
    glDepthRange(0.0, 1.0);
    glDisable(GL_DEPTH_TEST);
}

/// Where a beam is too narrow near its lens for the grid, no cell may be interpolated.
void AirGrid::markLenses(const LightInputs& in, int step) {
    static constexpr std::array<float, 4> kRefined{};
    const glm::ivec2 count = nodeCount(in.settings, step);
    glEnable(GL_SCISSOR_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    for (const BeamGroup& group : wide_) {
        for (const int beam : group.beams) {
            const auto index = static_cast<std::size_t>(beam);
            const auto square = thinSurroundings(in.scene.beams[index], in.plan.shapes[index], in.camera,
                                                 {in.settings.width, in.settings.height}, step);
            if (!square) continue;
            const glm::dvec2 last(count);
            const double nodePx = step;
            const glm::ivec2 from(glm::clamp(
                glm::floor((square->centerPx - square->halfEdgePx) / nodePx) - 1.0, glm::dvec2(0.0), last));
            const glm::ivec2 to(glm::clamp(glm::ceil((square->centerPx + square->halfEdgePx) / nodePx),
                                           glm::dvec2(0.0), last));
            glScissor(from.x, from.y, to.x - from.x, to.y - from.y);
            glClearBufferfv(GL_COLOR, 0, kRefined.data());
        }
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
}

void AirGrid::interpolate(AirPass& air, const LightInputs& in, int step) {
    glBindFramebuffer(GL_FRAMEBUFFER, pictureTarget_.id());
    glViewport(0, 0, width_, height_);
    beginMask();
    const gl::Program& interpolate = interpolate_.get();
    interpolate.use();
    setLightUniforms(interpolate, in);
    gl::bindTexture(kNodeUnit, GL_TEXTURE_2D, judged_.id());
    interpolate.set("judgedNodes", kNodeUnit);
    interpolate.set("nodeStep", step);
    air.drawHulls(in, wide_);
}

void AirGrid::refine(AirPass& air, const LightInputs& in) {
    glDepthMask(GL_FALSE);
    glDepthRange(0.5, 0.5);
    air.draw(in, wide_);
    glDepthRange(0.0, 1.0);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    air.draw(in, thin_);
}

void AirGrid::count(AirPass& air, const LightInputs& in, int step) {
    glBindFramebuffer(GL_FRAMEBUFFER, pictureTarget_.id());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthRange(0.5, 0.5);
    air.count(in, wide_, 1.0f);
    glDepthFunc(GL_GREATER);
    air.count(in, wide_, 1.0f / static_cast<float>(step * step));
    glDepthFunc(GL_LESS);
    glDepthRange(0.0, 1.0);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    air.count(in, thin_, 1.0f);
}

void AirGrid::draw(AirPass& air, const LightInputs& in, GLuint radiance, int step) {
    allocate(in.settings, radiance, step);
    splitBeams(in, step);
    const glm::ivec2 count = nodeCount(in.settings, step);
    glViewport(0, 0, count.x, count.y);
    drawNodes(air, in, step);
    judge(air, in, step);
    markLenses(in, step);
    interpolate(air, in, step);
    refine(air, in);
}

void AirGrid::list(Resources& resources) const {
    gl::listProgram(resources, judge_);
    gl::listProgram(resources, interpolate_);
    nodeSum_.list(resources);
    gl::listTexture(resources, "grid nodes", GL_TEXTURE_2D, nodes_);
    gl::listTexture(resources, "judged grid nodes", GL_TEXTURE_2D, judged_);
    gl::listTexture(resources, "judged grid mask", GL_TEXTURE_2D, seen_);
    gl::listTexture(resources, "grid mask", GL_TEXTURE_2D, done_);
}

}  // namespace hazer::render
