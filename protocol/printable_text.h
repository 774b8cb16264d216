// Text from the network, made fit for a terminal, a window and JSON.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hazer::protocol {

/// `bytes` as valid UTF-8 without control characters: everything else becomes U+FFFD, one for each byte.
/// At most maxSize bytes long, cut between characters.
std::string printableText(std::string_view bytes, std::size_t maxSize = 64);

}  // namespace hazer::protocol
