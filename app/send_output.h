// Where synthetic levels go: Art-Net or sACN behind one face.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/sacn_sender.h"

namespace hazer::app {

/// Sends the same levels to each of its universes.
class SendOutput {
 public:
    virtual ~SendOutput() = default;

    /// The levels of a frame. Throws protocol::NetworkError, as the others do.
    virtual void sendFrame(const protocol::Slots& slots, protocol::TimePoint now) = 0;

    /// Sends what is due between frames.
    virtual void sendDue(protocol::TimePoint) {}

    /// When that will be; nothing: never.
    virtual std::optional<protocol::TimePoint> nextDue() const { return std::nullopt; }

    /// Says goodbye, where the protocol has a word for it.
    virtual void finish() {}

    virtual std::uint64_t packetCount() const = 0;
};

/// ArtDmx for every universe with every frame; with `synchronizes`, an ArtSync after them.
std::unique_ptr<SendOutput> artNetOutput(const std::string& address, std::uint16_t port,
                                         std::vector<std::uint16_t> portAddresses, bool synchronizes);

/// sACN: changes with their repeats, then keep-alive; universe discovery; termination at the end.
/// `slotPriorities` may be empty.
std::unique_ptr<SendOutput> sacnOutput(const protocol::SacnSenderConfig& config,
                                       std::vector<std::uint16_t> universes,
                                       std::span<const std::uint8_t> slotPriorities);

}  // namespace hazer::app
