#include "app/report/accuracy_scenes.h"

#include <algorithm>

#include "app/paths.h"

namespace hazer::app {
namespace {

/// Also a show of its own, beside the others.
const std::string kThesis = "thesis";

std::filesystem::path showOf(const std::string& name) {
    const std::filesystem::path folder = name == kThesis ? showFolder() : showFolder() / "accuracy";
    return folder / (name + ".toml");
}

}  // namespace

const std::vector<std::string>& accuracySceneNames() {
    static const std::vector<std::string> kNames{"plain",       "soft",   "gobo",       "shadow",
                                                 "gobo-shadow", "noise",  "thick-haze", "narrow",
                                                 "wide",        "inside", "crossing",   kThesis};
    return kNames;
}

std::vector<NamedScene> accuracyScenes(const std::vector<std::string>& names) {
    std::vector<NamedScene> scenes;
    for (const std::string& name : accuracySceneNames()) {
        const bool isAsked = names.empty() || std::find(names.begin(), names.end(), name) != names.end();
        if (isAsked) scenes.push_back({name, showOf(name)});
    }
    return scenes;
}

}  // namespace hazer::app
