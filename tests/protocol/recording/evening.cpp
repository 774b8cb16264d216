#include "tests/protocol/recording/evening.h"

#include <fstream>
#include <random>

#include "protocol/recording/pcap_format.h"
#include "tests/protocol/sacn_packets.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;

class Evening {
 public:
    explicit Evening(std::uint32_t seed) : random_(seed) {}

    EveningPacket next() {
        time_ += gap();
        EveningPacket packet{time_, {}, {}, {}};
        const int desk = pick(1, 4);
        packet.from.address = {10, 0, 0, static_cast<std::uint8_t>(desk)};
        packet.to.address = {10, 0, 0, 99};
        if (pick(0, 1) == 0) {
            packet.from.port = packet.to.port = 6454;
            packet.bytes = artNet(desk);
        } else {
            packet.from.port = 50000;
            packet.to.port = 5568;
            packet.bytes = sacn(desk);
        }
        return packet;
    }

 private:
    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }

    std::chrono::nanoseconds gap() {
        switch (pick(0, 400)) {
            case 0:
                return std::chrono::milliseconds(pick(1000, 12000));  // silence in which sources are lost
            case 1:
            case 2:
                return std::chrono::milliseconds(pick(100, 2600));
            case 3:
            case 4:
            case 5:
                return 0ns;
            default:
                return std::chrono::microseconds(pick(1, 8000));
        }
    }

    Bytes slots() {
        Bytes values(static_cast<std::size_t>(pick(1, 24)));
        for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(pick(0, 255));
        return values;
    }

    std::uint8_t sequence(int desk) {
        if (pick(0, 30) == 0) return static_cast<std::uint8_t>(pick(0, 255));
        return ++sequences_[static_cast<std::size_t>(desk)];
    }

    Bytes artNet(int desk) {
        if (pick(0, 20) == 0) return pollDatagram();
        if (pick(0, 20) == 0) {
            Bytes sync = pollDatagram();
            sync[9] = 0x52;  // ArtSync
            return sync;
        }
        Bytes bytes = dmxDatagram({.sequence = sequence(desk),
                                   .physical = static_cast<std::uint8_t>(pick(0, 1)),
                                   .subUni = static_cast<std::uint8_t>(pick(0, 5)),
                                   .slots = slots()});
        return damaged(bytes);
    }

    Bytes sacn(int desk) {
        const auto syncAddress = static_cast<std::uint16_t>(pick(0, 3) == 0 ? 7000 + pick(0, 1) : 0);
        if (pick(0, 10) == 0) {
            return sacnSync(static_cast<std::uint16_t>(7000 + pick(0, 1)), sequence(desk),
                            static_cast<std::uint8_t>(desk));
        }
        if (pick(0, 100) == 0) return sacnDiscovery({.cid = static_cast<std::uint8_t>(desk)});
        const int special = pick(0, 60);
        Bytes bytes = sacnData({.cid = static_cast<std::uint8_t>(desk),
                                .priority = static_cast<std::uint8_t>(100 + 10 * pick(0, 2)),
                                .syncAddress = syncAddress,
                                .sequence = sequence(desk),
                                .options = static_cast<std::uint8_t>(special == 0   ? 0x40
                                                                     : special == 1 ? 0x80
                                                                                    : 0),
                                .universe = static_cast<std::uint16_t>(pick(1, 5)),
                                .startCode = static_cast<std::uint8_t>(special < 8 ? 0xDD : 0),
                                .slots = slots()});
        return damaged(bytes);
    }

    Bytes damaged(Bytes bytes) {
        if (pick(0, 60) == 0) bytes.resize(static_cast<std::size_t>(pick(0, static_cast<int>(bytes.size()))));
        return bytes;
    }

    std::mt19937 random_;
    RecordingTime time_{};
    std::array<std::uint8_t, 5> sequences_{};
};

}  // namespace

std::vector<EveningPacket> makeEvening(std::uint32_t seed, std::size_t count) {
    Evening evening(seed);
    std::vector<EveningPacket> packets;
    for (std::size_t i = 0; i < count; ++i) packets.push_back(evening.next());
    packets.front().time = RecordingTime(0);
    return packets;
}

void writeCapture(const std::filesystem::path& file, const std::vector<EveningPacket>& packets) {
    std::vector<std::uint8_t> bytes = packPcapFileHeader();
    for (const EveningPacket& packet : packets) {
        appendPcapRecord(bytes,
                         {packet.from, packet.to, WallTime(1'700'000'000s + packet.time), packet.bytes});
    }
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace hazer::protocol::test
