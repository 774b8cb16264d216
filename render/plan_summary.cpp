#include "render/plan_summary.h"

#include <algorithm>
#include <array>

#include "render/frame_parts.h"

namespace hazer::render {
namespace {

/// All passes in the order of Renderer::render.
constexpr std::array kPassOrder{"apertures",    "shadow maps",  "surfaces", "background",
                                "lit surfaces", "beams",        "lenses",   "block means",
                                "bloom",        "display grid", "tone map", "antialias"};

std::vector<std::string> passesOf(const std::vector<FramePart>& parts) {
    std::vector<std::string> passes;
    for (const char* pass : kPassOrder) {
        const auto draws = [&](const FramePart& part) {
            return part.needed && std::ranges::find(part.passes, pass) != part.passes.end();
        };
        if (std::ranges::any_of(parts, draws)) passes.emplace_back(pass);
    }
    return passes;
}

void appendVariants(const char* pass, const char* fragmentFile, const std::vector<BeamGroup>& groups,
                    std::vector<VariantUse>& variants) {
    for (const BeamGroup& group : groups) {
        variants.push_back(
            {pass, shaderName(fragmentFile, featureDefines(group.features)), group.beams.size()});
    }
}

template <typename Use>
void append(const std::vector<Use>& from, std::vector<Use>& to) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

PlanSummary summarizePlan(const SummaryInputs& in) {
    PlanSummary summary;
    summary.litLamps = static_cast<int>(in.plan.lit.size());
    summary.darkLamps = static_cast<int>(in.scene.beams.size()) - summary.litLamps + in.darkLampsBesides;
    summary.parts = frameParts(in);
    summary.passes = passesOf(summary.parts);
    appendVariants("lit surfaces", "lit_surface.frag", in.plan.surfaceGroups, summary.variants);
    appendVariants("beams", "air.frag", in.plan.airGroups, summary.variants);
    appendVariants("lenses", "lens.frag", in.plan.lenses, summary.variants);
    for (const ShadowMapPlan& map : in.plan.shadowMaps) {
        for (const ShadowFacePlan& face : map.faces)
            summary.shadowTiles.push_back({map.beam, face.sizeTexels, face.casters.size()});
    }
    summary.shadowsLeftOut = in.plan.shadowsLeftOut;
    return summary;
}

Resources neededResources(const PlanSummary& summary) {
    Resources all;
    for (const FramePart& part : summary.parts) {
        if (!part.needed) continue;
        append(part.resources.textures, all.textures);
        append(part.resources.buffers, all.buffers);
        append(part.resources.shaders, all.shaders);
    }
    return all;
}

}  // namespace hazer::render
