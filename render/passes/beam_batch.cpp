#include "render/passes/beam_batch.h"

#include <cmath>

#include "render/camera.h"
#include "render/gl/inventory.h"
#include "render/gl/texture.h"

namespace hazer::render {
namespace {

/// Six: where the hull's triangles meet, a processor that draws blocks of pixels draws them twice; with fewer
/// corners the prism is so much wider than the cone.
constexpr int kHullCorners = 6;
constexpr int kLensCorners = 12;
constexpr double kPi = 3.14159265358979323846;
/// How far a beam is followed [m]; the haze has long swallowed it.
constexpr float kBeamRangeM = 1000.0f;

void addRing(int count, int end, std::vector<glm::vec3>& corners) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * kPi * i / count;
        corners.emplace_back(std::cos(angle), std::sin(angle), end);
    }
}

/// The rings of corners at the hull's two ends (see beam.vert), and the lens.
std::vector<glm::vec3> hullCorners() {
    std::vector<glm::vec3> corners;
    addRing(kHullCorners, 0, corners);
    addRing(kHullCorners, 1, corners);
    addRing(kLensCorners, 0, corners);
    return corners;
}

/// Sides, then the two lids; counter-clockwise from outside.
std::vector<std::uint16_t> hullIndexList() {
    std::vector<std::uint16_t> list;
    const auto triangle = [&list](int a, int b, int c) {
        for (const int i : {a, b, c}) list.push_back(static_cast<std::uint16_t>(i));
    };
    for (int i = 0; i < kHullCorners; ++i) {
        const int next = (i + 1) % kHullCorners;
        triangle(i, i + kHullCorners, next);
        triangle(next, i + kHullCorners, next + kHullCorners);
    }
    for (int i = 1; i + 1 < kHullCorners; ++i) {
        triangle(0, i, i + 1);
        triangle(kHullCorners, kHullCorners + i + 1, kHullCorners + i);
    }
    return list;
}

BeamPicture pictureOf(const Beam& beam, int composed, const std::vector<int>& composedLayers,
                      const Settings& settings) {
    if (!settings.gobos) return {};
    if (composed < 0) return {beam.gobo, beam.goboRotationRad};
    return {composedLayers[static_cast<std::size_t>(composed)], pictureRotationRad(beam)};
}

}  // namespace

std::vector<GpuBeam> packBeams(const Scene& scene, const ScenePlan& plan, const Camera& camera,
                               const Settings& settings, const std::vector<int>& composedLayers,
                               const std::vector<GoboTableSlot>& goboTables) {
    std::vector<BeamShadow> shadows(scene.beams.size());
    for (std::size_t i = 0; i < scene.beams.size(); ++i) {
        if (const auto& reach = plan.surfaceReach[i]) shadows[i].reach = *reach;
    }
    int faces = 0;
    for (const ShadowMapPlan& map : plan.shadowMaps) {
        shadows[static_cast<std::size_t>(map.beam)].firstFace = faces;
        faces += faceRecordCount(map);
    }
    std::vector<GpuBeam> packed;
    packed.reserve(scene.beams.size());
    for (std::size_t i = 0; i < scene.beams.size(); ++i) {
        packed.push_back(packBeam(
            scene.beams[i], plan.shapes[i], camera, shadows[i],
            pictureOf(scene.beams[i], plan.apertures.ofBeam[i], composedLayers, settings), goboTables[i]));
    }
    return packed;
}

std::size_t beamHullBytes() {
    return hullCorners().size() * sizeof(glm::vec3) + hullIndexList().size() * sizeof(std::uint16_t);
}

glm::ivec2 nodeCount(const Settings& settings, int step) {
    return {(settings.width - 1) / step + 2, (settings.height - 1) / step + 2};
}

/// Moves the centre of every step-th pixel of the picture to the centre of a node's pixel.
glm::dmat4 nodesFromClip(const Settings& settings, int step) {
    if (step == 1) return glm::dmat4(1.0);
    const glm::dvec2 nodes(nodeCount(settings, step));
    const glm::dvec2 scale =
        glm::dvec2(settings.width, settings.height) / (static_cast<double>(step) * nodes);
    const glm::dvec2 shift = scale - 1.0 + (1.0 - 1.0 / step) / nodes;
    glm::dmat4 matrix(1.0);
    matrix[0][0] = scale.x;
    matrix[1][1] = scale.y;
    matrix[3][0] = shift.x;
    matrix[3][1] = shift.y;
    return matrix;
}

