// The fixture types of a rig, each read once, with those of hazer's library that stand in for others.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fixtures/fixture_budget.h"
#include "fixtures/mvr.h"

namespace hazer::app {

/// A type and its mode, as one fixture of the rig is patched.
struct RigType {
    fixtures::FixtureTypePtr type;  ///< Null: there is nothing to patch or draw.
    std::string mode;
};

class RigTypes {
 public:
    /// `folder` is where the rig lies: files that it lacks are looked for there. The archive must outlive it.
    RigTypes(fixtures::MvrArchive& archive, std::filesystem::path folder);

    /// `name` is that of the fixture, for warnings and to judge its kind. What is no fixture, such as a
    /// truss, is not replaced: it may well have no light.
    RigType typeOf(const fixtures::MvrDevice& device, const std::string& name, bool isFixture);

    /// What stands in for what and why; each sentence once, and 200 at most.
    const std::vector<std::string>& warnings() const { return warnings_; }

 private:
    /// A GDTF of the rig; without a type, why not.
    struct Loaded {
        fixtures::FixtureTypePtr type;
        std::string fault;
    };

    const Loaded& load(const std::string& spec);
    Loaded read(const std::string& spec, const std::optional<std::size_t>& entry);
    fixtures::FixtureTypePtr libraryType(const std::string& name);
    RigType standIn(const std::string& description, const std::string& reason, const fixtures::DmxMode* mode,
                    const std::string& name);
    const fixtures::DmxMode* modeOf(const fixtures::FixtureType& type, const std::string& mode,
                                    const std::string& name);
    void warn(const std::string& sentence);

    fixtures::MvrArchive& archive_;
    std::filesystem::path folder_;
    std::map<std::string, Loaded> loaded_;  // By the name in the archive, else that in the scene.
    std::map<std::string, fixtures::FixtureTypePtr> library_;
    std::vector<std::string> warnings_;
    fixtures::FixtureBudget budget_;  // Of all GDTFs together.
};

}  // namespace hazer::app
