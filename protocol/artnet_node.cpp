#include "protocol/artnet_node.h"

#include <fmt/format.h>

#include <algorithm>

namespace hazer::protocol {
namespace {

// Sources are told apart by address, and two inputs of one sender by Physical (section Data Merging). The UDP
// port is no part of it: a program that is started again comes from another one.
SourceId artNetSource(Ipv4Address address, std::uint8_t physical) {
    SourceId source;
    source.transport = Transport::kArtNet;
    std::ranges::copy(address, source.id.begin());
    source.id[address.size()] = physical;
    return source;
}

}  // namespace

ArtNetNode::ArtNetNode(ArtNetNodeConfig config) : config_(std::move(config)), random_(config_.randomSeed) {
    auto& addresses = config_.portAddresses;
    std::sort(addresses.begin(), addresses.end());
    addresses.erase(std::unique(addresses.begin(), addresses.end()), addresses.end());
}

void ArtNetNode::receive(std::span<const std::uint8_t> datagram, Endpoint from, TimePoint now,
                         UniverseMerger& merger) {
    const ArtNetPacket packet = parseArtNet(datagram);
    if (const auto* dmx = std::get_if<ArtDmx>(&packet)) {
        takeDmx(*dmx, from, now, merger);
    } else if (const auto* poll = std::get_if<ArtPoll>(&packet)) {
        takePoll(*poll, from, now);
    } else {
        countRefusal(std::get<Refusal>(packet));
    }
}

void ArtNetNode::takeDmx(const ArtDmx& dmx, Endpoint from, TimePoint now, UniverseMerger& merger) {
    const UniverseId universe{Transport::kArtNet, dmx.portAddress};
    const SourceId source = artNetSource(from.address, dmx.physical);
    if (!sequences_.accept({from, dmx.physical, dmx.portAddress}, dmx.sequence, now)) {
        ++counters_.late;
        merger.countLate(universe, source);
        return;
    }
    Levels levels;
    levels.universe = universe;
    levels.source = source;
    levels.slots = dmx.slots;
    if (merger.show(levels, now) != Verdict::kTaken) {
        ++counters_.refused;
        return;
    }
    ++counters_.dmx;
}

// The reply goes to where the poll came from. For a desk that keeps to the standard that is port 6454, as the
// standard wants; a program that polls from another port shares its machine with one that holds 6454, and
// hears nothing there.
void ArtNetNode::takePoll(const ArtPoll& poll, Endpoint from, TimePoint now) {
    if (isAddressedTo(poll) && owe(from, poll.target.value_or(PortAddressRange{}), now)) {
        ++counters_.polls;
    } else {
        ++counters_.ignored;
    }
}

void ArtNetNode::countRefusal(Refusal refusal) {
    if (refusal == Refusal::kUnusedOpCode || refusal == Refusal::kNoSlots) {
        ++counters_.ignored;
    } else {
        ++counters_.malformed;
    }
}

bool ArtNetNode::isAddressedTo(const ArtPoll& poll) const {
    return !poll.target || std::ranges::any_of(config_.portAddresses, [&](std::uint16_t portAddress) {
        return poll.target->contains(portAddress);
    });
}

// A desk that polls again before it was answered gets one answer to both, so that a flood of polls makes no
// flood of replies.
bool ArtNetNode::owe(Endpoint to, PortAddressRange wanted, TimePoint now) {
    const auto owed = std::ranges::find(pending_, to, &PendingReply::to);
    if (owed != pending_.end()) {
        owed->wanted.first = std::min(owed->wanted.first, wanted.first);
        owed->wanted.last = std::max(owed->wanted.last, wanted.last);
        return true;
    }
    if (pending_.size() == kMaxPendingReplies) return false;
    pending_.push_back({to, wanted, replyTime(now)});
    return true;
}

// Hundreds of nodes hear the same broadcast poll; a random wait keeps them from answering in one burst
// (section ArtPollReply).
TimePoint ArtNetNode::replyTime(TimePoint now) {
    std::uniform_int_distribution<std::chrono::milliseconds::rep> delay(0, config_.maxPollReplyDelay.count());
    return now + std::chrono::milliseconds(delay(random_));
}

std::optional<TimePoint> ArtNetNode::nextReplyDue() const {
    if (pending_.empty()) return std::nullopt;
    return std::ranges::min(pending_, {}, &PendingReply::due).due;
}

std::optional<PendingReply> ArtNetNode::takeDueReply(TimePoint now) {
    const auto due =
        std::ranges::find_if(pending_, [&](const PendingReply& reply) { return reply.due <= now; });
    if (due == pending_.end()) return std::nullopt;
    const PendingReply reply = *due;
    pending_.erase(due);
    return reply;
}

std::vector<ArtPollReplyBytes> ArtNetNode::packReply(const PendingReply& reply, Ipv4Address ownAddress) {
    std::vector<ArtPollReplyBytes> datagrams;
    if (config_.portAddresses.empty()) datagrams.push_back(packOne(std::nullopt, 0, ownAddress));
    for (std::size_t i = 0; i < config_.portAddresses.size(); ++i) {
        const std::uint16_t portAddress = config_.portAddresses[i];
        if (reply.wanted.contains(portAddress)) datagrams.push_back(packOne(portAddress, i, ownAddress));
    }
    return datagrams;
}

ArtPollReplyBytes ArtNetNode::packOne(std::optional<std::uint16_t> portAddress, std::size_t index,
                                      Ipv4Address ownAddress) {
    replyCount_ = (replyCount_ + 1) % 10000;  // NodeReport has four digits for it
    const std::string report = fmt::format("#0001 [{:04}] Listening", replyCount_);
    ArtPollReply reply;
    reply.ownAddress = ownAddress;
    reply.portAddress = portAddress;
    // BindIndex is one byte and 0 means none: the 256th Port-Address starts again at 1. Desks look at the
    // Port-Address.
    reply.bindIndex = static_cast<std::uint8_t>(1 + index % 255);
    reply.shortName = config_.shortName;
    reply.longName = config_.longName;
    reply.nodeReport = report;
    return packArtPollReply(reply);
}

}  // namespace hazer::protocol
