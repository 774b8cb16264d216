// Tables of gobos on a thread of their own. Runs under ThreadSanitizer, too.
#include "render/gobo_table_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "tests/render/gobo_pictures.h"

namespace hazer::test {
namespace {

using render::GoboPicture;
using render::GoboProfile;
using render::GoboTable;
using render::GoboTableKey;
using render::GoboTableQueue;

/// In no time, a table whose only value says for which profile and from which picture it was built.
GoboTable markedTable(const GoboPicture& picture, const GoboProfile& profile, const std::stop_token&) {
    return {picture.grey ? 1 : 3, {static_cast<std::uint16_t>(100.0 * profile.beamOverField)}};
}

TEST(GoboTableQueue, BuildsTables) {
    GoboTableQueue queue;
    const GoboTableKey key{0, {0.8, 5.4}};
    queue.request(key, std::make_shared<const GoboPicture>(letterGobo()));
    queue.wait();
    const auto finished = queue.take();
    ASSERT_EQ(finished.size(), 1u);
    EXPECT_EQ(finished[0].key, key);
    EXPECT_EQ(finished[0].table.layers, 1);
    EXPECT_EQ(finished[0].table.halves.size(), render::kGoboTableLayerHalves);
}

TEST(GoboTableQueue, BuildsWhatIsAskedForInTurn) {
    GoboTableQueue queue(markedTable);
    const auto grey = std::make_shared<GoboPicture>();
    const auto coloured = std::make_shared<GoboPicture>();
    coloured->grey = false;
    queue.request({0, {0.5, 2.0}}, grey);
    queue.request({1, {0.25, 2.0}}, coloured);
    queue.wait();
    const auto finished = queue.take();
    ASSERT_EQ(finished.size(), 2u);
    EXPECT_EQ(finished[0].key.gobo, 0);
    EXPECT_EQ(finished[0].table.layers, 1);
    EXPECT_EQ(finished[0].table.halves[0], 50);
    EXPECT_EQ(finished[1].key.gobo, 1);
    EXPECT_EQ(finished[1].table.layers, 3);
    EXPECT_EQ(finished[1].table.halves[0], 25);
    EXPECT_TRUE(queue.take().empty());
}

TEST(GoboTableQueue, WaitsForNothingIfNothingWasAskedFor) {
    GoboTableQueue queue;
    queue.wait();
    EXPECT_TRUE(queue.take().empty());
}

TEST(GoboTableQueue, GivesTablesOutWhileMoreAreBuilt) {
    GoboTableQueue queue(markedTable);
    const auto picture = std::make_shared<GoboPicture>();
    constexpr std::size_t kCount = 2000;
    std::set<render::GoboId> seen;
    for (int gobo = 0; seen.size() < kCount;) {
        if (gobo < static_cast<int>(kCount)) queue.request({gobo++, {}}, picture);
        for (const auto& [key, table] : queue.take()) {
            EXPECT_EQ(table.layers, 1);
            EXPECT_TRUE(seen.insert(key.gobo).second);
        }
    }
    queue.request({static_cast<int>(kCount), {}}, picture);
    queue.wait();
    EXPECT_EQ(queue.take().size(), 1u);
}

TEST(GoboTableQueue, EndsWithoutFinishingWhatIsWaiting) {
    const auto picture = std::make_shared<GoboPicture>();
    std::atomic<int> built = 0;
    {
        GoboTableQueue queue([&](const GoboPicture&, const GoboProfile&, const std::stop_token& stop) {
            ++built;
            while (!stop.stop_requested()) std::this_thread::yield();
            return GoboTable{};
        });
        for (int gobo = 0; gobo < 1000; ++gobo) queue.request({gobo, {}}, picture);
        while (built == 0) std::this_thread::yield();
    }
    EXPECT_EQ(built, 1);
}

TEST(GoboTableQueue, KeepsThePictureOfARequestAlive) {
    GoboTableQueue queue(markedTable);
    for (int i = 0; i < 100; ++i) queue.request({i, {}}, std::make_shared<GoboPicture>());
    queue.wait();
    EXPECT_EQ(queue.take().size(), 100u);
}

}  // namespace
}  // namespace hazer::test
