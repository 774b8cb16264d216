// The quality that an error asks for.
#include "render/air_quality.h"

#include <gtest/gtest.h>

#include "render/scene.h"

namespace hazer::test {
namespace {

TEST(AirQuality, ASmallerErrorNeverAsksForLess) {
    render::AirQuality coarser = render::airQualityFor(0.5);
    for (const double error : {0.1, 0.02, 0.01, 5e-3, 1e-3, 2e-4, 1e-4}) {
        const render::AirQuality finer = render::airQualityFor(error);
        EXPECT_LE(finer.gridStep, coarser.gridStep) << error;
        EXPECT_LE(finer.gridTolerance, coarser.gridTolerance) << error;
        EXPECT_GE(finer.shadowIntervals, coarser.shadowIntervals) << error;
        EXPECT_GE(finer.shadowBisections, coarser.shadowBisections) << error;
        EXPECT_GE(finer.profilePairs, coarser.profilePairs) << error;
        EXPECT_GE(finer.goboTaps, coarser.goboTaps) << error;
        EXPECT_LT(finer.goboTolerance, coarser.goboTolerance) << error;
        EXPECT_LE(finer.goboLevelsApart, coarser.goboLevelsApart) << error;
        EXPECT_GE(finer.noiseNodes, coarser.noiseNodes) << error;
        coarser = finer;
    }
}

TEST(AirQuality, WhatTheShadersCanDoIsNotExceeded) {
    for (const double error : {0.5, 1e-4}) {
        const render::AirQuality quality = render::airQualityFor(error);
        EXPECT_TRUE(quality.shadowIntervals >= 4 && quality.shadowIntervals <= 232);
        EXPECT_TRUE(quality.profilePairs >= 2 && quality.profilePairs <= 4);
    }
}

TEST(AirQuality, ComparisonsAreDrawnAtEveryPixel) {
    render::Settings settings;
    EXPECT_EQ(render::airQuality(settings).gridStep, 1);
    settings.maxError = 0.01;
    EXPECT_GT(render::airQuality(settings).gridStep, 1);
    settings.samples = 16;
    EXPECT_EQ(render::airQuality(settings).gridStep, 1);
    settings.samples = 0;
    settings.integrator = render::Integrator::kUniform;
    EXPECT_EQ(render::airQuality(settings).gridStep, 1);
}

TEST(AirQuality, AGivenOneStands) {
    render::Settings settings;
    settings.maxError = 0.2;
    settings.quality = render::airQualityFor(1e-3);
    settings.quality->noiseNodes = 17;
    EXPECT_EQ(render::airQuality(settings).noiseNodes, 17);
    EXPECT_EQ(render::airQuality(settings).gridStep, 2);
}

}  // namespace
}  // namespace hazer::test
