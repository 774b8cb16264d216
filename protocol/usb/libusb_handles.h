// libusb's things, owned. Only files of HAZER_USB include this.
#pragma once

#include <memory>

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace hazer::protocol {

struct LibusbDelete {
    void operator()(libusb_context* context) const;
    void operator()(libusb_device* device) const;
    void operator()(libusb_device_handle* handle) const;
};

using LibusbContext = std::unique_ptr<libusb_context, LibusbDelete>;
using LibusbDevice = std::unique_ptr<libusb_device, LibusbDelete>;
using LibusbHandle = std::unique_ptr<libusb_device_handle, LibusbDelete>;

}  // namespace hazer::protocol
