// In place of usb_input.cpp where HAZER_USB is off: no libusb at all.
#include "protocol/network_error.h"
#include "protocol/usb/usb_input.h"

namespace hazer::protocol {

struct UsbInput::Impl {};

UsbInput::UsbInput(UsbConfig, UniverseStore&) {
    throw NetworkError(
        "A USB input is asked for, but this hazer was built without USB; build it with HAZER_USB=ON, or "
        "receive "
        "the universe over Art-Net or sACN.");
}

UsbInput::~UsbInput() = default;

std::vector<UsbLineStatus> UsbInput::devices() const {
    return {};
}

bool UsbInput::usesLibusb() const {
    return false;
}

bool UsbInput::isBuiltIn() {
    return false;
}

}  // namespace hazer::protocol
