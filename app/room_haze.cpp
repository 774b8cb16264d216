#include "app/room_haze.h"

#include <cmath>

namespace hazer::app {
namespace {

/// Extinction in the end, of one machine at full [1/m], and the time after which 63 % of it is reached, or 37
/// % is left.
constexpr double kHazePerM = 0.008;
constexpr double kHazeS = 120.0;
constexpr double kFogPerM = 0.06;
constexpr double kFogS = 15.0;

double approached(double from, double to, double dtS, double timeS) {
    return to + (from - to) * std::exp(-dtS / timeS);
}

}  // namespace

void HazeSupply::add(const fixtures::HazeOutput& output) {
    haze += output.haze * (1.0 + output.fan);
    fog += output.fog;
}

HazeSupply supplyOf(const Patch& patch) {
    HazeSupply supply;
    for (const PatchedFixture& patched : patch.fixtures()) supply.add(patched.fixture.output());
    return supply;
}

void RoomHaze::addTo(render::Haze& haze) const {
    const auto added = static_cast<float>(extinctionPerM());
    haze.extinctionPerM += added;
    haze.scatteringPerM += added;
}

void RoomHaze::step(const HazeSupply& supply, double dtS) {
    hazePerM_ = approached(hazePerM_, kHazePerM * supply.haze, dtS, kHazeS);
    fogPerM_ = approached(fogPerM_, kFogPerM * supply.fog, dtS, kFogS);
}

void RoomHaze::settle(const HazeSupply& supply) {
    hazePerM_ = kHazePerM * supply.haze;
    fogPerM_ = kFogPerM * supply.fog;
}

}  // namespace hazer::app
