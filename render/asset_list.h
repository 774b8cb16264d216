// What a plan must know of a scene's meshes, gobos and webs, kept without OpenGL.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/asset_sink.h"

namespace hazer::render {

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

    int gobos() const { return gobos_; }
    std::size_t meshBytes() const { return meshBytes_; }

 private:
    std::vector<MeshBounds> bounds_;
    std::vector<IesWeb> webs_;
    int gobos_ = 0;
    std::size_t meshBytes_ = 0;
};

}  // namespace hazer::render
