// The haze that the machines of a show put into its air.
#pragma once

#include "app/patch.h"
#include "fixtures/fixture.h"
#include "render/scene.h"

namespace hazer::app {

/// What all machines of a show blow out together, in machines that run at full.
struct HazeSupply {
    double haze = 0.0;
    double fog = 0.0;

    /// A hazer's fan doubles what stays in the air: more leaves the machine before it condenses.
    void add(const fixtures::HazeOutput& output);
};

/// Of the fixtures as they stand.
HazeSupply supplyOf(const Patch& patch);

/// Haze and fog in a room of the size of a theatre: each machine feeds the air evenly, and the same share of
/// what is there is lost every second. The solution of that is an exponential, exact for any step. Files say
/// nothing of it; the times and densities are what such machines do: haze hangs for minutes, fog for seconds.
class RoomHaze {
 public:
    /// Lets `dtS` >= 0 seconds go by.
    void step(const HazeSupply& supply, double dtS);

    /// As if a long time had gone by.
    void settle(const HazeSupply& supply);

    /// What they add to the air's extinction, all of it by scattering [1/m].
    double extinctionPerM() const { return hazePerM_ + fogPerM_; }

    /// Adds it.
    void addTo(render::Haze& haze) const;

 private:
    double hazePerM_ = 0.0;
    double fogPerM_ = 0.0;
};

}  // namespace hazer::app
