// Packets a second, with time as an argument.
#include "app/window_packet_rates.h"

#include <gtest/gtest.h>

namespace hazer::app {
namespace {

using std::chrono::milliseconds;

protocol::UniverseSet universeWith(std::uint64_t packetCount) {
    protocol::UniverseSet universes;
    universes[{protocol::Transport::kArtNet, 3}].packetCount = packetCount;
    return universes;
}

TEST(WindowPacketRates, countsOverASecond) {
    const protocol::UniverseId id{protocol::Transport::kArtNet, 3};
    const protocol::TimePoint start{};
    WindowPacketRates rates;
    EXPECT_EQ(rates.packetsPerS(id), 0.0);
    rates.update(universeWith(1000), start);
    rates.update(universeWith(1030), start + milliseconds(700));
    EXPECT_EQ(rates.packetsPerS(id), 0.0);
    rates.update(universeWith(1055), start + milliseconds(1250));
    EXPECT_NEAR(rates.packetsPerS(id), 44.0, 1e-9);
    rates.update(universeWith(1055), start + milliseconds(2500));
    EXPECT_EQ(rates.packetsPerS(id), 0.0);
}

}  // namespace
}  // namespace hazer::app
