// A network that belongs to the test program alone, so that multicast stays inside it.
#pragma once

#include <string>

namespace hazer::protocol::test {

/// Moves this process, which must have one thread, into a network namespace of its own with loopback and a
/// cable between two interfaces: viz0 (10.77.0.1, fd77::1) and viz1. Empty if all went well, else a sentence
/// that says why not.
std::string enterOwnNetwork();

/// Runs "ip <arguments>"; whether it went well.
bool ip(const std::string& arguments);

}  // namespace hazer::protocol::test
