#include "protocol/recording/resender.h"

#include <sys/prctl.h>

#include <algorithm>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>
#include <map>
#include <thread>
#include <utility>

#include "protocol/artnet.h"
#include "protocol/recording/lateness.h"
#include "protocol/recording/packet_stream.h"
#include "protocol/sacn.h"
#include "protocol/udp.h"

namespace hazer::protocol {
namespace {

using asio::ip::udp;
using Bytes = std::vector<std::uint8_t>;

constexpr std::chrono::milliseconds kAskEvery{50};

// A round of no length, as of a recording with one packet, must not become a flood.
constexpr RecordingTime kShortestRound = std::chrono::milliseconds(100);

// Streams beyond so many are sent as they are. No show has as many.
constexpr std::size_t kMostStreams = 65536;

/// Lets the numbers of a stream go on where a loop begins anew, so that receivers do not take the first
/// packets of the round for late ones.
class LoopNumbering {
 public:
    void startRound() { ++round_; }

    void renumber(const StreamedPacket& packet, Bytes& bytes) {
        std::uint8_t& number = bytes[packet.sequenceOffset];
        if (packet.stream.transport == Transport::kArtNet && number == 0) return;  // has no order
        if (streams_.size() >= kMostStreams && !streams_.contains(packet.stream)) return;
        const auto [entry, isNew] = streams_.try_emplace(packet.stream, Stream{round_, 0, number});
        Stream& stream = entry->second;
        if (stream.round != round_) {
            stream.round = round_;
            stream.shift = static_cast<std::uint8_t>(stream.last + 1 - number);
        }
        number = static_cast<std::uint8_t>(number + stream.shift);
        stream.last = number;
    }

 private:
    struct Stream {
        std::uint64_t round;
        std::uint8_t shift;
        std::uint8_t last;
    };

    std::map<PacketStream, Stream> streams_;
    std::uint64_t round_ = 0;
};

/// The last levels of every stream: what a receiver must hear to have the look that stood.
class StandingPackets {
 public:
    void take(const StreamedPacket& packet, const Bytes& bytes) {
        const Key key{packet.stream, packet.startCode};
        if (packet.ends) {
            packets_.erase(key);
        } else if (packet.holdsLevels && (packets_.size() < kMostStreams || packets_.contains(key))) {
            packets_[key] = bytes;
        }
    }

    template <class Send>
    void forEach(Send&& send) const {
        for (const auto& [key, bytes] : packets_) send(key.first.transport, bytes);
    }

 private:
    using Key = std::pair<PacketStream, std::uint8_t>;

    std::map<Key, Bytes> packets_;
};

}  // namespace

struct Resender::Impl {
    Impl(const std::filesystem::path& file, const FrameMap& map, const ResenderConfig& resenderConfig)
        : config(resenderConfig), reader(openRecording(file, map)) {
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
        if (!skipToStart(shouldStop)) return;
        TimePoint roundStart = Clock::now();
        standing.forEach([&](Transport over, const Bytes& datagram) { send(over, datagram); });
        while (sendRound(roundStart, shouldStop) && config.loops) {
            const RecordingTime end = reader->duration().value_or(status.time);
            roundStart += scaled(std::max(end - config.from, kShortestRound));
            reader->goTo(*startMark);
            numbering.startRound();
        }
    }

    /// Leaves the reader before the first packet to send. False if it was stopped.
    bool skipToStart(const std::function<bool()>& shouldStop) {
        for (std::uint64_t skipped = 0;; ++skipped) {
            constexpr std::uint64_t kAskEveryPackets = 4096;
            if (skipped % kAskEveryPackets == 0 && shouldStop()) return false;
            startMark = reader->mark();
            const auto packet = reader->next();
            if (!packet || packet->time >= config.from) break;
            prepare(*packet);
            if (streamed) standing.take(*streamed, bytes);
        }
        reader->goTo(*startMark);
        return true;
    }

    /// False if it was stopped.
    bool sendRound(TimePoint roundStart, const std::function<bool()>& shouldStop) {
        while (const auto packet = reader->next()) {
            const TimePoint deadline = roundStart + scaled(packet->time - config.from);
            if (!sleepUntil(deadline, shouldStop)) return false;
            prepare(*packet);
            if (streamed) numbering.renumber(*streamed, bytes);
            send(transport, bytes);
            lateness.add(Clock::now() - deadline);
            status.time = packet->time;
        }
        const RecordingTime end = reader->duration().value_or(status.time);
        ++status.rounds;
        return sleepUntil(roundStart + scaled(std::max(end - config.from, RecordingTime(0))), shouldStop);
    }

    Clock::duration scaled(RecordingTime time) const {
        return std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double, std::nano>(static_cast<double>(time.count()) / config.rate));
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

    /// Fills `bytes`, `transport` and `streamed`.
    void prepare(const RecordedPacket& packet) {
        if (const auto* datagram = std::get_if<RecordedDatagram>(&packet.content)) {
            bytes.assign(datagram->bytes.begin(), datagram->bytes.end());
            streamed = streamOf(bytes, datagram->from);
            const bool isSacn =
                streamed ? streamed->stream.transport == Transport::kSacn : datagram->to.port == kSacnPort;
            transport = isSacn ? Transport::kSacn : Transport::kArtNet;
            return;
        }
        pack(std::get<RecordedFrame>(packet.content));
        streamed = streamOf(bytes, {});
    }

    void pack(const RecordedFrame& frame) {
        transport = frame.universe.transport;
        std::uint8_t& sequence = frameSequences[frame.universe];
        if (transport == Transport::kSacn) {
            SacnData data;
            data.cid = {'h', 'a', 'z', 'e', 'r', ' ', 'r', 'e', 'p', 'l', 'a', 'y'};
            data.sourceName = "hazer replay";
            data.sequence = ++sequence;
            data.universe = frame.universe.number;
            data.slots = frame.slots;
            bytes = packSacnData(data);
        } else {
            sequence = sequence == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(sequence + 1);
            const std::array<std::uint8_t, 1> dark{};
            bytes = packArtDmx(frame.universe.number, sequence, frame.slots.empty() ? dark : frame.slots);
        }
    }

    void send(Transport over, const Bytes& datagram) {
        std::error_code failure;
        socket.send_to(asio::buffer(datagram), destinations.at(over), 0, failure);
        // An ICMP answer to an earlier packet, that nobody listens there, comes out of the next send.
        if (failure == asio::error::connection_refused) {
            socket.send_to(asio::buffer(datagram), destinations.at(over), 0, failure);
        }
        ++(failure ? status.failed : status.packets);
    }

    ResenderConfig config;
    std::unique_ptr<RecordingReader> reader;
    asio::io_context context;
    udp::socket socket{context};
    std::map<Transport, udp::endpoint> destinations;
    RecordingMarkPtr startMark;
    StandingPackets standing;
    LoopNumbering numbering;
    Lateness lateness;
    std::map<UniverseId, std::uint8_t> frameSequences;
    Bytes bytes;                               ///< Of the packet in hand.
    Transport transport = Transport::kArtNet;  ///< The same.
    std::optional<StreamedPacket> streamed;    ///< The same.
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
    status.medianLateS = impl_->lateness.withinS(0.5);
    status.p99LateS = impl_->lateness.withinS(0.99);
    status.worstLateS = impl_->lateness.worstS();
    return status;
}

const std::vector<std::string>& Resender::warnings() const {
    return impl_->reader->warnings();
}

}  // namespace hazer::protocol
