#include "protocol/usb/usb_input.h"

#include <fmt/format.h>
#include <libusb.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "protocol/usb/ftdi_setup.h"
#include "protocol/usb/libusb_handles.h"
#include "protocol/usb/usb_interfaces.h"
#include "protocol/usb/usb_line.h"

namespace hazer::protocol {

void LibusbDelete::operator()(libusb_context* context) const {
    libusb_exit(context);
}

void LibusbDelete::operator()(libusb_device* device) const {
    libusb_unref_device(device);
}

void LibusbDelete::operator()(libusb_device_handle* handle) const {
    libusb_close(handle);
}

namespace {

using namespace std::chrono_literals;

// Longer gaps than this between breaks are no DMX (ANSI E1.11 for receivers).
constexpr auto kDmxLoss = 1250ms;
constexpr auto kPublishEvery = 100ms;

/// FNV-1a of the key: two runs give an interface the same id.
SourceId sourceIdOf(const std::string& key) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char letter : key) hash = (hash ^ static_cast<std::uint8_t>(letter)) * 1099511628211ULL;
    SourceId source{Transport::kDmx, {}};
    for (std::size_t i = 0; i < sizeof hash; ++i) source.id[i] = static_cast<std::uint8_t>(hash >> 8 * i);
    return source;
}

/// A wanted input of a device that is plugged in, open or not.
struct Input {
    UsbInterface interface;
    int port = 0;
    std::string key;
    SourceId source;
    std::uint16_t universe = 0;
    TimePoint openAt{};  ///< When to try, while it is not open.
    TimePoint lastFrame{};
    std::string problem;
    std::string named;  ///< What the universe's status calls it.
    std::unique_ptr<UsbLine> line;

    bool is(const UsbInterface& other) const {
        return interface.bus == other.bus && interface.device == other.device && interface.port == other.port;
    }
};

/// "SERIAL", "usb-1-1.2"; the second port of a chip: "SERIAL-B".
std::string keyOf(const UsbInterface& interface, int port) {
    std::string key = interface.serial.empty() ? "usb-" + interface.port : interface.serial;
    if (port > 0) key += fmt::format("-{}", static_cast<char>('A' + port));
    return key;
}

int portCount(const UsbInterface& interface) {
    return interface.family == UsbFamily::kFtdi ? ftdiPortCount(interface.product) : 1;
}

}  // namespace

struct UsbInput::Impl {
    Impl(UsbConfig used, UniverseStore& filled)
        : config(std::move(used)), store(filled), universes(config.bindings, config.firstUniverse) {
        thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
    }

