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

/// Neither both nor, but for a web that brings its own, none.
bool hasOneIntensity(const hazer::app::ShowLight& light) {
    const int given = (light.beam.intensityCd > 0.0 ? 1 : 0) + (light.beam.fluxLm > 0.0 ? 1 : 0);
    return given == 1 || (given == 0 && !light.webFile.empty());
}

/// Finite, turned but not stretched, and neither dark nor mirrored.
bool isDrawable(const hazer::app::ShowLight& light) {
    const hazer::render::Beam& beam = light.beam;
    const double turned = glm::determinant(beam.worldFromBeam);
    const double luminance = hazer::app::luminance(glm::dvec3(beam.color));
    return isFinite(beam.lensPositionM) && std::abs(turned - 1.0) < 1e-9 &&
           std::abs(luminance - 1.0) < 1e-4 && beam.beamAngleRad > 0.0 &&
           beam.beamAngleRad <= beam.fieldAngleRad && hasOneIntensity(light) && beam.lensRadiusM >= 0.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hazer::app;
    try {
        const Show show = parseShow({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
        for (const ShowLight& light : show.lights) {
            if (!isDrawable(light)) std::abort();
        }
    } catch (const ShowError&) {
        // The answer to a broken file.
    }
    return 0;
}
