#include "app/usb_inputs.h"

#include <algorithm>

namespace hazer::app {

std::optional<UsbWish> usbWishOf(const std::vector<ShowInput>& inputs,
                                 const std::vector<protocol::UniverseId>& patched) {
    UsbWish wish;
    wish.config.others = protocol::UsbOthers::kNone;
    for (const ShowInput& input : inputs) {
        if (input.transport != protocol::Transport::kDmx) continue;
        wish.isAskedFor = true;
        if (!input.usbSerial.empty()) {
            wish.config.bindings.push_back({input.usbSerial, input.usbUniverse});
        } else {
            wish.config.others = protocol::UsbOthers::kAll;
            wish.config.firstUniverse = input.usbUniverse.value_or(1);
        }
    }
    if (wish.isAskedFor) return wish;
    const bool isPatched = std::ranges::any_of(patched, [](const protocol::UniverseId& universe) {
        return universe.transport == protocol::Transport::kDmx ||
               universe.transport == protocol::Transport::kAny;
    });
    if (!isPatched) return std::nullopt;
    wish.config.others = protocol::UsbOthers::kThoseThatNameDmx;
    return wish;
}

}  // namespace hazer::app
