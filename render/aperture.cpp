#include "render/aperture.h"

#include <algorithm>

namespace hazer::render {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The field of the beam is the unit disc.
bool isInField(const ApertureEdge& edge) {
    return edge.distance < 1.0;
}

/// Is there anything but an iris and pictures?
bool hasMore(const Aperture& aperture) {
    const bool isTinted = aperture.color != glm::vec3(1.0f);
    const bool isSplit = isInField(aperture.split) && aperture.beyondColor != aperture.color;
    return std::ranges::any_of(aperture.blades, isInField) || aperture.rectangle || isTinted || isSplit ||
           aperture.stretch != glm::dmat2(1.0);
}

}  // namespace

bool hasImages(const Aperture& aperture) {
    return std::ranges::any_of(aperture.images, [](const ApertureImage& image) { return image.gobo != -1; });
}

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

double rectangleShare(const Aperture& aperture) {
    if (!aperture.rectangle) return 1.0;
    // A ramp lets through half of what it covers.
    const glm::dvec2 half = glm::max(aperture.rectangle->halfSize - 0.5 * aperture.rectangle->softness, 1e-3);
    return 4.0 / kPi * half.x * half.y;
}

}  // namespace hazer::render
