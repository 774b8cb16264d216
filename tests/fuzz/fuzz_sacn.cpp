// Any bytes as sACN: what begins with 0, as every packet does, through the parser; all else as a series of
// datagrams through a listener that remembers.
#include <algorithm>
#include <cstdlib>

#include "protocol/sacn.h"
#include "protocol/sacn_group.h"
#include "protocol/sacn_listener.h"

namespace {

using namespace hazer::protocol;

void require(bool condition) {
    if (!condition) std::abort();
}

// What was parsed keeps its promises, and is the same after it is packed and parsed again.
void checkData(const SacnData& data) {
    require(data.priority <= kMaxPriority);
    require(data.universe >= 1 && data.universe <= kMaxSacnUniverse);
    require(data.slots.size() <= kSlotCount);
    const auto packed = packSacnData(data);
    const SacnPacket again = parseSacn(packed);
    const auto* copy = std::get_if<SacnData>(&again);
    require(copy && copy->cid == data.cid && copy->sourceName == data.sourceName);
    require(copy->priority == data.priority && copy->universe == data.universe);
    require(copy->sequence == data.sequence && copy->startCode == data.startCode);
    require(copy->isPreview == data.isPreview && copy->isTerminated == data.isTerminated);
    require(copy->forcesSync == data.forcesSync && copy->syncAddress == data.syncAddress);
    require(std::ranges::equal(copy->slots, data.slots));
}

void checkDiscovery(const SacnDiscovery& discovery) {
    require(discovery.page <= discovery.lastPage);
    require(discovery.universeCount() <= kSacnUniversesPerPage);
    const auto packed = packSacnDiscovery(discovery);
    const SacnPacket again = parseSacn(packed);
    const auto* copy = std::get_if<SacnDiscovery>(&again);
    require(copy && copy->page == discovery.page);
    require(std::ranges::equal(copy->universeBytes, discovery.universeBytes));
}

void checkPacket(std::span<const std::uint8_t> datagram) {
    const SacnPacket packet = parseSacn(datagram);
    if (const auto* data = std::get_if<SacnData>(&packet)) checkData(*data);
    if (const auto* discovery = std::get_if<SacnDiscovery>(&packet)) checkDiscovery(*discovery);
}

std::uint64_t total(const SacnCounters& c) {
    return c.levels + c.slotPriorities + c.terminations + c.syncs + c.discoveries + c.late + c.tooMany +
           c.otherPreview + c.otherStartCodes + c.ignored + c.malformed;
}

// One well-formed packet of a few sources, universes and addresses, so that their states meet.
std::vector<std::uint8_t> madeUp(std::uint8_t kind, std::uint8_t a, std::uint8_t b, std::uint8_t level) {
    Cid cid{};
    cid[0] = a & 3;
    if (kind % 4 == 0) {
        SacnSync sync;
        sync.cid = cid;
        sync.sequence = b;
        sync.syncAddress = static_cast<std::uint16_t>(1 + (a >> 6));
        return packSacnSync(sync);
    }
    const std::uint8_t slots[] = {level, static_cast<std::uint8_t>(~level)};
    SacnData data;
    data.cid = cid;
    data.priority = static_cast<std::uint8_t>(99 + ((a >> 2) & 3));
    data.universe = static_cast<std::uint16_t>(1 + ((a >> 4) & 3));
    data.syncAddress = static_cast<std::uint16_t>(kind >> 6);
    data.sequence = b;
    data.isTerminated = (kind & 0x3C) == 0x3C;
    data.forcesSync = kind & 0x20;
    data.startCode = kind % 4 == 1 ? kStartCodeSlotPriorities : kStartCodeLevels;
    data.slots = slots;
    return packSacnData(data);
}

// Four bytes make a packet, or a length of raw bytes that follow; time goes on in between.
void playEvening(std::span<const std::uint8_t> script) {
    UniverseMerger merger;
    merger.ask({Transport::kSacn, 1});
    SacnListener listener;
    TimePoint now{std::chrono::hours(1)};
    std::uint64_t sent = 0;
    const IpEndpoint desk{.address = {10, 0, 0, 1}, .port = kSacnPort};
    while (script.size() >= 4) {
        const std::uint8_t kind = script[0];
        now += std::chrono::milliseconds(script[3] * (kind & 1 ? 1 : 16));
        const std::uint8_t a = script[1];
        const std::uint8_t b = script[2];
        const std::uint8_t level = script[3];
        script = script.subspan(4);
        if (kind == 0xFF) {
            const std::size_t length = std::min<std::size_t>(a * 8U, script.size());
            listener.receive(script.first(length), desk, sacnGroupV4(b, kSacnPort), now, merger);
            script = script.subspan(length);
        } else {
            listener.receive(madeUp(kind, a, b, level), desk, sacnGroupV4(1, kSacnPort), now, merger);
        }
        ++sent;
        merger.expire(now);
    }
    require(total(listener.counters()) == sent);
    UniverseSet set;
    merger.latch(set, now);
    for (const UniverseStatus& status : merger.status(now)) {
        require(status.sources.size() <= merger.rules().sacnSourcesPerUniverse);
    }
    require(listener.discovered(now).size() <= SacnDiscoveredSources::kCapacity);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(data, size);
    const bool isPacket = size == 0 || data[0] == 0;
    isPacket ? checkPacket(bytes) : playEvening(bytes);
    return 0;
}
