#include "app/rig_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace hazer::app {
namespace {

/// Enough to see what hangs where; a lit beam is far brighter.
constexpr float kWorkLightLx = 200.0f;
constexpr float kEv100 = 9.0f;
constexpr double kEyeHeightM = 1.7;
constexpr double kVerticalFovRad = 0.8;
constexpr double kWideFovRad = 1.1;
constexpr double kAspect = 16.0 / 9.0;
/// Far from everything else is where programs leave what is not placed.
constexpr double kMostOutlying = 0.01;

struct StageBox {
    glm::dvec3 lowM{-5.0, -5.0, 0.0};
    glm::dvec3 highM{5.0, 5.0, 5.0};

    glm::dvec3 centreM() const { return 0.5 * (lowM + highM); }
    glm::dvec3 sizeM() const { return highM - lowM; }
};

/// Around all points, but for a hundredth at either end of each axis.
StageBox boxAround(const std::vector<glm::dvec3>& pointsM) {
    StageBox box;
    if (pointsM.empty()) return box;
    const auto outlying = static_cast<std::ptrdiff_t>(kMostOutlying * static_cast<double>(pointsM.size()));
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const glm::dvec3& point : pointsM) values.push_back(point[axis]);
        std::ranges::sort(values);
        box.lowM[axis] = values[static_cast<std::size_t>(outlying)];
        box.highM[axis] = values[values.size() - 1 - static_cast<std::size_t>(outlying)];
    }
    return box;
}

/// What the audience looks at: the fixtures and what they aim at; without any, the scene objects.
std::vector<glm::dvec3> pointsOfInterest(const Show& show) {
    std::vector<glm::dvec3> points;
    for (const ShowFixture& fixture : show.fixtures) {
        points.push_back(fixture.positionM);
        if (fixture.rig && fixture.rig->focusM) points.push_back(*fixture.rig->focusM);
    }
    if (!points.empty()) return points;
    for (const ShowScenery::Use& use : show.scenery.uses) points.emplace_back(use.worldFromMesh[3]);
    return points;
}

/// How far away a rectangle fills the picture.
double distanceFor(double widthM, double heightM) {
    const double halfTangent = std::tan(0.5 * kVerticalFovRad);
    return 0.5 * std::max(heightM, widthM / kAspect) / halfTangent;
}

ShowCamera cameraAt(const char* name, const glm::dvec3& positionM, const glm::dvec3& targetM) {
    ShowCamera camera{name, {}};
    camera.camera.positionM = positionM;
    camera.camera.targetM = targetM;
    camera.camera.verticalFovRad = kVerticalFovRad;
    return camera;
}

void addStageCameras(const StageBox& box, Show& show) {
    constexpr double kMargin = 1.25;
    const glm::dvec3 size = glm::max(box.sizeM(), glm::dvec3(4.0));
    const glm::dvec3 centre = box.centreM();
    const double frontM = distanceFor(kMargin * size.x, kMargin * size.z) + 0.5 * size.y;
    const double sideM = distanceFor(kMargin * size.y, kMargin * size.z) + 0.5 * size.x;
    const double eyeM = box.lowM.z + std::max(kEyeHeightM, 0.35 * size.z);
    const double cornerM = 0.5 * std::hypot(size.x, size.y) + 0.7 * distanceFor(size.x, size.z);
    // No higher than the fixtures: above them is the roof.
    const glm::dvec3 corner(centre.x - 0.6 * cornerM, centre.y - 0.8 * cornerM, box.lowM.z + 0.9 * size.z);
    show.cameras.clear();
    show.cameras.push_back(cameraAt("front", {centre.x, centre.y - frontM, eyeM}, centre));
    show.cameras.push_back(cameraAt("side", {centre.x - sideM, centre.y, eyeM}, centre));
    show.cameras.push_back(cameraAt("corner", corner, centre));
    // For rigs that come with the walls of their house, which the others stand outside of.
    show.cameras.push_back(cameraAt("inside", {centre.x, box.lowM.y + 0.1 * size.y, eyeM}, centre));
    show.cameras.back().camera.verticalFovRad = kWideFovRad;
}

/// Just below the ground, where the rig may have a floor of its own.
void addFloor(const StageBox& box, Show& show) {
    constexpr double kGapM = 0.02;
    constexpr double kAroundM = 15.0;
    ShowObject& floor = show.objects.emplace_back();
    floor.shape = ObjectShape::kFloor;
    floor.name = "floor";
    floor.positionM = {box.centreM().x, box.centreM().y, std::min(0.0, box.lowM.z) - kGapM};
    floor.sizeM = {box.sizeM().x + 2.0 * kAroundM, box.sizeM().y + 2.0 * kAroundM, 0.0};
    floor.material.albedo = render::Color(0.18f);
    floor.castsShadow = false;
}

}  // namespace

void setStage(Show& show) {
    StageBox box = boxAround(pointsOfInterest(show));
    // Rigs hang above a stage, and a beam ends on the floor.
    box.lowM.z = std::min(box.lowM.z, 0.0);
    show.ambient.illuminanceLx = kWorkLightLx;
    show.exposureEv100 = kEv100;
    addFloor(box, show);
    addStageCameras(box, show);
}

}  // namespace hazer::app
