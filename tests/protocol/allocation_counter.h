// Counts what a test allocates: this test program's operator new is replaced.
#pragma once

#include <cstddef>

namespace hazer::test {

/// Calls of operator new on this thread since it started.
std::size_t allocationCount();

}  // namespace hazer::test
