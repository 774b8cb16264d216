#include "protocol/sacn_discovered.h"

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
        source.collected.reset();
        source.nextPage = 0;
    }
    if (page.page != source.nextPage) return true;  // one was lost on its way; the next round begins anew
    ++source.nextPage;
    for (std::size_t i = 0; i < page.universeCount(); ++i) {
        const std::uint16_t universe = page.universe(i);
        if (universe >= 1 && universe <= kMaxSacnUniverse) source.collected.set(universe);
    }
    if (page.page == page.lastPage) source.universes = source.collected;
    return true;
}

std::vector<SacnDiscoveredSource> SacnDiscoveredSources::status(TimePoint now) const {
    std::vector<SacnDiscoveredSource> all;
    for (const auto& [cid, source] : sources_) {
        if (now - source->lastSeen > kForgetAfter) continue;
        SacnDiscoveredSource one{cid, source->name, addressText(source->from), {}, source->lastSeen};
        for (std::size_t universe = 1; universe <= kMaxSacnUniverse; ++universe) {
            if (source->universes[universe]) one.universes.push_back(static_cast<std::uint16_t>(universe));
        }
        all.push_back(std::move(one));
    }
    return all;
}

bool SacnDiscoveredSources::makeRoom(TimePoint now) {
    if (sources_.size() < kCapacity) return true;
    return std::erase_if(sources_,
                         [&](const auto& item) { return now - item.second->lastSeen > kForgetAfter; }) > 0;
}

}  // namespace hazer::protocol
