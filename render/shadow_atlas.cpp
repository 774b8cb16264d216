#include "render/shadow_atlas.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

namespace hazer::render {
namespace {

struct Square {
    glm::ivec2 originPx{0};
    int size = 0;
};

bool overlap(const Square& a, const Square& b) {
    return a.originPx.x < b.originPx.x + b.size && b.originPx.x < a.originPx.x + a.size &&
           a.originPx.y < b.originPx.y + b.size && b.originPx.y < a.originPx.y + a.size;
}

/// Quarter i of a square.
Square quarter(const Square& whole, int i) {
    const int half = whole.size / 2;
    return {whole.originPx + glm::ivec2((i & 1) * half, (i >> 1) * half), half};
}

/// The largest squares of `whole`, halved and halved again, that none of `used` touches. `used` lie on the
/// same grid.
void collectFree(const Square& whole, const std::vector<Square>& used, std::vector<Square>& free) {
    std::vector<Square> inside;
    std::copy_if(used.begin(), used.end(), std::back_inserter(inside),
                 [&](const Square& square) { return overlap(square, whole); });
    if (inside.empty()) {
        free.push_back(whole);
    } else if (inside.front().size < whole.size) {
        for (int i = 0; i < 4; ++i) collectFree(quarter(whole, i), inside, free);
    }
}

/// Takes a square of this size out of the smallest free one that holds it.
std::optional<Square> takeFrom(std::vector<Square>& free, int size) {
    auto best = free.end();
    for (auto it = free.begin(); it != free.end(); ++it) {
        if (it->size >= size && (best == free.end() || it->size < best->size)) best = it;
    }
    if (best == free.end()) return std::nullopt;
    Square square = *best;
    free.erase(best);
    while (square.size > size) {
        for (int i = 1; i < 4; ++i) free.push_back(quarter(square, i));
        square = quarter(square, 0);
    }
    return square;
}

/// Indices of the requests without a place, the largest first: squares of powers of two fill a square so
/// without a gap.
std::vector<std::size_t> largestFirst(const std::vector<ShadowRequest>& requests,
                                      const std::vector<int>& placed) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (placed[i] < 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return requests[a].sizeTexels > requests[b].sizeTexels;
    });
    return order;
}

}  // namespace

std::vector<ShadowTile> ShadowAtlas::place(const std::vector<ShadowRequest>& requests) {
    ++frame_;
    for (Held& held : held_) {
        held.isTaken = false;
        held.tile.isFresh = false;
    }
    Placed placed(requests.size(), -1);
    keepKnown(requests, placed);
    reuse(requests, placed);
    if (!allocateRest(requests, placed)) {
        std::erase_if(held_, [](const Held& held) { return !held.isTaken; });
        std::fill(placed.begin(), placed.end(), -1);
        for (Held& held : held_) held.isTaken = false;
        keepKnown(requests, placed);
        if (!allocateRest(requests, placed)) repack(requests, placed);
    }
    std::vector<ShadowTile> tiles;
    tiles.reserve(requests.size());
    for (const int held : placed) tiles.push_back(held_[static_cast<std::size_t>(held)].tile);
    return tiles;
}

void ShadowAtlas::take(int held, const ShadowRequest& request) {
    Held& tile = held_[static_cast<std::size_t>(held)];
    tile.isTaken = true;
    tile.lastUsed = frame_;
    if (tile.content == request.content) return;
    tile.content = request.content;
    tile.tile.isFresh = true;
}

void ShadowAtlas::keepKnown(const std::vector<ShadowRequest>& requests, Placed& placed) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const auto known = std::find_if(held_.begin(), held_.end(), [&](const Held& held) {
            return !held.isTaken && held.tile.sizeTexels == requests[i].sizeTexels &&
                   held.content == requests[i].content;
        });
        if (known == held_.end()) continue;
        placed[i] = static_cast<int>(known - held_.begin());
        take(placed[i], requests[i]);
    }
}

void ShadowAtlas::reuse(const std::vector<ShadowRequest>& requests, Placed& placed) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
        if (placed[i] >= 0) continue;
        int oldest = -1;
        for (std::size_t h = 0; h < held_.size(); ++h) {
            if (held_[h].isTaken || held_[h].tile.sizeTexels != requests[i].sizeTexels) continue;
            if (oldest < 0 || held_[h].lastUsed < held_[static_cast<std::size_t>(oldest)].lastUsed) {
                oldest = static_cast<int>(h);
            }
        }
        if (oldest < 0) continue;
        placed[i] = oldest;
        take(oldest, requests[i]);
    }
}

bool ShadowAtlas::allocateRest(const std::vector<ShadowRequest>& requests, Placed& placed) {
    const std::vector<std::size_t> rest = largestFirst(requests, placed);
    if (rest.empty()) return true;
    if (edge_ == 0) return false;
    std::vector<Square> used, free;
    for (const Held& held : held_) used.push_back({held.tile.originPx, held.tile.sizeTexels});
    collectFree({{0, 0}, edge_}, used, free);
    for (const std::size_t i : rest) {
        const std::optional<Square> square = takeFrom(free, requests[i].sizeTexels);
        if (!square) return false;
        held_.push_back({{square->originPx, square->size, true}, requests[i].content, true, frame_});
        placed[i] = static_cast<int>(held_.size()) - 1;
    }
    return true;
}

void ShadowAtlas::repack(const std::vector<ShadowRequest>& requests, Placed& placed) {
    std::vector<int> sizes;
    for (const ShadowRequest& request : requests) sizes.push_back(request.sizeTexels);
    edge_ = std::max(edge_, smallestAtlasEdge(sizes));
    held_.clear();
    std::fill(placed.begin(), placed.end(), -1);
    const bool isPlaced = allocateRest(requests, placed);
    assert(isPlaced);
    static_cast<void>(isPlaced);
}

int smallestAtlasEdge(const std::vector<int>& sizesTexels) {
    std::int64_t texels = 0;
    int edge = 0;
    for (const int size : sizesTexels) {
        texels += std::int64_t{size} * size;
        edge = std::max(edge, size);
    }
    while (std::int64_t{edge} * edge < texels) edge *= 2;
    return edge;
}

}  // namespace hazer::render
