#include "protocol/artnet_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace hazer::protocol {
namespace {

constexpr std::chrono::seconds kRefusalReportInterval{10};

// Sources are told apart by address, and two inputs of one sender by Physical (section "Data merging"). The
// UDP port is no part of it: a program that is started again comes from another one.
SourceId sourceOf(Ipv4Address address, std::uint8_t physical) {
    SourceId source;
    source.transport = Transport::kArtNet;
    std::ranges::copy(address, source.id.begin());
    source.id[address.size()] = physical;
    return source;
}

template <class Datagram>
std::vector<std::uint8_t> bytesOf(const Datagram& datagram) {
    return {datagram.begin(), datagram.end()};
}

}  // namespace

struct ArtNetNode::Packet {
    Endpoint from;
    TimePoint now;
    UniverseMerger& merger;
};

ArtNetNode::ArtNetNode(ArtNetNodeConfig config)
    : config_(std::move(config)), ports_(config_.portAddresses), random_(config_.randomSeed) {}

void ArtNetNode::receive(std::span<const std::uint8_t> datagram, Endpoint from, TimePoint now,
                         UniverseMerger& merger) {
    if (now >= peers_.nextSyncTimeOut()) advance(now, merger);
    const Packet packet{from, now, merger};
    std::visit([&](const auto& content) { take(content, packet); }, parseArtNet(datagram));
}

void ArtNetNode::take(const ArtDmx& dmx, const Packet& packet) {
    const auto number = ports_.universeOf(dmx.portAddress);
    if (!number) {
        ++status_.counters.ignored;
        return;
    }
    Levels levels;
    levels.universe = {Transport::kArtNet, *number};
    levels.source = sourceOf(packet.from.address, dmx.physical);
    if (!sequences_.accept({packet.from, dmx.physical, dmx.portAddress}, dmx.sequence, packet.now)) {
        ++status_.counters.late;
        packet.merger.countLate(levels.universe, levels.source);
        return;
    }
    levels.slots = dmx.slots;
    const ArtNetPeer* const peer = peers_.hearLevels(packet.from.address, packet.now);
    if (peer) {
        levels.name = peer->name;
        levels.address = peer->address;
    }
    if (merge(levels, peer && peer->isSynchronous, packet) == Verdict::kTaken) {
        ++status_.counters.dmx;
    } else {
        ++status_.counters.refused;
    }
}

// A universe that is merging has no one moment at which it is whole: it shows at once (section ArtSync).
Verdict ArtNetNode::merge(const Levels& levels, bool isSynchronous, const Packet& packet) {
    if (isSynchronous && !packet.merger.isMerging(levels.universe, packet.now)) {
        return packet.merger.hold(levels, syncGroupOf(packet.from.address), packet.now);
    }
    const Verdict verdict = packet.merger.show(levels, packet.now);
    if (verdict == Verdict::kTooManySources && packet.now >= nextRefusalReport_) {
        nextRefusalReport_ = packet.now + kRefusalReportInterval;
        diagnose(kDiagMedium,
                 fmt::format("Port-Address {}: a third source is refused", levels.universe.number),
                 packet.now);
    }
    return verdict;
}

void ArtNetNode::take(const ArtSync&, const Packet& packet) {
    if (!peers_.takeSync(packet.from.address, packet.now)) {
        ++status_.counters.ignored;
        return;
    }
    packet.merger.showHeld(syncGroupOf(packet.from.address), packet.now);
    ++status_.counters.syncs;
}

// The reply goes to where the poll came from. For a desk that keeps to the standard that is port 6454, as the
// standard wants; a program that polls from another port shares its machine with one that holds 6454, and
// hears nothing there.
void ArtNetNode::take(const ArtPoll& poll, const Packet& packet) {
    const PortAddressRange wanted = poll.target.value_or(PortAddressRange{});
    if (!isAddressedTo(poll) || !oweReply(packet.from, wanted, replyTime(packet.now))) {
        ++status_.counters.ignored;
        return;
    }
    desks_.hear(packet.from, poll, packet.now);
    if (nextChangeCheck_ == TimePoint::max()) nextChangeCheck_ = packet.now;
    ++status_.counters.polls;
}

// Only the root of a device names all of it.
void ArtNetNode::take(const PeerPollReply& reply, const Packet& packet) {
    if (reply.bindIndex <= 1) peers_.setName(packet.from.address, reply.shortName, packet.now);
    ++status_.counters.ignored;
}

