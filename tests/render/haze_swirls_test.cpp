// The density of uneven haze: what the shaders make of the volume of noise, where and when.
#include "render/haze_swirls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/glsl_as_cpp.h"
#include "render/noise_volume.h"
#include "render/oracle/haze_density.h"

namespace hazer::test {
namespace {

using render::Haze;

Haze unevenHaze(float amount) {
    Haze haze;
    haze.noise.amount = amount;
    haze.noise.scaleM = 1.3f;
    return haze;
}

/// Where in the volume the shaders look for a place, as render/passes/air_pass.cpp sets them up for a camera.
glm::dvec3 lookedUp(const render::HazeNoise& noise, const glm::dvec3& cameraM, const glm::dvec3& placeM,
                    double timeS) {
    const render::HazeSwirls swirls = render::hazeSwirls(noise, cameraM, timeS);
    return render::glsl::Formulas<double>().stirred(
        glm::dvec3(swirls.origin) + swirls.noiseFromWorld * (placeM - cameraM) / swirls.periodM,
        glm::dvec3(swirls.wave));
}

/// Apart in a volume that repeats.
double apart(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 difference = a - b;
    return glm::length(difference - glm::round(difference));
}

class RandomPlaces {
 public:
    glm::dvec3 operator()() { return {even_(random_), even_(random_), even_(random_)}; }

 private:
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> even_{-40.0, 40.0};
};

// As many places as the volume has values, between them and stirred; the density is the oracle's.
TEST(HazeSwirls, MeanDensityIsOneWhateverTheAmount) {
    constexpr int kPlaces = render::kNoiseSize;
    for (const float amount : {0.1f, 0.5f, 1.0f}) {
        Haze haze = unevenHaze(amount);
        const double periodM = render::kNoiseCells * static_cast<double>(haze.noise.scaleM);
        const auto density = render::oracle::hazeDensity(haze, 12.3);
        const glm::dmat3 worldFromNoise =
            glm::transpose(render::hazeSwirls(haze.noise, {}, 0.0).noiseFromWorld);
        double sum = 0.0, squares = 0.0, least = 2.0, most = 0.0;
        for (int i = 0; i < kPlaces * kPlaces * kPlaces; ++i) {
            const glm::dvec3 share(i % kPlaces, i / kPlaces % kPlaces, i / kPlaces / kPlaces);
            const double here = density(worldFromNoise * ((share + 0.25) * (periodM / kPlaces)));
            sum += here;
            squares += (here - 1.0) * (here - 1.0);
            least = std::min(least, here);
            most = std::max(most, here);
        }
        constexpr double kCount = static_cast<double>(kPlaces) * kPlaces * kPlaces;
        EXPECT_NEAR(sum / kCount, 1.0, 2e-4) << amount;
        // A parabola's, less what is lost between texels.
        EXPECT_NEAR(std::sqrt(squares / kCount), 0.44 * static_cast<double>(amount),
                    0.01 * static_cast<double>(amount));
        EXPECT_GE(least, 1.0 - static_cast<double>(amount));
        EXPECT_LE(most, 1.0 + static_cast<double>(amount));
    }
}

TEST(HazeSwirls, NoAmountIsEvenHaze) {
    render::glsl::Formulas<double> f;
    for (const double stored : {0.0, 0.3, 1.0}) EXPECT_EQ(f.swirlDensity(stored, 0.0), 1.0);
    EXPECT_EQ(f.swirlDensity(0.0, 1.0), 0.0);
    EXPECT_EQ(f.swirlDensity(1.0, 1.0), 2.0);
}

/// The volume at a place, nearest texel.
double nearest(const std::vector<std::uint16_t>& volume, const glm::dvec3& periods) {
    const glm::ivec3 texel((periods - glm::floor(periods)) * static_cast<double>(render::kNoiseSize));
    const int index = (texel.z * render::kNoiseSize + texel.y) * render::kNoiseSize + texel.x;
    return volume[static_cast<std::size_t>(index)] / 65535.0;
}

// Shaders and oracle each say where the swirls are.
TEST(HazeSwirls, ShadersAndOracleLookAtTheSamePlace) {
    const Haze haze = unevenHaze(1.0f);
    const auto volume = render::makeNoiseVolume(render::kNoiseSize, haze.noise.seed);
    render::glsl::Formulas<double> f;
    RandomPlaces place;
    for (const double timeS : {0.0, 3.7, 86400.0}) {
        const auto density = render::oracle::hazeDensity(haze, timeS);
        double error = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 placeM = place();
            const double stored = nearest(volume, lookedUp(haze.noise, {3.0, -20.0, 1.7}, placeM, timeS));
            error += std::abs(f.swirlDensity(stored, 1.0) - density(placeM)) / 2000.0;
        }
        // Half a texel.
        EXPECT_LT(error, 0.04) << timeS;
    }
}

TEST(HazeSwirls, WavesAreSmoothAndEvenOnTheWhole) {
    render::glsl::Formulas<double> f;
    constexpr double kStep = 1e-4;
    double sum = 0.0, largestBend = 0.0;
    for (double phase = -1.0; phase < 1.0; phase += kStep) {
        sum += f.softWave(phase);
        largestBend = std::max(largestBend, std::abs(f.softWave(phase + kStep) - 2.0 * f.softWave(phase) +
                                                     f.softWave(phase - kStep)));
        EXPECT_NEAR(f.softWave(phase), -std::sin(2.0 * 3.14159265358979 * phase), 0.06);
    }
    EXPECT_NEAR(sum * kStep, 0.0, 1e-6);
    EXPECT_LE(largestBend, 33.0 * kStep * kStep);
}

// Volumes are kept, so that what is stirred has the mean of what was not; and it tiles as before.
TEST(HazeSwirls, StirringKeepsVolumesAndPeriods) {
    render::glsl::Formulas<double> f;
    RandomPlaces random;
    constexpr double kStep = 1e-6;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 place = random(), wave = random();
        const glm::dvec3 moved = f.stirred(place, wave);
        glm::dmat3 slopes;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = kStep;
            slopes[axis] = (f.stirred(place + step, wave) - moved) / kStep;
            step[axis] = 1.0;
            EXPECT_LT(glm::length(f.stirred(place + step, wave) - moved - step), 1e-9);
            EXPECT_LT(glm::length(f.stirred(place, wave + step) - moved), 1e-9);
        }
        EXPECT_NEAR(glm::determinant(slopes), 1.0, 1e-3);
    }
}

