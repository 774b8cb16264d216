#include "protocol/artnet_desks.h"

#include <algorithm>

namespace hazer::protocol {

void ArtNetDesks::hear(Endpoint from, const ArtPoll& poll, TimePoint now) {
    const auto known = std::ranges::find(desks_, from, &ArtNetDesk::endpoint);
    if (known != desks_.end()) {
        *known = {from, poll, now};
    } else if (all(now).size() < kCapacity) {
        desks_.push_back({from, poll, now});
    }
}

const std::vector<ArtNetDesk>& ArtNetDesks::all(TimePoint now) {
    std::erase_if(desks_, [&](const ArtNetDesk& desk) { return now - desk.lastPoll > kForgetAfter; });
    return desks_;
}

}  // namespace hazer::protocol
