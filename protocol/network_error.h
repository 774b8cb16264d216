// The one exception of the protocol module: something about the network that a person has to mend.
#pragma once

#include <stdexcept>

namespace hazer::protocol {

/// what() is one sentence with the address and port, the system's reason, and what to do about it.
class NetworkError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace hazer::protocol
