#include "protocol/recording/udp_extractor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "protocol/recording/link_layer.h"
#include "tests/protocol/recording/capture_builder.h"

namespace hazer::protocol::test {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAreArray;

constexpr std::chrono::nanoseconds kNow = 1h;

Bytes counting(std::size_t size) {
    Bytes bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return bytes;
}

std::optional<Bytes> payloadOf(UdpExtractor& extractor, const Bytes& packet,
                               std::chrono::nanoseconds now = kNow) {
    const auto datagram = extractor.take(packet, now);
    if (!datagram) return std::nullopt;
    return Bytes(datagram->bytes.begin(), datagram->bytes.end());
}

TEST(UdpExtractor, ReadsIpv4) {
    UdpExtractor extractor;
    const Bytes packet =
        ipv4Packet({.lastByteOfSource = 5, .sourcePort = 1000, .port = 5568, .payload = {1, 2}});
    const auto datagram = extractor.take(packet, kNow);
    ASSERT_TRUE(datagram);
    EXPECT_EQ(datagram->from, (IpEndpoint{{10, 0, 0, 5}, false, 1000}));
    EXPECT_EQ(datagram->to, (IpEndpoint{{10, 0, 0, 99}, false, 5568}));
    EXPECT_THAT(datagram->bytes, ElementsAreArray({1, 2}));
    EXPECT_FALSE(datagram->isCut);
}

TEST(UdpExtractor, ReadsIpv6BehindExtensionHeaders) {
    UdpExtractor extractor;
    const Bytes plain = ipv6Packet({.lastByteOfSource = 5, .payload = {1, 2, 3}});
    const auto datagram = extractor.take(plain, kNow);
    ASSERT_TRUE(datagram);
    EXPECT_TRUE(datagram->from.isIpv6);
    EXPECT_EQ(datagram->from.address[15], 5);
    EXPECT_EQ(datagram->from.port, 6454);
    EXPECT_THAT(datagram->bytes, ElementsAreArray({1, 2, 3}));

    Bytes withOptions = plain;
    withOptions[6] = 0;  // hop by hop first
    withOptions[5] = static_cast<std::uint8_t>(withOptions[5] + 16);
    const Bytes options = {17, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    withOptions.insert(withOptions.begin() + 40, options.begin(), options.end());
    EXPECT_EQ(payloadOf(extractor, withOptions), (Bytes{1, 2, 3}));
}

TEST(UdpExtractor, LeavesPaddingOfEthernetOut) {
    UdpExtractor extractor;
    const Bytes padded = joined({ipv4Packet({.payload = {1, 2}}), Bytes(30, 0xEE)});
    EXPECT_EQ(payloadOf(extractor, padded), (Bytes{1, 2}));
}

TEST(UdpExtractor, SaysWhenTheCaptureCutADatagram) {
    UdpExtractor extractor;
    const Bytes whole = ipv4Packet({.payload = counting(100)});
    const Bytes cut = prefixOf(whole, 60);
    const auto datagram = extractor.take(cut, kNow);
    ASSERT_TRUE(datagram);
    EXPECT_TRUE(datagram->isCut);
}

TEST(UdpExtractor, JoinsFragmentsInAnyOrder) {
    for (const bool isIpv6 : {false, true}) {
        const UdpFields fields{.payload = counting(1144)};
        std::vector<Bytes> fragments = isIpv6 ? ipv6Fragments(fields, 256) : ipv4Fragments(fields, 256);
        ASSERT_EQ(fragments.size(), 5u);
        std::mt19937 random(1);
        for (int round = 0; round < 20; ++round) {
            std::ranges::shuffle(fragments, random);
            UdpExtractor extractor;
            for (std::size_t i = 0; i + 1 < fragments.size(); ++i) {
                EXPECT_EQ(payloadOf(extractor, fragments[i]), std::nullopt);
                EXPECT_EQ(payloadOf(extractor, fragments[i]), std::nullopt);  // captured twice
            }
            EXPECT_EQ(payloadOf(extractor, fragments.back()), fields.payload);
            EXPECT_EQ(extractor.waitingCount(), 0u);
            EXPECT_EQ(extractor.lostCount(), 0u);
        }
    }
}

TEST(UdpExtractor, KeepsFragmentsOfSeveralSendersApart) {
    UdpExtractor extractor;
    const auto a = ipv4Fragments({.lastByteOfSource = 1, .payload = counting(40)}, 24);
    const auto b = ipv4Fragments({.lastByteOfSource = 2, .payload = Bytes(40, 7)}, 24);
    const auto c = ipv4Fragments({.lastByteOfSource = 1, .payload = Bytes(40, 9)}, 24, 8);
    for (const auto* fragments : {&a, &b, &c}) EXPECT_EQ(payloadOf(extractor, (*fragments)[0]), std::nullopt);
    EXPECT_EQ(payloadOf(extractor, c[1]), Bytes(40, 9));
    EXPECT_EQ(payloadOf(extractor, a[1]), counting(40));
    EXPECT_EQ(payloadOf(extractor, b[1]), Bytes(40, 7));
}

TEST(UdpExtractor, GivesUpFragmentsThatOverlapDifferently) {
    UdpExtractor extractor;
    const auto fragments = ipv4Fragments({.payload = counting(100)}, 48);
    Bytes other = fragments[0];
    other.back() ^= 1;
    EXPECT_EQ(payloadOf(extractor, fragments[0]), std::nullopt);
    EXPECT_EQ(payloadOf(extractor, other), std::nullopt);
    EXPECT_EQ(extractor.lostCount(), 1u);
    EXPECT_EQ(extractor.waitingCount(), 0u);
}

TEST(UdpExtractor, GivesUpWhatWaitsTooLong) {
    UdpExtractor extractor;
    const auto fragments = ipv4Fragments({.payload = counting(100)}, 48);
    payloadOf(extractor, fragments[0]);
    payloadOf(extractor, fragments[1], kNow + UdpExtractor::kMaxWait);
    EXPECT_EQ(extractor.waitingCount(), 1u);
    payloadOf(extractor, ipv4Packet({}), kNow + UdpExtractor::kMaxWait + 1ns);
    EXPECT_EQ(extractor.waitingCount(), 0u);
    EXPECT_EQ(extractor.lostCount(), 1u);
}

TEST(UdpExtractor, FloodOfFirstFragmentsIsBounded) {
    UdpExtractor extractor;
    for (std::uint16_t id = 0; id < 1000; ++id) {
        payloadOf(extractor, ipv4Fragments({.payload = counting(100)}, 48, id)[0]);
    }
    EXPECT_EQ(extractor.waitingCount(), UdpExtractor::kMaxWaiting);
    EXPECT_EQ(extractor.lostCount(), 1000 - UdpExtractor::kMaxWaiting);
}

TEST(UdpExtractor, FragmentsBeyond64KiBAreRefused) {
    UdpExtractor extractor;
    Bytes fragment = ipv4Fragments({.payload = counting(100)}, 48)[1];
    fragment[6] = 0x1F;  // offset 65528, with 48 bytes
    fragment[7] = 0xFF;
    EXPECT_EQ(payloadOf(extractor, fragment), std::nullopt);
    EXPECT_EQ(extractor.waitingCount(), 0u);
}

TEST(UdpExtractor, LosesNoWordOverOtherTraffic) {
    UdpExtractor extractor;
    payloadOf(extractor, ipv4Fragments({.port = 53, .payload = counting(100)}, 48)[0]);
    payloadOf(extractor, ipv4Packet({}), kNow + 1h);
    EXPECT_EQ(extractor.lostCount(), 0u);
    Bytes tcp = ipv4Packet({});
    tcp[9] = 6;
    EXPECT_EQ(payloadOf(extractor, tcp), std::nullopt);
}

TEST(UdpExtractor, CopiesGoOnAlone) {
    const auto fragments = ipv4Fragments({.payload = counting(100)}, 64);
    UdpExtractor extractor;
    payloadOf(extractor, fragments[0]);
    UdpExtractor copy = extractor;
    EXPECT_EQ(payloadOf(extractor, fragments[1]), counting(100));
    EXPECT_EQ(payloadOf(copy, fragments[1]), counting(100));
}

// Whatever is cut off, nothing is read beyond, and what comes out is a beginning of the truth.
TEST(UdpExtractor, TakesEveryTruncatedPrefix) {
    const Bytes payload = counting(20);
    for (const Bytes& whole : {ipv4Packet({.payload = payload}), ipv6Packet({.payload = payload}),
                               ipv6Fragments({.payload = payload}, 32)[0]}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            UdpExtractor extractor;
            const Bytes prefix = prefixOf(whole, size);
            const auto datagram = extractor.take(prefix, kNow);
            if (!datagram) continue;
            EXPECT_TRUE(datagram->isCut);
            EXPECT_TRUE(std::equal(datagram->bytes.begin(), datagram->bytes.end(), payload.begin()));
        }
    }
}

std::optional<Bytes> ipIn(int linkType, const Bytes& frame) {
    const auto ip = ipPacketOf(linkType, frame);
    if (!ip) return std::nullopt;
    return Bytes(ip->begin(), ip->end());
}

TEST(LinkLayer, FindsTheIpPacketInEveryKindOfFrame) {
    const Bytes ip = ipv4Packet({});
    const Bytes tag = {0x81, 0x00, 0x00, 0x05};
    const Bytes outerTag = {0x88, 0xA8, 0x00, 0x07};
    const Bytes ethertype = {0x08, 0x00};
    EXPECT_EQ(ipIn(1, ethernetFrame(ip)), ip);
    EXPECT_EQ(ipIn(1, ethernetFrame(ipv6Packet({}))), ipv6Packet({}));
    EXPECT_EQ(ipIn(1, joined({Bytes(12), tag, ethertype, ip})), ip);
    EXPECT_EQ(ipIn(1, joined({Bytes(12), outerTag, tag, ethertype, ip})), ip);
    EXPECT_EQ(ipIn(113, joined({Bytes(14), ethertype, ip})), ip);
    EXPECT_EQ(ipIn(113, joined({Bytes(14), tag, ethertype, ip})), ip);
    EXPECT_EQ(ipIn(276, joined({ethertype, Bytes(18), ip})), ip);
    EXPECT_EQ(ipIn(0, joined({{2, 0, 0, 0}, ip})), ip);
    EXPECT_EQ(ipIn(108, joined({{0, 0, 0, 2}, ip})), ip);
    for (const int raw : {12, 14, 101, 228, 229}) EXPECT_EQ(ipIn(raw, ip), ip);
}

TEST(LinkLayer, PassesOverWhatIsNoIp) {
    EXPECT_EQ(ipIn(1, joined({Bytes(12), {0x08, 0x06}, Bytes(28)})), std::nullopt);       // ARP
    EXPECT_EQ(ipIn(1, joined({Bytes(12), Bytes{0x00, 0x40}, Bytes(64)})), std::nullopt);  // 802.3 length
    EXPECT_EQ(ipIn(220, Bytes(64)), std::nullopt);
    EXPECT_FALSE(isKnownLinkType(220));
}

TEST(LinkLayer, EndlessVlanTagsEnd) {
    Bytes frame(12);
    for (int i = 0; i < 100; ++i) frame = joined({frame, {0x81, 0x00, 0x00, 0x05}});
    EXPECT_EQ(ipIn(1, joined({frame, {0x08, 0x00}, ipv4Packet({})})), std::nullopt);
}

TEST(LinkLayer, TakesEveryTruncatedPrefix) {
    const Bytes frame = joined({Bytes(12), {0x81, 0x00, 0, 5, 0x08, 0x00}, ipv4Packet({})});
    for (const int linkType : {0, 1, 12, 101, 108, 113, 228, 276}) {
        for (std::size_t size = 0; size < frame.size(); ++size) {
            const Bytes prefix = prefixOf(frame, size);
            const auto ip = ipPacketOf(linkType, prefix);
            EXPECT_TRUE(!ip || ip->size() <= size);
        }
    }
}

}  // namespace
}  // namespace hazer::protocol::test
