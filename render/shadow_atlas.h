// Which square of the shadow atlas each map has, from frame to frame. No GL.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "render/scene.h"

namespace hazer::render {

/// All that a map's content depends on.
struct ShadowContent {
    glm::dmat4 clipFromWorld{0.0};
    std::vector<std::pair<MeshId, glm::dmat4>> casters;  ///< Mesh, and its worldFromMesh.

    bool operator==(const ShadowContent&) const = default;
};

struct ShadowRequest {
    int sizeTexels = 0;  ///< A power of two.
    ShadowContent content;
};

struct ShadowTile {
    glm::ivec2 originPx{0};
    int sizeTexels = 0;
    bool isFresh = true;  ///< Its content has to be drawn.
};

/// A tile keeps its place and its content as long as the same content of the same size is asked for, whatever
/// lamp asks. Content that nobody asks for stays until its place is needed, so that a lamp that blinks finds
/// its map again.
class ShadowAtlas {
 public:
    /// A tile for each request. No two overlap. The atlas grows to the smallest square that
    /// holds them, and never shrinks; when edge() has
    /// changed, every tile is fresh.
    std::vector<ShadowTile> place(const std::vector<ShadowRequest>& requests);

    /// Texels along both edges; 0 before anything was placed.
    int edge() const { return edge_; }

 private:
    struct Held {
        ShadowTile tile;
        ShadowContent content;
        bool isTaken = false;        ///< By a request of this frame.
        std::uint64_t lastUsed = 0;  ///< Frame.
    };
    /// Per request, an index into held_, or -1.
    using Placed = std::vector<int>;

    void keepKnown(const std::vector<ShadowRequest>& requests, Placed& placed);
    void reuse(const std::vector<ShadowRequest>& requests, Placed& placed);
    bool allocateRest(const std::vector<ShadowRequest>& requests, Placed& placed);
    void repack(const std::vector<ShadowRequest>& requests, Placed& placed);
    void take(int held, const ShadowRequest& request);

    int edge_ = 0;
    std::uint64_t frame_ = 0;
    std::vector<Held> held_;
};

/// Texels along both edges of the smallest atlas that holds tiles of these sizes; 0 for none.
int smallestAtlasEdge(const std::vector<int>& sizesTexels);

}  // namespace hazer::render
