#include "render/gpu_beam.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace hazer::render {
namespace {

/// Diameter of the disc that has a Gaussian's variance, over the Gaussian's width at half its peak.
constexpr double kDiscOverHalf = 1.6986;

}  // namespace

glm::dvec3 apexPosition(const Beam& beam, const BeamShape& shape) {
    return beam.lensPositionM + beam.worldFromBeam * glm::dvec3(0.0, 0.0, shape.apexToLensM);
}

GpuBeam packBeam(const Beam& beam, const BeamShape& shape, const Camera& camera, const BeamShadow& shadow,
                 const BeamPicture& picture, const GoboTableSlot& goboTable) {
    const glm::dmat3 lampFromWorld = glm::transpose(beam.worldFromBeam);
    const glm::dmat3 viewFromLamp = glm::transpose(lampFromWorld * worldFromView(camera));
    const glm::dvec3 cameraInLamp = lampFromWorld * (camera.positionM - apexPosition(beam, shape));
    GpuBeam gpu{};
    gpu.row0 = glm::vec4(glm::dvec4(viewFromLamp[0], cameraInLamp.x));
    gpu.row1 = glm::vec4(glm::dvec4(viewFromLamp[1], cameraInLamp.y));
    gpu.row2 = glm::vec4(glm::dvec4(viewFromLamp[2], cameraInLamp.z));
    gpu.light =
        glm::vec4(beam.color * static_cast<float>(shape.peakCd), static_cast<float>(shape.apexToLensM));
    gpu.cone = glm::vec4(glm::dvec4(std::cos(shape.cutHalfAngleRad), std::sin(shape.cutHalfAngleRad),
                                    shape.beamHalfAngleRad, shape.exponent));
    const double tanPicture = std::tan(shape.pictureHalfAngleRad);
    gpu.gobo = glm::vec4(glm::dvec4(picture.layer, std::cos(picture.rotationRad) / tanPicture,
                                    std::sin(picture.rotationRad) / tanPicture,
                                    beam.focusDistanceM > 0.0 ? 1.0 / beam.focusDistanceM : -1.0));
    gpu.shadow =
        glm::vec4(glm::dvec4(shadow.firstFace, shadow.reach.nearM, shadow.reach.farM, shadow.reach.deepM));
    gpu.lens.x = static_cast<float>(beam.lensRadiusM);
    gpu.lens.z = static_cast<float>(beam.web);
    gpu.lens.w = goboTable.layers > 0
                     ? static_cast<float>(2 * goboTable.firstLayer + (goboTable.layers == 3 ? 1 : 0))
                     : -1.0f;
    gpu.lens.y =
        picture.layer >= 0 ? static_cast<float>(kDiscOverHalf * std::max(beam.frostRad, 0.0)) : -1.0f;
    return gpu;
}

}  // namespace hazer::render
