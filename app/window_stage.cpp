#include "app/window_stage.h"

#include <algorithm>
#include <limits>

namespace hazer::app {
namespace {

/// Grows with each point it is shown.
class Box {
 public:
    void add(const glm::dvec3& pointM) {
        lowM_ = glm::min(lowM_, pointM);
        highM_ = glm::max(highM_, pointM);
    }

    bool isEmpty() const { return lowM_.x > highM_.x; }

    Ball ballAround() const {
        constexpr double kSmallestRadiusM = 1.0;
        return {0.5 * (lowM_ + highM_), std::max(kSmallestRadiusM, 0.5 * glm::distance(lowM_, highM_))};
    }

 private:
    glm::dvec3 lowM_{std::numeric_limits<double>::infinity()};
    glm::dvec3 highM_{-std::numeric_limits<double>::infinity()};
};

}  // namespace

Ball ballAroundStage(const Show& show) {
    Box box;
    for (const ShowFixture& fixture : show.fixtures) {
        box.add(fixture.positionM);
        box.add({fixture.positionM.x, fixture.positionM.y, 0.0});
    }
    for (const ShowObject& object : show.objects) {
        if (object.shape != ObjectShape::kFloor && object.shape != ObjectShape::kWall)
            box.add(object.positionM);
    }
    return box.isEmpty() ? Ball{} : box.ballAround();
}

}  // namespace hazer::app
