// What this process has taken at most so far.
#pragma once

#include <fstream>
#include <string>

namespace hazer::bench {

/// In MiB; 0 where the system does not tell.
inline double peakMib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
    }
    return 0.0;
}

}  // namespace hazer::bench
