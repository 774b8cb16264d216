#include "render/passes/light_pass.h"

#include <array>
#include <cmath>
#include <vector>

#include "render/camera.h"
#include "render/gl/texture.h"
#include "render/gpu_beam.h"
#include "render/noise_volume.h"

namespace hazer::render {
namespace {

constexpr int kHullCorners = 12;
constexpr double kPi = 3.14159265358979323846;
/// How far a beam is followed [m]; the haze has long swallowed it.
constexpr float kBeamRangeM = 1000.0f;
constexpr int kNoiseSize = 64;
/// How fast the waves that stir the smoke go round; no two in step.
constexpr glm::dvec3 kStirHz(0.037, 0.029, 0.043);

enum TextureUnit : int { kGeometryUnit, kMaterialUnit, kGoboUnit, kShadowUnit, kNoiseUnit };

/// Two rings of corners (see light.vert); the first ring alone is the lens.
std::vector<glm::vec3> hullCorners() {
    std::vector<glm::vec3> corners;
    for (int ring = 0; ring < 2; ++ring) {
        for (int i = 0; i < kHullCorners; ++i) {
            const double angle = 2.0 * kPi * i / kHullCorners;
            corners.emplace_back(std::cos(angle), std::sin(angle), ring);
        }
    }
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

/// Pieces of the lit stretch with 4 nodes each. A smooth integrand needs one, a soft edge three; what is cut
/// up by a gobo, by shadows or by swirls needs more.
float leastPieces(LightFeatures features, int samples) {
    if (samples > 0) return 0.25f * static_cast<float>(samples);
    if ((features & kFeatureGobo) != 0) return 8.0f;
    if ((features & kFeatureShadow) != 0) return 6.0f;
    if ((features & kFeatureNoise) != 0) return 5.0f;
    return (features & kFeatureFlat) != 0 ? 1.0f : 3.0f;
}

}  // namespace

LightPass::LightPass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {
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

const gl::Program& LightPass::variant(LightFeatures features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_
        .try_emplace(features, shaderFolder_, "light.vert", "light.frag", featureDefines(features))
        .first->second;
}

void LightPass::upload(const Inputs& in) {
    std::vector<int> layers(in.scene.beams.size(), -1);
    for (std::size_t i = 0; i < in.plan.shadowMaps.size(); ++i) {
        layers[static_cast<std::size_t>(in.plan.shadowMaps[i].beam)] = static_cast<int>(i);
    }
    std::vector<GpuBeam> packed;
    for (const BeamGroup& group : in.plan.groups) {
        for (const int beam : group.beams) {
            const auto index = static_cast<std::size_t>(beam);
            const int layer = layers[index];
            const ShadowProjection shadow =
                layer < 0 ? ShadowProjection{}
                          : in.plan.shadowMaps[static_cast<std::size_t>(layer)].projection;
            packed.push_back(packBeam(in.scene.beams[index], in.plan.shapes[index], in.camera, layer, shadow,
                                      in.plan.shadowMapSize));
        }
    }
    beamCount_ = packed.size();
    glBindBuffer(GL_ARRAY_BUFFER, beams_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(packed.size() * sizeof(GpuBeam)), packed.data(),
                 GL_STREAM_DRAW);
}

/// 4.1 has no base instance: the instance inputs are pointed at the group's first beam.
void LightPass::bindBeams(std::size_t firstBeam) {
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, beams_.id());
    for (GLuint i = 0; i < sizeof(GpuBeam) / sizeof(glm::vec4); ++i) {
        const std::size_t offset = firstBeam * sizeof(GpuBeam) + i * sizeof(glm::vec4);
        glEnableVertexAttribArray(1 + i);
        glVertexAttribPointer(1 + i, 4, GL_FLOAT, GL_FALSE, sizeof(GpuBeam),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(1 + i, 1);
    }
}

void LightPass::setCommon(const gl::Program& program, const Inputs& in) {
    const double aspect = static_cast<double>(in.settings.width) / in.settings.height;
    const PhaseFunction& phase = in.scene.haze.phase;
    program.set("clipFromView", glm::mat4(clipFromView(in.camera, aspect)));
    program.set("viewportPx", glm::vec2(in.settings.width, in.settings.height));
    program.set("viewTangent", glm::vec2(viewTangent(in.camera, aspect)));
    program.set("worldFromView", glm::mat3(worldFromView(in.camera)));
    program.set("beamRangeM", kBeamRangeM);
    program.set("circumscribe", static_cast<float>(1.0 / std::cos(kPi / kHullCorners)));
    program.set("extinctionPerM", in.scene.haze.extinctionPerM);
    program.set("scatteringPerM", in.scene.haze.scatteringPerM);
    program.set("phaseLobes", glm::vec3(phase.forwardG, phase.backwardG, phase.forwardWeight));
    program.set("geometryBuffer", kGeometryUnit);
    program.set("materialBuffer", kMaterialUnit);
    program.set("goboImages", kGoboUnit);
    program.set("shadowMaps", kShadowUnit);
    program.set("noiseVolume", kNoiseUnit);
}

void LightPass::setIntegrator(const gl::Program& program, const Inputs& in, LightFeatures features) {
    // The thesis marched to its far plane; this is a stage's worth of it.
    constexpr float kUniformRangeM = 60.0f;
    program.set("leastPieces", leastPieces(features, in.settings.samples));
    program.set("uniformSamples", in.settings.samples > 0 ? in.settings.samples : 110);
    program.set("uniformRangeM", kUniformRangeM);
}

void LightPass::setNoise(const gl::Program& program, const Inputs& in) {
    if (noise_.id() == 0) {
        noise_ = gl::makeTexture();
        const std::vector<std::uint8_t> bytes = makeNoiseVolume(kNoiseSize, 1);
        gl::bindTexture(kNoiseUnit, GL_TEXTURE_3D, noise_.id());
        glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, kNoiseSize, kNoiseSize, kNoiseSize, 0, GL_RED, GL_UNSIGNED_BYTE,
                     bytes.data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    gl::bindTexture(kNoiseUnit, GL_TEXTURE_3D, noise_.id());
    const HazeNoise& noise = in.scene.haze.noise;
    const double tileM = kNoiseCells * static_cast<double>(noise.scaleM);
    const auto fraction = [](const glm::dvec3& v) { return glm::vec3(v - glm::floor(v)); };
    program.set("noiseOrigin",
                fraction((in.camera.positionM - glm::dvec3(noise.windMps) * in.scene.timeS) / tileM));
    program.set("noisePerM", static_cast<float>(1.0 / tileM));
    program.set("noiseWave", fraction(kStirHz * in.scene.timeS));
    program.set("noiseAmount", noise.amount);
}

void LightPass::drawBeams(const Inputs& in) {
    if (!in.plan.air && !in.plan.surfaces) return;
    gl::bindTexture(kGeometryUnit, GL_TEXTURE_2D, in.surfaces.geometry());
    gl::bindTexture(kMaterialUnit, GL_TEXTURE_2D, in.surfaces.material());
    gl::bindTexture(kGoboUnit, GL_TEXTURE_2D_ARRAY, in.gobos);
    gl::bindTexture(kShadowUnit, GL_TEXTURE_2D_ARRAY, in.shadowMaps);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    // Back faces without a depth test cover the beam from outside and from inside; clamped depth keeps the
    // near plane from cutting them.
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glEnable(GL_DEPTH_CLAMP);
    std::size_t firstBeam = 0;
    for (const BeamGroup& group : in.plan.groups) {
        const gl::Program& program = variant(group.features);
        program.use();
        setCommon(program, in);
        setIntegrator(program, in, group.features);
        if ((group.features & kFeatureNoise) != 0) setNoise(program, in);
        bindBeams(firstBeam);
        glDrawElementsInstanced(GL_TRIANGLES, hullIndexCount_, GL_UNSIGNED_SHORT, nullptr,
                                static_cast<GLsizei>(group.beams.size()));
        firstBeam += group.beams.size();
    }
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

void LightPass::drawLenses(const Inputs& in) {
    if (!in.plan.lenses || beamCount_ == 0) return;
    if (!lensProgram_) lensProgram_.emplace(shaderFolder_, "lens.vert", "lens.frag");
    lensProgram_->use();
    setCommon(*lensProgram_, in);
    bindBeams(0);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_FAN, 0, kHullCorners, static_cast<GLsizei>(beamCount_));
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

}  // namespace hazer::render
