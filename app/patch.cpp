#include "app/patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/fixture_library.h"
#include "app/nearest_name.h"
#include "fixtures/fixture_file.h"
#include "fixtures/parse_error.h"

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

std::set<int> slotsOf(const fixtures::Fixture& fixture) {
    std::set<int> slots;
    for (const fixtures::ChannelPatch& channel : fixture.channels()) {
        slots.insert(channel.slots.begin(), channel.slots.end());
    }
    return slots;
}

}  // namespace

std::vector<std::string> attributeNames(const fixtures::Fixture& fixture) {
    std::vector<std::string> names;
    for (const fixtures::AttributeRange& range : fixture.attributes()) names.push_back(range.attribute);
    return names;
}

Patch::Patch(const Show& show) {
    TypesByPath loaded;
    for (const ShowFixture& written : show.fixtures) {
        try {
            fixtures_.push_back(
                {fixtures::Fixture(written.name, loadType(show, written, loaded), written.mode, written.slot,
                                   worldFromPlaced(written.positionM, written.rotationDeg)),
                 written.universe});
        } catch (const std::runtime_error& error) {
            failFixture(show, written, error.what());
        }
        fixtures_.back().fixture.setInertia(show.hasInertia);
        holdAsWritten(show, written, fixtures_.back().fixture);
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
    for (const PatchedFixture& patched : fixtures_) distinct.insert(patched.universe);
    return {distinct.begin(), distinct.end()};
}

std::vector<std::string> Patch::overlaps() const {
    // A whole rig left at address 1 is one mistake, not hundreds.
    constexpr std::size_t kMostSaid = 5;
    std::map<std::pair<protocol::UniverseId, int>, const fixtures::Fixture*> owners;
    std::set<std::pair<const fixtures::Fixture*, const fixtures::Fixture*>> reported;
    std::vector<std::string> sentences;
    for (const PatchedFixture& patched : fixtures_) {
        for (const int slot : slotsOf(patched.fixture)) {
            const auto [owner, isFirst] = owners.try_emplace({patched.universe, slot}, &patched.fixture);
            if (isFirst || !reported.insert({owner->second, &patched.fixture}).second) continue;
            sentences.push_back(fmt::format("'{}' and '{}' share slot {} of universe {}",
                                            owner->second->name(), patched.fixture.name(), slot,
                                            patched.universe.number));
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
    for (PatchedFixture& patched : fixtures_) {
        const auto found = universes.find(patched.universe);
        if (found != universes.end()) patched.fixture.decode(found->second.slots);
    }
}

void Patch::step(double dtS) {
    for (PatchedFixture& patched : fixtures_) patched.fixture.step(dtS);
}

void Patch::settle() {
    for (PatchedFixture& patched : fixtures_) patched.fixture.settle();
}

}  // namespace hazer::app
