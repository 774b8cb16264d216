// What a frame is made of and what was left out of it, each with its reason. A pure function; no GL.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/asset_list.h"
#include "render/resources.h"
#include "render/scene.h"
#include "render/scene_plan.h"

namespace hazer::render {

/// One part of the frame. What a part that is not needed lists is what leaving it out saves.
struct FramePart {
    std::string name;
    bool needed = false;
    std::string reason;  ///< In terms of the scene, such as "the haze is even".
    std::vector<std::string> passes;
    /// Code in the shaders of beams, by the shaders' names for it; "!NAME" is there where NAME is not.
    std::vector<std::string> features;
    Resources resources;
};

/// Beams that are drawn with the same shader in the same pass.
struct VariantUse {
    std::string pass;
    std::string shader;
    std::size_t beams = 0;
};

/// A tile of the texture of all shadow maps.
struct ShadowTileUse {
    int beam = 0;        ///< Index into Scene::beams. A wide lamp may have several tiles.
    int sizeTexels = 0;  ///< Along both edges.
    std::size_t casters = 0;
};

struct PlanSummary {
    int litLamps = 0;
    int darkLamps = 0;
    std::vector<std::string> passes;  ///< In the order in which they are drawn.
    std::vector<FramePart> parts;
    std::vector<VariantUse> variants;
    std::vector<ShadowTileUse> shadowTiles;
    std::vector<int> shadowsLeftOut;  ///< Beams that shine through their casters, for want of memory.
};

struct SummaryInputs {
    const Scene& scene;
    const Camera& camera;
    const Settings& settings;
    const ScenePlan& plan;  ///< planScene() of the scene and the settings.
    AssetCounts assets;
    int darkLampsBesides = 0;  ///< Dark lamps that are not in the scene at all.
};

/// Settings::countsIntegrals is not looked at.
PlanSummary summarizePlan(const SummaryInputs& in);

/// What a fresh renderer has on the GPU when it has drawn the frame: that of all parts that are needed.
Resources neededResources(const PlanSummary& summary);

}  // namespace hazer::render
