// A limit on how deep the keys of a TOML text lie in each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hazer::app {

/// The line, from 1, of a key with more dots than any show has, such as a.b.c.d ...; empty if there is none.
/// toml++ limits nested brackets, but not these: on tens of thousands its recursion overflows the stack.
std::optional<std::size_t> lineOfDeepKey(std::string_view toml);

}  // namespace hazer::app
