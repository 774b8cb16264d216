#include "app/set_dressing.h"

#include <gtest/gtest.h>

namespace hazer::app {
namespace {

glm::dvec3 placed(const ShowObject& object, const glm::dvec3& mesh) {
    return glm::dvec3(worldFromMesh(object) * glm::dvec4(mesh, 1.0));
}

void expectPoint(const glm::dvec3& point, const glm::dvec3& expected) {
    EXPECT_NEAR(glm::distance(point, expected), 0.0, 1e-12) << point.x << ' ' << point.y << ' ' << point.z;
}

ShowObject objectOf(ObjectShape shape, const glm::dvec3& sizeM) {
    ShowObject object;
    object.shape = shape;
    object.positionM = {1.0, 2.0, 3.0};
    object.sizeM = sizeM;
    return object;
}

TEST(WorldFromMesh, theFloorsSurfaceIsAtItsPosition) {
    expectPoint(placed(objectOf(ObjectShape::kFloor, {4.0, 6.0, 0.0}), {0.5, 0.5, 0.0}), {3.0, 5.0, 3.0});
}

TEST(WorldFromMesh, theWallStandsAndFacesTheAudience) {
    const ShowObject wall = objectOf(ObjectShape::kWall, {4.0, 6.0, 0.0});
    expectPoint(placed(wall, {0.5, 0.5, 0.0}), {3.0, 2.0, 6.0});
    const glm::dvec3 normal = glm::dvec3(worldFromMesh(wall) * glm::dvec4(0.0, 0.0, 1.0, 0.0));
    expectPoint(normal, {0.0, -1.0, 0.0});
}

TEST(WorldFromMesh, theDeckStandsOnItsPosition) {
    const ShowObject deck = objectOf(ObjectShape::kDeck, {2.0, 1.0, 0.4});
    expectPoint(placed(deck, {0.0, 0.0, -0.5}), {1.0, 2.0, 3.0});
    expectPoint(placed(deck, {0.0, 0.0, 0.5}), {1.0, 2.0, 3.4});
}

TEST(WorldFromMesh, thePersonHasItsHeight) {
    expectPoint(placed(objectOf(ObjectShape::kPerson, {1.0, 1.0, 1.6}), {0.0, 0.0, 1.75}), {1.0, 2.0, 4.6});
}

TEST(WorldFromMesh, theTrussHasItsSizeAlready) {
    expectPoint(placed(objectOf(ObjectShape::kTruss, {6.0, 0.3, 0.3}), {3.0, 0.0, 0.0}), {4.0, 2.0, 3.0});
}

TEST(WorldFromMesh, isTurnedAboutItsPosition) {
    ShowObject box = objectOf(ObjectShape::kBox, {2.0, 1.0, 1.0});
    box.rotationDeg = {0.0, 0.0, 90.0};
    expectPoint(placed(box, {0.5, 0.0, 0.0}), {1.0, 3.0, 3.0});
}

}  // namespace
}  // namespace hazer::app
