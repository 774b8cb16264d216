// The haze's noise: its mean, its spread, its size, without seams or directions, and always the same.
#include "render/noise_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace hazer::test {
namespace {

constexpr int kSize = 32;
constexpr double kMiddle = 32767.5;

using Volume = std::vector<std::uint16_t>;

/// -1..1, repeating.
double at(const Volume& volume, int x, int y, int z) {
    const auto wrapped = [](int i) { return ((i % kSize) + kSize) % kSize; };
    return volume[static_cast<std::size_t>((wrapped(z) * kSize + wrapped(y)) * kSize + wrapped(x))] /
               kMiddle -
           1.0;
}

/// Of values so far apart [texels], 1 for the same place.
double correlation(const Volume& volume, const std::array<int, 3>& apart) {
    double products = 0.0, squares = 0.0;
    for (int z = 0; z < kSize; ++z) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const double here = at(volume, x, y, z);
                products += here * at(volume, x + apart[0], y + apart[1], z + apart[2]);
                squares += here * here;
            }
        }
    }
    return products / squares;
}

std::vector<Volume> volumes() {
    std::vector<Volume> list;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) list.push_back(render::makeNoiseVolume(kSize, seed));
    return list;
}

double meanCorrelation(const std::vector<Volume>& list, const std::array<int, 3>& apart) {
    double sum = 0.0;
    for (const Volume& volume : list) sum += correlation(volume, apart);
    return sum / static_cast<double>(list.size());
}

TEST(NoiseVolume, MeanIsTheMiddleToTheLastDigit) {
    for (const std::uint32_t seed : {0u, 1u, 5u, 2147483647u}) {
        const Volume volume = render::makeNoiseVolume(kSize, seed);
        ASSERT_EQ(volume.size(), static_cast<std::size_t>(kSize * kSize * kSize));
        EXPECT_EQ(2 * std::accumulate(volume.begin(), volume.end(), std::uint64_t{0}), 65535 * volume.size());
    }
}

// The parabola 3/4 (1 - x^2) over -1..1 has the variance 1/5 and the mean size 3/8.
TEST(NoiseVolume, ValuesAreSpreadAsAParabola) {
    double squares = 0.0, sizes = 0.0;
    const Volume volume = render::makeNoiseVolume(kSize, 5);
    for (const std::uint16_t value : volume) {
        const double x = value / kMiddle - 1.0;
        squares += x * x;
        sizes += std::abs(x);
    }
    EXPECT_NEAR(squares / static_cast<double>(volume.size()), 0.2, 1e-4);
    EXPECT_NEAR(sizes / static_cast<double>(volume.size()), 0.375, 1e-4);
}

TEST(NoiseVolume, AnotherSeedIsAnotherOrderOfTheSameValues) {
    Volume first = render::makeNoiseVolume(kSize, 5);
    Volume second = render::makeNoiseVolume(kSize, 6);
    EXPECT_EQ(first, render::makeNoiseVolume(kSize, 5));
    double products = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
        products += (first[i] / kMiddle - 1.0) * (second[i] / kMiddle - 1.0);
    EXPECT_LT(std::abs(products / static_cast<double>(first.size())), 0.3 * 0.2);
    std::sort(first.begin(), first.end());
    std::sort(second.begin(), second.end());
    EXPECT_EQ(first, second);
}

// Across the border steps and bends are as small as anywhere else.
TEST(NoiseVolume, TilesWithoutASeam) {
    const Volume volume = render::makeNoiseVolume(kSize, 5);
    const auto roughness = [&](int x) {
        double sum = 0.0;
        for (int a = 0; a < kSize; ++a) {
            for (int b = 0; b < kSize; ++b) {
                sum +=
                    std::abs(at(volume, x + 1, a, b) - at(volume, x, a, b)) +
                    std::abs(at(volume, a, x + 1, b) - at(volume, a, x, b)) +
                    std::abs(at(volume, a, b, x + 1) - 2.0 * at(volume, a, b, x) + at(volume, a, b, x - 1));
            }
        }
        return sum;
    };
    double inside = 0.0;
    for (int x = 1; x < kSize - 2; ++x) inside = std::max(inside, roughness(x));
    EXPECT_GT(roughness(kSize - 1), 0.3 * inside);
    EXPECT_LT(roughness(kSize - 1), 1.1 * inside);
}

// A cell is 32 / 3 texels long: half of the likeness is lost after a third of it, all of it after one.
TEST(NoiseVolume, SwirlsAreAsLargeAsTheCells) {
    const std::vector<Volume> list = volumes();
    const auto alike = [&](int texels) {
        return (meanCorrelation(list, {texels, 0, 0}) + meanCorrelation(list, {0, texels, 0}) +
                meanCorrelation(list, {0, 0, texels})) /
               3.0;
    };
    EXPECT_GT(alike(1), 0.85);
    EXPECT_NEAR(alike(4), 0.45, 0.1);
    EXPECT_NEAR(alike(10), 0.0, 0.15);
}

// All vectors of the length 3 on the texels' lattice, along its axes and askew, are alike.
TEST(NoiseVolume, NoDirectionIsSpecial) {
    const std::vector<Volume> list = volumes();
    std::vector<double> alike;
    for (const std::array<int, 3>& apart : {std::array{3, 0, 0},
                                            {0, 3, 0},
                                            {0, 0, 3},
                                            {1, 2, 2},
                                            {2, 1, 2},
                                            {2, 2, 1},
                                            {-1, 2, 2},
                                            {2, -1, 2},
                                            {2, 2, -1},
                                            {1, -2, 2},
                                            {2, 1, -2},
                                            {-2, 2, 1},
                                            {1, 2, -2},
                                            {-2, 1, 2},
                                            {2, -2, 1}}) {
        alike.push_back(meanCorrelation(list, apart));
    }
    const auto [least, most] = std::minmax_element(alike.begin(), alike.end());
    EXPECT_GT(*least, 0.5);
    EXPECT_LT(*most - *least, 0.08);
}

TEST(NoiseVolume, LevelsAreMeansOfBoxes) {
    const auto levels = render::noiseLevels(render::makeNoiseVolume(kSize, 5), kSize);
    ASSERT_EQ(levels.size(), 6u);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::vector<std::uint16_t>& level = levels[i];
        EXPECT_EQ(level.size(), levels[0].size() >> (3 * i));
        EXPECT_NEAR(std::accumulate(level.begin(), level.end(), 0.0) / static_cast<double>(level.size()),
                    kMiddle, 1.0);
    }
    double box = 0.0;
    for (int i = 0; i < 8; ++i) box += at(levels[0], 4 + (i & 1), 8 + ((i >> 1) & 1), 2 + (i >> 2)) / 8.0;
    EXPECT_NEAR(levels[1][(1 * 16 + 4) * 16 + 2] / kMiddle - 1.0, box, 0.6 / kMiddle);
}

}  // namespace
}  // namespace hazer::test
