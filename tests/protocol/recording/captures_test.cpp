// What real desks sent, recorded on their networks, and the look that it leads to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/recording/recording_player.h"
#include "tests/protocol/recording/capture_builder.h"

namespace hazer::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

class Captures : public ::testing::Test {
 protected:
    void SetUp() override {
        if (test::capturesFolder().empty()) {
            GTEST_SKIP() << "no captures beside the source tree; set HAZER_SHARED_DATA";
        }
    }

    /// The universe as the whole capture leaves it.
    static UniverseStatus end(const char* file, UniverseId universe) {
        RecordingPlayer player(test::capturesFolder() / file, {}, {}, RecordingPlayer::Indexing::kNone);
        player.goToEnd();
        for (const UniverseStatus& one : player.status()) {
            if (one.universe == universe) return one;
        }
        ADD_FAILURE() << file << " has no such universe";
        return {};
    }

    static std::vector<int> slots(const UniverseStatus& status, std::size_t first, std::size_t count) {
        const auto begin = status.look.slots.begin() + static_cast<std::ptrdiff_t>(first - 1);
        return {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }
};

TEST_F(Captures, OlaEndsAUniverseAndItsLookIsHeld) {
    const UniverseStatus status = end("ola_e131_veth.pcapng", {Transport::kSacn, 1});
    EXPECT_THAT(slots(status, 1, 5), ElementsAre(3, 0, 255, 0, 0));
    EXPECT_TRUE(status.isLost);
    EXPECT_EQ(status.sources.at(0).name, "viz-loop");
    EXPECT_EQ(status.sources.at(0).address, "10.77.0.1");
    EXPECT_EQ(status.sources.at(0).lateCount, 0U);
    EXPECT_EQ(status.packetCount, 4U);
}

TEST_F(Captures, OlaFallsSilentAndItsLookIsHeld) {
    const UniverseStatus status = end("ola_e131_veth.pcapng", {Transport::kSacn, 2});
    EXPECT_THAT(slots(status, 1, 3), ElementsAre(2, 3, 4));
    EXPECT_EQ(status.look.slots[511], (2 + 511) % 256);
    EXPECT_TRUE(status.isLost);
}

TEST_F(Captures, QlcFadesOnBothProtocols) {
    const UniverseStatus artNet = end("qlc_lo.pcapng", {Transport::kArtNet, 3});
    EXPECT_THAT(slots(artNet, 1, 3), ElementsAre(112, 56, 3));
    const UniverseStatus sacn = end("qlc_lo.pcapng", {Transport::kSacn, 7});
    EXPECT_THAT(slots(sacn, 10, 2), ElementsAre(88, 44));
    EXPECT_EQ(sacn.packetCount, 11U);
    EXPECT_EQ(sacn.sources.at(0).priority, 120);
    EXPECT_THAT(sacn.sources.at(0).name, StartsWith("Q Light Controller Plus"));
    EXPECT_FALSE(sacn.isLost);
}

TEST_F(Captures, OlaCountsItsSequenceThroughZero) {
    const UniverseStatus status = end("ola_artnet_bcast.pcapng", {Transport::kArtNet, 1});
    EXPECT_THAT(slots(status, 1, 3), ElementsAre(39, 1, 0));
    EXPECT_EQ(status.packetCount, 300U);
}

}  // namespace
}  // namespace hazer::protocol
