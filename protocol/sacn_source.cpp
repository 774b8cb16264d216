#include "protocol/sacn_source.h"

#include <algorithm>
#include <cassert>
#include <random>

namespace hazer::protocol {
namespace {

std::vector<std::uint8_t> universeBytesOf(std::span<const std::uint16_t> universes) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(2 * universes.size());
    for (const std::uint16_t universe : universes) {
        bytes.push_back(static_cast<std::uint8_t>(universe >> 8));
        bytes.push_back(static_cast<std::uint8_t>(universe & 0xFF));
    }
    return bytes;
}

}  // namespace

Cid randomCid() {
    std::random_device device;
    std::uniform_int_distribution<unsigned> byte(0, 255);
    Cid cid{};
    for (std::uint8_t& one : cid) one = static_cast<std::uint8_t>(byte(device));
    cid[6] = static_cast<std::uint8_t>((cid[6] & 0x0F) | 0x40);  // version 4
    cid[8] = static_cast<std::uint8_t>((cid[8] & 0x3F) | 0x80);  // the variant of RFC 4122
    return cid;
}

void SacnSource::Content::set(std::span<const std::uint8_t> newSlots) {
    if (lastSent && std::ranges::equal(slots, newSlots)) return;
    slots.assign(newSlots.begin(), newSlots.end());
    repeatsLeft = kRepeats;
    lastSent.reset();
}

TimePoint SacnSource::Content::due() const {
    if (slots.empty()) return TimePoint::max();
    if (!lastSent) return TimePoint::min();
    if (repeatsLeft > 0) return *lastSent + kRepeatInterval;
    return *lastSent + kKeepAliveInterval;
}

void SacnSource::Content::markSent(TimePoint now) {
    if (lastSent && repeatsLeft > 0) --repeatsLeft;
    lastSent = now;
}

SacnSource::SacnSource(SacnSourceConfig config) : config_(std::move(config)) {
    assert(config_.priority <= kMaxPriority);
    assert(config_.syncAddress <= kMaxSacnUniverse);
}

void SacnSource::setLevels(std::uint16_t universe, std::span<const std::uint8_t> slots) {
    assert(universe >= 1 && universe <= kMaxSacnUniverse);
    assert(!slots.empty() && slots.size() <= kSlotCount);
    outputs_[universe].levels.set(slots);
}

void SacnSource::setSlotPriorities(std::uint16_t universe, std::span<const std::uint8_t> priorities) {
    assert(universe >= 1 && universe <= kMaxSacnUniverse);
    assert(priorities.size() <= kSlotCount);
    outputs_[universe].priorities.set(priorities);
}

std::optional<TimePoint> SacnSource::nextDue() const {
    if (outputs_.empty()) return std::nullopt;
    TimePoint next = nextDiscovery_;
    for (const auto& [universe, output] : outputs_) {
        next = std::min({next, output.levels.due(), output.priorities.due()});
    }
    return next;
}

void SacnSource::emitDue(TimePoint now, const Emit& emit) {
    bool hasLevels = false;
    for (auto& [universe, output] : outputs_) {
        // Priorities first, so that no receiver shows new levels by the packet's priority.
        if (output.priorities.due() <= now) {
            emitContent(universe, output, output.priorities, kStartCodeSlotPriorities, false, emit);
            output.priorities.markSent(now);
        }
        if (output.levels.due() <= now) {
            emitContent(universe, output, output.levels, kStartCodeLevels, false, emit);
            output.levels.markSent(now);
            hasLevels = true;
        }
    }
    if (hasLevels && config_.syncAddress != 0) emitSync(emit);
    if (!outputs_.empty() && nextDiscovery_ <= now) {
        emitDiscovery(emit);
        nextDiscovery_ = now + kDiscoveryInterval;
    }
}

// Round by round over all universes, so that a burst of loss does not take all copies of one.
void SacnSource::terminate(const Emit& emit) {
    for (int copy = 0; copy < kTerminations; ++copy) {
        for (auto& [universe, output] : outputs_) {
            emitContent(universe, output, output.levels, kStartCodeLevels, true, emit);
        }
    }
    outputs_.clear();
}

void SacnSource::emitContent(std::uint16_t universe, Output& output, const Content& content,
                             std::uint8_t startCode, bool isTerminated, const Emit& emit) {
    SacnData data;
    data.cid = config_.cid;
    data.sourceName = config_.name;
    data.priority = config_.priority;
    data.syncAddress = startCode == kStartCodeLevels ? config_.syncAddress : std::uint16_t{0};
    data.sequence = output.sequence++;
    data.isPreview = config_.isPreview;
    data.isTerminated = isTerminated;
    data.universe = universe;
    data.startCode = startCode;
    data.slots = content.slots;
    emit(universe, packSacnData(data));
}

void SacnSource::emitSync(const Emit& emit) {
    SacnSync sync;
    sync.cid = config_.cid;
    sync.sequence = syncSequence_++;
    sync.syncAddress = config_.syncAddress;
    emit(sync.syncAddress, packSacnSync(sync));
}

void SacnSource::emitDiscovery(const Emit& emit) {
    std::vector<std::uint16_t> universes;
    for (const auto& [universe, output] : outputs_) universes.push_back(universe);
    const std::size_t lastPage = (universes.size() - 1) / kSacnUniversesPerPage;
    for (std::size_t page = 0; page <= lastPage; ++page) {
        const auto rest = std::span(universes).subspan(page * kSacnUniversesPerPage);
        const auto bytes = universeBytesOf(rest.first(std::min(rest.size(), kSacnUniversesPerPage)));
        SacnDiscovery discovery;
        discovery.cid = config_.cid;
        discovery.sourceName = config_.name;
        discovery.page = static_cast<std::uint8_t>(page);
        discovery.lastPage = static_cast<std::uint8_t>(lastPage);
        discovery.universeBytes = bytes;
        emit(kSacnDiscoveryUniverse, packSacnDiscovery(discovery));
    }
}

}  // namespace hazer::protocol
