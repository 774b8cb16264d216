// Everything that a recording has done to the receiver up to some moment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/artnet_node.h"
#include "protocol/recording/recording.h"
#include "protocol/sacn_listener.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

/// How a recording is received; the same words as for a network.
struct ReplayRules {
    MergeRules merge{};
    PreviewRule preview = PreviewRule::kBoth;
    std::vector<UniverseId> asked{};  ///< Those of the patch.
    std::string fileName{};           ///< What a format without network calls its source.
};

/// The same state machines that receive live packets, driven by the times of a recording. A value: a copy
/// goes on exactly as the original does. Not thread-safe.
class ReplayState {
 public:
    explicit ReplayState(const ReplayRules& rules = {});

    /// Takes the next packet of a recording.
    void play(const RecordedPacket& packet);

    /// Copies every look as it stands at `now`, which is not before the last packet.
    void latch(UniverseSet& out, RecordingTime now);
    std::vector<UniverseStatus> status(RecordingTime now);

    std::uint64_t packetCount() const { return packetCount_; }

    /// Packets that were broken, out of order, or of more sources or universes than there are places for.
    std::uint64_t refusedCount() const;

    /// What a copy takes in memory, roughly.
    std::size_t approximateBytes() const;

    const ArtNetNode& artNet() const { return artNet_; }
    const SacnListener& sacn() const { return sacn_; }

    /// The moment of a recording for the state machines.
    static TimePoint timePointOf(RecordingTime time) { return kStart + time; }

 private:
    // Far enough from 0 that "an hour ago" is no negative time.
    static constexpr TimePoint kStart{std::chrono::hours(1)};

    void ageTo(TimePoint now);
    void playDatagram(const RecordedDatagram& datagram, TimePoint now);
    void playArtNet(const RecordedDatagram& datagram, TimePoint now);
    bool playUsb(std::span<const std::uint8_t> bytes, TimePoint now);
    void playFrame(const RecordedFrame& frame, TimePoint now);

    std::string fileName_;
    UniverseMerger merger_;
    ArtNetNode artNet_;
    SacnListener sacn_;
    std::uint64_t packetCount_ = 0;
    std::uint64_t refusedCount_ = 0;  ///< Those that no state machine has counted.
};

}  // namespace hazer::protocol
