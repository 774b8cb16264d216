// Runs the real program, as a person at a shell would.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace hazer::test {

struct ProcessResult {
    int exitCode = -1;   ///< -1: ended by a signal, or killed for taking too long.
    std::string output;  ///< stdout.
    std::string errors;  ///< stderr.
};

/// Runs `program` with `arguments` and waits for at most 120 s. `environment` adds to this process' own; an
/// empty value takes the variable away.
ProcessResult runProcess(const std::string& program, const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment = {});

}  // namespace hazer::test
