#include "app/demo_player.h"

#include "app/demo_programme.h"

namespace hazer::app {

DemoPlayer::DemoPlayer(const Patch& patch, std::uint16_t port) : patch_(patch), sender_("127.0.0.1", port) {}

int DemoPlayer::send(double timeS) {
    for (const PatchedFixture& patched : patch_.fixtures()) {
        if (const auto universe = firstUniverse(patched))
            writeDemoLook(patched.fixture, timeS, slots_[*universe]);
    }
    for (const auto& [universe, slots] : slots_) sender_.send(universe.number, slots);
    return static_cast<int>(slots_.size());
}

}  // namespace hazer::app
