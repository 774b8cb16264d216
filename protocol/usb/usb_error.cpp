#include <fmt/format.h>
#include <libusb.h>

#include "protocol/usb/usb_line.h"

namespace hazer::protocol {
namespace {

std::string explain(int code) {
    switch (code) {
        case LIBUSB_ERROR_ACCESS:
            return "hazer may not open it; copy 60-hazer-usb.rules (from hazer's folder lib/udev/rules.d) to "
                   "/etc/udev/rules.d, then unplug it and plug it in again";
        case LIBUSB_ERROR_BUSY:
            return "another program uses it; close that program (OLA and QLC+ open interfaces of this kind)";
        case LIBUSB_ERROR_NO_DEVICE:
            return "it was unplugged";
        case LIBUSB_ERROR_TIMEOUT:
            return "it does not answer; unplug it and plug it in again";
        case LIBUSB_ERROR_PIPE:
            return "it refuses what every interface of its kind can do; unplug it and plug it in again";
        case LIBUSB_ERROR_IO:
            return "the connection fails; try another cable or another socket";
        case LIBUSB_ERROR_OVERFLOW:
            return "it sends more than it was asked for; try another socket, without a hub";
        case LIBUSB_ERROR_NO_MEM:
            return "the system has no memory left for USB; raise usbcore.usbfs_memory_mb";
        case LIBUSB_ERROR_NOT_FOUND:
            return "it has not the endpoints of a DMX interface of its kind";
        case LIBUSB_ERROR_NOT_SUPPORTED:
            return "this system cannot take it from its driver; unload that driver (ftdi_sio or usbhid)";
        default:
            return fmt::format("libusb reports {}", libusb_error_name(code));
    }
}

}  // namespace

UsbError::UsbError(int code)
    : std::runtime_error(explain(code)), isUnplugged_(code == LIBUSB_ERROR_NO_DEVICE) {}

}  // namespace hazer::protocol
