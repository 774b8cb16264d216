// Places in the picture, held against the renderer's own projection.
#include "app/window_picking.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "render/camera.h"

namespace hazer::app {
namespace {

constexpr glm::dvec2 kPicture{800.0, 600.0};

render::Camera camera() {
    render::Camera camera;
    camera.positionM = {2.0, -9.0, 3.0};
    camera.targetM = {0.0, 1.0, 2.0};
    return camera;
}

TEST(Picking, agreesWithTheProjectionOfTheRenderer) {
    const glm::dvec3 pointM{-1.0, 2.5, 4.0};
    const glm::dmat4 viewFromWorld = glm::dmat4(glm::transpose(render::worldFromView(camera()))) *
                                     glm::translate(glm::dmat4(1.0), -camera().positionM);
    const glm::dvec4 clip =
        render::clipFromView(camera(), kPicture.x / kPicture.y) * viewFromWorld * glm::dvec4(pointM, 1.0);
    const auto place = placeInPicture(camera(), kPicture, pointM);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->x, kPicture.x * (0.5 + 0.5 * clip.x / clip.w), 1e-9);
    EXPECT_NEAR(place->y, kPicture.y * (0.5 - 0.5 * clip.y / clip.w), 1e-9);
}

TEST(Picking, nothingBehindTheCameraIsInThePicture) {
    EXPECT_FALSE(placeInPicture(camera(), kPicture, {2.0, -20.0, 3.0}));
    EXPECT_FALSE(placeInPicture(camera(), kPicture, camera().positionM));
}

TEST(Picking, takesTheNearestWithinReach) {
    const std::array<glm::dvec3, 3> pointsM{{{0.0, 1.0, 2.0}, {0.3, 1.0, 2.0}, {2.0, -20.0, 3.0}}};
    const glm::dvec2 second = *placeInPicture(camera(), kPicture, pointsM[1]);
    EXPECT_EQ(pointAt(camera(), kPicture, second + glm::dvec2(3.0, 0.0), 100.0, pointsM), 1U);
    EXPECT_EQ(pointAt(camera(), kPicture, 0.5 * kPicture, 100.0, pointsM), 0U);
    EXPECT_FALSE(pointAt(camera(), kPicture, second + glm::dvec2(0.0, 50.0), 40.0, pointsM));
}

}  // namespace
}  // namespace hazer::app
