// An Art-Net node without sockets or clocks: datagrams and the time go in, universes and replies come out.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "protocol/artnet.h"
#include "protocol/artnet_desks.h"
#include "protocol/artnet_peers.h"
#include "protocol/artnet_ports.h"
#include "protocol/receiver_counters.h"
#include "protocol/sequence_table.h"
#include "protocol/universe_merger.h"

namespace hazer::protocol {

struct ArtNetNodeConfig {
    /// 0..32767 each, those we ask desks for. Repeated ones count once.
    std::vector<std::uint16_t> portAddresses{};
    std::string shortName{};                         ///< At most 17 characters reach the wire.
    std::string longName{};                          ///< At most 63 characters reach the wire.
    std::chrono::milliseconds maxPollReplyDelay{0};  ///< Replies wait a random time up to this.
    std::uint32_t randomSeed = 0;  ///< Of that time. Nodes on one network should differ in it.
    /// Whether ArtAddress may change anything. Anybody on the network can send one.
    bool isProgrammable = false;
};

/// An answer that is owed to a desk.
struct PendingReply {
    enum class Kind : std::uint8_t { kPollReply, kIpProgReply, kDiagnostics };
    Kind kind = Kind::kPollReply;
    Endpoint to{};
    PortAddressRange wanted{};  ///< kPollReply: the Port-Addresses it asked about.
    TimePoint due{};
    std::uint8_t priority = kDiagLow;  ///< kDiagnostics
    std::string text{};                ///< kDiagnostics
};

struct ReceivedTimeCode {
    ArtTimeCode code{};
    Endpoint from{};
    TimePoint time{};
};

struct ReceivedTrigger {
    std::uint8_t key = 0;  ///< 0 ASCII, 1 macro, 2 soft key, 3 show.
    std::uint8_t subKey = 0;
    Endpoint from{};
    TimePoint time{};
};

/// What there is to know about a node besides universes.
struct ArtNetStatus {
    ReceiverCounters counters{};
    std::optional<ReceivedTimeCode> timeCode{};  ///< The last one of the main stream.
    std::optional<ReceivedTrigger> trigger{};    ///< The last one for everybody.
    Indicators indicators = Indicators::kNormal;
};

/// Not thread-safe; times handed in must not go back. Memory is bounded whatever arrives.
class ArtNetNode {
 public:
    /// Desks that can be owed a reply at once. A network has a handful; the polls of further ones are
    /// ignored.
    static constexpr std::size_t kMaxPendingReplies = 64;

    /// How often a desk that wants to hear of changes can hear of one.
    static constexpr std::chrono::milliseconds kChangeInterval{250};

    explicit ArtNetNode(ArtNetNodeConfig config);

    /// Takes one datagram of any content: levels into the merger, polls into the replies owed, all into the
    /// counters.
    void receive(std::span<const std::uint8_t> datagram, Endpoint from, TimePoint now,
                 UniverseMerger& merger);

    /// Ends synchronizations that timed out, and finds what has changed since the desks were last told. Call
    /// at nextDeadline(), before takeDueReply.
    void advance(TimePoint now, UniverseMerger& merger);

    /// When advance or takeDueReply has something to do.
    std::optional<TimePoint> nextDeadline() const;

    /// Hands over one reply that is due at `now`; call until there is none.
    std::optional<PendingReply> takeDueReply(TimePoint now);

    /// The datagrams of a reply. To a poll: one for each Port-Address that was asked about and that we have;
    /// a node without any Port-Address still answers with one. ownAddress: our address on the network of the
    /// desk.
    std::vector<std::vector<std::uint8_t>> packReply(const PendingReply& reply, Ipv4Address ownAddress);

    const ArtNetStatus& status() const { return status_; }
    const ReceiverCounters& counters() const { return status_.counters; }

 private:
    struct Packet;  // one that arrived, with all that came with it

    void take(const ArtDmx& dmx, const Packet& packet);
    void take(const ArtNzs&, const Packet&) { ++status_.counters.ignored; }
    void take(const ArtSync&, const Packet& packet);
    void take(const ArtPoll& poll, const Packet& packet);
    void take(const PeerPollReply& reply, const Packet& packet);
    void take(const ArtDiagData&, const Packet&) { ++status_.counters.ignored; }
    void take(const ArtAddress& address, const Packet& packet);
    void take(const ArtIpProg&, const Packet& packet);
    void take(const ArtTimeCode& timeCode, const Packet& packet);
    void take(const ArtTrigger& trigger, const Packet& packet);
    void take(Refusal refusal, const Packet&);

    Verdict merge(const Levels& levels, bool isSynchronous, const Packet& packet);
    void obey(const ArtAddress& address, const Packet& packet);
    void obey(AddressCommand command, ArtNetPort& port, const Packet& packet);
    bool isAddressedTo(const ArtPoll& poll) const;
    bool oweReply(Endpoint to, PortAddressRange wanted, TimePoint due);
    bool owe(PendingReply reply);
    void tellOfChange(PortAddressRange changed, TimePoint now);
    void diagnose(std::uint8_t priority, const std::string& text, TimePoint now);
    TimePoint replyTime(TimePoint now);
    std::vector<std::uint8_t> packOne(const ArtNetPort* port, std::size_t index, Ipv4Address ownAddress);

    ArtNetNodeConfig config_;
    ArtNetPorts ports_;
    ArtNetPeers peers_;
    ArtNetDesks desks_;
    SequenceTable sequences_;
    std::vector<PendingReply> pending_;
    std::mt19937 random_;
    std::uint32_t replyCount_ = 0;
    TimePoint nextChangeCheck_ = TimePoint::max();  ///< Never while no desk polls.
    TimePoint nextRefusalReport_{};
    ArtNetStatus status_;
};

}  // namespace hazer::protocol
