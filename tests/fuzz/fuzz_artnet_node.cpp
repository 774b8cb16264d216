// Any bytes as an evening of Art-Net: datagrams of several senders at several times, through a node and a
// merger that remember.
//
// A record is: sender (1 byte), milliseconds in steps of 16 (1 byte), length (2 bytes, high first), datagram.
#include <algorithm>
#include <cstdlib>

#include "protocol/artnet_node.h"
#include "protocol/byte_reader.h"

namespace {

using namespace hazer::protocol;

void require(bool condition) {
    if (!condition) std::abort();
}

std::uint64_t total(const ReceiverCounters& c) {
    return c.dmx + c.late + c.refused + c.polls + c.syncs + c.control + c.ignored + c.malformed;
}

class Evening {
 public:
    void play(std::span<const std::uint8_t> records) {
        ByteReader reader(records);
        while (reader.remaining() > 0) {
            const std::uint8_t sender = reader.u8();
            now_ += std::chrono::milliseconds(16 * reader.u8());
            const std::size_t size = reader.u16BigEndian();
            const auto datagram = reader.take(std::min(size, reader.remaining()));
            if (reader.failed()) break;
            node_.receive(datagram, {{10, 0, 0, sender}, kArtNetPort}, now_, merger_);
            ++count_;
            check();
        }
    }

 private:
    void check() {
        require(total(node_.counters()) == count_);
        node_.advance(now_, merger_);
        merger_.expire(now_);
        require(!merger_.nextDeadline() || *merger_.nextDeadline() > now_);
        UniverseSet set;
        merger_.latch(set, now_);
        require(set.size() <= 3 + merger_.rules().unaskedUniverses);
        for (const UniverseStatus& status : merger_.status(now_)) {
            require(status.sources.size() <= 2);
            require(status.universe.number <= kMaxPortAddress);
        }
        while (const auto reply = node_.takeDueReply(now_)) {
            require(node_.packReply(*reply, {10, 0, 0, 9}).size() <= 3);
        }
    }

    UniverseMerger merger_{MergeRules{.unaskedUniverses = 4}};
    ArtNetNode node_{{.portAddresses = {0, 1, kMaxPortAddress}, .isProgrammable = true}};
    TimePoint now_{std::chrono::hours(1)};
    std::uint64_t count_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Evening().play({data, size});
    return 0;
}
