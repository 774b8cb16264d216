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
        if (!sweep_.makeRoom(streams_, kCapacity, kForgetAfter, now)) return true;
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

}  // namespace hazer::protocol
