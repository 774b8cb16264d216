#include "app/send_output.h"

#include "protocol/sender.h"

namespace hazer::app {
namespace {

class ArtNetOutput : public SendOutput {
 public:
    ArtNetOutput(const std::string& address, std::uint16_t port, std::vector<std::uint16_t> portAddresses,
                 bool synchronizes)
        : sender_(address, port), portAddresses_(std::move(portAddresses)), synchronizes_(synchronizes) {}

    void sendFrame(const protocol::Slots& slots, protocol::TimePoint) override {
        for (const std::uint16_t portAddress : portAddresses_) {
            sender_.send(portAddress, slots);
            ++packetCount_;
        }
        if (!synchronizes_) return;
        sender_.sendSync();
        ++packetCount_;
    }

    std::uint64_t packetCount() const override { return packetCount_; }

 private:
    protocol::ArtNetSender sender_;
    std::vector<std::uint16_t> portAddresses_;
    bool synchronizes_;
    std::uint64_t packetCount_ = 0;
};

class SacnOutput : public SendOutput {
 public:
    SacnOutput(const protocol::SacnSenderConfig& config, std::vector<std::uint16_t> universes,
               std::span<const std::uint8_t> slotPriorities)
        : sender_(config), universes_(std::move(universes)) {
        if (slotPriorities.empty()) return;
        for (const std::uint16_t universe : universes_) sender_.setSlotPriorities(universe, slotPriorities);
    }

    void sendFrame(const protocol::Slots& slots, protocol::TimePoint now) override {
        for (const std::uint16_t universe : universes_) sender_.setLevels(universe, slots);
        sender_.sendDue(now);
    }

    void sendDue(protocol::TimePoint now) override { sender_.sendDue(now); }
    std::optional<protocol::TimePoint> nextDue() const override { return sender_.nextDue(); }
    void finish() override { sender_.terminate(); }
    std::uint64_t packetCount() const override { return sender_.packetCount(); }

 private:
    protocol::SacnSender sender_;
    std::vector<std::uint16_t> universes_;
};

}  // namespace

std::unique_ptr<SendOutput> artNetOutput(const std::string& address, std::uint16_t port,
                                         std::vector<std::uint16_t> portAddresses, bool synchronizes) {
    return std::make_unique<ArtNetOutput>(address, port, std::move(portAddresses), synchronizes);
}

std::unique_ptr<SendOutput> sacnOutput(const protocol::SacnSenderConfig& config,
                                       std::vector<std::uint16_t> universes,
                                       std::span<const std::uint8_t> slotPriorities) {
    return std::make_unique<SacnOutput>(config, std::move(universes), slotPriorities);
}

}  // namespace hazer::app
