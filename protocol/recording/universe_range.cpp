#include "protocol/recording/universe_range.h"

#include <fmt/format.h>

namespace hazer::protocol {
namespace {

struct Range {
    std::int64_t first;
    std::int64_t last;
    const char* name;
};

Range rangeOf(Transport transport) {
    switch (transport) {
        case Transport::kArtNet:
            return {0, 32767, "Art-Net"};
        case Transport::kSacn:
            return {1, 63999, "sACN"};
        case Transport::kDmx:
        case Transport::kAny:
            break;
    }
    return {0, 65535, "DMX"};
}

std::int64_t mappedNumber(const FrameMap& map, std::uint32_t number) {
    return std::int64_t{map.firstUniverse} + number - 1;
}

}  // namespace

std::optional<UniverseId> universeAt(const FrameMap& map, std::uint32_t number) {
    const Range range = rangeOf(map.transport);
    const std::int64_t mapped = mappedNumber(map, number);
    if (mapped < range.first || mapped > range.last) return std::nullopt;
    return UniverseId{map.transport, static_cast<std::uint16_t>(mapped)};
}

std::string outOfRange(const FrameMap& map, std::uint32_t number) {
    const Range range = rangeOf(map.transport);
    return fmt::format(
        "universe {} would become {}, but {} universes are {}..{}; choose another first universe", number,
        mappedNumber(map, number), range.name, range.first, range.last);
}

}  // namespace hazer::protocol
