#include "app/session.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <utility>

#include "app/paths.h"
#include "app/usb_inputs.h"

namespace hazer::app {
namespace {

double millisecondsSince(protocol::TimePoint start) {
    return std::chrono::duration<double, std::milli>(protocol::Clock::now() - start).count();
}

/// The Port-Addresses that desks should send us: those of our fixtures.
std::vector<std::uint16_t> portAddressesOf(const Patch& patch) {
    std::vector<std::uint16_t> portAddresses;
    for (const protocol::UniverseId& universe : patch.universes()) {
        if (universe.transport == protocol::Transport::kArtNet) portAddresses.push_back(universe.number);
    }
    return portAddresses;
}

render::Settings settingsOf(const Show& show) {
    render::Settings settings;
    settings.exposureEv100 = show.exposureEv100;
    return settings;
}

}  // namespace

Session::Session(Show show, const SessionOptions& options)
    : show_(std::move(show)),
      patch_(show_),
      renderer_(shaderFolder()),
      staging_(show_, renderer_),
      controls_(controlsOf(show_)),
      camera_(show_.cameras.front().camera),
      settings_(settingsOf(show_)) {
    for (const std::string& warning : patch_.fileWarnings())
        spdlog::warn("{}: {}", show_.file.string(), warning);
    for (const std::string& overlap : patch_.overlaps()) spdlog::warn("{}: {}", show_.file.string(), overlap);
    patch_.settle();
    if (!options.listen) return;
    listen(options.port);
    listenToUsb();
}

void Session::listen(const std::optional<std::uint16_t>& port) {
    std::vector<ShowInput> inputs = show_.inputs;
    if (inputs.empty()) inputs.emplace_back();
    for (const protocol::UniverseId universe : patch_.universes()) {
        store_.change([&](protocol::UniverseMerger& merger) { merger.ask(universe); });
    }
    for (const ShowInput& input : inputs) {
        if (input.transport != protocol::Transport::kArtNet) continue;
        protocol::ReceiverConfig config;
        config.address = input.address;
        config.port = port.value_or(input.port);
        config.portAddresses = portAddressesOf(patch_);
        receivers_.push_back(std::make_unique<protocol::Receiver>(config, store_));
    }
}

void Session::listenToUsb() {
    const auto wish = usbWishOf(show_.inputs, patch_.universes());
    if (!wish) return;
    if (wish->isAskedFor || protocol::UsbInput::isBuiltIn()) {
        usb_ = std::make_unique<protocol::UsbInput>(wish->config, store_);
    } else {
        spdlog::warn(
            "{}: fixtures are patched to DMX lines, but this hazer was built without USB (HAZER_USB=OFF)",
            show_.file.string());
    }
}

void Session::advance(double dtS) {
    const protocol::TimePoint start = protocol::Clock::now();
    store_.latch(latched_, start);
    patch_.decode(latched_);
    patch_.step(dtS);
    timeS_ += dtS;
    frameTimes_.advanceMs = millisecondsSince(start);
}

void Session::draw() {
    const protocol::TimePoint start = protocol::Clock::now();
    renderer_.render(scene(), camera_, settings_);
    frameTimes_.drawMs = millisecondsSince(start);
}

render::Scene Session::scene() {
    return staging_.scene(patch_, controls_, timeS_);
}

protocol::ReceiverCounters Session::counters() const {
    protocol::ReceiverCounters sum;
    for (const auto& receiver : receivers_) {
        const protocol::ReceiverCounters one = receiver->counters();
        sum.dmx += one.dmx;
        sum.late += one.late;
        sum.refused += one.refused;
        sum.polls += one.polls;
        sum.ignored += one.ignored;
        sum.malformed += one.malformed;
    }
    return sum;
}

std::vector<protocol::UsbLineStatus> Session::usbDevices() const {
    return usb_ ? usb_->devices() : std::vector<protocol::UsbLineStatus>{};
}

std::uint16_t Session::port() const {
    return receivers_.empty() ? std::uint16_t{0} : receivers_.front()->port();
}

}  // namespace hazer::app
