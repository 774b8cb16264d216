// Receives DMX from USB interfaces through libusb, on a thread of its own. docs/usb.md tells what works with
// what.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/universe_store.h"
#include "protocol/usb/usb_tap.h"
#include "protocol/usb/usb_universes.h"
#include "protocol/usb/usb_widget.h"

namespace hazer::protocol {

/// Which of the interfaces that no binding names are opened.
enum class UsbOthers : std::uint8_t {
    kNone,
    kThoseThatNameDmx,  ///< A bare serial chip may as well be somebody's modem.
    kAll,
};

struct UsbConfig {
    std::vector<UsbBinding> bindings{};  ///< Interfaces by serial number.
    UsbOthers others = UsbOthers::kAll;
    std::uint16_t firstUniverse = 1;  ///< The lowest number for those without a binding.
    UsbTap tap{};
    std::filesystem::path sysfs = "/sys";
    /// How often to look for what was plugged in, and to try again what could not be opened.
    std::chrono::milliseconds lookEvery{1000};
};

enum class UsbState : std::uint8_t {
    kStarting,   ///< Opened; its kind is being found out.
    kReceiving,  ///< Frames come.
    kSilent,     ///< Nothing on its DMX line for 1.25 s.
    kFailed,     ///< Not open: UsbLineStatus::problem says why. It is tried again.
};

/// One DMX input. A chip with several ports has one for each.
struct UsbLineStatus {
    std::string key{};     ///< What a show calls it: its serial number, or "usb-1-1.2" by its socket.
    std::string name{};    ///< "ENTTEC DMX USB PRO".
    std::string socket{};  ///< "1-1.2": the bus, then the sockets of the hubs on the way.
    UsbState state = UsbState::kStarting;
    std::string problem{};  ///< One sentence; empty if it is open.
    UniverseId universe{Transport::kDmx, 0};
    UsbWidgetFacts facts{};
};

/// From the constructor to the destructor, every frame stands in `store` as a universe of Transport::kDmx.
/// Interfaces may come and go; each keeps its number. As long as none is plugged in, libusb is not used at
/// all.
class UsbInput {
 public:
    /// Throws NetworkError if hazer was built without USB (HAZER_USB=OFF). `store` must outlive it.
    UsbInput(UsbConfig config, UniverseStore& store);
    ~UsbInput();  ///< Gives the interfaces back to the kernel's own drivers.
    UsbInput(const UsbInput&) = delete;
    UsbInput& operator=(const UsbInput&) = delete;

    /// Every interface that is plugged in and wanted, ascending by socket. Thread-safe.
    std::vector<UsbLineStatus> devices() const;

    /// Whether libusb has been needed so far. Thread-safe.
    bool usesLibusb() const;

    /// False where hazer was built without USB.
    static bool isBuiltIn();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
