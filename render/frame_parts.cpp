#include "render/frame_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <set>

#include "render/beam_width.h"
#include "render/gobo_picture.h"
#include "render/gobo_table_plan.h"
#include "render/gobo_table_slots.h"
#include "render/gpu_beam.h"
#include "render/noise_volume.h"
#include "render/passes/beam_batch.h"
#include "render/passes/bloom_pass.h"
#include "render/passes/display_grid.h"
#include "render/passes/surface_pass.h"
#include "render/passes/texel_sum.h"
#include "render/profile_rule.h"
#include "render/shadow_projection.h"

namespace hazer::render {
namespace {

constexpr const char* kNoLampIsLit = "no lamp is lit";
constexpr const char* kNoLightInTheAir = "there is no light in the air";

/// Bytes of a texel.
constexpr int kRgba32F = 16;
constexpr int kRgba16 = 8;
constexpr int kRgba16F = 8;
constexpr int kRgba8 = 4;
constexpr int kDepth32F = 4;
constexpr int kDepth16 = 2;
constexpr int kR32F = 4;
constexpr int kR16F = 2;

/// One level. A volume counts its slices as layers.
TextureUse texture(const char* name, int width, int height, int bytesPerTexel, int layers = 1) {
    const std::size_t texels =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(layers);
    return {name, width, height, layers, 1, texels * static_cast<std::size_t>(bytesPerTexel)};
}

/// Down to a single texel.
int allMipLevels(int width, int height) {
    return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

/// The same with mip levels; the layers of an array stay as many.
TextureUse withMipLevels(TextureUse use, int levels) {
    const std::size_t bytesPerTexel =
        use.bytes / (static_cast<std::size_t>(use.width) * static_cast<std::size_t>(use.height));
    use.levels = levels;
    use.bytes = 0;
    for (int level = 0; level < use.levels; ++level) {
        use.bytes += static_cast<std::size_t>(std::max(use.width >> level, 1)) *
                     static_cast<std::size_t>(std::max(use.height >> level, 1)) * bytesPerTexel;
    }
    return use;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "1 of 5 lit lamps has", "2 of 5 lit lamps have"; "the lit lamp has" where there is but one.
std::string ofLit(std::size_t count, const SummaryInputs& in, const char* has, const char* have,
                  const char* what) {
    if (in.plan.lit.size() == 1) return fmt::format("the lit lamp {} {}", has, what);
    return fmt::format("{} of {} lit lamps {} {}", count, in.plan.lit.size(), count == 1 ? has : have, what);
}

template <typename Test>
std::size_t countLit(const SummaryInputs& in, Test test) {
    return static_cast<std::size_t>(std::ranges::count_if(
        in.plan.lit, [&](int index) { return test(in.scene.beams[static_cast<std::size_t>(index)]); }));
}

std::vector<std::string> shadersOf(const char* fragmentFile, const std::vector<BeamGroup>& groups) {
    std::vector<std::string> names;
    for (const BeamGroup& group : groups)
        names.push_back(shaderName(fragmentFile, featureDefines(group.features)));
    if (names.empty()) names.emplace_back(fragmentFile);
    return names;
}

FramePart named(const char* name, bool needed) {
    FramePart part;
    part.name = name;
    part.needed = needed;
    return part;
}

/// Instances of the beams of a pass, and the hull that it draws them with.
std::vector<BufferUse> beamBuffers(const char* name, std::size_t beams) {
    return {{name, beams * sizeof(GpuBeam)}, {"beam hull", beamHullBytes()}};
}

std::size_t beamsIn(const std::vector<BeamGroup>& groups) {
    std::size_t beams = 0;
    for (const BeamGroup& group : groups) beams += group.beams.size();
    return beams;
}

FramePart picture(const SummaryInputs& in) {
    const int width = in.settings.width;
    const int height = in.settings.height;
    const glm::ivec2 blocks = displayBlocks(width, height);
    FramePart part = named("picture", true);
    part.reason = "every frame has one";
    part.passes = {"block means", "display grid", "tone map", "antialias"};
    part.resources.textures = {
        texture("radiance", width, height, kRgba32F), texture("tone mapped", width, height, kRgba8),
        texture("display", width, height, kRgba8), texture("display mask", width, height, kDepth16)};
    for (const char* name : {"block means", "blocks shown", "blocks marked"})
        part.resources.textures.push_back(texture(name, blocks.x, blocks.y, kRgba32F));
    part.resources.shaders = {"block_mean.frag", "block_mark.frag", "block_between.frag", "antialias.frag"};
    for (const char* shader : {"block_shown.frag", "tone_map.frag"})
        part.resources.shaders.push_back(in.plan.bloom ? shaderName(shader, {"BLOOM"}) : shader);
    return part;
}

FramePart bodies(const SummaryInputs& in) {
    const int width = in.settings.width;
    const int height = in.settings.height;
    const glm::ivec2 table = materialTableSize(in.scene.instances.size());
    FramePart part = named("bodies", in.plan.surfaces);
    part.reason = part.needed ? counted(in.scene.instances.size(), "body is drawn", "bodies are drawn")
                              : "the scene has no body";
    part.passes = {"surfaces"};
    part.resources.textures = {
        texture("distance", width, height, kR32F), texture("shape", width, height, kRgba16),
        texture("depth", width, height, kDepth32F), texture("materials", table.x, table.y, kRgba32F)};
    part.resources.shaders = {"surface.frag"};
    return part;
}

FramePart background(const SummaryInputs& in) {
    FramePart part = named("bare background", !in.plan.surfaces);
    part.reason = part.needed ? "the scene has no body" : "bodies are drawn over the background";
    part.passes = {"background"};
    part.resources.textures = {texture("sky", 1, 1, kR32F)};
    return part;
}

/// They stay, so that a body that comes back is there at once.
FramePart meshes(const SummaryInputs& in) {
    FramePart part = named("meshes", in.assets.meshBytes > 0);
    part.reason = part.needed ? "bodies that the scene has, or may have in a later frame" : "there are none";
    part.resources.buffers = {{"meshes", in.assets.meshBytes}};
    return part;
}

FramePart surfaceLight(const SummaryInputs& in) {
    const std::size_t beams = beamsIn(in.plan.surfaceGroups);
    FramePart part = named("light on surfaces", !in.plan.surfaceGroups.empty());
    part.reason = part.needed           ? ofLit(beams, in, "reaches", "reach", "a body")
                  : in.plan.lit.empty() ? kNoLampIsLit
                  : !in.plan.surfaces   ? "the scene has no body"
                                        : "no lit lamp reaches a body";
    part.passes = {"lit surfaces"};
    part.resources.shaders = shadersOf("lit_surface.frag", in.plan.surfaceGroups);
    part.resources.buffers = beamBuffers("beams on surfaces", part.needed ? beams : in.plan.lit.size());
    return part;
}

FramePart air(const SummaryInputs& in) {
    FramePart part = named("light in the air", in.plan.air);
    part.reason = part.needed           ? fmt::format("{} into haze that scatters {} /m{}",
                                                      counted(in.plan.lit.size(), "lit lamp shines", "lit lamps shine"),
                                                      in.plan.haze.scatteringPerM,
                                            in.scene.haze.deltaEddington ? " beside its forward peak" : "")
                  : in.plan.lit.empty() ? kNoLampIsLit
                                        : "the haze scatters nothing";
    part.passes = {"beams"};
    part.resources.shaders = shadersOf("air.frag", in.plan.airGroups);
    part.resources.buffers = beamBuffers("beams in the air", in.plan.lit.size());
    return part;
}

std::string whyNoGrid(const SummaryInputs& in) {
    if (!in.plan.air) return kNoLightInTheAir;
    if (in.settings.integrator == Integrator::kUniform)
        return "the thesis' integrator is drawn as it is, for comparison";
    if (in.settings.samples > 0) return "a given number of samples is drawn as it is, for comparison";
    if (in.settings.maxError > 0.0 && in.settings.airStep == 0)
        return "integrating every pixel is cheaper, or the error asked for wants it";
    return "the settings ask for every pixel to be integrated";
}

FramePart airGrid(const SummaryInputs& in) {
    const int step = in.plan.airStep;
    FramePart part = named("coarse grid of the air", in.plan.air && step > 1);
    part.reason =
        part.needed ? fmt::format("every {}th pixel of the air is integrated first", step) : whyNoGrid(in);
    part.resources.shaders = {"air_nodes.frag", "air_between.frag", "sum_texels.frag"};
    if (step < 2) return part;
    const glm::ivec2 nodes = nodeCount(in.settings, step);
    part.resources.textures = {texture("grid nodes", nodes.x, nodes.y, kRgba32F),
                               texture("judged grid nodes", nodes.x, nodes.y, kRgba32F),
                               texture("judged grid mask", nodes.x, nodes.y, kDepth16),
                               texture("grid mask", in.settings.width, in.settings.height, kDepth16)};
    for (const glm::ivec2& size : texelSumSizes(nodes))
        part.resources.textures.push_back(texture("grid sums", size.x, size.y, kRgba32F));
    return part;
}

FramePart thinBeams(const SummaryInputs& in) {
    const int step = in.plan.airStep;
    const auto isThin = [&](int index) {
        const auto beam = static_cast<std::size_t>(index);
        return isThinOnScreen(in.scene.beams[beam], in.plan.shapes[beam], in.camera, in.settings.height,
                              step);
    };
    const auto thin = static_cast<std::size_t>(std::ranges::count_if(in.plan.lit, isThin));
    const bool hasGrid = in.plan.air && step > 1;
    FramePart part = named("thin beams", hasGrid && thin > 0);
    part.reason = !hasGrid ? "without a coarse grid no beam can slip through it"
                  : thin > 0
                      ? ofLit(thin, in, "is", "are", "so thin on the screen that the grid would miss it")
                      : "no lit lamp's beam is so thin on the screen that the grid could miss it";
    return part;
}

FramePart noise(const SummaryInputs& in) {
    FramePart part = named("noise in the haze", usesFeature(in.plan, kFeatureNoise));
    part.reason = part.needed    ? fmt::format("noise is {}", in.scene.haze.noise.amount)
                  : !in.plan.air ? kNoLightInTheAir
                                 : "noise is 0";
    part.features = featureDefines(kFeatureNoise);
    TextureUse volume = texture("noise", kNoiseSize, kNoiseSize, kR32F, kNoiseSize);
    volume.levels = allMipLevels(kNoiseSize, kNoiseSize);
    for (std::size_t size = kNoiseSize / 2; size > 0; size /= 2) volume.bytes += size * size * size * kR32F;
    part.resources.textures = {volume};
    return part;
}

FramePart uniformSamples(const SummaryInputs& in) {
    const bool isUniform = in.settings.integrator == Integrator::kUniform;
    FramePart part = named("uniform samples", in.plan.air && isUniform);
    part.reason = part.needed    ? "the thesis' integrator was asked for"
                  : !in.plan.air ? kNoLightInTheAir
                                 : "light in the air is integrated over the angle at the lamp";
    part.features = featureDefines(kFeatureUniform);
    return part;
}

FramePart profile(const SummaryInputs& in) {
    const auto isSoft = [&](int index) {
        const auto beam = static_cast<std::size_t>(index);
        return in.scene.beams[beam].web < 0 && in.plan.shapes[beam].exponent > 0.0;
    };
    const auto soft = static_cast<std::size_t>(std::ranges::count_if(in.plan.lit, isSoft));
    FramePart part = named("soft profile", soft > 0);
    part.reason = part.needed           ? ofLit(soft, in, "has", "have", "a soft edge")
                  : in.plan.lit.empty() ? kNoLampIsLit
                                        : "no lit lamp has a soft edge";
    part.features = {"!FLAT_PROFILE"};
    if (!part.needed || usesProfileRules(in.plan)) {
        part.resources.textures = {texture("profile rules", kProfileRuleColumns, kProfileRuleRows, kRgba32F)};
    }
    return part;
}

FramePart gobos(const SummaryInputs& in) {
    const std::size_t count = countLit(in, [](const Beam& beam) { return beam.gobo >= 0; });
    FramePart part = named("gobos", usesFeature(in.plan, kFeatureGobo));
    if (part.needed) {
        part.reason = count > 0 ? ofLit(count, in, "has", "have", "a gobo")
                                : "composed apertures are looked at like gobos";
    } else if (in.plan.lit.empty()) {
        part.reason = kNoLampIsLit;
    } else if (count == 0) {
        part.reason = "no lit lamp has a gobo";
    } else {
        part.reason = in.settings.gobos
                          ? "there is neither light in the air nor a body or lens to see a gobo on"
                          : "gobos are switched off";
    }
    part.features = featureDefines(kFeatureGobo);
    part.resources.textures = {withMipLevels(
        texture("gobos", kGoboSize, kGoboSize, kRgba8,
                std::max(in.assets.gobos + static_cast<int>(in.plan.apertures.composed.size()), 1)),
        kGoboLevels)};
    return part;
}

std::string whyApertures(const SummaryInputs& in) {
    const std::vector<int>& ofBeam = in.plan.apertures.ofBeam;
    const auto isComposed = [](int picture) { return picture >= 0; };
    const auto beams = static_cast<std::size_t>(std::ranges::count_if(ofBeam, isComposed));
    std::string reason = ofLit(beams, in, "has", "have", "more than a gobo in the way");
    const std::size_t leftOut = in.plan.apertures.leftOut.size();
    if (leftOut > 0)
        reason += fmt::format("; {}, for want of memory",
                              counted(leftOut, "further one shines without", "further ones shine without"));
    return reason;
}

std::vector<std::string> apertureShaders(const SummaryInputs& in) {
    std::set<std::string> names;
    for (const ComposedAperture& aperture : in.plan.apertures.composed)
        names.insert(shaderName("aperture.frag", apertureFeatures(aperture)));
    if (names.empty()) names.insert("aperture.frag");
    return {names.begin(), names.end()};
}

FramePart apertures(const SummaryInputs& in) {
    FramePart part = named("composed apertures", !in.plan.apertures.composed.empty());
    part.reason = part.needed           ? whyApertures(in)
                  : in.plan.lit.empty() ? kNoLampIsLit
                  : in.settings.gobos
                      ? "no lit lamp that is seen has more in its way than a gobo or an iris alone"
                      : "gobos are switched off";
    part.passes = {"apertures"};
    part.resources.shaders = apertureShaders(in);
    part.resources.textures = {withMipLevels(texture("aperture", kGoboSize, kGoboSize, kRgba8), kGoboLevels)};
    return part;
}

FramePart goboTables(const SummaryInputs& in) {
    std::set<GoboTableKey> tables;
    std::size_t beams = 0;
    for (const GoboTableKey& key : goboTableKeys(in.scene, in.settings, in.plan)) {
        if (key.gobo < 0) continue;
        tables.insert(key);
        ++beams;
    }
    int layers = 0;
    for (const GoboTableKey& key : tables)
        layers += in.assets.layersOfGoboTables[static_cast<std::size_t>(key.gobo)];
    FramePart part = named("tables of gobos", beams > 0);
    part.reason = part.needed           ? ofLit(beams, in, "sends", "send", "a gobo through the haze")
                  : in.plan.lit.empty() ? kNoLampIsLit
                  : in.plan.air && usesFeature(in.plan, kFeatureGobo)
                      ? "gobos in the air are sampled: none is in a beam of up to 70 degrees, or so the "
                        "settings ask for"
                      : "no lit lamp sends a gobo through the haze";
    part.resources.textures = {texture("gobo tables", kGoboTableWidth, kGoboTableHeight, kRgba16F,
                                       std::clamp(layers, 1, kMostGoboTableLayers))};
    return part;
}

FramePart webs(const SummaryInputs& in) {
    const std::size_t count = countLit(in, [](const Beam& beam) { return beam.web >= 0; });
    FramePart part = named("photometric webs", usesFeature(in.plan, kFeatureWeb));
    if (part.needed) {
        part.reason = ofLit(count, in, "has", "have", "a photometric web");
    } else if (in.plan.lit.empty()) {
        part.reason = kNoLampIsLit;
    } else {
        part.reason =
            count == 0 ? "no lit lamp has a photometric web" : "nothing of the lamps that have one is seen";
    }
    part.features = featureDefines(kFeatureWeb);
    part.resources.textures = {texture("webs", kWebAzimuths, kWebThetas, kR16F, std::max(in.assets.webs, 1))};
    return part;
}

std::string whyNoShadow(const SummaryInputs& in) {
    if (in.plan.lit.empty()) return kNoLampIsLit;
    if (!in.plan.air && !in.plan.surfaces)
        return "there is neither light in the air nor a body to see a shadow on";
    if (!in.settings.shadows) return "shadows are switched off";
    if (std::ranges::none_of(in.scene.instances, &MeshInstance::castsShadow)) return "no body casts a shadow";
    if (countLit(in, [](const Beam& beam) { return beam.castsShadow; }) == 0)
        return "no lit lamp casts shadows";
    return "no caster stands in any lit cone";
}

std::string whyShadows(const SummaryInputs& in) {
    std::string reason = ofLit(in.plan.shadowMaps.size(), in, "has", "have", "a caster in the cone");
    if (!in.plan.shadowsLeftOut.empty()) {
        reason += fmt::format("; the {} dimmest further ones shine through theirs, for want of memory",
                              in.plan.shadowsLeftOut.size());
    }
    return reason;
}

FramePart shadows(const SummaryInputs& in) {
    FramePart part = named("shadow maps", !in.plan.shadowMaps.empty());
    part.reason = part.needed ? whyShadows(in) : whyNoShadow(in);
    part.passes = {"shadow maps"};
    part.features = featureDefines(kFeatureShadow);
    // Without any: what one lamp would take at most.
    const int edge = part.needed ? in.plan.shadowAtlasEdge : kLargestShadowTile;
    int records = part.needed ? 0 : 1;
    for (const ShadowMapPlan& map : in.plan.shadowMaps) records += faceRecordCount(map);
    const int texelsPerRecord = sizeof(ShadowFaceRecord) / kRgba32F;
    part.resources.textures = {texture("shadow maps", edge, edge, kDepth32F),
                               texture("shadow faces", records * texelsPerRecord, 1, kRgba32F)};
    part.resources.shaders = {"shadow.frag"};
    return part;
}

FramePart wideLamps(const SummaryInputs& in) {
    const auto wide =
        static_cast<std::size_t>(std::ranges::count_if(in.plan.shadowMaps, &ShadowMapPlan::isWide));
    FramePart part = named("shadows all around", usesFeature(in.plan, kFeatureWide));
    part.reason = part.needed ? ofLit(wide, in, "is", "are", "so wide that casters may stand all around")
                  : in.plan.shadowMaps.empty() ? "there are no shadow maps"
                                               : "no lamp with a shadow map is wider than 140 degrees";
    part.features = featureDefines(kFeatureWide);
    return part;
}

/// Beams in the air that are drawn with a feature.
std::size_t beamsWith(const SummaryInputs& in, LightFeature feature) {
    std::size_t beams = 0;
    for (const BeamGroup& group : in.plan.airGroups)
        beams += (group.features & feature) != 0 ? group.beams.size() : 0;
    return beams;
}

/// Code that some beams in the air need. `thesis` says why the thesis' integrator has none of it, `none` why
/// no beam needs it.
FramePart beamCode(const SummaryInputs& in, LightFeature feature, const char* name, const char* thesis,
                   const char* none) {
    FramePart part = named(name, usesFeature(in.plan, feature));
    part.reason = !in.plan.air                                     ? kNoLightInTheAir
                  : in.settings.integrator == Integrator::kUniform ? thesis
                                                                   : none;
    part.features = featureDefines(feature);
    return part;
}

FramePart lampsBackwards(const SummaryInputs& in) {
    FramePart part =
        beamCode(in, kFeatureBackwards, "light backwards", "the thesis' integrator takes every angle alike",
                 "no lit lamp without a web is wider than 180 degrees");
    if (part.needed)
        part.reason = ofLit(beamsWith(in, kFeatureBackwards), in, "shines", "shine", "backwards, too");
    return part;
}

FramePart lines(const SummaryInputs& in) {
    FramePart part =
        beamCode(in, kFeatureLine, "beams as lines", "the thesis' integrator takes every pixel's ray alone",
                 "no lit lamp's beam is thinner than two pixels over a length");
    if (part.needed) {
        part.reason =
            ofLit(beamsWith(in, kFeatureLine), in, "is", "are", "thinner than two pixels over a length");
    }
    return part;
}

FramePart lenses(const SummaryInputs& in) {
    const std::size_t shown = beamsIn(in.plan.lenses);
    FramePart part = named("lenses", shown > 0);
    part.reason = part.needed           ? ofLit(shown, in, "shows", "show", "a lens")
                  : in.plan.lit.empty() ? kNoLampIsLit
                                        : "no lit lamp shows a lens that has a size";
    part.passes = {"lenses"};
    part.resources.shaders = shadersOf("lens.frag", in.plan.lenses);
    part.resources.buffers = beamBuffers("beams of lenses", part.needed ? shown : in.plan.lit.size());
    return part;
}

FramePart bloom(const SummaryInputs& in) {
    FramePart part = named("bloom", in.plan.bloom);
    part.reason = part.needed ? "the picture is for people" : "bloom is switched off";
    part.passes = {"bloom"};
    part.resources.shaders = {"bloom_down.frag", "bloom_up.frag"};
    const glm::ivec2 blocks = displayBlocks(in.settings.width, in.settings.height);
    part.resources.textures = {texture("block bloom", blocks.x, blocks.y, kRgba32F)};
    for (const glm::ivec2& size : bloomLevelSizes(blocks))
        part.resources.textures.push_back(texture("bloom", size.x, size.y, kRgba32F));
    return part;
}

FramePart darkLamps(const SummaryInputs& in) {
    const std::size_t dark =
        in.scene.beams.size() - in.plan.lit.size() + static_cast<std::size_t>(in.darkLampsBesides);
    FramePart part = named("dark lamps", false);
    part.reason = dark == 0 ? "no lamp is dark"
                            : fmt::format("{} of {} lamps {} dark", dark, dark + in.plan.lit.size(),
                                          dark == 1 ? "is" : "are");
    if (dark > 0) part.resources.buffers = {{"their beams", dark * sizeof(GpuBeam)}};
    return part;
}

}  // namespace

std::vector<FramePart> frameParts(const SummaryInputs& in) {
    return {
        picture(in), bodies(in),    background(in),     meshes(in),     surfaceLight(in),
        air(in),     airGrid(in),   thinBeams(in),      noise(in),      uniformSamples(in),
        profile(in), gobos(in),     apertures(in),      goboTables(in), webs(in),
        shadows(in), wideLamps(in), lampsBackwards(in), lines(in),      lenses(in),
        bloom(in),   darkLamps(in),
    };
}

}  // namespace hazer::render
