// One opened DMX input: libusb's transfers on one side, a UsbWidget on the other.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "protocol/usb/libusb_handles.h"
#include "protocol/usb/usb_interfaces.h"
#include "protocol/usb/usb_widget.h"

namespace hazer::protocol {

/// Why an interface is of no use now. what() says in half a sentence what is wrong and what to do.
class UsbError : public std::runtime_error {
 public:
    /// `code`: one of libusb_error.
    explicit UsbError(int code);
    bool isUnplugged() const { return isUnplugged_; }

 private:
    bool isUnplugged_;
};

/// Everything happens on the thread that handles libusb's events.
class UsbLine {
 public:
    /// Opens and takes the port `port` (from 0) of `device`, from the kernel's driver if need be, and begins
    /// to receive. Throws UsbError. `show` is called with every frame.
    UsbLine(libusb_context* context, libusb_device* device, const UsbInterface& interface, int port,
            ShowSlots show);
    ~UsbLine();  ///< Gives it back to the kernel's driver.
    UsbLine(const UsbLine&) = delete;
    UsbLine& operator=(const UsbLine&) = delete;

    /// Writes what the interface is to be asked for by now. Throws UsbError if the line cannot go on.
    void advance(TimePoint now);

    /// When to call advance though nothing was received.
    std::optional<TimePoint> nextDeadline() const;

    UsbWidgetFacts facts() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
