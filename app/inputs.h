// The receivers of a show, and the universes they fill. Needs no OpenGL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/show.h"
#include "protocol/receiver.h"
#include "protocol/universe_store.h"
#include "protocol/usb/usb_input.h"

namespace hazer::app {

class Inputs {
 public:
    /// Rules and universes of the show; nothing listens yet.
    explicit Inputs(const Show& show);

    /// Opens the inputs of the show. A show without any listens to Art-Net on every interface. `port` takes
    /// the place of the port of each; 0 lets the system choose. Throws protocol::NetworkError.
    void listen(const std::optional<std::uint16_t>& port);

    /// Copies what stands at `now` into `out`, as one consistent set.
    void latch(protocol::UniverseSet& out, protocol::TimePoint now) { store_.latch(out, now); }

    std::vector<protocol::UniverseStatus> status(protocol::TimePoint now) { return store_.status(now); }

    /// What all receivers of Art-Net together have seen, and the latest time code and trigger of any.
    protocol::ArtNetStatus artNet() const;

    /// Every USB interface that the show wants and that is plugged in.
    std::vector<protocol::UsbLineStatus> usbDevices() const;

    /// The UDP port that the first receiver really bound; 0 if nothing listens.
    std::uint16_t port() const;

 private:
    void listenToUsb();
    protocol::ReceiverConfig artNetConfig(const ShowInput& input) const;

    std::string file_;  ///< Of the show, for warnings.
    std::vector<ShowInput> inputs_;
    std::vector<protocol::UniverseId> universes_;  ///< Of the show's fixtures, each once.
    protocol::UniverseStore store_;
    std::vector<std::unique_ptr<protocol::Receiver>>
        receivers_;                            ///< After store_: their threads write into it.
    std::unique_ptr<protocol::UsbInput> usb_;  ///< The same.
};

}  // namespace hazer::app
