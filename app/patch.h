// The patch: a show's fixtures with their GDTF read, each knowing which universes drive it.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/show.h"
#include "fixtures/fixture.h"
#include "protocol/universe_store.h"

namespace hazer::app {

struct PatchedFixture {
    fixtures::Fixture fixture;
    std::vector<ShowAddress> addresses;  ///< As in the show.
};

/// The universe that drives its first channels, for display; empty if it is not patched.
std::optional<protocol::UniverseId> firstUniverse(const PatchedFixture& patched);

/// Names of the attributes that a fixture's mode has, for messages.
std::vector<std::string> attributeNames(const fixtures::Fixture& fixture);

/// All fixtures of a show, in the show's order.
class Patch {
 public:
    /// Reads every GDTF that the show names, each once, and holds what the show holds. Throws ShowError.
    explicit Patch(const Show& show);

    std::deque<PatchedFixture>& fixtures() { return fixtures_; }
    const std::deque<PatchedFixture>& fixtures() const { return fixtures_; }

    /// Null if the show has no fixture of that name.
    PatchedFixture* find(std::string_view name);

    std::vector<std::string> fixtureNames() const;

    /// Each universe that drives a fixture, once.
    std::vector<protocol::UniverseId> universes() const;

    /// One sentence for each pair of fixtures that share a slot. They are legal, and mostly a mistake.
    std::vector<std::string> overlaps() const;

    /// What was read over in the fixtures' files, such as a gobo picture that is missing; each file once,
    /// three sentences at most and one that says how many more there are.
    std::vector<std::string> fileWarnings() const;

    /// Gives each fixture its universes; fixtures whose universes are not there keep what they have.
    void decode(const protocol::UniverseSet& universes);

    /// Lets all mechanics move for `dtS` >= 0 seconds.
    void step(double dtS);

    /// Puts all mechanics where they want to go.
    void settle();

 private:
    /// What drives a break of a fixture: one universe or, merged, several.
    struct Feed {
        std::vector<protocol::UniverseId> universes;
        protocol::Slots merged{};
        const protocol::Slots* slots = nullptr;  // What stands now; null: nothing was heard yet.
    };
    struct Use {
        std::size_t fixture;
        int dmxBreak;
        std::size_t feed;
    };

    void addFeeds(std::size_t fixture);

    std::deque<PatchedFixture> fixtures_;
    std::deque<Feed> feeds_;
    std::vector<Use> uses_;
    std::map<std::vector<protocol::UniverseId>, std::size_t> feedIndices_;
};

}  // namespace hazer::app
