// A photometric web may be any bytes: it becomes a web that keeps its promises, or a RenderError and nothing
// else.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>

#include "render/error.h"
#include "render/ies_web.h"

namespace {

using namespace hazer::render;

void require(bool condition) {
    if (!condition) std::abort();
}

void check(const IesWeb& web) {
    require(web.peakCd > 0.0 && web.peakCd <= kMaxIesCandela);
    require(web.fluxLm > 0.0 && web.fluxLm <= 4.0001 * 3.1415927 * web.peakCd);
    require(web.cutHalfAngleRad > 0.0 && web.cutHalfAngleRad <= 3.1415927);
    require(web.beamHalfAngleRad <= web.fieldHalfAngleRad && web.fieldHalfAngleRad <= web.cutHalfAngleRad);
    for (const float relative : web.relative) require(relative >= 0.0f && relative <= 1.0f);
    const BeamShape shape = webShape(Beam{}, web);
    require(std::isfinite(shape.apexToLensM) && shape.apexToLensM >= 0.0);
    require(std::isfinite(web.relativeAt({0.0, 0.0, -1.0})) &&
            std::isfinite(web.relativeAt({0.3, -0.2, 0.1})));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        check(parseIesWeb({reinterpret_cast<const char*>(data), size}, "fuzz.ies"));
    } catch (const RenderError&) {
        // The answer to a broken file.
    }
    return 0;
}