    ~Impl() {
        thread.request_stop();
        {
            const std::lock_guard lock(mutex);
            if (context) libusb_interrupt_event_handler(context.get());
        }
        thread.join();
    }

    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const TimePoint now = Clock::now();
            if (busChanged || now >= lookAt) look(now);
            for (const auto& input : inputs) keepOpen(*input, now);
            if (now >= publishAt) publish(now);
            wait(stop);
        }
        inputs.clear();
    }

    void look(TimePoint now) {
        busChanged = false;
        lookAt = now + config.lookEvery;
        const auto found = findUsbInterfaces(config.sysfs);
        std::erase_if(inputs, [&](const auto& input) {
            const bool isGone = std::ranges::none_of(found, [&](const auto& one) { return input->is(one); });
            if (isGone) leave(*input);
            return isGone;
        });
        for (const UsbInterface& interface : found) {
            if (std::ranges::none_of(inputs, [&](const auto& input) { return input->is(interface); }))
                add(interface);
        }
        publishAt = now;
    }

    void add(const UsbInterface& interface) {
        for (int port = 0; port < portCount(interface); ++port) {
            std::string key = keyOf(interface, port);
            if (!isWanted(interface, key)) continue;
            // Some makers give all their interfaces the same serial number.
            if (std::ranges::any_of(inputs, [&](const auto& input) { return input->key == key; }))
                key += "@" + interface.port;
            const auto universe = universes.of(key);
            if (!universe) continue;
            auto input = std::make_unique<Input>();
            input->interface = interface;
            input->port = port;
            input->key = key;
            input->source = sourceIdOf(key);
            input->universe = *universe;
            inputs.push_back(std::move(input));
        }
    }

    bool isWanted(const UsbInterface& interface, const std::string& key) const {
        const bool isBound = std::ranges::any_of(
            config.bindings, [&](const UsbBinding& binding) { return binding.serial == key; });
        return isBound || config.others == UsbOthers::kAll ||
               (config.others == UsbOthers::kThoseThatNameDmx && namesDmx(interface));
    }

    void keepOpen(Input& input, TimePoint now) {
        if (!input.line && now < input.openAt) return;
        try {
            if (!input.line) open(input, now);
            if (input.line) input.line->advance(now);
        } catch (const UsbError& error) {
            input.line.reset();
            input.openAt = now + config.lookEvery;
            input.problem = fmt::format("USB interface {} ({}) cannot be used: {}.",
                                        describe(input.interface), input.key, error.what());
            if (error.isUnplugged()) leave(input);
            publishAt = now;
        }
    }

    void open(Input& input, TimePoint now) {
        input.openAt = now + config.lookEvery;
        useLibusb();
        const LibusbDevice device = deviceOf(input.interface);
        if (!device) return;  // libusb hears of it in a moment
        const auto show = [this, &input](std::span<const std::uint8_t> slots) { take(input, slots); };
        input.line =
            std::make_unique<UsbLine>(context.get(), device.get(), input.interface, input.port, show);
        input.problem.clear();
        publishAt = now;
    }

    void useLibusb() {
        if (context) return;
        libusb_context* made = nullptr;
        if (const int failure = libusb_init(&made); failure != 0) throw UsbError(failure);
        const std::lock_guard lock(mutex);
        context.reset(made);
        // Where this does not work, one is found a little later.
        libusb_hotplug_register_callback(
            made, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
            LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, &Impl::onHotplug,
            this, nullptr);
    }

    static int LIBUSB_CALL onHotplug(libusb_context*, libusb_device*, libusb_hotplug_event,
                                     void* input) noexcept {
        static_cast<Impl*>(input)->busChanged = true;
        return 0;  // call again
    }

    LibusbDevice deviceOf(const UsbInterface& interface) const {
        libusb_device** list = nullptr;
        const auto count = libusb_get_device_list(context.get(), &list);
        LibusbDevice device;
        for (libusb_device* candidate :
             std::span(list, static_cast<std::size_t>(std::max<ssize_t>(count, 0)))) {
            if (libusb_get_bus_number(candidate) == interface.bus &&
                libusb_get_device_address(candidate) == interface.device)
                device.reset(libusb_ref_device(candidate));
        }
        if (count >= 0) libusb_free_device_list(list, 1);
        return device;
    }

    void take(Input& input, std::span<const std::uint8_t> slots) {
        const UniverseId universe = idOf(input);
        store.change([&](UniverseMerger& merger) {
            input.lastFrame = Clock::now();
            merger.show({.universe = universe, .source = input.source, .slots = slots}, input.lastFrame);
        });
        if (config.tap) config.tap(universe, slots, std::chrono::system_clock::now());
    }

    static UniverseId idOf(const Input& input) { return {Transport::kDmx, input.universe}; }

    void leave(const Input& input) {
        store.change([&](UniverseMerger& merger) { merger.leave(idOf(input), input.source, Clock::now()); });
    }

    /// Says in the universe's status who sends.
    void name(Input& input, const UsbLineStatus& status) {
        if (input.lastFrame == TimePoint{} || input.named == status.name) return;
        input.named = status.name;
        const std::string address = fmt::format("USB {}, {}", status.socket, status.key);
        store.change([&](UniverseMerger& merger) {
            merger.describe(idOf(input), input.source, status.name, address);
        });
    }

    void wait(const std::stop_token& stop) {
        TimePoint until = std::min(lookAt, publishAt);
        for (const auto& input : inputs) {
            if (!input->line)
                until = std::min(until, input->openAt);
            else if (const auto deadline = input->line->nextDeadline())
                until = std::min(until, *deadline);
        }
        if (!context || !handleEvents(until)) sleep(stop, until);
    }

    /// False if libusb cannot.
    bool handleEvents(TimePoint until) {
        const auto left = std::max(Clock::duration(0), until - Clock::now());
        const auto us = std::chrono::duration_cast<std::chrono::microseconds>(left).count();
        timeval longest{.tv_sec = us / 1'000'000, .tv_usec = us % 1'000'000};
        const int result = libusb_handle_events_timeout_completed(context.get(), &longest, nullptr);
        return result == 0 || result == LIBUSB_ERROR_INTERRUPTED;
    }

    void sleep(const std::stop_token& stop, TimePoint until) {
        std::unique_lock lock(mutex);
        wakeUp.wait_until(lock, stop, until, [] { return false; });
    }

    UsbLineStatus statusOf(const Input& input, TimePoint now) const {
        UsbLineStatus status;
        status.key = input.key;
        status.socket = input.interface.port;
        status.problem = input.problem;
        status.universe = idOf(input);
        if (input.line) status.facts = input.line->facts();
        status.name = status.facts.name.empty() ? describe(input.interface) : status.facts.name;
        status.state = stateOf(input, now);
        return status;
    }

    static UsbState stateOf(const Input& input, TimePoint now) {
        if (!input.line) return input.problem.empty() ? UsbState::kStarting : UsbState::kFailed;
        if (input.lastFrame != TimePoint{} && now - input.lastFrame <= kDmxLoss) return UsbState::kReceiving;
        return input.line->nextDeadline() ? UsbState::kStarting : UsbState::kSilent;
    }

    void publish(TimePoint now) {
        // Without an input nothing changes until one is found.
        publishAt = inputs.empty() ? TimePoint::max() : now + kPublishEvery;
        std::vector<UsbLineStatus> statuses;
        for (const auto& input : inputs) {
            statuses.push_back(statusOf(*input, now));
            name(*input, statuses.back());
        }
        std::ranges::sort(statuses, {},
                          [](const UsbLineStatus& one) { return std::pair(one.socket, one.key); });
        const std::lock_guard lock(mutex);
        published = std::move(statuses);
    }

    const UsbConfig config;
    UniverseStore& store;
    UsbUniverses universes;
    mutable std::mutex mutex;  ///< Of `published`, and of `context` while it is made.
    std::vector<UsbLineStatus> published;
    LibusbContext context;
    std::vector<std::unique_ptr<Input>> inputs;  ///< Closed before the context.
    bool busChanged = false;
    TimePoint lookAt{};
    TimePoint publishAt{};
    std::condition_variable_any wakeUp;
    std::jthread thread;
};

UsbInput::UsbInput(UsbConfig config, UniverseStore& store)
    : impl_(std::make_unique<Impl>(std::move(config), store)) {}

UsbInput::~UsbInput() = default;

std::vector<UsbLineStatus> UsbInput::devices() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->published;
}

bool UsbInput::usesLibusb() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->context != nullptr;
}

bool UsbInput::isBuiltIn() {
    return true;
}

}  // namespace hazer::protocol
