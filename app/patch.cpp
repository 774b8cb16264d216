#include "app/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/aim.h"
#include "app/fixture_library.h"
#include "app/nearest_name.h"
#include "fixtures/fixture_file.h"
#include "fixtures/parse_error.h"
#include "fixtures/text.h"

namespace hazer::app {
namespace {

using TypesByPath = std::map<std::filesystem::path, fixtures::FixtureTypePtr>;

[[noreturn]] void failFixture(const Show& show, const ShowFixture& fixture, const std::string& what) {
    throw ShowError(
        fmt::format("{}:{}: fixture '{}': {}", show.file.string(), fixture.line, fixture.name, what));
}

fixtures::FixtureTypePtr loadType(const Show& show, const ShowFixture& fixture, TypesByPath& loaded) {
    const std::filesystem::path path = resolveGdtf(fixture.gdtf, show.file.parent_path());
    fixtures::FixtureTypePtr& type = loaded[path];
    if (type == nullptr) type = fixtures::loadFixtureType(path);
    return type;
}

void holdAsWritten(const Show& show, const ShowFixture& written, fixtures::Fixture& fixture) {
    for (const auto& [attribute, value] : written.held) {
        if (fixture.hold(attribute, value)) continue;
        failFixture(show, written,
                    fmt::format("mode '{}' has no attribute '{}'.{}", fixture.mode().name, attribute,
                                suggestName(attribute, attributeNames(fixture))));
    }
}

/// The slots that a break of a fixture hears.
std::set<int> slotsOf(const fixtures::Fixture& fixture, int dmxBreak) {
    std::set<int> slots;
    for (const fixtures::ChannelPatch& channel : fixture.channels()) {
        if (channel.dmxBreak == dmxBreak) slots.insert(channel.slots.begin(), channel.slots.end());
    }
    return slots;
}

fixtures::BreakAddresses breakAddresses(const ShowFixture& written) {
    fixtures::BreakAddresses slots;
    for (const ShowAddress& address : written.addresses) {
        slots.resize(static_cast<std::size_t>(address.dmxBreak));
        slots.back() = address.slot;
    }
    return slots;
}

/// Of a rig, what does not fit is cut off: it has been told, and the rest of it works.
fixtures::Fixture makeFixture(const Show& show, const ShowFixture& written, TypesByPath& loaded) {
    const glm::dmat4 world =
        written.rig ? written.rig->worldFromFixture : worldFromPlaced(written.positionM, written.rotationDeg);
    const fixtures::FixtureTypePtr type = written.rig ? written.rig->type : loadType(show, written, loaded);
    fixtures::Fixture fixture(written.name, type, written.mode, breakAddresses(written), world);
    if (written.rig) return fixture;
    for (const ShowAddress& address : written.addresses)
        fixtures::requireRoom(fixture.mode(), address.dmxBreak, address.slot);
    return fixture;
}

void setAsInRig(const RigFixture& rig, fixtures::Fixture& fixture) {
    fixture.fit(rig.fittings);
    if (rig.focusM) aim(fixture, *rig.focusM);
    for (const auto& [attribute, value] : rig.presets) {
        const bool isAimed = rig.focusM && (fixtures::equalsIgnoringCase(attribute, "Pan") ||
                                            fixtures::equalsIgnoringCase(attribute, "Tilt"));
        if (!isAimed) fixture.preset(attribute, value);
    }
}

void keepHighest(const protocol::Slots& from, protocol::Slots& into) {
    std::ranges::transform(from, into, into.begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
}

}  // namespace

std::optional<protocol::UniverseId> firstUniverse(const PatchedFixture& patched) {
    if (patched.addresses.empty()) return std::nullopt;
    return patched.addresses.front().universes.front();
}

std::vector<std::string> attributeNames(const fixtures::Fixture& fixture) {
    std::vector<std::string> names;
    for (const fixtures::AttributeRange& range : fixture.attributes()) names.push_back(range.attribute);
    return names;
}

Patch::Patch(const Show& show) {
    TypesByPath loaded;
    for (const ShowFixture& written : show.fixtures) {
        try {
            fixtures_.push_back({makeFixture(show, written, loaded), written.addresses});
        } catch (const std::runtime_error& error) {
            failFixture(show, written, error.what());
        }
        fixtures_.back().fixture.setInertia(show.hasInertia);
        if (written.rig) setAsInRig(*written.rig, fixtures_.back().fixture);
        holdAsWritten(show, written, fixtures_.back().fixture);
        addFeeds(fixtures_.size() - 1);
    }
}

void Patch::addFeeds(std::size_t fixture) {
    for (const ShowAddress& address : fixtures_[fixture].addresses) {
        const auto [feed, isNew] = feedIndices_.try_emplace(address.universes, feeds_.size());
        if (isNew) feeds_.push_back({address.universes, {}, nullptr});
        uses_.push_back({fixture, address.dmxBreak, feed->second});
    }
}

PatchedFixture* Patch::find(std::string_view name) {
    const auto found = std::find_if(fixtures_.begin(), fixtures_.end(), [&](const PatchedFixture& patched) {
        return patched.fixture.name() == name;
    });
    return found == fixtures_.end() ? nullptr : &*found;
}

std::vector<std::string> Patch::fixtureNames() const {
    std::vector<std::string> names;
    for (const PatchedFixture& patched : fixtures_) names.push_back(patched.fixture.name());
    return names;
}

std::vector<protocol::UniverseId> Patch::universes() const {
    std::set<protocol::UniverseId> distinct;
    for (const Feed& feed : feeds_) distinct.insert(feed.universes.begin(), feed.universes.end());
    return {distinct.begin(), distinct.end()};
}

std::vector<std::string> Patch::overlaps() const {
    // A whole rig left at address 1 is one mistake, not hundreds.
    constexpr std::size_t kMostSaid = 5;
    std::map<std::pair<std::size_t, int>, const fixtures::Fixture*> owners;
    std::set<std::pair<const fixtures::Fixture*, const fixtures::Fixture*>> reported;
    std::vector<std::string> sentences;
    for (const Use& use : uses_) {
        const fixtures::Fixture& fixture = fixtures_[use.fixture].fixture;
        for (const int slot : slotsOf(fixture, use.dmxBreak)) {
            const auto [owner, isFirst] = owners.try_emplace({use.feed, slot}, &fixture);
            if (isFirst || !reported.insert({owner->second, &fixture}).second) continue;
            sentences.push_back(fmt::format("'{}' and '{}' share slot {} of universe {}",
                                            owner->second->name(), fixture.name(), slot,
                                            feeds_[use.feed].universes.front().number));
        }
    }
    if (sentences.size() > kMostSaid) {
        const std::size_t more = sentences.size() - kMostSaid;
        sentences.resize(kMostSaid);
        sentences.push_back(fmt::format("{} more pairs of fixtures share slots", more));
    }
    return sentences;
}

std::vector<std::string> Patch::fileWarnings() const {
    constexpr std::size_t kMostPerType = 3;
    std::set<const fixtures::FixtureType*> reported;
    std::vector<std::string> sentences;
    for (const PatchedFixture& patched : fixtures_) {
        const fixtures::FixtureType& type = patched.fixture.type();
        if (!reported.insert(&type).second) continue;
        const std::size_t shown = std::min(type.warnings.size(), kMostPerType);
        for (std::size_t i = 0; i < shown; ++i) {
            sentences.push_back(fmt::format("fixture '{}': {}", patched.fixture.name(), type.warnings[i]));
        }
        if (shown == type.warnings.size()) continue;
        sentences.push_back(fmt::format("fixture '{}': {} more; 'hazer inspect' of its file lists them",
                                        patched.fixture.name(), type.warnings.size() - shown));
    }
    return sentences;
}

void Patch::decode(const protocol::UniverseSet& universes) {
    for (Feed& feed : feeds_) {
        feed.slots = nullptr;
        for (const protocol::UniverseId& universe : feed.universes) {
            const auto found = universes.find(universe);
            if (found == universes.end()) continue;
            if (feed.slots == nullptr) {
                feed.slots = &found->second.slots;
                continue;
            }
            if (feed.slots != &feed.merged) feed.merged = *feed.slots;
            keepHighest(found->second.slots, feed.merged);
            feed.slots = &feed.merged;
        }
    }
    for (const Use& use : uses_) {
        const protocol::Slots* const slots = feeds_[use.feed].slots;
        if (slots != nullptr) fixtures_[use.fixture].fixture.decode(*slots, use.dmxBreak);
    }
}

void Patch::step(double dtS) {
    for (PatchedFixture& patched : fixtures_) patched.fixture.step(dtS);
}

void Patch::settle() {
    for (PatchedFixture& patched : fixtures_) patched.fixture.settle();
}

}  // namespace hazer::app
