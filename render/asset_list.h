// What a plan must know of a scene's meshes, gobos and webs, kept without OpenGL.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/asset_sink.h"

namespace hazer::render {

/// What waits for scenes to refer to it.
struct AssetCounts {
    std::size_t meshBytes = 0;  ///< Of vertices and indices.
    int gobos = 0;
    int webs = 0;
    std::vector<int> layersOfGoboTables;  ///< By GoboId: 1 for a grey gobo, 3 for a coloured one.
};

/// Gives out the handles that a Renderer would.
class AssetList : public AssetSink {
 public:
    MeshId addMesh(const Mesh& mesh) override;
    GoboId addGobo(const std::uint8_t* rgba, int width, int height) override;
    WebId addWeb(const IesWeb& web) override;

    /// Indexed by MeshId.
    std::span<const MeshBounds> meshBounds() const { return bounds_; }

    /// Indexed by WebId.
    std::span<const IesWeb> webs() const { return webs_; }

    AssetCounts counts() const {
        return {meshBytes_, static_cast<int>(layersOfGoboTables_.size()), static_cast<int>(webs_.size()),
                layersOfGoboTables_};
    }

 private:
    std::vector<MeshBounds> bounds_;
    std::vector<IesWeb> webs_;
    std::vector<int> layersOfGoboTables_;
    std::size_t meshBytes_ = 0;
};

}  // namespace hazer::render
