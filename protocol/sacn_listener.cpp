#include "protocol/sacn_listener.h"

#include <algorithm>
#include <array>

#include "protocol/endpoint_text.h"
#include "protocol/printable_text.h"
#include "protocol/sacn_group.h"

namespace hazer::protocol {
namespace {

SourceId sourceOf(const SacnData& data) {
    return {Transport::kSacn, data.cid};
}

UniverseId universeOf(const SacnData& data) {
    return {Transport::kSacn, data.universe};
}

bool isForUs(std::uint8_t startCode) {
    return startCode == kStartCodeLevels || startCode == kStartCodeSlotPriorities;
}

// Values above 200 are kept for what receivers do among themselves; from the network they mean nothing.
std::span<const std::uint8_t> withoutReserved(std::span<const std::uint8_t> priorities, Slots& buffer) {
    const auto isReserved = [](std::uint8_t priority) { return priority > kMaxPriority; };
    if (std::ranges::none_of(priorities, isReserved)) return priorities;
    std::ranges::replace_copy_if(priorities, buffer.begin(), isReserved, std::uint8_t{0});
    return std::span(buffer).first(priorities.size());
}

}  // namespace

void SacnListener::receive(std::span<const std::uint8_t> datagram, const IpEndpoint& from,
                           const IpEndpoint& to, TimePoint now, UniverseMerger& merger) {
    const SacnPacket packet = parseSacn(datagram);
    if (const auto* data = std::get_if<SacnData>(&packet)) {
        takeData(*data, from, to, now, merger);
    } else if (const auto* sync = std::get_if<SacnSync>(&packet)) {
        takeSync(*sync, from, now, merger);
    } else if (const auto* discovery = std::get_if<SacnDiscovery>(&packet)) {
        ++(discovered_.take(*discovery, from, now) ? counters_.discoveries : counters_.tooMany);
    } else {
        countRefusal(std::get<SacnRefusal>(packet));
    }
}

void SacnListener::takeData(const SacnData& data, const IpEndpoint& from, const IpEndpoint& to, TimePoint now,
                            UniverseMerger& merger) {
    const SacnStreamKey key{data.universe, false, data.cid};
    if (!streams_.isInOrder(key, data.sequence, now)) {
        ++counters_.late;
        merger.countLate(universeOf(data), sourceOf(data));
        return;
    }
    if (isWrongGroup(to, data.universe) && wrongGroups_.size() < kMaxWrongGroups) {
        wrongGroups_.insert(data.universe);
    }
    if (data.isTerminated) {
        // The copies that follow are of a stream that is not known any more, and so is a source that begins
        // again from any number.
        streams_.forget(key);
        merger.leave(universeOf(data), sourceOf(data), now);
        ++counters_.terminations;
    } else if (!isWanted(data.isPreview)) {
        streams_.pass(key, data.sequence, now);
        ++counters_.otherPreview;
    } else if (!isForUs(data.startCode)) {
        streams_.pass(key, data.sequence, now);
        ++counters_.otherStartCodes;
    } else {
        takeOrdered(data, key, from, now, merger);
    }
}

void SacnListener::takeOrdered(const SacnData& data, const SacnStreamKey& key, const IpEndpoint& from,
                               TimePoint now, UniverseMerger& merger) {
    if (takeSlots(data, now, merger) != Verdict::kTaken) {
        ++counters_.tooMany;
        return;
    }
    ++(data.startCode == kStartCodeLevels ? counters_.levels : counters_.slotPriorities);
    if (streams_.take(key, data.sequence, data.sourceName, from, now)) {
        merger.describe(universeOf(data), sourceOf(data), printableText(data.sourceName), addressText(from));
    }
}

Verdict SacnListener::takeSlots(const SacnData& data, TimePoint now, UniverseMerger& merger) {
    if (data.startCode == kStartCodeSlotPriorities) {
        Slots buffer;
        return merger.setSlotPriorities(universeOf(data), sourceOf(data), withoutReserved(data.slots, buffer),
                                        now);
    }
    const Levels levels{universeOf(data), sourceOf(data), data.priority, data.slots, data.isPreview};
    if (!sync_.mustWait(data.syncAddress, data.forcesSync, now)) return merger.show(levels, now);
    return merger.hold(levels, {Transport::kSacn, data.syncAddress}, now);
}

void SacnListener::takeSync(const SacnSync& sync, const IpEndpoint& from, TimePoint now,
                            UniverseMerger& merger) {
    const SacnStreamKey key{sync.syncAddress, true, sync.cid};
    if (!streams_.isInOrder(key, sync.sequence, now)) {
        ++counters_.late;
    } else if (!sync_.takeSync(sync.syncAddress, now)) {
        ++counters_.ignored;
    } else {
        streams_.take(key, sync.sequence, {}, from, now);
        merger.showHeld({Transport::kSacn, sync.syncAddress}, now);
        ++counters_.syncs;
    }
}

void SacnListener::countRefusal(SacnRefusal refusal) {
    ++(refusal == SacnRefusal::kUnusedVector ? counters_.ignored : counters_.malformed);
}

bool SacnListener::isWanted(bool isPreview) const {
    if (preview_ == PreviewRule::kBoth) return true;
    return isPreview == (preview_ == PreviewRule::kPreviewOnly);
}

}  // namespace hazer::protocol
