// DMX from a USB interface, dressed as sACN so that a recording of it is one that everybody can read.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "protocol/datagram.h"
#include "protocol/recording/recorder.h"
#include "protocol/sacn.h"
#include "protocol/universe_status.h"

namespace hazer::protocol {

/// A frame of a DMX line.
struct UsbFrame {
    std::uint16_t line = 1;   ///< Number of the universe, 1..63999.
    SourceId source{};        ///< Of which the first eight bytes are kept.
    std::string_view name{};  ///< Of the interface; at most 63 bytes reach the file.
    std::uint8_t startCode = 0;
    std::span<const std::uint8_t> slots{};  ///< 0..512 values.
};

/// An sACN packet whose CID says that it never was on a network.
std::vector<std::uint8_t> wrapUsbFrame(const UsbFrame& frame, std::uint8_t sequence);

/// Whether a datagram, if it is sACN at all, carries such a CID: a glance at eight bytes.
bool isWrappedUsbFrame(std::span<const std::uint8_t> datagram);

/// The frame within such a packet; nothing if a desk sent it.
std::optional<UsbFrame> unwrapUsbFrame(const SacnData& data);

/// Records what comes by USB, wrapped. Not thread-safe, as it is called from the one thread of USB.
class UsbRecording {
 public:
    explicit UsbRecording(Recorder& recorder) : recorder_(recorder) {}

    /// A frame of universe 1..63999; others are left out.
    void record(UniverseId universe, std::span<const std::uint8_t> slots, WallTime time);

 private:
    Recorder& recorder_;
    std::map<UniverseId, std::uint8_t> sequences_;
};

}  // namespace hazer::protocol