void setLightUniforms(const gl::Program& program, const LightInputs& in) {
    const double aspect = static_cast<double>(in.settings.width) / in.settings.height;
    program.set("clipFromView",
                glm::mat4(nodesFromClip(in.settings, in.pixelStep) * clipFromView(in.camera, aspect)));
    program.set("pixelStep", static_cast<float>(in.pixelStep));
    program.set("viewportPx", glm::vec2(in.settings.width, in.settings.height));
    program.set("viewTangent", glm::vec2(viewTangent(in.camera, aspect)));
    program.set("beamRangeM", kBeamRangeM);
    program.set("circumscribe", static_cast<float>(1.0 / std::cos(kPi / kHullCorners)));
    program.set("extinctionPerM", in.plan.haze.extinctionPerM);
    program.set("distanceBuffer", kDistanceUnit);
    program.set("shapeBuffer", kShapeUnit);
    program.set("materialTable", kMaterialUnit);
    program.set("goboImages", kGoboUnit);
    program.set("shadowAtlas", kShadowAtlasUnit);
    program.set("shadowFaces", kShadowFacesUnit);
    program.set("webImages", kWebUnit);
    program.set("goboTables", kGoboTableUnit);
    gl::bindTexture(kDistanceUnit, GL_TEXTURE_2D, in.surfaces.distance());
    gl::bindTexture(kShapeUnit, GL_TEXTURE_2D, in.surfaces.shape());
    gl::bindTexture(kMaterialUnit, GL_TEXTURE_2D, in.surfaces.materials());
    gl::bindTexture(kGoboUnit, GL_TEXTURE_2D_ARRAY, in.gobos);
    gl::bindTexture(kGoboTableUnit, GL_TEXTURE_2D_ARRAY, in.goboTables);
    gl::bindTexture(kShadowAtlasUnit, GL_TEXTURE_2D, in.shadows.atlas);
    gl::bindTexture(kShadowFacesUnit, GL_TEXTURE_BUFFER, in.shadows.faces);
    gl::bindTexture(kWebUnit, GL_TEXTURE_2D_ARRAY, in.webs);
}

void BeamBatch::makeHull() {
    vertexArray_ = gl::makeVertexArray();
    corners_ = gl::makeBuffer();
    hullIndices_ = gl::makeBuffer();
    beams_ = gl::makeBuffer();
    const std::vector<glm::vec3> corners = hullCorners();
    const std::vector<std::uint16_t> indices = hullIndexList();
    hullIndexCount_ = static_cast<GLsizei>(indices.size());
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(glm::vec3)), corners.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, hullIndices_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)),
                 indices.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
}

void BeamBatch::upload(std::span<const BeamGroup> groups, const std::vector<GpuBeam>& beams) {
    if (hullIndexCount_ == 0) makeHull();
    std::vector<GpuBeam> ordered;
    ranges_.clear();
    for (const BeamGroup& group : groups) {
        ranges_.push_back({ordered.size(), group.beams.size()});
        for (const int beam : group.beams) ordered.push_back(beams[static_cast<std::size_t>(beam)]);
    }
    glBindBuffer(GL_ARRAY_BUFFER, beams_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ordered.size() * sizeof(GpuBeam)), ordered.data(),
                 GL_STREAM_DRAW);
}

/// 4.1 has no base instance: the instance inputs are pointed at the group's first beam.
void BeamBatch::bind(const Range& range) {
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, beams_.id());
    for (GLuint i = 0; i < sizeof(GpuBeam) / sizeof(glm::vec4); ++i) {
        const std::size_t offset = range.first * sizeof(GpuBeam) + i * sizeof(glm::vec4);
        glEnableVertexAttribArray(1 + i);
        glVertexAttribPointer(1 + i, 4, GL_FLOAT, GL_FALSE, sizeof(GpuBeam),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(1 + i, 1);
    }
}

void BeamBatch::drawHulls(std::size_t group) {
    bind(ranges_[group]);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnable(GL_DEPTH_CLAMP);
    glDrawElementsInstanced(GL_TRIANGLES, hullIndexCount_, GL_UNSIGNED_SHORT, nullptr,
                            static_cast<GLsizei>(ranges_[group].count));
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

void BeamBatch::drawLenses(std::size_t group) {
    bind(ranges_[group]);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDrawArraysInstanced(GL_TRIANGLE_FAN, 2 * kHullCorners, kLensCorners,
                          static_cast<GLsizei>(ranges_[group].count));
    glDisable(GL_BLEND);
}

void BeamBatch::list(Resources& resources, const char* name) const {
    gl::listBuffer(resources, name, beams_);
    gl::listBuffer(resources, "beam hull", corners_);
    gl::listBuffer(resources, "beam hull", hullIndices_);
}

}  // namespace hazer::render
