#include "app/assignment.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/nearest_name.h"
#include "fixtures/text.h"

namespace hazer::app {
namespace {

struct Assignment {
    std::string fixture;
    std::string attribute;
    double value;
};

std::optional<Assignment> parseAssignment(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) return std::nullopt;
    const std::size_t dot = text.rfind('.', equals);
    if (dot == std::string::npos || dot == 0 || dot + 1 == equals) return std::nullopt;
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return Assignment{text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), value};
}

/// A fixture stops at the end of its range; "Dimmer=50", meant as percent, would pass for 1 without a word.
void warnIfOutOfRange(const std::string& text, const Assignment& assignment,
                      const fixtures::Fixture& fixture) {
    for (const fixtures::AttributeRange& range : fixture.attributes()) {
        if (!fixtures::equalsIgnoringCase(range.attribute, assignment.attribute)) continue;
        const bool isWheel = range.wheelSlotCount > 0;
        const auto [from, to] = isWheel ? std::pair(1.0, static_cast<double>(range.wheelSlotCount))
                                        : std::minmax({range.physicalFrom, range.physicalTo});
        if (assignment.value >= from && assignment.value <= to) return;
        spdlog::warn("--set {}: {} goes from {} to {}; the nearest of them is used", text, range.attribute,
                     from, to);
        return;
    }
}

/// Holds it in every fixture that has the attribute; says so if there is none.
void assignToAll(const std::string& text, const Assignment& assignment, Patch& patch) {
    bool isKnown = false;
    std::set<std::string> attributes;
    for (PatchedFixture& patched : patch.fixtures()) {
        isKnown |= patched.fixture.hold(assignment.attribute, assignment.value);
        for (std::string& name : attributeNames(patched.fixture)) attributes.insert(std::move(name));
    }
    if (isKnown) return;
    const std::vector<std::string> names(attributes.begin(), attributes.end());
    throw std::runtime_error(fmt::format("{}: no fixture has an attribute '{}'.{}", text,
                                         assignment.attribute, suggestName(assignment.attribute, names)));
}

}  // namespace

std::string checkAssignment(const std::string& text) {
    if (parseAssignment(text)) return {};
    return fmt::format("'{}' must read FIXTURE.Attribute=VALUE with a number, such as spot1.Tilt=30", text);
}

void assign(const std::string& text, Patch& patch) {
    const std::optional<Assignment> assignment = parseAssignment(text);
    if (!assignment) throw std::runtime_error(checkAssignment(text));
    if (assignment->fixture == "*") return assignToAll(text, *assignment, patch);
    PatchedFixture* patched = patch.find(assignment->fixture);
    if (patched == nullptr) {
        throw std::runtime_error(fmt::format("{}: the show has no fixture '{}'.{}", text, assignment->fixture,
                                             suggestName(assignment->fixture, patch.fixtureNames())));
    }
    if (patched->fixture.hold(assignment->attribute, assignment->value)) {
        warnIfOutOfRange(text, *assignment, patched->fixture);
        return;
    }
    throw std::runtime_error(
        fmt::format("{}: '{}' has no attribute '{}'.{}", text, assignment->fixture, assignment->attribute,
                    suggestName(assignment->attribute, attributeNames(patched->fixture))));
}

}  // namespace hazer::app
