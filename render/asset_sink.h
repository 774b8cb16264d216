// Where scenes put what they refer to by handle: meshes, gobos, webs.
#pragma once

#include <cstdint>

#include "render/ies_web.h"
#include "render/mesh.h"
#include "render/scene.h"

namespace hazer::render {

class AssetSink {
 public:
    virtual ~AssetSink() = default;

    virtual MeshId addMesh(const Mesh& mesh) = 0;

    /// Takes an sRGB RGBA picture, row 0 on top: transmission = linear RGB x alpha. The inscribed circle of
    /// the picture is the field of the beam. Pictures of any size; they are resampled to 512 x 512.
    virtual GoboId addGobo(const std::uint8_t* rgba, int width, int height) = 0;

    /// Takes a photometric web, for beams that have it as their `web`.
    virtual WebId addWeb(const IesWeb& web) = 0;
};

}  // namespace hazer::render
