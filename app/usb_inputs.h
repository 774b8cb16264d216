// What a show wants of USB.
#pragma once

#include <optional>
#include <vector>

#include "app/show.h"
#include "protocol/usb/usb_input.h"

namespace hazer::app {

struct UsbWish {
    protocol::UsbConfig config;
    bool isAskedFor = false;  ///< By an input; else only by fixtures that are patched to DMX lines.
};

/// Nothing if the show has nothing to do with USB. `patched`: the universes of its fixtures.
std::optional<UsbWish> usbWishOf(const std::vector<ShowInput>& inputs,
                                 const std::vector<protocol::UniverseId>& patched);

}  // namespace hazer::app
