// What the panels for haze, colour and camera work with.
#include <gtest/gtest.h>

#include "app/light_color.h"
#include "app/window_color.h"
#include "app/window_haze.h"
#include "app/window_stage.h"

namespace hazer::app {
namespace {

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance) {
    EXPECT_LE(glm::distance(actual, expected), tolerance)
        << "(" << actual.r << ", " << actual.g << ", " << actual.b << ")";
}

TEST(ScreenColor, goesThereAndBack) {
    for (const glm::vec3 srgb : {glm::vec3(1.0f), {0.9f, 0.2f, 0.05f}, {0.0f, 0.5f, 1.0f}}) {
        expectNear(srgbFromRec2020(rec2020FromSrgb(srgb)), srgb, 1e-4f);
    }
}

TEST(ScreenColor, middleGreyIsEncoded) {
    // IEC 61966-2-1: linear 0.2140 is shown by 0.5.
    expectNear(srgbFromRec2020(render::Color(0.2140f)), glm::vec3(0.5f), 1e-3f);
}

TEST(ScreenColor, swatchesAreAsBrightAsTheScreen) {
    const glm::vec3 deepBlue = swatchOf({0.148, 0.07, 5.0});
    EXPECT_GT(deepBlue.b, 0.95f);
    EXPECT_LT(deepBlue.r, 0.5f);
    expectNear(swatchOf({0.3127, 0.329, 40.0}), glm::vec3(1.0f), 0.01f);
    expectNear(swatchOf({0.3127, 0.329, 0.0}), glm::vec3(0.0f), 0.0f);
}

TEST(HazeFader, keepsTheShareThatIsScattered) {
    render::Haze haze;
    haze.extinctionPerM = 0.02f;
    haze.scatteringPerM = 0.015f;
    setExtinction(haze, 0.2f);
    EXPECT_FLOAT_EQ(haze.extinctionPerM, 0.2f);
    EXPECT_FLOAT_EQ(haze.scatteringPerM, 0.15f);
}

TEST(HazeFader, comesBackFromNone) {
    render::Haze haze;
    setExtinction(haze, 0.0f);
    EXPECT_EQ(haze.scatteringPerM, 0.0f);
    setExtinction(haze, 0.03f);
    EXPECT_FLOAT_EQ(haze.scatteringPerM, 0.03f);
}

ShowFixture fixtureAt(const glm::dvec3& positionM) {
    ShowFixture fixture;
    fixture.positionM = positionM;
    return fixture;
}

TEST(Stage, holdsFixturesTheFloorUnderThemAndObjects) {
    Show show;
    show.fixtures = {fixtureAt({-4.0, 0.0, 6.0}), fixtureAt({4.0, 2.0, 6.0})};
    ShowObject person;
    person.shape = ObjectShape::kPerson;
    person.positionM = {0.0, -3.0, 1.0};
    show.objects.push_back(person);
    const Ball ball = ballAroundStage(show);
    for (const glm::dvec3& pointM :
         {glm::dvec3(-4.0, 0.0, 6.0), glm::dvec3(4.0, 2.0, 0.0), person.positionM}) {
        EXPECT_LE(glm::distance(ball.centreM, pointM), ball.radiusM);
    }
    EXPECT_LT(ball.radiusM, 6.0);
}

TEST(Stage, floorsDoNotCount) {
    Show show;
    ShowObject floor;
    floor.shape = ObjectShape::kFloor;
    floor.positionM = {500.0, 0.0, 0.0};
    show.objects.push_back(floor);
    const Ball ball = ballAroundStage(show);
    EXPECT_EQ(glm::length(ball.centreM), 0.0);
    EXPECT_GT(ball.radiusM, 0.0);
}

}  // namespace
}  // namespace hazer::app
