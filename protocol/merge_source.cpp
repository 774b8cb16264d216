#include "protocol/merge_source.h"

#include <algorithm>

namespace hazer::protocol {
namespace {

constexpr std::size_t kMaxTextLength = 64;

void assign(std::string& text, std::string_view value) {
    value = value.substr(0, kMaxTextLength);
    if (!value.empty() && text != value) text.assign(value);
}

}  // namespace

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

void MergeSource::describe(std::string_view newName, std::string_view newAddress) {
    assign(name, newName);
    assign(address, newAddress);
}

}  // namespace hazer::protocol