// Who goes with the wind sees what he saw, after a second and after twelve days.
TEST(HazeSwirls, WithoutTurbulenceTheWindCarriesThemExactly) {
    render::HazeNoise noise = unevenHaze(1.0f).noise;
    noise.turbulence = 0.0f;
    RandomPlaces random;
    for (const double timeS : {1.0, 1e3, 1e6}) {
        const glm::dvec3 way = glm::dvec3(noise.windMps) * timeS;
        const glm::dvec3 cameraM = random(), placeM = random();
        EXPECT_LT(
            apart(lookedUp(noise, cameraM, placeM, 0.0), lookedUp(noise, cameraM + way, placeM + way, timeS)),
            1e-6)
            << timeS;
    }
}

// A hundredth of a second is a small step however late it is, also where a wave has gone round.
TEST(HazeSwirls, TheyMoveWithoutJumps) {
    render::HazeNoise noise = unevenHaze(1.0f).noise;
    noise.turbulence = 4.0f;
    RandomPlaces random;
    const glm::dvec3 cameraM = random(), placeM = random();
    for (const double fromS : {0.0, 1.0 / 0.037 / 4.0 - 0.5, 3.6e4, 1e6}) {
        for (double timeS = fromS; timeS < fromS + 1.0; timeS += 0.01) {
            EXPECT_LT(apart(lookedUp(noise, cameraM, placeM, timeS),
                            lookedUp(noise, cameraM, placeM, timeS + 0.01)),
                      4e-3);
        }
    }
    EXPECT_GT(apart(lookedUp(noise, cameraM, placeM, 1e6), lookedUp(noise, cameraM, placeM, 1e6 + 0.1)),
              1e-4);
}

TEST(HazeSwirls, LevelsFadeWhatFitsBetweenTwoLooks) {
    render::glsl::Formulas<double> f;
    EXPECT_EQ(f.swirlLevel(0.0, 0.0), 0.0);
    EXPECT_EQ(f.swirlLevel(4.0, 1.0), 0.0);
    EXPECT_EQ(f.swirlLevel(8.0, 0.0), 1.0);
    EXPECT_EQ(f.swirlLevel(0.0, 8.0), 3.0);
}

}  // namespace
}  // namespace hazer::test
