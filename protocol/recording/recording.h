// What every recording gives, whatever its format: packets in the order of time, from any place on.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "protocol/dmx.h"
#include "protocol/endpoint.h"

namespace hazer::protocol {

/// A recording that cannot be used. what() is one sentence: file, place, what is wrong, what to do.
class RecordingError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Since the first packet of the recording; never negative.
using RecordingTime = std::chrono::nanoseconds;

/// The payload of a UDP datagram as it was on the wire.
struct RecordedDatagram {
    IpEndpoint from{};
    IpEndpoint to{};
    std::span<const std::uint8_t> bytes{};
};

/// A universe of a format that knows no network (OLA, FSEQ).
struct RecordedFrame {
    UniverseId universe{};
    std::span<const std::uint8_t> slots{};  ///< 0..512 values.
};

struct RecordedPacket {
    RecordingTime time{};  ///< Never less than that of the packet before.
    std::variant<RecordedDatagram, RecordedFrame> content{};
};

/// A place in a recording, which its reader alone understands.
class RecordingMark {
 public:
    virtual ~RecordingMark() = default;
};
using RecordingMarkPtr = std::shared_ptr<const RecordingMark>;

/// Reads a recording packet by packet and holds only a bounded part of it in memory. Not thread-safe.
/// Everything may throw RecordingError if the file changes under it.
class RecordingReader {
 public:
    virtual ~RecordingReader() = default;

    /// The next packet, or nothing at the end. What it points to is valid until the next call.
    virtual std::optional<RecordedPacket> next() = 0;

    /// The place before the next packet.
    virtual RecordingMarkPtr mark() const = 0;

    /// Goes on at a place that mark() of a reader of the same file has told.
    virtual void goTo(const RecordingMark& mark) = 0;

    /// When the recording ends, as far as it has been read; nothing if only reading it to its end tells.
    virtual std::optional<RecordingTime> duration() const = 0;

    /// What has been read of the file, 0..1.
    virtual double readShare() const = 0;

    /// Packets of lighting so far that are in the file and yet could not be taken out of it: cut short, or in
    /// fragments of which some are missing.
    virtual std::uint64_t refusedCount() const = 0;

    /// Sentences about what is wrong with the file but does not hinder reading the rest.
    virtual const std::vector<std::string>& warnings() const = 0;
};

/// How a format that knows no network becomes universes.
struct FrameMap {
    Transport transport = Transport::kDmx;  ///< What the universes are called.
    std::uint16_t firstUniverse = 1;        ///< What universe 1 of the file is called, or its first channels.
    std::uint16_t slotsPerUniverse = 512;   ///< FSEQ: channels that go into a universe, 1..512.
};

/// Opens a recording of any format; its first bytes tell which. Throws RecordingError.
std::unique_ptr<RecordingReader> openRecording(const std::filesystem::path& file, const FrameMap& map = {});

/// Whether the file begins like one of the formats; false if it cannot be read.
bool isRecording(const std::filesystem::path& file);

}  // namespace hazer::protocol
