// Which DMX interfaces are plugged in: a look into sysfs, which needs neither permission nor libusb.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hazer::protocol {

/// Who talks to it.
enum class UsbFamily : std::uint8_t {
    kFtdi,   ///< A serial chip: ENTTEC's DMX USB Pro and its kin, Open DMX.
    kNodle,  ///< HID: Nodle, FX5.
};

struct UsbId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    UsbFamily family = UsbFamily::kFtdi;
};

/// Those that app/60-hazer-usb.rules lets people open.
inline constexpr std::array kUsbIds{
    UsbId{0x0403, 0x6001,
          UsbFamily::kFtdi},  // FT232B, FT232R, FT245: ENTTEC Pro and Open, DMXking, most others
    UsbId{0x0403, 0x6010, UsbFamily::kFtdi},   // FT2232: two ports
    UsbId{0x0403, 0x6011, UsbFamily::kFtdi},   // FT4232: four ports
    UsbId{0x0403, 0x6014, UsbFamily::kFtdi},   // FT232H
    UsbId{0x0403, 0x6015, UsbFamily::kFtdi},   // FT-X
    UsbId{0x16D0, 0x0830, UsbFamily::kNodle},  // Nodle U1
    UsbId{0x16D0, 0x0833, UsbFamily::kNodle},  // Nodle R4S
    UsbId{0x16C0, 0x088B, UsbFamily::kNodle},  // Digital Enlightenment USB-DMX
    UsbId{0x04B4, 0x0F1F, UsbFamily::kNodle},  // FX5
};

/// Nothing for a device that hazer does not know.
std::optional<UsbFamily> usbFamilyOf(std::uint16_t vendor, std::uint16_t product);

/// A device as the kernel describes it. Texts are printable UTF-8 and short, whatever the device says.
struct UsbInterface {
    std::string port{};       ///< "1-1.2": the bus, then the sockets of the hubs on the way.
    std::uint8_t bus = 0;     ///< With `device` the name of the node in /dev/bus/usb.
    std::uint8_t device = 0;  ///< Anew each time it is plugged in.
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::uint16_t bcdDevice = 0;
    UsbFamily family = UsbFamily::kFtdi;
    std::string manufacturer{};
    std::string name{};
    std::string serial{};  ///< May be empty, and is not always unique.
};

/// Manufacturer and name, or the ids where it says nothing.
std::string describe(const UsbInterface& interface);

/// Whether it says that it is for DMX. A bare serial chip says the same in a DMX cable and in a modem's.
bool namesDmx(const UsbInterface& interface);

/// All that hazer knows of, ascending by port. Empty where there is no USB. `sysfs`: /sys, but in tests.
std::vector<UsbInterface> findUsbInterfaces(const std::filesystem::path& sysfs = "/sys");

}  // namespace hazer::protocol
