#include "app/inputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "app/show_universes.h"
#include "app/usb_inputs.h"

namespace hazer::app {
namespace {

bool isPatchedTo(protocol::Transport transport, const Show& show) {
    return std::ranges::any_of(universesOf(show), [&](const protocol::UniverseId& universe) {
        return universe.transport == transport || universe.transport == protocol::Transport::kAny;
    });
}

std::vector<ShowInput> inputsOf(const Show& show) {
    if (!show.inputs.empty()) return show.inputs;
    std::vector<ShowInput> inputs;
    const bool hasSacn = isPatchedTo(protocol::Transport::kSacn, show);
    if (!hasSacn || isPatchedTo(protocol::Transport::kArtNet, show) || followsTimeCode(show)) {
        inputs.push_back(inputOf(protocol::Transport::kArtNet));
    }
    if (hasSacn) inputs.push_back(inputOf(protocol::Transport::kSacn));
    return inputs;
}

// Those of a universe's own transport; where there are none, or where all transports merge, the first of all.
const ShowInput& rulesFor(protocol::UniverseId universe, const std::vector<ShowInput>& inputs) {
    const auto own = std::ranges::find(inputs, universe.transport, &ShowInput::transport);
    return own == inputs.end() ? inputs.front() : *own;
}

template <class Received>
void keepLatest(std::optional<Received>& kept, const std::optional<Received>& other) {
    if (other && (!kept || other->time > kept->time)) kept = other;
}

void add(protocol::ReceiverCounters& sum, const protocol::ReceiverCounters& one) {
    sum.dmx += one.dmx;
    sum.late += one.late;
    sum.refused += one.refused;
    sum.polls += one.polls;
    sum.syncs += one.syncs;
    sum.control += one.control;
    sum.ignored += one.ignored;
    sum.malformed += one.malformed;
    sum.droppedBySystem += one.droppedBySystem;
}

}  // namespace

std::vector<ShowInput> everyInput() {
    std::vector<ShowInput> inputs{inputOf(protocol::Transport::kArtNet), inputOf(protocol::Transport::kSacn)};
    if (protocol::UsbInput::isBuiltIn()) inputs.push_back(inputOf(protocol::Transport::kDmx));
    return inputs;
}

Inputs::Inputs(const Show& show)
    : file_(show.file.string()),
      inputs_(inputsOf(show)),
      universes_(universesOf(show)),
      store_({.mode = inputs_.front().merge, .loss = inputs_.front().loss}) {
    store_.change([&](protocol::UniverseMerger& merger) {
        for (const protocol::UniverseId universe : universes_) {
            const ShowInput& rules = rulesFor(universe, inputs_);
            merger.setMode(universe, rules.merge);
            merger.setLoss(universe, rules.loss);
            merger.ask(universe);
        }
    });
}

void Inputs::listen(const ListenOptions& options) {
    for (const ShowInput& input : inputs_) {
        if (input.transport == protocol::Transport::kArtNet) {
            receivers_.push_back(std::make_unique<protocol::Receiver>(artNetConfig(input, options), store_));
        } else if (input.transport == protocol::Transport::kSacn) {
            sacnReceivers_.push_back(
                std::make_unique<protocol::SacnReceiver>(sacnConfig(input, options), store_));
        }
    }
    listenToUsb(options);
}

void Inputs::listenToUsb(const ListenOptions& options) {
    auto wish = usbWishOf(inputs_, universes_);
    if (!wish) return;
    if (wish->isAskedFor || protocol::UsbInput::isBuiltIn()) {
        wish->config.tap = options.usbTap;
        usb_ = std::make_unique<protocol::UsbInput>(wish->config, store_);
    } else {
        spdlog::warn(
            "{}: fixtures are patched to DMX lines, but this hazer was built without USB (HAZER_USB=OFF)",
            file_);
    }
}

protocol::ReceiverConfig Inputs::artNetConfig(const ShowInput& input, const ListenOptions& options) const {
    protocol::ReceiverConfig config;
    config.address = input.address;
    config.port = options.ports.artNet.value_or(input.port);
    config.isProgrammable = input.isProgrammable;
    config.portAddresses = numbersOn(protocol::Transport::kArtNet, universes_);
    config.tap = options.tap;
    return config;
}

protocol::SacnReceiverConfig Inputs::sacnConfig(const ShowInput& input, const ListenOptions& options) const {
    protocol::SacnReceiverConfig config;
    config.universes = numbersOn(protocol::Transport::kSacn, universes_);
    config.universes.insert(config.universes.end(), options.sacnUniverses.begin(),
                            options.sacnUniverses.end());
    config.joinsAnnounced = options.joinsAnnounced;
    config.interface = input.interface;
    config.port = options.ports.sacn.value_or(input.port);
    config.preview = input.preview;
    config.tap = options.tap;
    config.notice = [](const std::string& sentence) { spdlog::warn("{}", sentence); };
    return config;
}

protocol::ArtNetStatus Inputs::artNet() const {
    protocol::ArtNetStatus all;
    for (const auto& receiver : receivers_) {
        const protocol::ArtNetStatus one = receiver->status();
        add(all.counters, one.counters);
        keepLatest(all.timeCode, one.timeCode);
        keepLatest(all.trigger, one.trigger);
    }
    return all;
}

std::vector<protocol::SacnReport> Inputs::sacn() const {
    std::vector<protocol::SacnReport> reports;
    for (const auto& receiver : sacnReceivers_) reports.push_back(receiver->report());
    return reports;
}

std::vector<protocol::UsbLineStatus> Inputs::usbDevices() const {
    return usb_ ? usb_->devices() : std::vector<protocol::UsbLineStatus>{};
}

std::string Inputs::description() const {
    std::vector<std::string> parts;
    for (const auto& one : receivers_) parts.push_back(fmt::format("Art-Net on UDP port {}", one->port()));
    for (const auto& one : sacnReceivers_) parts.push_back(fmt::format("sACN on UDP port {}", one->port()));
    if (usb_) parts.push_back("USB interfaces");
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::uint16_t Inputs::port() const {
    return receivers_.empty() ? std::uint16_t{0} : receivers_.front()->port();
}

std::uint16_t Inputs::sacnPort() const {
    return sacnReceivers_.empty() ? std::uint16_t{0} : sacnReceivers_.front()->port();
}

}  // namespace hazer::app
