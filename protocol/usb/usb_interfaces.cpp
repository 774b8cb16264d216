#include "protocol/usb/usb_interfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>

#include "protocol/printable_text.h"

namespace hazer::protocol {
namespace {

constexpr std::size_t kLongestText = 64;

/// The one line of an attribute; empty if there is none.
std::string attribute(const std::filesystem::path& device, const char* name) {
    std::ifstream file(device / name);
    std::string text(kLongestText, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return printableText(text.substr(0, text.find('\n')));
}

template <class Number>
std::optional<Number> numberOf(std::string_view text, int base) {
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<UsbInterface> readInterface(const std::filesystem::path& folder) {
    constexpr int kHexadecimal = 16;
    const auto vendor = numberOf<std::uint16_t>(attribute(folder, "idVendor"), kHexadecimal);
    if (!vendor) return std::nullopt;
    const auto product = numberOf<std::uint16_t>(attribute(folder, "idProduct"), kHexadecimal);
    const auto family = product ? usbFamilyOf(*vendor, *product) : std::nullopt;
    if (!family) return std::nullopt;
    const auto bus = numberOf<std::uint8_t>(attribute(folder, "busnum"), 10);
    const auto device = numberOf<std::uint8_t>(attribute(folder, "devnum"), 10);
    if (!bus || !device) return std::nullopt;
    return UsbInterface{
        .port = folder.filename().string(),
        .bus = *bus,
        .device = *device,
        .vendor = *vendor,
        .product = *product,
        .bcdDevice = numberOf<std::uint16_t>(attribute(folder, "bcdDevice"), kHexadecimal).value_or(0),
        .family = *family,
        .manufacturer = attribute(folder, "manufacturer"),
        .name = attribute(folder, "product"),
        .serial = attribute(folder, "serial"),
    };
}

bool holds(std::string text, std::string_view word) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return text.find(word) != std::string::npos;
}

}  // namespace

std::optional<UsbFamily> usbFamilyOf(std::uint16_t vendor, std::uint16_t product) {
    const auto known = std::ranges::find_if(
        kUsbIds, [&](const UsbId& id) { return id.vendor == vendor && id.product == product; });
    if (known == kUsbIds.end()) return std::nullopt;
    return known->family;
}

std::string describe(const UsbInterface& interface) {
    if (interface.manufacturer.empty() && interface.name.empty())
        return fmt::format("USB device {:04x}:{:04x}", interface.vendor, interface.product);
    if (interface.manufacturer.empty() || interface.name.empty())
        return interface.manufacturer + interface.name;
    return fmt::format("{} {}", interface.manufacturer, interface.name);
}

bool namesDmx(const UsbInterface& interface) {
    return interface.family != UsbFamily::kFtdi || holds(interface.name, "DMX") ||
           holds(interface.manufacturer, "DMX") || holds(interface.manufacturer, "ENTTEC");
}

std::vector<UsbInterface> findUsbInterfaces(const std::filesystem::path& sysfs) {
    std::vector<UsbInterface> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(sysfs / "bus/usb/devices", none)) {
        if (const auto interface = readInterface(entry.path())) found.push_back(*interface);
    }
    std::ranges::sort(found, {}, &UsbInterface::port);
    return found;
}

}  // namespace hazer::protocol
