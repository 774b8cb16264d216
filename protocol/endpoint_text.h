// Addresses as people write them.
#pragma once

#include <string>

#include "protocol/endpoint.h"

namespace hazer::protocol {

/// "10.0.0.5" or "fe80::1", without the port.
std::string addressText(const IpEndpoint& endpoint);

}  // namespace hazer::protocol
