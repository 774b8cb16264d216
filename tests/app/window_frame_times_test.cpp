// Median and 99th percentile of the latest frames.
#include "app/window_frame_times.h"

#include <gtest/gtest.h>

namespace hazer::app {
namespace {

TEST(WindowFrameTimes, isZeroBeforeTheFirstFrame) {
    const WindowFrameTimes times;
    EXPECT_EQ(times.medianMs(), 0.0);
    EXPECT_EQ(times.percentile99Ms(), 0.0);
    EXPECT_TRUE(times.history().empty());
}

TEST(WindowFrameTimes, ranksWhatItHasSeen) {
    WindowFrameTimes times;
    for (int i = 100; i >= 1; --i) times.add(i);
    EXPECT_EQ(times.medianMs(), 50.0);
    EXPECT_EQ(times.percentile99Ms(), 99.0);
    EXPECT_EQ(times.history().front(), 100.0f);
    EXPECT_EQ(times.history().back(), 1.0f);
}

TEST(WindowFrameTimes, forgetsTheOldest) {
    WindowFrameTimes times;
    times.add(1e6);
    for (std::size_t i = 0; i < WindowFrameTimes::kCapacity; ++i) times.add(16.0);
    EXPECT_EQ(times.history().size(), WindowFrameTimes::kCapacity);
    EXPECT_EQ(times.percentile99Ms(), 16.0);
}

}  // namespace
}  // namespace hazer::app
