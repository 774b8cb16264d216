// What the fuzz targets of recordings share: any bytes as a file, read whole, then from a place in the
// middle.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "protocol/recording/recording.h"
#include "protocol/recording/replay_state.h"

namespace hazer::protocol::fuzz {

inline void require(bool condition) {
    if (!condition) std::abort();
}

/// A file in memory, with a path to open it by.
class MemoryFile {
 public:
    MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("recording", 0)) {
        require(descriptor_ >= 0 && ::write(descriptor_, data, size) == static_cast<ssize_t>(size));
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
    int descriptor_;
};

inline std::vector<std::uint8_t> bytesOf(const RecordedPacket& packet) {
    if (const auto* datagram = std::get_if<RecordedDatagram>(&packet.content)) {
        return {datagram->bytes.begin(), datagram->bytes.end()};
    }
    const auto& frame = std::get<RecordedFrame>(packet.content);
    require(frame.slots.size() <= kSlotCount);
    return {frame.slots.begin(), frame.slots.end()};
}

/// Times never go back; a mark leads to the same packet again; the receiver takes whatever comes.
inline void readRecording(RecordingReader& reader) {
    constexpr int kMostPackets = 200;  // a small file may claim a frame for every day of the year
    constexpr int kMarked = 5;
    RecordingMarkPtr mark = reader.mark();
    std::vector<std::uint8_t> markedBytes;
    ReplayState state;
    RecordingTime last{};
    int count = 0;
    for (; count < kMostPackets; ++count) {
        if (count == kMarked) mark = reader.mark();
        const auto packet = reader.next();
        if (!packet) break;
        require(packet->time >= last);
        last = packet->time;
        if (count == kMarked) markedBytes = bytesOf(*packet);
        state.play(*packet);
    }
    require(state.packetCount() == static_cast<std::uint64_t>(count));
    UniverseSet looks;
    state.latch(looks, last);
    if (count <= kMarked) return;
    reader.goTo(*mark);
    const auto again = reader.next();
    require(again && bytesOf(*again) == markedBytes);
}

/// Opens a file by `open(path)`, which may refuse it.
template <class Open>
int run(const std::uint8_t* data, std::size_t size, Open&& open) {
    const MemoryFile file(data, size);
    try {
        const std::unique_ptr<RecordingReader> reader = open(file.path());
        readRecording(*reader);
    } catch (const RecordingError&) {
        // Most files are none.
    }
    return 0;
}

}  // namespace hazer::protocol::fuzz
