// What goes out when a recording is sent again, and when: without sockets or clocks.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocol/recording/packet_stream.h"
#include "protocol/recording/recording.h"

namespace hazer::protocol {

struct ResendRules {
    double rate = 1.0;     ///< Times faster than recorded, above 0.
    bool loops = false;    ///< Begins again at the end, at `from`.
    RecordingTime from{};  ///< Begins there, with what stood then sent first.
};

/// One datagram.
struct ResentDatagram {
    Clock::duration due{};  ///< Since the beginning; never less than that of the one before.
    RecordingTime time{};   ///< In the recording.
    Transport transport = Transport::kArtNet;
    std::span<const std::uint8_t> bytes{};  ///< Valid until the next call.
};

/// Not thread-safe. May throw RecordingError whenever it reads.
class ResendSchedule {
 public:
    ResendSchedule(std::unique_ptr<RecordingReader> reader, const ResendRules& rules);
    ~ResendSchedule();

    /// Reads up to where sending begins, which may take a while. `shouldStop` is asked now and then; false if
    /// it said so. Call once, before next().
    bool skipToStart(const std::function<bool()>& shouldStop);

    /// The next datagram; nothing at the end. With `loops` there is none only if no packet follows `from`.
    /// Sequence numbers go on from round to round, or receivers would take the first packets of each for late
    /// ones.
    std::optional<ResentDatagram> next();

    /// When the round that was begun last is over, since the beginning: at the end of the recording.
    Clock::duration roundEnd() const;

    std::uint64_t rounds() const { return rounds_; }  ///< Times the end was reached.
    const std::vector<std::string>& warnings() const { return reader_->warnings(); }

 private:
    using Bytes = std::vector<std::uint8_t>;
    class LoopNumbering;
    class StandingPackets;

    Clock::duration scaled(RecordingTime time) const;
    RecordingTime roundLength() const;
    bool beginRound();
    void prepare(const RecordedPacket& packet);
    void pack(const RecordedFrame& frame);

    std::unique_ptr<RecordingReader> reader_;
    ResendRules rules_;
    RecordingMarkPtr startMark_;
    std::unique_ptr<StandingPackets> standing_;
    std::unique_ptr<LoopNumbering> numbering_;
    std::map<UniverseId, std::uint8_t> frameSequences_;
    RecordingTime lastTime_{};
    Clock::duration roundStart_{};
    bool isRoundEmpty_ = true;
    std::uint64_t rounds_ = 0;
    Bytes bytes_;                               ///< Of the packet in hand.
    Transport transport_ = Transport::kArtNet;  ///< The same.
    std::optional<StreamedPacket> streamed_;    ///< The same.
};

}  // namespace hazer::protocol
