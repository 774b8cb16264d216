#include "protocol/sacn_discovered.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "protocol/endpoint_text.h"
#include "protocol/printable_text.h"

namespace hazer::protocol {

bool SacnDiscoveredSources::take(const SacnDiscovery& page, const IpEndpoint& from, TimePoint now) {
    auto found = sources_.find(page.cid);
    if (found == sources_.end()) {
        if (!makeRoom(now)) return false;
        found = sources_.emplace(page.cid, makeDeep<Source>()).first;
    }
    Source& source = *found->second;
    source.name = printableText(page.sourceName);
    source.from = from;
    source.lastSeen = now;
    if (page.page == 0) {
        source.collected.fill(0);
        source.nextPage = 0;
    }
    if (page.page != source.nextPage) return true;  // one was lost on its way; the next round begins anew
    ++source.nextPage;
    for (std::size_t i = 0; i < page.universeCount(); ++i) {
        const std::uint16_t universe = page.universe(i);
        if (universe >= 1 && universe <= kMaxSacnUniverse)
            source.collected[universe / 64] |= std::uint64_t{1} << universe % 64;
    }
    if (page.page == page.lastPage) source.universes = source.collected;
    return true;
}

std::vector<SacnDiscoveredSource> SacnDiscoveredSources::status(TimePoint now) const {
    std::vector<SacnDiscoveredSource> all;
    for (const auto& [cid, source] : sources_) {
        if (now - source->lastSeen > kForgetAfter) continue;
        all.push_back(
            {cid, source->name, addressText(source->from), listOf(source->universes), source->lastSeen});
    }
    return all;
}

std::vector<std::uint16_t> SacnDiscoveredSources::universes(TimePoint now) const {
    UniverseBits all{};
    for (const auto& [cid, source] : sources_) {
        if (now - source->lastSeen > kForgetAfter) continue;
        std::ranges::transform(all, source->universes, all.begin(), std::bit_or{});
    }
    return listOf(all);
}

std::vector<std::uint16_t> SacnDiscoveredSources::listOf(const UniverseBits& bits) {
    std::vector<std::uint16_t> universes;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        for (std::uint64_t word = bits[i]; word != 0; word &= word - 1) {
            universes.push_back(
                static_cast<std::uint16_t>(64 * i + static_cast<std::size_t>(std::countr_zero(word))));
        }
    }
    return universes;
}

bool SacnDiscoveredSources::makeRoom(TimePoint now) {
    if (sources_.size() < kCapacity) return true;
    return std::erase_if(sources_,
                         [&](const auto& item) { return now - item.second->lastSeen > kForgetAfter; }) > 0;
}

}  // namespace hazer::protocol
