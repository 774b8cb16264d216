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
};

/// An answer that is owed to a desk.
struct PendingReply {
    Endpoint to;
    PortAddressRange wanted;  ///< The Port-Addresses it asked about.
    TimePoint due;
};

/// Not thread-safe; times handed in must not go back. Memory is bounded whatever arrives.
class ArtNetNode {
 public:
    /// Desks that can be owed a reply at once. A network has a handful; the polls of further ones are
    /// ignored.
    static constexpr std::size_t kMaxPendingReplies = 64;

    explicit ArtNetNode(ArtNetNodeConfig config);

    /// Takes one datagram of any content: levels into the merger, polls into the replies owed, all into the
    /// counters.
    void receive(std::span<const std::uint8_t> datagram, Endpoint from, TimePoint now,
                 UniverseMerger& merger);

    /// When the next reply is due, if any is owed.
    std::optional<TimePoint> nextReplyDue() const;

    /// Hands over one reply that is due at `now`; call until there is none.
    std::optional<PendingReply> takeDueReply(TimePoint now);

    /// The datagrams of a reply: one for each Port-Address that was asked about and that we have. A node
    /// without any Port-Address still answers with one datagram. ownAddress: our address on the network of
    /// the desk.
    std::vector<ArtPollReplyBytes> packReply(const PendingReply& reply, Ipv4Address ownAddress);

    const ReceiverCounters& counters() const { return counters_; }

 private:
    void takeDmx(const ArtDmx& dmx, Endpoint from, TimePoint now, UniverseMerger& merger);
    void takePoll(const ArtPoll& poll, Endpoint from, TimePoint now);
    void countRefusal(Refusal refusal);
    bool isAddressedTo(const ArtPoll& poll) const;
    bool owe(Endpoint to, PortAddressRange wanted, TimePoint now);
    TimePoint replyTime(TimePoint now);
    ArtPollReplyBytes packOne(std::optional<std::uint16_t> portAddress, std::size_t index,
                              Ipv4Address ownAddress);

    ArtNetNodeConfig config_;
    SequenceTable sequences_;
    std::vector<PendingReply> pending_;
    std::mt19937 random_;
    std::uint32_t replyCount_ = 0;
    ReceiverCounters counters_;
};

}  // namespace hazer::protocol
