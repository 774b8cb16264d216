// Fixtures of a rig that hang on parts of other fixtures.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "fixtures/fixture_type.h"
#include "fixtures/mvr_scene.h"

namespace hazer::app {

/// The pose at rest of the geometry that a path such as "Base.Yoke.Hook" names in a mode's tree. The path may
/// leave out geometries at its beginning. Empty if there is none.
std::optional<glm::dmat4> restPose(const fixtures::Geometry& root, std::string_view path);

/// Moves what hangs on a part of a fixture, and all below, from the fixture's origin to that part as it is at
/// rest: what is mounted on a head does not turn with it. At most 2000 hang.
class RigMounts {
 public:
    /// Remembers the mode of an object that others may hang on.
    void add(int object, const fixtures::DmxMode& mode) { modes_[object] = &mode; }

    /// From where the scene has an object to where it is; parents have to be asked for before what is in
    /// them. `isFound` is false where its ChildPosition names nothing.
    glm::dmat4 worldFromScene(const fixtures::MvrScene& scene, int object, bool& isFound);

 private:
    std::map<int, const fixtures::DmxMode*> modes_;
    std::map<int, glm::dmat4> moved_;  // Only those that are.
    int mounted_ = 0;
};

}  // namespace hazer::app
