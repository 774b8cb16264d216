#include "render/passes/air_pass.h"

#include "render/air_quality.h"
#include "render/camera.h"
#include "render/gl/inventory.h"
#include "render/gl/texture.h"
#include "render/haze_swirls.h"
#include "render/noise_volume.h"

namespace hazer::render {
namespace {

/// The thesis' number of samples.
constexpr int kUniformSamples = 110;

}  // namespace

AirPass::AirPass(std::filesystem::path shaderFolder) : shaderFolder_(std::move(shaderFolder)) {}

const gl::Program& AirPass::variant(LightFeatures features) {
    const auto found = variants_.find(features);
    if (found != variants_.end()) return found->second;
    return variants_.try_emplace(features, shaderFolder_, "beam.vert", "air.frag", featureDefines(features))
        .first->second;
}

void AirPass::setHaze(const gl::Program& program, const LightInputs& in) {
    // The thesis marched to its far plane; this is a stage's worth of it.
    constexpr float kUniformRangeM = 60.0f;
    const Haze& haze = in.plan.haze;
    program.set("scatteringPerM", haze.scatteringPerM);
    program.set("phaseLobes", glm::vec3(haze.phase.forwardG, haze.phase.backwardG, haze.phase.forwardWeight));
    program.set("profileRules", kProfileUnit);
    gl::bindTexture(kProfileUnit, GL_TEXTURE_2D, rules_.texture());
    const AirQuality quality = airQuality(in.settings);
    program.set("shadowIntervals", quality.shadowIntervals);
    program.set("shadowBisections", quality.shadowBisections);
    program.set("profilePairs", quality.profilePairs);
    program.set("goboTaps", quality.goboTaps);
    program.set("goboTolerance", static_cast<float>(quality.goboTolerance));
    program.set("goboLevelsApart", static_cast<float>(quality.goboLevelsApart));
    program.set("noiseNodes", quality.noiseNodes);
    program.set("sampleCount", in.settings.samples > 0 ? in.settings.samples : kUniformSamples);
    program.set("uniformRangeM", kUniformRangeM);
}

void AirPass::makeNoise(std::uint32_t seed) {
    if (noise_.id() != 0 && seed == noiseSeed_) return;
    noiseSeed_ = seed;
    noise_ = gl::makeTexture();
    gl::bindTexture(kNoiseUnit, GL_TEXTURE_3D, noise_.id());
    const auto levels = noiseLevels(makeNoiseVolume(kNoiseSize, seed), kNoiseSize);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    // Eight bits would show as bands. Floats take a sixth off the time of software renderers, next to 16
    // bits.
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const GLsizei size = kNoiseSize >> i;
        glTexImage3D(GL_TEXTURE_3D, static_cast<GLint>(i), GL_R32F, size, size, size, 0, GL_RED,
                     GL_UNSIGNED_SHORT, levels[i].data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void AirPass::setNoise(const gl::Program& program, const LightInputs& in) {
    const HazeNoise& noise = in.scene.haze.noise;
    makeNoise(noise.seed);
    gl::bindTexture(kNoiseUnit, GL_TEXTURE_3D, noise_.id());
    const HazeSwirls swirls = hazeSwirls(noise, in.camera.positionM, in.scene.timeS);
    program.set("noiseVolume", kNoiseUnit);
    program.set("noiseFromView", glm::mat3(swirls.noiseFromWorld * worldFromView(in.camera)));
    program.set("noiseOrigin", swirls.origin);
    program.set("noisePerM", static_cast<float>(1.0 / swirls.periodM));
    program.set("noiseTexelsPerM", static_cast<float>(kNoiseSize / swirls.periodM));
    program.set("noiseWave", swirls.wave);
    program.set("noiseAmount", noise.amount);
}

void AirPass::drawHulls(const LightInputs& in, const std::vector<BeamGroup>& groups) {
    batch_.upload(groups, in.beams);
    for (std::size_t i = 0; i < groups.size(); ++i) batch_.drawHulls(i);
}

std::vector<GpuBeam> AirPass::withProfiles(const LightInputs& in, const std::vector<BeamGroup>& groups) {
    std::vector<GpuBeam> beams = in.beams;
    rules_.beginFrame();
    for (const BeamGroup& group : groups) {
        for (const int beam : group.beams) {
            const auto index = static_cast<std::size_t>(beam);
            const BeamShape& shape = in.plan.shapes[index];
            if (takesProfileRules(group.features))
                beams[index].lens.y = static_cast<float>(rules_.row(shape));
            if ((group.features & kFeatureLine) != 0)
                beams[index].lens.z = static_cast<float>(profileSolidAngle(shape));
        }
    }
    return beams;
}

void AirPass::draw(const LightInputs& in, const std::vector<BeamGroup>& groups) {
    drawWith(in, groups, 0, 0.0f);
}

void AirPass::count(const LightInputs& in, const std::vector<BeamGroup>& groups, float countedAs) {
    drawWith(in, groups, kFeatureCount, countedAs);
}

void AirPass::drawWith(const LightInputs& in, const std::vector<BeamGroup>& groups, LightFeatures further,
                       float countedAs) {
    batch_.upload(groups, withProfiles(in, groups));
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const LightFeatures features = groups[i].features | further;
        const gl::Program& program = variant(features);
        program.use();
        setLightUniforms(program, in);
        setHaze(program, in);
        if ((features & kFeatureNoise) != 0) setNoise(program, in);
        program.set("countedAs", countedAs);
        batch_.drawHulls(i);
    }
}

void AirPass::list(Resources& resources) const {
    for (const auto& [features, program] : variants_) gl::listProgram(resources, program);
    gl::listTexture(resources, "noise", GL_TEXTURE_3D, noise_);
    rules_.list(resources);
    batch_.list(resources, "beams in the air");
}

}  // namespace hazer::render
