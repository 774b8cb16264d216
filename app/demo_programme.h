// What the lights of the demo show do, as a pure function of time.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fixtures/fixture.h"

namespace hazer::app {

/// The programme repeats after this time [s]: 20 bars of four beats at 120 beats per minute.
constexpr double kDemoLoopS = 40.0;

/// When to take a still picture [s]: gobos and crossing beams in the air, the band in silhouette.
constexpr double kStrikingMomentS = 9.0;

/// What a fixture is asked for, in the units of Fixture::hold.
struct AttributeValue {
    std::string_view attribute;
    double value;
};

/// What a fixture of app/shows/demo.toml does at `timeS`, which may be any time. The name is a kind and a
/// number from 1, such as "spot3". Empty if the programme does not know that name.
std::vector<AttributeValue> demoLook(std::string_view fixtureName, double timeS);

/// Writes what demoLook asks of a fixture into the 512 slots of its universe. Slots of other fixtures stay.
void writeDemoLook(const fixtures::Fixture& fixture, double timeS, std::span<std::uint8_t> slots);

}  // namespace hazer::app
