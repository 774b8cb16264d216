// A made-up evening on a lighting network: every kind of packet, several desks, silences, garbage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "protocol/recording/recording.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol::test {

struct EveningPacket {
    RecordingTime time{};
    IpEndpoint from{};
    IpEndpoint to{};
    Bytes bytes;
};

/// `count` packets, the same for the same seed.
std::vector<EveningPacket> makeEvening(std::uint32_t seed, std::size_t count);

/// Writes packets as a capture.
void writeCapture(const std::filesystem::path& file, const std::vector<EveningPacket>& packets);

}  // namespace hazer::protocol::test
