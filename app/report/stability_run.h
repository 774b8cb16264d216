// Draws the cases of hazer report stability and looks at every number.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/report/stability_cases.h"
#include "render/renderer.h"

namespace hazer::app {

/// What a case came to. Errors are relative to the larger of the oracle's light at a pixel and 1e-3 of the
/// brightest pixel compared.
struct StabilityRow {
    std::string name;
    std::size_t rays = 0;
    std::size_t notFinite = 0;  ///< NaN or infinite.
    std::size_t belowZero = 0;
    std::size_t compared = 0;  ///< Rays held against the oracle.
    double medianError = 0.0;
    double p99Error = 0.0;
    double worstError = 0.0;
    std::string verdict;  ///< "ok", or what is wrong first.

    bool passed() const { return verdict == "ok"; }
};

/// Allowed errors of cases that are held against the oracle: at the median and at 99 % of their rays.
inline constexpr double kStabilityMedianError = 2e-3;
inline constexpr double kStabilityP99Error = 5e-2;

/// Counts what is wrong in a picture's numbers by themselves.
StabilityRow countFaults(const std::string& name, const render::FloatImage& picture);

/// Median, 99 % and worst of relative errors, into the row.
void addErrors(std::vector<double> errors, StabilityRow& row);

/// Draws one case, `size` x `size` pixels, and judges it. `renderer` knows the stability meshes and nothing
/// else.
StabilityRow runCase(const StabilityCase& one, render::Renderer& renderer, int size);

/// Every text of refusedShows() must be refused with a sentence.
std::vector<StabilityRow> runRefusals();

/// Scenes of one random, extreme lamp, seen from anywhere, until `rays` rays are drawn; `compareEach` rays of
/// each are held against the oracle. The parameters of the worst ray go into `worst`.
StabilityRow runRandomRays(render::Renderer& renderer, std::size_t rays, int compareEach, std::string& worst,
                           const std::function<void()>& step);

}  // namespace hazer::app
