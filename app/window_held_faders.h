// Faders that a hand has moved: they win over DMX until they are released.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "app/patch.h"
#include "app/show.h"

namespace hazer::app {

/// Knows what the hand holds apart from what the show file holds: a released fader goes back to the show
/// file's value if there is one, else to DMX.
class HeldFaders {
 public:
    explicit HeldFaders(const Show& show);

    /// Holds an attribute at a value in the units of Fixture::hold. Nothing happens if the mode lacks it.
    void hold(fixtures::Fixture& fixture, const std::string& attribute, double value);

    void release(fixtures::Fixture& fixture, const std::string& attribute);
    void releaseAll(Patch& patch);

    bool isHeld(const fixtures::Fixture& fixture, const std::string& attribute) const;

    /// Is any fader of the fixture held?
    bool holdsAny(const fixtures::Fixture& fixture) const;

    std::size_t count() const { return byHand_.size(); }

 private:
    using Key = std::pair<std::string, std::string>;  // fixture name, attribute

    std::map<Key, double> byShow_;
    std::set<Key> byHand_;
};

}  // namespace hazer::app
