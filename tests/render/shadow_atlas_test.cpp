// Tiles of the shadow atlas: they keep their place, do not overlap, and are drawn only when they must be.
#include "render/shadow_atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hazer::test {
namespace {

using render::ShadowAtlas;
using render::ShadowRequest;
using render::ShadowTile;

/// Content that differs by its number.
ShadowRequest request(int size, int content) {
    ShadowRequest made{size, {}};
    made.content.casters.emplace_back(content, glm::dmat4(1.0));
    return made;
}

int freshOnes(const std::vector<ShadowTile>& tiles) {
    return static_cast<int>(
        std::count_if(tiles.begin(), tiles.end(), [](const auto& tile) { return tile.isFresh; }));
}

bool overlap(const ShadowTile& a, const ShadowTile& b) {
    return a.originPx.x < b.originPx.x + b.sizeTexels && b.originPx.x < a.originPx.x + a.sizeTexels &&
           a.originPx.y < b.originPx.y + b.sizeTexels && b.originPx.y < a.originPx.y + a.sizeTexels;
}

void expectSound(const std::vector<ShadowTile>& tiles, const std::vector<ShadowRequest>& requests, int edge) {
    ASSERT_EQ(tiles.size(), requests.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        EXPECT_EQ(tiles[i].sizeTexels, requests[i].sizeTexels);
        EXPECT_GE(std::min(tiles[i].originPx.x, tiles[i].originPx.y), 0);
        EXPECT_LE(std::max(tiles[i].originPx.x, tiles[i].originPx.y) + tiles[i].sizeTexels, edge);
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(tiles[i], tiles[j]));
    }
}

TEST(ShadowAtlas, NothingAskedForNothingHeld) {
    ShadowAtlas atlas;
    EXPECT_TRUE(atlas.place({}).empty());
    EXPECT_EQ(atlas.edge(), 0);
}

TEST(ShadowAtlas, AStillLampKeepsItsTileAndItsContent) {
    ShadowAtlas atlas;
    std::vector<ShadowRequest> requests{request(256, 1), request(512, 2), request(64, 3)};
    const std::vector<ShadowTile> first = atlas.place(requests);
    EXPECT_EQ(freshOnes(first), 3);
    const std::vector<ShadowTile> second = atlas.place(requests);
    EXPECT_EQ(freshOnes(second), 0);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(first[i].originPx, second[i].originPx);
    // One moves; the others stay, also when the list begins with another lamp.
    requests[1] = request(512, 4);
    requests.insert(requests.begin(), request(64, 5));
    const std::vector<ShadowTile> third = atlas.place(requests);
    EXPECT_EQ(freshOnes(third), 2);
    EXPECT_FALSE(third[1].isFresh || third[3].isFresh);
    EXPECT_EQ(third[1].originPx, first[0].originPx);
    EXPECT_EQ(third[2].originPx, first[1].originPx) << "a lamp that moves draws into its own tile";
}

TEST(ShadowAtlas, ALampThatBlinksFindsItsMapAgain) {
    ShadowAtlas atlas;
    const std::vector<ShadowRequest> both{request(128, 1), request(128, 2)};
    atlas.place(both);
    atlas.place({both[0]});
    EXPECT_EQ(freshOnes(atlas.place(both)), 0);
}

TEST(ShadowAtlas, GrowsOnlyAsNeeded) {
    ShadowAtlas atlas;
    atlas.place({request(128, 1)});
    EXPECT_EQ(atlas.edge(), 128);
    const std::vector<ShadowTile> tiles = atlas.place({request(128, 1), request(64, 2)});
    EXPECT_EQ(atlas.edge(), 256);
    EXPECT_EQ(freshOnes(tiles), 2) << "a new texture holds nothing yet";
    // A lamp that moves for a thousand frames needs no more room than one that stands.
    for (int i = 0; i < 1000; ++i) atlas.place({request(128, 1), request(64, 3 + i)});
    EXPECT_EQ(atlas.edge(), 256);
}

TEST(ShadowAtlas, FillsASquareToTheLastTexel) {
    ShadowAtlas atlas;
    std::vector<ShadowRequest> requests;
    for (int i = 0; i < 256; ++i) requests.push_back(request(256, i));
    expectSound(atlas.place(requests), requests, 4096);
    EXPECT_EQ(atlas.edge(), 4096);
    // Three quarters in one size, one in another, in an order that does not help.
    std::vector<ShadowRequest> mixed;
    for (int i = 0; i < 16; ++i) mixed.push_back(request(512, 1000 + i));
    for (int i = 0; i < 12; ++i) mixed.push_back(request(1024, 2000 + i));
    expectSound(atlas.place(mixed), mixed, 4096);
    EXPECT_EQ(atlas.edge(), 4096);
}

TEST(ShadowAtlas, StaysSoundWhateverComes) {
    std::mt19937 random(4);
    ShadowAtlas atlas;
    for (int frame = 0; frame < 400; ++frame) {
        std::vector<ShadowRequest> requests;
        const std::size_t count = random() % 40;
        for (std::size_t i = 0; i < count; ++i) {
            requests.push_back(request(64 << (random() % 4), static_cast<int>(random() % 60)));
        }
        const std::vector<ShadowTile> tiles = atlas.place(requests);
        expectSound(tiles, requests, atlas.edge());
        ASSERT_LE(atlas.edge(), 4096);
        EXPECT_EQ(freshOnes(atlas.place(requests)), 0);
    }
}

/// What a tile was last drawn with must be what it is used for.
TEST(ShadowAtlas, ContentThatIsNotFreshIsTheContentThatWasDrawn) {
    std::mt19937 random(5);
    ShadowAtlas atlas;
    std::vector<std::pair<ShadowTile, int>> drawn;
    int edge = 0;
    for (int frame = 0; frame < 400; ++frame) {
        std::vector<ShadowRequest> requests;
        for (std::size_t i = random() % 12; i > 0; --i) {
            requests.push_back(request(64 << (random() % 3), static_cast<int>(random() % 20)));
        }
        const std::vector<ShadowTile> tiles = atlas.place(requests);
        if (atlas.edge() != edge) drawn.clear();
        edge = atlas.edge();
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            if (!tiles[i].isFresh) continue;
            std::erase_if(drawn, [&](const auto& old) { return overlap(old.first, tiles[i]); });
            drawn.emplace_back(tiles[i], requests[i].content.casters.front().first);
        }
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const auto there = std::find_if(drawn.begin(), drawn.end(), [&](const auto& old) {
                return old.first.originPx == tiles[i].originPx && old.first.sizeTexels == tiles[i].sizeTexels;
            });
            ASSERT_NE(there, drawn.end());
            EXPECT_EQ(there->second, requests[i].content.casters.front().first);
        }
    }
}

}  // namespace
}  // namespace hazer::test
