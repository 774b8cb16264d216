#include "app/explanation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "app/assignment.h"
#include "app/room_haze.h"
#include "app/staging.h"
#include "render/asset_list.h"

namespace hazer::app {
namespace {

using Json = nlohmann::ordered_json;

/// What carries light, and how much of it is dark.
struct Lamps {
    std::vector<std::string> names;  ///< Of the beams that Staging::scene() puts into a scene, in its order.
    int dark = 0;                    ///< Those that it leaves out.
};

Lamps lampsOf(const Show& show, const Patch& patch) {
    Lamps lamps;
    for (const ShowLight& light : show.lights) lamps.names.push_back(light.name);
    for (const PatchedFixture& patched : patch.fixtures()) {
        for (const fixtures::BeamState& beam : patched.fixture.state().beams) {
            if (beamFromState(beam)) {
                lamps.names.push_back(patched.fixture.name());
            } else if (beam.type != fixtures::BeamType::kNone) {
                ++lamps.dark;
            }
        }
    }
    return lamps;
}

std::string sizeText(std::size_t bytes) {
    const auto value = static_cast<double>(bytes);
    if (value >= 1e5) return fmt::format("{:.1f} MB", value * 1e-6);
    return value >= 1e3 ? fmt::format("{:.1f} kB", value * 1e-3) : fmt::format("{} bytes", bytes);
}

/// "4.9 MB of bloom 640x360, bloom 320x180".
std::string texturesText(const render::Resources& resources) {
    std::vector<std::string> names;
    for (const render::TextureUse& use : resources.textures) {
        names.push_back(fmt::format("{} {}x{}", use.name, use.width, use.height));
        if (use.layers > 1) names.back() += fmt::format("x{}", use.layers);
    }
    return fmt::format("{} of {}", sizeText(textureBytes(resources)), fmt::join(names, ", "));
}

/// What a part takes or saves, a line for each kind of thing.
std::vector<std::string> contentLines(const render::FramePart& part) {
    std::vector<std::string> lines;
    const auto list = [&](const char* kind, const std::vector<std::string>& things) {
        if (!things.empty()) lines.push_back(fmt::format("{} {}", kind, fmt::join(things, ", ")));
    };
    list("passes:", part.passes);
    list("shaders:", part.resources.shaders);
    list("shader code:", part.features);
    if (!part.resources.textures.empty()) lines.push_back("textures: " + texturesText(part.resources));
    const std::size_t buffers = bufferBytes(part.resources);
    if (buffers > 0) lines.push_back("buffers: " + sizeText(buffers));
    return lines;
}

std::string partText(const render::FramePart& part) {
    std::string text = fmt::format("  {:24}{}\n", part.name, part.reason);
    const char* verb = part.needed ? "takes" : "saves";
    for (const std::string& line : contentLines(part)) {
        text += fmt::format("  {:24}{:6}{}\n", "", verb, line);
        verb = "";
    }
    return text;
}

std::string partsText(const std::vector<render::FramePart>& parts, bool needed) {
    std::string text;
    for (const render::FramePart& part : parts) {
        if (part.needed == needed) text += partText(part);
    }
    return text;
}

std::string totalsText(const Explanation& explanation) {
    const render::PlanSummary& summary = explanation.summary;
    const render::Resources all = neededResources(summary);
    return fmt::format("{}, camera '{}', {}x{}: {} of {} lamps lit, {} passes, {} shaders, {}\n",
                       explanation.show, explanation.camera, explanation.width, explanation.height,
                       summary.litLamps, summary.litLamps + summary.darkLamps, summary.passes.size(),
                       all.shaders.size(), sizeText(textureBytes(all) + bufferBytes(all)));
}

const std::string& lampName(const Explanation& explanation, int beam) {
    return explanation.lamps[static_cast<std::size_t>(beam)];
}

std::string variantsText(const Explanation& explanation) {
    if (explanation.summary.variants.empty()) return {};
    std::string text = "\nBeams by shader\n";
    for (const render::VariantUse& variant : explanation.summary.variants) {
        text += fmt::format("  {:24}{} {} by {}\n", variant.pass, variant.beams,
                            variant.beams == 1 ? "beam" : "beams", variant.shader);
    }
    return text;
}

std::string shadowsText(const Explanation& explanation) {
    std::string text;
    for (const render::ShadowTileUse& tile : explanation.summary.shadowTiles) {
        text += fmt::format("  {:24}{}x{}, {} {}\n", lampName(explanation, tile.beam), tile.sizeTexels,
                            tile.sizeTexels, tile.casters, tile.casters == 1 ? "caster" : "casters");
    }
    for (const int beam : explanation.summary.shadowsLeftOut) {
        text += fmt::format("  {:24}none, for want of memory: it shines through its casters\n",
                            lampName(explanation, beam));
    }
    return text.empty() ? text : "\nShadow maps\n" + text;
}

Json resourcesJson(const render::Resources& resources) {
    Json json{{"shaders", resources.shaders}, {"textures", Json::array()}, {"buffers", Json::array()}};
    for (const render::TextureUse& use : resources.textures) {
        json["textures"].push_back({{"name", use.name},
                                    {"size", {use.width, use.height, use.layers}},
                                    {"levels", use.levels},
                                    {"bytes", use.bytes}});
    }
    for (const render::BufferUse& use : resources.buffers) {
        json["buffers"].push_back({{"name", use.name}, {"bytes", use.bytes}});
    }
    return json;
}

Json partJson(const render::FramePart& part) {
    Json json{{"name", part.name},
              {"needed", part.needed},
              {"reason", part.reason},
              {"passes", part.passes},
              {"features", part.features}};
    json.update(resourcesJson(part.resources));
    return json;
}

Json shadowsJson(const Explanation& explanation) {
    Json maps = Json::array();
    for (const render::ShadowTileUse& tile : explanation.summary.shadowTiles) {
        maps.push_back({{"lamp", lampName(explanation, tile.beam)},
                        {"size", tile.sizeTexels},
                        {"casters", tile.casters}});
    }
    return maps;
}

Json leftOutJson(const Explanation& explanation) {
    Json lamps = Json::array();
    for (const int beam : explanation.summary.shadowsLeftOut) lamps.push_back(lampName(explanation, beam));
    return lamps;
}

}  // namespace

Explanation explainShow(const Show& show, const ExplainRequest& request) {
    const ShowCamera& camera = request.camera.empty() ? show.cameras.front() : show.camera(request.camera);
    Patch patch(show);
    for (const std::string& warning : patch.fileWarnings())
        spdlog::warn("{}: {}", show.file.string(), warning);
    for (const std::string& assignment : request.assignments) assign(assignment, patch);
    patch.settle();
    render::AssetList assets;
    Staging staging(show, assets);
    warnAboutRig(show, staging);
    SceneControls controls = controlsOf(show);
    RoomHaze roomHaze;
    roomHaze.settle(supplyOf(patch));
    roomHaze.addTo(controls.haze);
    const render::Scene scene = staging.scene(patch, controls, 0.0);
    render::Settings settings;
    settings.width = request.width;
    settings.height = request.height;
    settings.integrator = request.integrator;
    settings.bloom = request.bloom;
    Lamps lamps = lampsOf(show, patch);
    const render::ScenePlan plan =
        render::planScene(scene, camera.camera, settings, assets.meshBounds(), assets.webs());
    return {show.title,
            camera.name,
            request.width,
            request.height,
            render::summarizePlan({scene, camera.camera, settings, plan, assets.counts(), lamps.dark}),
            std::move(lamps.names)};
}

std::string explanationText(const Explanation& explanation) {
    const render::PlanSummary& summary = explanation.summary;
    return totalsText(explanation) + fmt::format("Passes: {}\n", fmt::join(summary.passes, ", ")) +
           "\nNeeded\n" + partsText(summary.parts, true) + "\nLeft out\n" + partsText(summary.parts, false) +
           variantsText(explanation) + shadowsText(explanation);
}

Json explanationJson(const Explanation& explanation) {
    const render::PlanSummary& summary = explanation.summary;
    const render::Resources all = neededResources(summary);
    Json json{{"show", explanation.show},
              {"camera", explanation.camera},
              {"size", {explanation.width, explanation.height}},
              {"lamps", {{"lit", summary.litLamps}, {"dark", summary.darkLamps}}},
              {"passes", summary.passes},
              {"shaders", all.shaders.size()},
              {"texture_bytes", textureBytes(all)},
              {"buffer_bytes", bufferBytes(all)},
              {"parts", Json::array()},
              {"variants", Json::array()},
              {"shadow_maps", shadowsJson(explanation)},
              {"shadows_left_out", leftOutJson(explanation)}};
    for (const render::FramePart& part : summary.parts) json["parts"].push_back(partJson(part));
    for (const render::VariantUse& variant : summary.variants) {
        json["variants"].push_back(
            {{"pass", variant.pass}, {"shader", variant.shader}, {"beams", variant.beams}});
    }
    return json;
}

}  // namespace hazer::app
