#include "protocol/recording/replay_state.h"

#include <algorithm>
#include <string_view>

#include "protocol/artnet.h"
#include "protocol/recording/usb_wrapping.h"
#include "protocol/sacn.h"

namespace hazer::protocol {
namespace {

ArtNetNodeConfig nodeConfigFor(const ReplayRules& rules) {
    ArtNetNodeConfig config;
    for (const UniverseId& universe : rules.asked) {
        if (universe.transport == Transport::kArtNet) config.portAddresses.push_back(universe.number);
    }
    return config;
}

/// A packet may be played from a capture of other ports, so its first bytes decide before its port does.
bool isSacn(const RecordedDatagram& datagram) {
    constexpr std::string_view kArtNetStart("Art-Net\0", 8);
    const std::size_t size = std::min(datagram.bytes.size(), kArtNetStart.size());
    const std::string_view start(reinterpret_cast<const char*>(datagram.bytes.data()), size);
    if (start == kArtNetStart) return false;
    return datagram.to.port != kArtNetPort;
}

}  // namespace

ReplayState::ReplayState(const ReplayRules& rules)
    : fileName_(rules.fileName), merger_(rules.merge), artNet_(nodeConfigFor(rules)), sacn_(rules.preview) {
    for (const UniverseId& universe : rules.asked) merger_.ask(universe);
}

void ReplayState::play(const RecordedPacket& packet) {
    const TimePoint now = timePointOf(packet.time);
    ageTo(now);
    ++packetCount_;
    if (const auto* datagram = std::get_if<RecordedDatagram>(&packet.content)) {
        playDatagram(*datagram, now);
    } else {
        playFrame(std::get<RecordedFrame>(packet.content), now);
    }
}

/// What happens without packets happens at its own time, not when somebody looks. Answers that a desk would
/// get are dropped.
void ReplayState::ageTo(TimePoint now) {
    for (auto due = artNet_.nextDeadline(); due && *due <= now;) {
        artNet_.advance(*due, merger_);
        while (artNet_.takeDueReply(*due)) {
        }
        const auto next = artNet_.nextDeadline();
        due = next == due ? std::nullopt : next;
    }
}

void ReplayState::playDatagram(const RecordedDatagram& datagram, TimePoint now) {
    if (!isSacn(datagram)) {
        playArtNet(datagram, now);
    } else if (!playUsb(datagram.bytes, now)) {
        sacn_.receive(datagram.bytes, datagram.from, datagram.to, now, merger_);
    }
}

void ReplayState::playArtNet(const RecordedDatagram& datagram, TimePoint now) {
    if (datagram.from.isIpv6) {
        ++refusedCount_;  // Art-Net knows IPv4 only
        return;
    }
    Endpoint from;
    std::copy_n(datagram.from.address.begin(), from.address.size(), from.address.begin());
    from.port = datagram.from.port;
    artNet_.receive(datagram.bytes, from, now, merger_);
}

bool ReplayState::playUsb(std::span<const std::uint8_t> bytes, TimePoint now) {
    if (!isWrappedUsbFrame(bytes)) return false;
    const SacnPacket packet = parseSacn(bytes);
    const auto* data = std::get_if<SacnData>(&packet);
    const auto frame = data ? unwrapUsbFrame(*data) : std::nullopt;
    if (!frame) return false;
    if (frame->startCode != kStartCodeLevels) return true;
    const UniverseId universe{Transport::kDmx, frame->line};
    merger_.show({.universe = universe, .source = frame->source, .slots = frame->slots}, now);
    merger_.describe(universe, frame->source, frame->name, "");
    return true;
}

/// A file without network tells what stands, not who is alive: its looks are never lost.
void ReplayState::playFrame(const RecordedFrame& frame, TimePoint now) {
    const SourceId source{frame.universe.transport, {}};
    merger_.setLoss(frame.universe, {.fadesOut = false});
    const Verdict verdict =
        merger_.show({.universe = frame.universe, .source = source, .slots = frame.slots}, now);
    merger_.describe(frame.universe, source, fileName_, "");
    if (verdict != Verdict::kTaken) ++refusedCount_;
}

void ReplayState::latch(UniverseSet& out, RecordingTime now) {
    ageTo(timePointOf(now));
    merger_.expire(timePointOf(now));
    merger_.latch(out, timePointOf(now));
}

std::vector<UniverseStatus> ReplayState::status(RecordingTime now) {
    ageTo(timePointOf(now));
    merger_.expire(timePointOf(now));
    return merger_.status(timePointOf(now));
}

std::uint64_t ReplayState::refusedCount() const {
    const ReceiverCounters& artNet = artNet_.counters();
    const SacnCounters& sacn = sacn_.counters();
    return refusedCount_ + artNet.late + artNet.refused + artNet.malformed + sacn.late + sacn.tooMany +
           sacn.malformed;
}

// Counted in sources, which hold the slots; the rest is small beside them, or of one size.
std::size_t ReplayState::approximateBytes() const {
    constexpr std::size_t kPerSource = 2048;
    constexpr std::size_t kRest = 32u * 1024u;
    return kRest + kPerSource * merger_.sourceCount();
}

}  // namespace hazer::protocol
