// Tables of gobos on a thread of their own. Runs under ThreadSanitizer, too.
#include "render/gobo_table_queue.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "tests/render/gobo_pictures.h"

namespace hazer::test {
namespace {

using render::GoboPicture;
using render::GoboTableKey;
using render::GoboTableQueue;

std::shared_ptr<const GoboPicture> letter() {
    return std::make_shared<const GoboPicture>(letterGobo());
}

TEST(GoboTableQueue, BuildsWhatIsAskedForInTurn) {
    GoboTableQueue queue;
    const auto picture = letter();
    const GoboTableKey flat{0, {}};
    const GoboTableKey soft{0, {0.8, 5.4}};
    queue.request(flat, picture);
    queue.request(soft, picture);
    queue.wait();
    const auto finished = queue.take();
    ASSERT_EQ(finished.size(), 2u);
    EXPECT_EQ(finished[0].key, flat);
    EXPECT_EQ(finished[1].key, soft);
    EXPECT_EQ(finished[0].table.halves, render::buildGoboTable(*picture, flat.profile).halves);
    EXPECT_EQ(finished[1].table.halves, render::buildGoboTable(*picture, soft.profile).halves);
    EXPECT_TRUE(queue.take().empty());
}

TEST(GoboTableQueue, WaitsForNothingIfNothingWasAskedFor) {
    GoboTableQueue queue;
    queue.wait();
    EXPECT_TRUE(queue.take().empty());
}

TEST(GoboTableQueue, GivesTablesOutWhileMoreAreBuilt) {
    GoboTableQueue queue;
    const auto picture = letter();
    std::set<render::GoboId> seen;
    for (int gobo = 0; gobo < 3; ++gobo) queue.request({gobo, {}}, picture);
    while (seen.size() < 3) {
        for (const auto& [key, table] : queue.take()) {
            EXPECT_EQ(table.layers, 1);
            EXPECT_TRUE(seen.insert(key.gobo).second);
        }
        std::this_thread::yield();
    }
    queue.request({3, {}}, picture);
    queue.wait();
    EXPECT_EQ(queue.take().size(), 1u);
}

TEST(GoboTableQueue, EndsWithoutFinishingWhatIsWaiting) {
    const auto picture = letter();
    const auto begin = std::chrono::steady_clock::now();
    {
        GoboTableQueue queue;
        for (int gobo = 0; gobo < 1000; ++gobo) queue.request({gobo, {}}, picture);
    }
    // A thousand tables take minutes.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(GoboTableQueue, KeepsThePictureOfARequestAlive) {
    GoboTableQueue queue;
    queue.request({0, {}}, letter());
    queue.wait();
    EXPECT_EQ(queue.take().size(), 1u);
}

}  // namespace
}  // namespace hazer::test
