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

/// Is there anything but an iris and pictures?
bool hasMore(const Aperture& aperture) {
    const bool isTinted = aperture.color != glm::vec3(1.0f);
    const bool isSplit = isInField(aperture.split) && aperture.beyondColor != aperture.color;
    return std::ranges::any_of(aperture.blades, isInField) || aperture.shape != ApertureShape::kRound ||
           isTinted || isSplit || aperture.stretch != glm::dmat2(1.0);
}

}  // namespace

bool isOpen(const Aperture& aperture) {
    return aperture.irisRadius >= 1.0 && !hasImages(aperture) && !hasMore(aperture);
}

bool isIrisOnly(const Aperture& aperture) {
    return aperture.irisRadius < 1.0 && aperture.softness <= 0.0 && !hasImages(aperture) &&
           !hasMore(aperture);
}

bool isRound(const Aperture& aperture) {
    return !hasImages(aperture) && !hasMore(aperture);
}

}  // namespace hazer::render
