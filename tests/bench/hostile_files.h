// Files that are made to take as much time and memory as their readers let them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hazer::bench {

struct HostileFile {
    std::string name;  ///< Its end tells its kind: .gdtf, .mvr, .3ds, .glb or .png.
    std::function<std::string()> bytes;
};

/// The first of each kind is harmless and small.
std::vector<HostileFile> hostileFiles();

}  // namespace hazer::bench
