// What targets of fixture files share: every mode is patched and driven by the input itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "fixtures/fixture.h"
#include "fixtures/parse_error.h"

namespace hazer::fixtures {

/// The slots are taken from the input, so that the fuzzer finds its way into every channel function.
inline void drive(Fixture& fixture, std::span<const std::uint8_t> data) {
    std::array<std::uint8_t, 512> slots{};
    for (std::size_t index = 0; index < slots.size() && index < data.size(); ++index)
        slots[index] = data[index];
    fixture.decode(slots);
    for (const AttributeRange& range : fixture.attributes()) {
        fixture.encode(range.attribute, range.physicalTo, slots);
        fixture.hold(range.attribute, range.physicalFrom);
    }
    fixture.step(0.02);
    fixture.state();
}

/// `parse(text)` gives a FixtureType or throws ParseError, and nothing else.
template <typename Parse>
void parseAndDrive(std::span<const std::uint8_t> data, const Parse& parse) {
    try {
        const std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
        const auto type = std::make_shared<const FixtureType>(parse(text));
        for (const DmxMode& mode : type->modes) {
            Fixture fixture("fuzz", type, mode.name, 1, glm::dmat4(1.0));
            drive(fixture, data);
        }
    } catch (const ParseError&) {
        // The answer to a broken file.
    }
}

}  // namespace hazer::fixtures
