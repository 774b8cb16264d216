#include "protocol/usb/ftdi_setup.h"

namespace hazer::protocol {
namespace {

constexpr std::uint8_t kReset = 0x00;
constexpr std::uint8_t kModemControl = 0x01;
constexpr std::uint8_t kFlowControl = 0x02;
constexpr std::uint8_t kBaudRate = 0x03;
constexpr std::uint8_t kLineProperties = 0x04;
constexpr std::uint8_t kLatencyTimer = 0x09;

constexpr std::uint16_t kResetPort = 0;
constexpr std::uint16_t kDropReceived = 2;
constexpr std::uint16_t kRtsLow = 0x0200;
constexpr std::uint16_t kEightDataTwoStopBits = 0x1008;
constexpr std::uint16_t kLatencyMs = 1;  // so that few packets hold more than one event of the line

// bcdDevice of FT2232H, FT4232H and FT232H; FT-X has a higher one and the older clock.
constexpr std::uint16_t kFt2232h = 0x0700;
constexpr std::uint16_t kFt232h = 0x0900;

/// 250 kbaud: a twelfth of 3 MHz, or, for the fast chips, a 48th of 12 MHz, which bit 9 of the index chooses.
UsbControlRequest baudRate(std::uint16_t bcdDevice, std::uint16_t index) {
    const bool isFast = bcdDevice >= kFt2232h && bcdDevice <= kFt232h;
    if (!isFast) return {kBaudRate, 12, index};
    return {kBaudRate, 48, static_cast<std::uint16_t>(0x0200 | index)};
}

}  // namespace

std::vector<UsbControlRequest> ftdiSetup(std::uint16_t bcdDevice, int port) {
    const std::uint16_t index = ftdiIndex(port);
    constexpr std::uint16_t kFt2232c = 0x0500;
    const bool hasOnePort = bcdDevice < kFt2232c || bcdDevice == 0x0600 || bcdDevice > kFt232h;
    return {
        {kReset, kResetPort, index},
        {kFlowControl, 0, index},
        baudRate(bcdDevice, hasOnePort ? std::uint16_t{0} : index),
        {kLineProperties, kEightDataTwoStopBits, index},
        {kModemControl, kRtsLow, index},
        {kLatencyTimer, kLatencyMs, index},
        {kReset, kDropReceived, index},
    };
}

std::uint16_t ftdiIndex(int port) {
    return static_cast<std::uint16_t>(port + 1);
}

int ftdiPortCount(std::uint16_t productId) {
    switch (productId) {
        case 0x6010:
            return 2;
        case 0x6011:
            return 4;
        default:
            return 1;
    }
}

}  // namespace hazer::protocol
