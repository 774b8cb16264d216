// Text from the network, made fit for a terminal, a window and JSON.
#pragma once

#include <string>
#include <string_view>

namespace hazer::protocol {

/// `bytes` as valid UTF-8 without control characters: everything else becomes U+FFFD, one for each byte.
std::string printableText(std::string_view bytes);

}  // namespace hazer::protocol