void ArtNetNode::take(const ArtAddress& address, const Packet& packet) {
    if (config_.isProgrammable) obey(address, packet);
    nextChangeCheck_ = packet.now;  // so that the answer tells what has changed
    const bool isOwed = oweReply(packet.from, PortAddressRange{}, packet.now);
    ++(isOwed ? status_.counters.control : status_.counters.ignored);
}

void ArtNetNode::obey(const ArtAddress& address, const Packet& packet) {
    if (!address.shortName.empty()) config_.shortName = address.shortName;
    if (!address.longName.empty()) config_.longName = address.longName;
    switch (address.command) {
        case AddressCommand::kIndicatorsNormal:
            status_.indicators = Indicators::kNormal;
            break;
        case AddressCommand::kIndicatorsMute:
            status_.indicators = Indicators::kMute;
            break;
        case AddressCommand::kIndicatorsLocate:
            status_.indicators = Indicators::kLocate;
            break;
        default:
            break;
    }
    ArtNetPort* const port = ports_.atBindIndex(address.bindIndex);
    if (!port) return;
    obey(address.command, *port, packet);
    if (ports_.program(*port, address)) tellOfChange({port->onWire, port->onWire}, packet.now);
}

void ArtNetNode::obey(AddressCommand command, ArtNetPort& port, const Packet& packet) {
    const UniverseId universe{Transport::kArtNet, port.patched};
    switch (command) {
        case AddressCommand::kCancelMerge:
            return packet.merger.cancelMerge(universe);
        case AddressCommand::kMergeLatest:
            return packet.merger.setMode(universe, MergeMode::kLatest);
        case AddressCommand::kMergeHighest:
            return packet.merger.setMode(universe, MergeMode::kHighest);
        case AddressCommand::kFailHold:
            return packet.merger.setLoss(universe, {});
        case AddressCommand::kFailZero:
            return packet.merger.setLoss(universe, {.fadesOut = true, .fadeTime = {}});
        case AddressCommand::kClear:
            return packet.merger.clear(universe, packet.now);
        default:
            return;
    }
}

void ArtNetNode::take(const ArtIpProg&, const Packet& packet) {
    PendingReply reply;
    reply.kind = PendingReply::Kind::kIpProgReply;
    reply.to = packet.from;
    reply.due = packet.now;
    ++(owe(std::move(reply)) ? status_.counters.control : status_.counters.ignored);
}

void ArtNetNode::take(const ArtTimeCode& timeCode, const Packet& packet) {
    if (timeCode.streamId == 0) status_.timeCode = {timeCode, packet.from, packet.now};
    ++(timeCode.streamId == 0 ? status_.counters.control : status_.counters.ignored);
}

void ArtNetNode::take(const ArtTrigger& trigger, const Packet& packet) {
    if (trigger.oem != kOemEverybody) {
        ++status_.counters.ignored;
        return;
    }
    status_.trigger = {trigger.key, trigger.subKey, packet.from, packet.now};
    ++status_.counters.control;
}

void ArtNetNode::take(Refusal refusal, const Packet&) {
    if (refusal == Refusal::kUnusedOpCode || refusal == Refusal::kNoSlots) {
        ++status_.counters.ignored;
    } else {
        ++status_.counters.malformed;
    }
}

bool ArtNetNode::isAddressedTo(const ArtPoll& poll) const {
    return !poll.target || std::ranges::any_of(ports_.all(), [&](const ArtNetPort& port) {
        return poll.target->contains(port.onWire);
    });
}

// A desk that polls again before it was answered gets one answer to both, so that a flood of polls makes no
// flood of replies.
bool ArtNetNode::oweReply(Endpoint to, PortAddressRange wanted, TimePoint due) {
    const auto owed = std::ranges::find_if(pending_, [&](const PendingReply& reply) {
        return reply.kind == PendingReply::Kind::kPollReply && reply.to == to;
    });
    if (owed != pending_.end()) {
        owed->wanted.first = std::min(owed->wanted.first, wanted.first);
        owed->wanted.last = std::max(owed->wanted.last, wanted.last);
        return true;
    }
    PendingReply reply;
    reply.to = to;
    reply.wanted = wanted;
    reply.due = due;
    return owe(std::move(reply));
}

bool ArtNetNode::owe(PendingReply reply) {
    if (pending_.size() == kMaxPendingReplies) return false;
    pending_.push_back(std::move(reply));
    return true;
}

