// USB devices that are not there: libumockdev shows them to the real libusb, and these classes say what they
// do. Works only where libumockdev-preload.so is loaded; without a USB port, a kernel with USB, or root.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "protocol/usb/ftdi_setup.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol::test {

struct FakeUsbDescription {
    std::string port = "1-1";
    int device = 2;  ///< 1..127, its number on bus 1.
    std::uint16_t vendor = 0x0403;
    std::uint16_t product = 0x6001;
    std::uint16_t bcdDevice = 0x0600;
    std::string manufacturer = "ENTTEC";
    std::string name = "DMX USB PRO";
    std::string serial = "EN123456";
    bool isHid = false;
};

class FakeUsbBus;

/// A device while it is plugged in. Thread-safe.
class FakeUsbDevice {
 public:
    FakeUsbDevice(FakeUsbBus& bus, const FakeUsbDescription& description);
    ~FakeUsbDevice();  ///< Pulls the plug.
    FakeUsbDevice(const FakeUsbDevice&) = delete;
    FakeUsbDevice& operator=(const FakeUsbDevice&) = delete;

    /// One USB packet, as it stands on the bus.
    void sendPacket(const Bytes& packet);

    /// Bytes on the serial line of an FTDI chip, in as many packets as they need.
    void sendSerial(const Bytes& bytes, std::uint8_t lineStatus = 0x60);

    /// From now on, `answer` tells the serial bytes that follow what is written. Called on the fake's thread.
    void answerWith(std::function<Bytes(const Bytes& written)> answer);

    /// The next `count` reads end with -`error` (EPIPE: a stall, which lasts until it is cleared).
    void failReads(int count, int error);

    void setMute(bool isMute);    ///< Neither control requests nor reads come to an end.
    void setQuiet(bool isQuiet);  ///< No status packets while nothing is on the line, as with some copies.
    void setBusy(bool isBusy);    ///< Another program has claimed the interface.

    std::vector<UsbControlRequest> controlRequests() const;
    std::vector<Bytes> written() const;
    bool hasKernelDriver() const;
    bool isClaimed() const;
    int clearedHalts() const;
    bool hasSentAll() const;

 private:
    friend class FakeUsbBus;
    struct Impl;
    std::shared_ptr<Impl> impl_;
    FakeUsbBus& bus_;
    FakeUsbDescription description_;
};

/// The machine's USB, with bus 1 and nothing on it. One at a time.
class FakeUsbBus {
 public:
    FakeUsbBus();
    ~FakeUsbBus();
    FakeUsbBus(const FakeUsbBus&) = delete;
    FakeUsbBus& operator=(const FakeUsbBus&) = delete;

    /// Whether libumockdev is loaded.
    static bool isPossible();

    /// Where /dev and /sys are in the real file system.
    std::string rootFolder() const;

 private:
    friend class FakeUsbDevice;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol::test
