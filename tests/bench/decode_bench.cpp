// What it costs to turn slots into what fixtures do: milliseconds a frame for many fixtures of many channels,
// and beside it the mere reading of the same slots as numbers in the same run.
//     decode_bench --fixtures 1000
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "fixtures/fixture.h"
#include "tests/protocol/allocation_counter.h"

namespace {

using namespace hazer::fixtures;
using Clock = std::chrono::steady_clock;
using Universe = std::array<std::uint8_t, 512>;

/// One of the 40 channels of the lamp below.
struct Row {
    const char* geometry;
    int geometryIndex;
    const char* attribute;
    double from;
    double to;
    int byteCount;
};

// A profile spot in its large mode: 52 slots.
constexpr std::array kRows{
    Row{"Yoke", 1, "Pan", -270, 270, 2},
    Row{"Head", 2, "Tilt", -135, 135, 2},
    Row{"Head", 2, "Dimmer", 0, 1, 2},
    Row{"Head", 2, "Shutter1Strobe", 0.5, 20, 1},
    Row{"Head", 2, "Zoom", 50, 6, 2},
    Row{"Head", 2, "Focus1", 0, 1, 2},
    Row{"Head", 2, "Iris", 1, 0.1, 2},
    Row{"Head", 2, "Frost1", 0, 1, 1},
    Row{"Head", 2, "Frost2", 0, 1, 1},
    Row{"Head", 2, "ColorSub_C", 0, 1, 2},
    Row{"Head", 2, "ColorSub_M", 0, 1, 2},
    Row{"Head", 2, "ColorSub_Y", 0, 1, 2},
    Row{"Head", 2, "CTO", 6500, 2700, 1},
    Row{"Head", 2, "Tint", -1, 1, 1},
    Row{"Head", 2, "Color1", 0, 1, 2},
    Row{"Head", 2, "Color2", 0, 1, 2},
    Row{"Head", 2, "Gobo1", 0, 1, 1},
    Row{"Head", 2, "Gobo1Pos", 0, 360, 2},
    Row{"Head", 2, "Gobo2", 0, 1, 1},
    Row{"Head", 2, "Gobo2PosRotate", -360, 360, 1},
    Row{"Head", 2, "Gobo3WheelSpin", -90, 90, 1},
    Row{"Head", 2, "AnimationSystem1", 0, 1, 1},
    Row{"Head", 2, "AnimationSystem1PosRotate", -360, 360, 1},
    Row{"Head", 2, "Prism1", 0, 1, 1},
    Row{"Head", 2, "Prism1PosRotate", -360, 360, 1},
    Row{"Head", 2, "Prism2", 0, 1, 1},
    Row{"Head", 2, "Prism2Pos", 0, 360, 1},
    Row{"Head", 2, "Blade1A", 0, 1, 1},
    Row{"Head", 2, "Blade1Rot", -45, 45, 1},
    Row{"Head", 2, "Blade2A", 0, 1, 1},
    Row{"Head", 2, "Blade2Rot", -45, 45, 1},
    Row{"Head", 2, "Blade3A", 0, 1, 1},
    Row{"Head", 2, "Blade3Rot", -45, 45, 1},
    Row{"Head", 2, "Blade4A", 0, 1, 1},
    Row{"Head", 2, "Blade4Rot", -45, 45, 1},
    Row{"Head", 2, "ShaperRot", -60, 60, 1},
    Row{"Head", 2, "Effects1", 0, 1, 1},
    Row{"Head", 2, "ColorMacro1", 0, 1, 1},
    Row{"Head", 2, "Fan1", 0, 1, 1},
    Row{"Head", 2, "FixtureGlobalReset", 0, 1, 1},
};
static_assert(kRows.size() == 40);

constexpr int kWheelSlots = 8;

Geometry node(const char* name, GeometryKind kind) {
    Geometry geometry;
    geometry.name = name;
    geometry.kind = kind;
    return geometry;
}

DmxChannel channelOf(const Row& row, int& offset, FixtureType& type) {
    ChannelFunction function;
    function.name = function.attribute = row.attribute;
    function.physicalFrom = row.from;
    function.physicalTo = row.to;
    DmxChannel channel;
    channel.geometry = row.geometry;
    channel.geometryIndex = row.geometryIndex;
    for (int byte = 0; byte < row.byteCount; ++byte) channel.offsets.push_back(++offset);
    function.dmxTo = channel.maxValue();
    const AttributeKind kind = attributeKind(row.attribute);
    if (kind == AttributeKind::kColorSub) {
        function.filterIndex = static_cast<int>(type.filters.size());
        type.filters.push_back({row.attribute, *defaultColor(row.attribute)});
    }
    if (kind == AttributeKind::kColorWheel || kind == AttributeKind::kGoboWheel) {
        function.wheelIndex = static_cast<int>(type.wheels.size());
        Wheel wheel{row.attribute, {}};
        for (int slot = 0; slot < kWheelSlots; ++slot) {
            wheel.slots.push_back({"Slot", {0.3 + 0.02 * slot, 0.33, 100.0 - 10.0 * slot}, nullptr, {}, {}});
            const std::uint32_t share = channel.maxValue() / kWheelSlots;
            ChannelSet set;
            set.dmxFrom = static_cast<std::uint32_t>(slot) * share;
            set.dmxTo = slot + 1 == kWheelSlots ? channel.maxValue() : set.dmxFrom + share - 1;
            set.wheelSlotIndex = slot + 1;
            function.sets.push_back(set);
        }
        type.wheels.push_back(std::move(wheel));
    }
    channel.logicalChannels.push_back({row.attribute, {function}});
    return channel;
}

FixtureTypePtr lamp() {
    auto type = std::make_shared<FixtureType>();
    type->name = "Bench";
    DmxMode mode;
    mode.name = "Large";
    mode.geometry = node("Base", GeometryKind::kGeometry);
    Geometry yoke = node("Yoke", GeometryKind::kAxis);
    Geometry head = node("Head", GeometryKind::kAxis);
    head.children.push_back(node("Beam", GeometryKind::kBeam));
    yoke.children.push_back(std::move(head));
    mode.geometry.children.push_back(std::move(yoke));
    int offset = 0;
    for (const Row& row : kRows) mode.channels.push_back(channelOf(row, offset, *type));
    mode.footprint = offset;
    type->modes.push_back(std::move(mode));
    return type;
}

/// Slots that all change from frame to frame.
std::vector<Universe> frames() {
    std::vector<Universe> result(16);
    std::uint32_t noise = 1;
    for (Universe& universe : result) {
        for (std::uint8_t& slot : universe) {
            noise = noise * 1664525u + 1013904223u;
            slot = static_cast<std::uint8_t>(noise >> 24);
        }
    }
    return result;
}

struct Cost {
    double medianMs = 0.0;
    double allocations = 0.0;  ///< A frame.
};

template <typename Frame>
Cost costOf(const Frame& frame) {
    constexpr int kWarmUp = 20;
    constexpr int kFrames = 200;
    for (int index = 0; index < kWarmUp; ++index) frame(index);
    std::vector<double> milliseconds;
    const std::size_t allocations = hazer::test::allocationCount();
    for (int index = 0; index < kFrames; ++index) {
        const Clock::time_point start = Clock::now();
        frame(index);
        milliseconds.reserve(kFrames);
        milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    const std::size_t spent = hazer::test::allocationCount() - allocations;
    std::sort(milliseconds.begin(), milliseconds.end());
    return {milliseconds[milliseconds.size() / 2], static_cast<double>(spent - 1) / kFrames};
}

void print(const char* what, const Cost& cost) {
    fmt::print("{:<44} {:8.3f} ms a frame, {:.1f} allocations\n", what, cost.medianMs, cost.allocations);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Times of decoding DMX into what fixtures do");
    int count = 1000;
    app.add_option("--fixtures", count, "How many");
    CLI11_PARSE(app, argc, argv);

    const FixtureTypePtr type = lamp();
    std::vector<Fixture> fixtures;
    for (int index = 0; index < count; ++index) {
        fixtures.emplace_back("Lamp " + std::to_string(index), type, "Large", 1, glm::dmat4(1.0));
    }
    const std::vector<Universe> universes = frames();
    const auto universeAt = [&](int frame) -> const Universe& {
        return universes[static_cast<std::size_t>(frame) % universes.size()];
    };
    FixtureState state;
    volatile double sink = 0.0;

    fmt::print("{} fixtures of {} channels, {} slots each\n", count, kRows.size(), type->modes[0].footprint);
    print("slots added up", costOf([&](int frame) {
              double sum = 0.0;
              for (int index = 0; index < count; ++index) {
                  for (const DmxChannel& channel : type->modes[0].channels) {
                      for (const int offset : channel.offsets) {
                          sum += universeAt(frame + index)[static_cast<std::size_t>(offset - 1)];
                      }
                  }
              }
              sink = sum;
          }));
    print("decode, nothing has changed", costOf([&](int) {
              for (Fixture& fixture : fixtures) fixture.decode(universes[0]);
          }));
    print("decode, every slot has changed", costOf([&](int frame) {
              for (Fixture& fixture : fixtures) fixture.decode(universeAt(frame));
          }));
    print("motion", costOf([&](int) {
              for (Fixture& fixture : fixtures) fixture.step(1.0 / 60.0);
          }));
    print("states: poses, light, optics", costOf([&](int) {
              for (Fixture& fixture : fixtures) {
                  fixture.state(state);
                  sink = sink + state.beams[0].fluxLm;
              }
          }));
    return 0;
}
