#include "protocol/artnet_peers.h"

#include <algorithm>

#include "protocol/endpoint_text.h"
#include "protocol/printable_text.h"

namespace hazer::protocol {
namespace {

std::string textOf(Ipv4Address address) {
    IpEndpoint endpoint;
    std::ranges::copy(address, endpoint.address.begin());
    return addressText(endpoint);
}

}  // namespace

SyncGroup syncGroupOf(Ipv4Address address) {
    std::uint32_t number = 0;
    for (const std::uint8_t byte : address) number = number << 8 | byte;
    return {Transport::kArtNet, number};
}

const ArtNetPeer* ArtNetPeers::hearLevels(Ipv4Address from, TimePoint now) {
    ArtNetPeer* const peer = place(from, true, now);
    if (!peer) return nullptr;
    peer->hasSentLevels = true;
    peer->lastHeard = now;
    return peer;
}

void ArtNetPeers::setName(Ipv4Address of, std::string_view name, TimePoint now) {
    ArtNetPeer* const peer = place(of, false, now);
    if (!peer) return;
    peer->name = printableText(name);
    peer->lastHeard = std::max(peer->lastHeard, now);
}

// The standard has a node ignore an ArtSync unless its latest ArtDmx came from the same address, so that a
// stranger does not hold up the show. With two desks on one node that would drop syncs by chance; each of
// them with a synchronization of its own keeps strangers out just as well.
bool ArtNetPeers::takeSync(Ipv4Address from, TimePoint now) {
    const auto found = peers_.find(from);
    if (found == peers_.end() || !found->second.hasSentLevels) return false;
    found->second.isSynchronous = true;
    found->second.lastSync = now;
    nextSyncTimeOut_ = std::min(nextSyncTimeOut_, now + kSyncTimeOut);
    return true;
}

std::optional<SyncTimeOut> ArtNetPeers::takeSyncTimeOut(TimePoint now) {
    if (now < nextSyncTimeOut_) return std::nullopt;
    nextSyncTimeOut_ = TimePoint::max();
    std::optional<SyncTimeOut> timedOut;
    for (auto& [address, peer] : peers_) {
        if (!peer.isSynchronous) continue;
        const TimePoint due = peer.lastSync + kSyncTimeOut;
        if (due <= now && !timedOut) {
            peer.isSynchronous = false;
            timedOut = {address, due};
        } else {
            nextSyncTimeOut_ = std::min(nextSyncTimeOut_, due);
        }
    }
    return timedOut;
}

ArtNetPeer* ArtNetPeers::place(Ipv4Address address, bool sendsLevels, TimePoint now) {
    const auto found = peers_.find(address);
    if (found != peers_.end()) return &found->second;
    if (peers_.size() >= kCapacity && !(sendsLevels && makeRoom(now))) return nullptr;
    ArtNetPeer& peer = peers_[address];
    peer.address = textOf(address);
    return &peer;
}

// Forgets the silent ones and those who never sent levels, at most once a second, so that a flood of made-up
// peers does not buy a walk through the whole table with each packet.
bool ArtNetPeers::makeRoom(TimePoint now) {
    if (now < nextSweep_) return false;
    nextSweep_ = now + std::chrono::seconds(1);
    std::erase_if(peers_, [&](const auto& item) {
        const ArtNetPeer& peer = item.second;
        return !peer.isSynchronous && (now - peer.lastHeard > kForgetAfter || !peer.hasSentLevels);
    });
    return peers_.size() < kCapacity;
}

}  // namespace hazer::protocol
