// The scenes that hazer report accuracy knows: shows that come with hazer.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hazer::app {

struct NamedScene {
    std::string name;  ///< What --scene takes, and part of file names.
    std::filesystem::path show;
};

/// What they are called, in the report's order.
const std::vector<std::string>& accuracySceneNames();

/// The scenes of those names, in the report's order; all if there are no names. Throws as showFolder().
std::vector<NamedScene> accuracyScenes(const std::vector<std::string>& names);

}  // namespace hazer::app
