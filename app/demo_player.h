// Plays the demo show: its programme goes out as real ArtDmx and comes back in through the session's own
// receiver.
#pragma once

#include <map>

#include "app/patch.h"
#include "protocol/sender.h"

namespace hazer::app {

/// Sends what the demo programme asks of a patch, universe by universe. Reads the patch's addresses only, so
/// that it may run beside a session on another thread with a patch of its own.
class DemoPlayer {
 public:
    /// `patch` must outlive it. Sends to `port` on the loopback interface. Throws protocol::NetworkError.
    DemoPlayer(const Patch& patch, std::uint16_t port);

    /// Sends one ArtDmx for each universe of the patch as it is at `timeS`. Returns how many.
    int send(double timeS);

 private:
    const Patch& patch_;
    protocol::ArtNetSender sender_;
    std::map<protocol::UniverseId, protocol::Slots> slots_;
};

}  // namespace hazer::app
