#include "protocol/sacn_streams.h"

#include <algorithm>

#include "protocol/sequence.h"

namespace hazer::protocol {
namespace {

std::array<char, kSacnNameSize> nameField(std::string_view name) {
    std::array<char, kSacnNameSize> field{};
    std::copy_n(name.begin(), std::min(name.size(), field.size()), field.begin());
    return field;
}

}  // namespace

bool SacnStreams::isInOrder(const SacnStreamKey& key, std::uint8_t sequence, TimePoint now) const {
    const auto found = streams_.find(key);
    if (found == streams_.end() || now - found->second.time > kForgetAfter) return true;
    return protocol::isInOrder(sequence, found->second.sequence);
}

bool SacnStreams::take(const SacnStreamKey& key, std::uint8_t sequence, std::string_view name,
                       const IpEndpoint& from, TimePoint now) {
    auto found = streams_.find(key);
    const bool isNew = found == streams_.end();
    if (isNew) {
        if (!makeRoom(now)) return true;
        found = streams_.emplace(key, Stream{}).first;
    }
    Stream& stream = found->second;
    const auto field = nameField(name);
    const bool wasSilent = now - stream.time > kForgetAfter;
    const bool isChanged = isNew || wasSilent || stream.from != from || stream.name != field;
    stream = {sequence, now, from, field};
    return isChanged;
}

void SacnStreams::pass(const SacnStreamKey& key, std::uint8_t sequence, TimePoint now) {
    const auto found = streams_.find(key);
    if (found == streams_.end()) return;
    found->second.sequence = sequence;
    found->second.time = now;
}

// Forgets the streams that have been silent. At most once every kForgetAfter, so that a flood of made-up
// sources does not buy a walk through the whole table with each packet.
bool SacnStreams::makeRoom(TimePoint now) {
    if (streams_.size() < kCapacity) return true;
    if (now < nextSweep_) return false;
    nextSweep_ = now + kForgetAfter;
    std::erase_if(streams_, [&](const auto& item) { return now - item.second.time > kForgetAfter; });
    return streams_.size() < kCapacity;
}

}  // namespace hazer::protocol
