#include "protocol/merge_source.h"

#include <algorithm>

namespace hazer::protocol {

std::chrono::milliseconds lossTime(Transport transport) {
    switch (transport) {
        case Transport::kArtNet:
            return std::chrono::milliseconds(10000);
        case Transport::kSacn:
            return std::chrono::milliseconds(2500);
        case Transport::kDmx:
        case Transport::kAny:
            break;
    }
    return std::chrono::milliseconds(1250);
}

void PacketLevels::take(const Levels& taken) {
    const std::size_t count = std::min(taken.slots.size(), kSlotCount);
    std::copy_n(taken.slots.begin(), count, slots.begin());
    slotCount = static_cast<std::uint16_t>(count);
    priority = std::min(taken.priority, kMaxPriority);
    isPreview = taken.isPreview;
}

}  // namespace hazer::protocol
