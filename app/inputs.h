// The receivers of a show, and the universes they fill. Needs no OpenGL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/show.h"
#include "protocol/datagram.h"
#include "protocol/receiver.h"
#include "protocol/sacn_receiver.h"
#include "protocol/universe_store.h"
#include "protocol/usb/usb_input.h"

namespace hazer::app {

/// UDP ports that replace those of the show's inputs; 0 lets the system choose.
struct InputPorts {
    std::optional<std::uint16_t> artNet{};
    std::optional<std::uint16_t> sacn{};
};

/// What a command asks for beyond what the show says.
struct ListenOptions {
    InputPorts ports{};
    std::vector<std::uint16_t> sacnUniverses{};  ///< 1..63999 each: their groups are joined, too.
    bool joinsAnnounced = false;                 ///< sACN: see SacnReceiverConfig::joinsAnnounced.
    protocol::DatagramTap tap{};                 ///< Hears every datagram, on several threads; may be empty.
    protocol::UsbTap usbTap{};                   ///< Hears every frame of USB; may be empty.
};

/// The inputs of a command that wants whatever there is: Art-Net and sACN on every interface, and USB where
/// it is built in.
std::vector<ShowInput> everyInput();

class Inputs {
 public:
    /// Rules and universes of the show; nothing listens yet.
    explicit Inputs(const Show& show);

    /// Opens the inputs of the show. A show without any listens on every interface, to sACN if fixtures are
    /// patched to it, and to Art-Net unless all are patched elsewhere and nothing follows its time code.
    /// Throws protocol::NetworkError.
    void listen(const ListenOptions& options);

    /// Copies what stands at `now` into `out`, as one consistent set.
    void latch(protocol::UniverseSet& out, protocol::TimePoint now) { store_.latch(out, now); }

    std::vector<protocol::UniverseStatus> status(protocol::TimePoint now) { return store_.status(now); }

    /// What all receivers of Art-Net together have seen, and the latest time code and trigger of any.
    protocol::ArtNetStatus artNet() const;

    /// Whether a time code can arrive, which only Art-Net brings.
    bool hearsTimeCode() const { return !receivers_.empty(); }

    /// What sACN tells besides its universes, receiver by receiver.
    std::vector<protocol::SacnReport> sacn() const;

    /// Every USB interface that the show wants and that is plugged in.
    std::vector<protocol::UsbLineStatus> usbDevices() const;

    /// "Art-Net on UDP port 6454, sACN on UDP port 5568"; empty if nothing listens.
    std::string description() const;

    /// The UDP port that the first receiver of Art-Net really bound; 0 if nothing listens.
    std::uint16_t port() const;

    std::uint16_t sacnPort() const;  ///< The same of sACN.

 private:
    void listenToUsb(const ListenOptions& options);
    protocol::ReceiverConfig artNetConfig(const ShowInput& input, const ListenOptions& options) const;
    protocol::SacnReceiverConfig sacnConfig(const ShowInput& input, const ListenOptions& options) const;

    std::string file_;  ///< Of the show, for warnings.
    std::vector<ShowInput> inputs_;
    std::vector<protocol::UniverseId> universes_;  ///< Of the show's fixtures, each once.
    protocol::UniverseStore store_;
    std::vector<std::unique_ptr<protocol::Receiver>>
        receivers_;  ///< After store_: their threads write into it.
    std::vector<std::unique_ptr<protocol::SacnReceiver>> sacnReceivers_;  ///< The same.
    std::unique_ptr<protocol::UsbInput> usb_;                             ///< The same.
};

}  // namespace hazer::app
