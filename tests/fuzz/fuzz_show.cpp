// A show file may hold anything: it becomes a show, or a ShowError and nothing else. What becomes a show can
// be drawn.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "app/light_color.h"
#include "app/show.h"

namespace {

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Finite, turned but not stretched, and neither dark nor mirrored.
bool isDrawable(const hazer::render::Beam& beam) {
    const double turned = glm::determinant(beam.worldFromBeam);
    const double luminance = hazer::app::luminance(glm::dvec3(beam.color));
    return isFinite(beam.lensPositionM) && std::abs(turned - 1.0) < 1e-9 &&
           std::abs(luminance - 1.0) < 1e-4 && beam.beamAngleRad > 0.0 &&
           beam.beamAngleRad <= beam.fieldAngleRad && (beam.intensityCd > 0.0) != (beam.fluxLm > 0.0) &&
           beam.lensRadiusM >= 0.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::app;
    try {
        const Show show = parseShow({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
        for (const ShowLight& light : show.lights) {
            if (!isDrawable(light.beam)) std::abort();
        }
    } catch (const ShowError&) {
        // The answer to a broken file.
    }
    return 0;
}
