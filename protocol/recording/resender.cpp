#include "protocol/recording/resender.h"

#include <sys/prctl.h>

#include <algorithm>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <map>
#include <thread>

#include "protocol/artnet.h"
#include "protocol/recording/lateness.h"
#include "protocol/sacn.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;

constexpr std::chrono::milliseconds kAskEvery{50};

}  // namespace

struct Resender::Impl {
    Impl(const std::filesystem::path& file, const FrameMap& map, const ResenderConfig& config)
        : schedule(openRecording(file, map), config.rules) {
        const udp::endpoint artNet = anyUdpEndpoint(config.to, config.port.value_or(kArtNetPort));
        const udp::endpoint sacn = anyUdpEndpoint(config.to, config.port.value_or(kSacnPort));
        destinations = {{Transport::kArtNet, artNet}, {Transport::kSacn, sacn}};
        std::error_code failure;
        socket.open(artNet.protocol(), failure);
        if (!failure) socket.set_option(asio::socket_base::broadcast(true), failure);
        if (failure) throwNetworkError("send to", artNet, failure);
    }

    // Linux wakes a thread up to 50 us late to save power, unless it asks otherwise.
    static void askForPunctualSleep() { ::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL); }

    void run(const std::function<bool()>& shouldStop) {
        askForPunctualSleep();
        if (!schedule.skipToStart(shouldStop)) return;
        const TimePoint start = Clock::now();
        while (const auto datagram = schedule.next()) {
            const TimePoint deadline = start + datagram->due;
            if (!sleepUntil(deadline, shouldStop)) return;
            send(*datagram);
            lateness.add(Clock::now() - deadline);
            status.time = datagram->time;
        }
        sleepUntil(start + schedule.roundEnd(), shouldStop);
    }

    bool sleepUntil(TimePoint deadline, const std::function<bool()>& shouldStop) {
        for (TimePoint now = Clock::now(); now < deadline; now = Clock::now()) {
            if (now >= nextAsk) {
                if (shouldStop()) return false;
                nextAsk = now + kAskEvery;
            }
            std::this_thread::sleep_until(std::min(deadline, nextAsk));
        }
        if (Clock::now() < nextAsk) return true;
        nextAsk = Clock::now() + kAskEvery;
        return !shouldStop();
    }

    void send(const ResentDatagram& datagram) {
        const auto bytes = asio::buffer(datagram.bytes.data(), datagram.bytes.size());
        const udp::endpoint& to = destinations.at(datagram.transport);
        std::error_code failure;
        socket.send_to(bytes, to, 0, failure);
        // An ICMP answer to an earlier packet, that nobody listens there, comes out of the next send.
        if (failure == asio::error::connection_refused) {
            socket.send_to(bytes, to, 0, failure);
        }
        ++(failure ? status.failed : status.packets);
    }

    ResendSchedule schedule;
    asio::io_context context;
    udp::socket socket{context};
    std::map<Transport, udp::endpoint> destinations;
    Lateness lateness;
    TimePoint nextAsk{};
    ResenderStatus status;
};

Resender::Resender(const std::filesystem::path& file, const FrameMap& map, const ResenderConfig& config)
    : impl_(std::make_unique<Impl>(file, map, config)) {}

Resender::~Resender() = default;

void Resender::run(const std::function<bool()>& shouldStop) {
    impl_->run(shouldStop);
}

ResenderStatus Resender::status() const {
    ResenderStatus status = impl_->status;
    status.rounds = impl_->schedule.rounds();
    status.medianLateS = impl_->lateness.withinS(0.5);
    status.p99LateS = impl_->lateness.withinS(0.99);
    status.worstLateS = impl_->lateness.worstS();
    return status;
}

const std::vector<std::string>& Resender::warnings() const {
    return impl_->schedule.warnings();
}

}  // namespace hazer::protocol
