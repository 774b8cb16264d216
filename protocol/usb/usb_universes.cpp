#include "protocol/usb/usb_universes.h"

#include <algorithm>
#include <limits>

namespace hazer::protocol {

UsbUniverses::UsbUniverses(const std::vector<UsbBinding>& bindings, std::uint16_t first) : next_(first) {
    for (const UsbBinding& binding : bindings) {
        if (binding.universe) numbers_.emplace(binding.serial, *binding.universe);
    }
}

std::optional<std::uint16_t> UsbUniverses::of(const std::string& key) {
    if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
    const auto isTaken = [&](std::uint32_t number) {
        return std::ranges::any_of(numbers_, [&](const auto& entry) { return entry.second == number; });
    };
    while (isTaken(next_)) ++next_;
    if (next_ > std::numeric_limits<std::uint16_t>::max()) return std::nullopt;
    const auto number = static_cast<std::uint16_t>(next_);
    numbers_.emplace(key, number);
    return number;
}

}  // namespace hazer::protocol
