#include "app/inputs.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "app/usb_inputs.h"

namespace hazer::app {
namespace {

std::vector<ShowInput> inputsOf(const Show& show) {
    return show.inputs.empty() ? std::vector<ShowInput>(1) : show.inputs;
}

std::vector<protocol::UniverseId> universesOf(const Show& show) {
    std::vector<protocol::UniverseId> universes;
    for (const ShowFixture& fixture : show.fixtures) universes.push_back(fixture.universe);
    std::ranges::sort(universes);
    universes.erase(std::unique(universes.begin(), universes.end()), universes.end());
    return universes;
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

void Inputs::listen(const std::optional<std::uint16_t>& port) {
    for (const ShowInput& input : inputs_) {
        if (input.transport != protocol::Transport::kArtNet) continue;
        protocol::ReceiverConfig config = artNetConfig(input);
        config.port = port.value_or(input.port);
        receivers_.push_back(std::make_unique<protocol::Receiver>(config, store_));
    }
    listenToUsb();
}

void Inputs::listenToUsb() {
    const auto wish = usbWishOf(inputs_, universes_);
    if (!wish) return;
    if (wish->isAskedFor || protocol::UsbInput::isBuiltIn()) {
        usb_ = std::make_unique<protocol::UsbInput>(wish->config, store_);
    } else {
        spdlog::warn(
            "{}: fixtures are patched to DMX lines, but this hazer was built without USB (HAZER_USB=OFF)",
            file_);
    }
}

protocol::ReceiverConfig Inputs::artNetConfig(const ShowInput& input) const {
    protocol::ReceiverConfig config;
    config.address = input.address;
    config.isProgrammable = input.isProgrammable;
    for (const protocol::UniverseId universe : universes_) {
        const bool isOurs = universe.transport == protocol::Transport::kArtNet ||
                            universe.transport == protocol::Transport::kAny;
        if (isOurs && universe.number <= protocol::kMaxPortAddress) {
            config.portAddresses.push_back(universe.number);
        }
    }
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

std::vector<protocol::UsbLineStatus> Inputs::usbDevices() const {
    return usb_ ? usb_->devices() : std::vector<protocol::UsbLineStatus>{};
}

std::uint16_t Inputs::port() const {
    return receivers_.empty() ? std::uint16_t{0} : receivers_.front()->port();
}

}  // namespace hazer::app