void ArtNetNode::advance(TimePoint now, UniverseMerger& merger) {
    while (const auto timeOut = peers_.takeSyncTimeOut(now)) {
        merger.showHeld(syncGroupOf(timeOut->address), timeOut->time);
    }
    if (now < nextChangeCheck_) return;
    nextChangeCheck_ = desks_.all(now).empty() ? TimePoint::max() : now + kChangeInterval;
    for (std::size_t i = 0; i < ports_.all().size(); ++i) {
        const auto change = ports_.update(i, merger, now);
        if (!change) continue;
        tellOfChange({change->onWire, change->onWire}, now);
        if (!change->hasMergingChanged) continue;
        diagnose(kDiagLow,
                 fmt::format("Port-Address {}: merging {}", change->onWire,
                             change->isMergingNow ? "begins" : "ends"),
                 now);
    }
}

void ArtNetNode::tellOfChange(PortAddressRange changed, TimePoint now) {
    for (const ArtNetDesk& desk : desks_.all(now)) {
        if (desk.poll.wantsChanges) oweReply(desk.endpoint, changed, replyTime(now));
    }
}

// The standard has a node broadcast its messages where several desks want them, with the lowest priority that
// any of them asked for. One to each who asked, by its own wish, reaches the same desks and nobody else.
void ArtNetNode::diagnose(std::uint8_t priority, const std::string& text, TimePoint now) {
    for (const ArtNetDesk& desk : desks_.all(now)) {
        if (!desk.poll.wantsDiagnostics || priority < desk.poll.diagPriority) continue;
        if (pending_.size() >= kMaxPendingReplies / 2) return;  // the rest is for answers
        PendingReply reply;
        reply.kind = PendingReply::Kind::kDiagnostics;
        reply.to = desk.endpoint;
        reply.due = now;
        reply.priority = priority;
        reply.text = text;
        owe(std::move(reply));
    }
}

// Hundreds of nodes hear the same broadcast poll; a random wait keeps them from answering in one burst
// (section ArtPollReply).
TimePoint ArtNetNode::replyTime(TimePoint now) {
    std::uniform_int_distribution<std::chrono::milliseconds::rep> delay(0, config_.maxPollReplyDelay.count());
    return now + std::chrono::milliseconds(delay(random_));
}

std::optional<TimePoint> ArtNetNode::nextDeadline() const {
    TimePoint next = std::min(peers_.nextSyncTimeOut(), nextChangeCheck_);
    for (const PendingReply& reply : pending_) next = std::min(next, reply.due);
    return next == TimePoint::max() ? std::nullopt : std::optional(next);
}

std::optional<PendingReply> ArtNetNode::takeDueReply(TimePoint now) {
    const auto due =
        std::ranges::find_if(pending_, [&](const PendingReply& reply) { return reply.due <= now; });
    if (due == pending_.end()) return std::nullopt;
    PendingReply reply = std::move(*due);
    pending_.erase(due);
    return reply;
}

std::vector<std::vector<std::uint8_t>> ArtNetNode::packReply(const PendingReply& reply,
                                                             Ipv4Address ownAddress) {
    if (reply.kind == PendingReply::Kind::kIpProgReply) return {bytesOf(packArtIpProgReply(ownAddress))};
    if (reply.kind == PendingReply::Kind::kDiagnostics) {
        return {packArtDiagData({.priority = reply.priority, .text = reply.text})};
    }
    const std::vector<ArtNetPort>& ports = ports_.all();
    if (ports.empty()) return {packOne(nullptr, 0, ownAddress)};
    std::vector<std::vector<std::uint8_t>> datagrams;
    for (std::size_t i = 0; i < ports.size(); ++i) {
        if (reply.wanted.contains(ports[i].onWire)) datagrams.push_back(packOne(&ports[i], i, ownAddress));
    }
    return datagrams;
}

std::vector<std::uint8_t> ArtNetNode::packOne(const ArtNetPort* port, std::size_t index,
                                              Ipv4Address ownAddress) {
    replyCount_ = (replyCount_ + 1) % 10000;  // NodeReport has four digits for it
    const std::string report = fmt::format("#0001 [{:04}] Listening", replyCount_);
    ArtPollReply reply;
    reply.ownAddress = ownAddress;
    // BindIndex is one byte and 0 means none: the 256th Port-Address starts again at 1. Desks look at the
    // Port-Address.
    reply.bindIndex = static_cast<std::uint8_t>(1 + index % 255);
    reply.shortName = config_.shortName;
    reply.longName = config_.longName;
    reply.nodeReport = report;
    reply.indicators = status_.indicators;
    reply.isProgrammable = config_.isProgrammable;
    if (port) {
        reply.portAddress = port->onWire;
        reply.isReceiving = port->isReceiving;
        reply.isMerging = port->isMerging;
        reply.mergesLatest = port->mode == MergeMode::kLatest;
    }
    return bytesOf(packArtPollReply(reply));
}

}  // namespace hazer::protocol
