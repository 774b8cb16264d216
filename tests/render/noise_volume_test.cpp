// The haze's noise: even on the whole, without seams, and always the same.
#include "render/noise_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

namespace hazer::test {
namespace {

constexpr int kSize = 32;

int at(const std::vector<std::uint8_t>& bytes, int x, int y, int z) {
    return bytes[static_cast<std::size_t>((z * kSize + y) * kSize + x)];
}

TEST(NoiseVolume, MeanIsTheMiddle) {
    const auto bytes = render::makeNoiseVolume(kSize, 5);
    ASSERT_EQ(bytes.size(), static_cast<std::size_t>(kSize * kSize * kSize));
    EXPECT_NEAR(std::accumulate(bytes.begin(), bytes.end(), 0.0) / static_cast<double>(bytes.size()), 127.5,
                0.5);
}

TEST(NoiseVolume, SameSeedSameBytesOtherSeedOthers) {
    EXPECT_EQ(render::makeNoiseVolume(kSize, 5), render::makeNoiseVolume(kSize, 5));
    EXPECT_NE(render::makeNoiseVolume(kSize, 5), render::makeNoiseVolume(kSize, 6));
}

// Across the border the steps are as small as anywhere else.
TEST(NoiseVolume, TilesWithoutASeam) {
    const auto bytes = render::makeNoiseVolume(kSize, 5);
    double inside = 0.0, across = 0.0;
    for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) {
            inside += std::abs(at(bytes, 15, a, b) - at(bytes, 16, a, b)) +
                      std::abs(at(bytes, a, 15, b) - at(bytes, a, 16, b)) +
                      std::abs(at(bytes, a, b, 15) - at(bytes, a, b, 16));
            across += std::abs(at(bytes, 31, a, b) - at(bytes, 0, a, b)) +
                      std::abs(at(bytes, a, 31, b) - at(bytes, a, 0, b)) +
                      std::abs(at(bytes, a, b, 31) - at(bytes, a, b, 0));
        }
    }
    EXPECT_GT(inside, 0.0);
    EXPECT_LT(across, 1.5 * inside);
}

}  // namespace
}  // namespace hazer::test
