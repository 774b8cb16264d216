// Writes what arrives to a pcap file, on a thread of its own, so that receiving never waits for a disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "protocol/datagram.h"

namespace hazer::protocol {

struct RecorderStatus {
    std::uint64_t packets = 0;  ///< In the file, whole.
    std::uint64_t bytes = 0;    ///< Of the file.
    /// Not in the file: the disk could not keep up for longer than the queue lasts, or writing has failed.
    std::uint64_t dropped = 0;
    std::string failure;  ///< Why writing ended before its time, one sentence; empty: it has not.
};

struct RecorderConfig {
    std::filesystem::path file;
    bool replacesFile = false;  ///< Else a file that exists is an error.
    /// What may wait for the disk. The default lasts some five seconds at 512 universes of 44 Hz.
    std::size_t queueBytes = 64u * 1024u * 1024u;
};

/// Thread-safe. What has been handed to the system survives the end of the program in whatever way; that is
/// all but what arrived while the last write was under way.
class Recorder {
 public:
    /// Creates the file. Throws RecordingError if that fails.
    explicit Recorder(const RecorderConfig& config);
    ~Recorder();  ///< As finish().
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Takes a copy. Waits for nothing but another thread that does the same.
    void record(const Datagram& datagram);

    RecorderStatus status() const;

    /// Writes what waits and closes the file. Later packets count as dropped.
    void finish();

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hazer::protocol
