#include "render/aperture.h"

#include <algorithm>

namespace hazer::render {
namespace {

/// The field of the beam is the unit disc.
bool isInField(const ApertureEdge& edge) {
    return edge.distance < 1.0;
}

bool hasImages(const Aperture& aperture) {
    return std::ranges::any_of(aperture.images, [](const ApertureImage& image) { return image.gobo >= 0; });
}

/// All but the iris and pictures.
bool hasEdges(const Aperture& aperture) {
    const bool isTinted = aperture.color != glm::vec3(1.0f);
    const bool isSplit = isInField(aperture.split) && aperture.beyondColor != aperture.color;
    return std::ranges::any_of(aperture.blades, isInField) || aperture.shape != ApertureShape::kRound ||
           isTinted || isSplit;
}

}  // namespace

bool isOpen(const Aperture& aperture) {
    return aperture.irisRadius >= 1.0 && !hasImages(aperture) && !hasEdges(aperture);
}

bool isIrisOnly(const Aperture& aperture) {
    return aperture.irisRadius < 1.0 && aperture.softness <= 0.0 && !hasImages(aperture) &&
           !hasEdges(aperture);
}

bool isRound(const Aperture& aperture) {
    return !hasImages(aperture) && !hasEdges(aperture);
}

}  // namespace hazer::render
