#include "protocol/sacn_receiver.h"

#include <fmt/format.h>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>
#include <map>
#include <mutex>
#include <thread>

#include "protocol/datagram_batch.h"
#include "protocol/sacn_sockets.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

// How soon a cable that was plugged in is noticed.
constexpr std::chrono::milliseconds kInterfaceInterval{500};

// Full batches taken from one socket before the others have their turn.
constexpr int kBatchesInARow = 4;

struct LocalAddresses {
    std::optional<asio::ip::address_v4> v4 = asio::ip::address_v4::any();
    std::optional<asio::ip::address_v6> v6 = asio::ip::address_v6::any();
};

// Loopback is bound to, so that nothing reaches it from outside. Any other interface is not: a socket bound
// to one of its addresses would hear no multicast.
LocalAddresses localAddresses(const std::string& chosen, const NetworkInterface& interface) {
    if (!interface.isLoopback) return {};
    std::error_code notAnAddress;
    const asio::ip::address address = asio::ip::make_address(chosen, notAnAddress);
    if (notAnAddress) return {asio::ip::address_v4::loopback(), std::nullopt};
    if (address.is_v6()) return {std::nullopt, address.to_v6()};
    return {address.to_v4(), std::nullopt};
}

LocalAddresses localAddresses(const std::string& chosen) {
    if (chosen.empty()) return {};
    const auto interface = findInterface(networkInterfaces(), chosen);
    if (!interface) throwUnknownInterface(chosen);
    return localAddresses(chosen, *interface);
}

}  // namespace

struct SacnReceiver::Impl {
    Impl(SacnReceiverConfig receiverConfig, UniverseStore& universeStore)
        : config(std::move(receiverConfig)),
          local(localAddresses(config.interface)),
          store(universeStore),
          listener(config.preview),
          sockets(
              context, local.v4, local.v6, config.port, [this](udp::socket& one) { read(one); },
              config.notice),
          port(sockets.port()),
          timer(context) {
        watchInterfaces();
        thread = std::jthread([this] { context.run(); });
    }

    ~Impl() { context.stop(); }  // the thread, the last member, is joined first

    void watchInterfaces() {
        updateMemberships();
        timer.expires_after(kInterfaceInterval);
        timer.async_wait([this](const std::error_code& failure) {
            if (!failure) watchInterfaces();
        });
    }

    bool isLoopbackOnly() const { return !local.v4 || !local.v4->is_unspecified(); }

    void updateMemberships() {
        if (isLoopbackOnly()) return;
        const std::vector<NetworkInterface> interfaces = networkInterfaces();
        chosenInterface =
            config.interface.empty() ? std::nullopt : findInterface(interfaces, config.interface);
        const auto wanted = sacnMemberships(interfaces, config.interface, numbers(), sockets.hasIpv6());
        if (wanted.empty()) noticeNoMulticast();
        sockets.setMemberships(wanted);
        const std::lock_guard lock(mutex);
        membershipCount = sockets.membershipCount();
        socketCount = sockets.socketCount();
    }

    // Universes, what they say that they are synchronized by, discovery, and what it has told.
    std::set<std::uint16_t> numbers() {
        std::set<std::uint16_t> all(config.universes.begin(), config.universes.end());
        all.insert(kSacnDiscoveryUniverse);
        const std::lock_guard lock(mutex);
        for (const SacnSyncStatus& one : listener.syncTable().status(Clock::now())) all.insert(one.address);
        joinedSyncRevision = listener.syncTable().revision();
        if (config.joinsAnnounced) all.merge(announced());
        return all;
    }

    // The mutex is held.
    std::set<std::uint16_t> announced() {
        const std::vector<std::uint16_t> all = listener.announcedUniverses(Clock::now());
        if (all.size() <= kMostAnnounced) return {all.begin(), all.end()};
        noticeTooManyAnnounced();
        return {all.begin(), all.begin() + kMostAnnounced};
    }

    void noticeTooManyAnnounced() {
        if (std::exchange(hasNoticedTooMany, true) || !config.notice) return;
        config.notice(fmt::format(
            "sources announce more sACN universes than the {} that are listened to; name those that you want",
            kMostAnnounced));
    }

