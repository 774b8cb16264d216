#include "protocol/recording/resend_schedule.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/artnet.h"
#include "protocol/sacn.h"

namespace hazer::protocol {
namespace {

// A round of no length, as of a recording with one packet, must not become a flood.
constexpr RecordingTime kShortestRound = std::chrono::milliseconds(100);

// Streams beyond so many are sent as they are. No show has as many.
constexpr std::size_t kMostStreams = 65536;

}  // namespace

/// Lets the numbers of a stream go on where a loop begins anew.
class ResendSchedule::LoopNumbering {
 public:
    void startRound() { ++round_; }

    void renumber(const StreamedPacket& packet, Bytes& bytes) {
        std::uint8_t& number = bytes[packet.sequenceOffset];
        if (packet.stream.transport == Transport::kArtNet && number == 0) return;  // has no order
        if (streams_.size() >= kMostStreams && !streams_.contains(packet.stream)) return;
        // Art-Net counts 1..255, sACN 0..255.
        const int first = packet.stream.transport == Transport::kArtNet ? 1 : 0;
        const int count = 256 - first;
        const auto [entry, isNew] = streams_.try_emplace(packet.stream, Stream{round_, 0, number});
        Stream& stream = entry->second;
        if (stream.round != round_) {
            stream.round = round_;
            stream.shift = (stream.last + 1 - number + count) % count;
        }
        number = static_cast<std::uint8_t>((number - first + stream.shift) % count + first);
        stream.last = number;
    }

 private:
    struct Stream {
        std::uint64_t round;
        int shift;
        int last;
    };

    std::map<PacketStream, Stream> streams_;
    std::uint64_t round_ = 0;
};

/// The last levels of every stream: what a receiver must hear to have the look that stood.
class ResendSchedule::StandingPackets {
 public:
    void take(const StreamedPacket& packet, const Bytes& bytes) {
        const Key key{packet.stream, packet.startCode};
        if (packet.ends) {
            packets_.erase(key);
        } else if (packet.holdsLevels && (packets_.size() < kMostStreams || packets_.contains(key))) {
            packets_[key] = bytes;
        }
    }

    /// Takes one out, in no order that means anything; false if there is none.
    bool takeOut(Transport& transport, Bytes& bytes) {
        if (packets_.empty()) return false;
        auto first = packets_.extract(packets_.begin());
        transport = first.key().first.transport;
        bytes = std::move(first.mapped());
        return true;
    }

 private:
    using Key = std::pair<PacketStream, std::uint8_t>;

    std::map<Key, Bytes> packets_;
};

ResendSchedule::ResendSchedule(std::unique_ptr<RecordingReader> reader, const ResendRules& rules)
    : reader_(std::move(reader)),
      rules_(rules),
      startMark_(reader_->mark()),
      standing_(std::make_unique<StandingPackets>()),
      numbering_(std::make_unique<LoopNumbering>()),
      lastTime_(rules.from) {}

ResendSchedule::~ResendSchedule() = default;

bool ResendSchedule::skipToStart(const std::function<bool()>& shouldStop) {
    for (std::uint64_t skipped = 0;; ++skipped) {
        constexpr std::uint64_t kAskEveryPackets = 4096;
        if (skipped % kAskEveryPackets == 0 && shouldStop()) return false;
        startMark_ = reader_->mark();
        const auto packet = reader_->next();
        if (!packet || packet->time >= rules_.from) break;
        prepare(*packet);
        if (streamed_) standing_->take(*streamed_, bytes_);
    }
    reader_->goTo(*startMark_);
    return true;
}

std::optional<ResentDatagram> ResendSchedule::next() {
    if (standing_->takeOut(transport_, bytes_)) return ResentDatagram{{}, rules_.from, transport_, bytes_};
    auto packet = reader_->next();
    while (!packet) {
        if (!beginRound()) return std::nullopt;
        packet = reader_->next();
    }
    isRoundEmpty_ = false;
    lastTime_ = packet->time;
    prepare(*packet);
    if (streamed_) numbering_->renumber(*streamed_, bytes_);
    return ResentDatagram{roundStart_ + scaled(packet->time - rules_.from), packet->time, transport_, bytes_};
}

/// At the end of a round: whether another one follows.
bool ResendSchedule::beginRound() {
    ++rounds_;
    if (!rules_.loops || std::exchange(isRoundEmpty_, true)) return false;
    roundStart_ += scaled(std::max(roundLength(), kShortestRound));
    reader_->goTo(*startMark_);
    numbering_->startRound();
    return true;
}

Clock::duration ResendSchedule::roundEnd() const {
    return roundStart_ + scaled(roundLength());
}

RecordingTime ResendSchedule::roundLength() const {
    return std::max(reader_->duration().value_or(lastTime_) - rules_.from, RecordingTime(0));
}

Clock::duration ResendSchedule::scaled(RecordingTime time) const {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double, std::nano>(static_cast<double>(time.count()) / rules_.rate));
}

/// Fills bytes_, transport_ and streamed_.
void ResendSchedule::prepare(const RecordedPacket& packet) {
    if (const auto* datagram = std::get_if<RecordedDatagram>(&packet.content)) {
        bytes_.assign(datagram->bytes.begin(), datagram->bytes.end());
        streamed_ = streamOf(bytes_, datagram->from);
        const bool isSacn =
            streamed_ ? streamed_->stream.transport == Transport::kSacn : datagram->to.port == kSacnPort;
        transport_ = isSacn ? Transport::kSacn : Transport::kArtNet;
        return;
    }
    pack(std::get<RecordedFrame>(packet.content));
    streamed_ = streamOf(bytes_, {});
}

void ResendSchedule::pack(const RecordedFrame& frame) {
    transport_ = frame.universe.transport;
    std::uint8_t& sequence = frameSequences_[frame.universe];
    if (transport_ == Transport::kSacn) {
        SacnData data;
        data.cid = {'h', 'a', 'z', 'e', 'r', ' ', 'r', 'e', 'p', 'l', 'a', 'y'};
        data.sourceName = "hazer replay";
        data.sequence = ++sequence;
        data.universe = frame.universe.number;
        data.slots = frame.slots;
        bytes_ = packSacnData(data);
    } else {
        sequence = sequence == 255 ? std::uint8_t{1} : static_cast<std::uint8_t>(sequence + 1);
        const std::array<std::uint8_t, 1> dark{};
        bytes_ = packArtDmx(frame.universe.number, sequence, frame.slots.empty() ? dark : frame.slots);
    }
}

}  // namespace hazer::protocol