    void noticeNoMulticast() {
        if (std::exchange(hasNoticedNoMulticast, true) || !config.notice) return;
        config.notice(
            "no network interface that takes multicast is up; until one is, sACN is heard by unicast alone");
    }

    void read(udp::socket& socket) {
        for (int i = 0; i < kBatchesInARow; ++i) {
            const auto arrived = batch.receive(socket.native_handle(), port);
            take(arrived, lostBySocket[socket.native_handle()]);
            if (arrived.size() < DatagramBatch::kCapacity) break;
        }
        if (hasNewSyncAddresses()) updateMemberships();
    }

    void take(std::span<const ArrivedDatagram> arrived, std::uint32_t& lostBefore) {
        if (arrived.empty()) return;
        if (config.tap) {
            for (const ArrivedDatagram& one : arrived) {
                if (isFromChosen(one)) config.tap(one.datagram);
            }
        }
        const std::lock_guard lock(mutex);
        droppedBySystem += static_cast<std::uint32_t>(arrived.back().lostBefore - lostBefore);
        lostBefore = arrived.back().lostBefore;
        store.change([&](UniverseMerger& merger) {
            const TimePoint now = Clock::now();
            for (const ArrivedDatagram& one : arrived) takeOne(one, now, merger);
        });
    }

    void takeOne(const ArrivedDatagram& arrived, TimePoint now, UniverseMerger& merger) {
        if (!isFromChosen(arrived)) {
            ++otherInterface;
            return;
        }
        const Datagram& datagram = arrived.datagram;
        listener.receive(datagram.bytes, datagram.from, datagram.to, now, merger);
    }

    // What this machine sends to its own address comes in by loopback.
    bool isFromChosen(const ArrivedDatagram& arrived) const {
        if (!chosenInterface || arrived.interfaceIndex == 0) return true;
        return arrived.interfaceIndex == chosenInterface->index || arrived.interfaceIndex == kLoopbackIndex;
    }

    bool hasNewSyncAddresses() {
        const std::lock_guard lock(mutex);
        return listener.syncTable().revision() != joinedSyncRevision;
    }

    static constexpr unsigned kLoopbackIndex = 1;  // on every system that has one

    const SacnReceiverConfig config;
    const LocalAddresses local;
    UniverseStore& store;
    asio::io_context context{1};
    DatagramBatch batch;
    std::map<int, std::uint32_t> lostBySocket;  // as ArrivedDatagram counts it
    mutable std::mutex mutex;                   // of the listener and the counts; taken before the store's
    SacnListener listener;
    std::uint64_t otherInterface = 0;
    std::uint64_t droppedBySystem = 0;
    std::size_t membershipCount = 0;
    std::size_t socketCount = 0;
    std::uint64_t joinedSyncRevision = 0;
    std::optional<NetworkInterface> chosenInterface;
    bool hasNoticedNoMulticast = false;
    bool hasNoticedTooMany = false;
    SacnSockets sockets;
    const std::uint16_t port;  // read by others, who must not touch the sockets
    asio::steady_timer timer;
    std::jthread thread;
};

SacnReceiver::SacnReceiver(SacnReceiverConfig config, UniverseStore& store)
    : impl_(std::make_unique<Impl>(std::move(config), store)) {}

SacnReceiver::~SacnReceiver() = default;

std::uint16_t SacnReceiver::port() const {
    return impl_->port;
}

SacnCounters SacnReceiver::counters() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->listener.counters();
}

std::uint64_t SacnReceiver::droppedBySystem() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->droppedBySystem;
}

SacnReport SacnReceiver::report() const {
    const std::lock_guard lock(impl_->mutex);
    const TimePoint now = Clock::now();
    return {.counters = impl_->listener.counters(),
            .otherInterface = impl_->otherInterface,
            .discovered = impl_->listener.discovered(now),
            .syncs = impl_->listener.syncTable().status(now),
            .universesOfWrongGroups = impl_->listener.universesOfWrongGroups(),
            .membershipCount = impl_->membershipCount,
            .socketCount = impl_->socketCount};
}

}  // namespace hazer::protocol
