#include <gmock/gmock.h>

#include "protocol/usb/ftdi_setup.h"
#include "protocol/usb/ftdi_widget.h"
#include "protocol/usb/nodle_widget.h"
#include "tests/protocol/packets.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using testing::ElementsAre;
using testing::IsEmpty;

const TimePoint kStart{std::chrono::hours(1)};

/// A widget, the frames that it showed, and its time.
template <class Widget>
struct Bench {
    Widget widget;
    TimePoint now = kStart;
    std::vector<Bytes> shown{};

    void receive(const Bytes& transfer) {
        widget.receive(transfer, now, [&](std::span<const std::uint8_t> slots) {
            shown.emplace_back(slots.begin(), slots.end());
        });
    }

    Bytes request() { return widget.takeRequest(now); }

    Bytes requestAfter(std::chrono::milliseconds wait) {
        now += wait;
        return request();
    }
};

struct FtdiBench : Bench<FtdiWidget> {
    FtdiBench() : Bench{FtdiWidget(64, kStart)} {}

    void packet(std::uint8_t lineStatus, const Bytes& payload) {
        Bytes transfer{0x01, lineStatus};
        transfer.insert(transfer.end(), payload.begin(), payload.end());
        receive(transfer);
    }

    void message(EnttecLabel label, const Bytes& data) {
        const Bytes bytes = packEnttec(label, data);
        for (std::size_t at = 0; at < bytes.size(); at += 62) {
            packet(0x60, Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                               bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at + 62, bytes.size()))));
        }
    }
};

TEST(FtdiWidget, ListensBeforeItAsks) {
    FtdiBench bench;
    EXPECT_THAT(bench.request(), IsEmpty());
    EXPECT_THAT(bench.requestAfter(149ms), IsEmpty());
    EXPECT_EQ(bench.requestAfter(1ms), (Bytes{0x7E, 10, 0, 0, 0xE7}));
    EXPECT_THAT(bench.request(), IsEmpty());
}

TEST(FtdiWidget, WhoAnswersIsAProAndIsAskedForMore) {
    FtdiBench bench;
    bench.requestAfter(150ms);
    bench.message(EnttecLabel::kSerialNumber, {0x67, 0x45, 0x23, 0x01});
    EXPECT_EQ(bench.request()[1], 10);
    bench.message(EnttecLabel::kSerialNumber, {0x67, 0x45, 0x23, 0x01});
    EXPECT_EQ(bench.request(), (Bytes{0x7E, 3, 2, 0, 0, 0, 0xE7}));
    bench.message(EnttecLabel::kParameters, {44, 1, 9, 1, 40});
    EXPECT_EQ(bench.request()[1], 77);
    EXPECT_THAT(bench.request(), IsEmpty()) << "an older Pro does not answer";
    EXPECT_EQ(bench.requestAfter(400ms)[1], 78);
    EXPECT_EQ(bench.requestAfter(400ms), (Bytes{0x7E, 8, 1, 0, 0, 0xE7}));
    EXPECT_THAT(bench.request(), IsEmpty());
    EXPECT_FALSE(bench.widget.nextDeadline());
    const UsbWidgetFacts facts = bench.widget.facts();
    EXPECT_EQ(facts.kind, "DMX USB Pro");
    EXPECT_EQ(facts.serial, "01234567");
    EXPECT_EQ(facts.firmware, "1.44");
}

TEST(FtdiWidget, AProThatSendsAlreadyIsHeardAtOnce) {
    FtdiBench bench;
    bench.message(EnttecLabel::kReceivedDmx, {0, 0, 1, 2, 3});
    EXPECT_EQ(bench.shown, std::vector<Bytes>({{1, 2, 3}}));
    EXPECT_EQ(bench.request()[1], 10) << "no need to wait";
    EXPECT_EQ(bench.widget.facts().kind, "DMX USB Pro");
}

TEST(FtdiWidget, TheNameIsWhatTheInterfaceCallsItself) {
    FtdiBench bench;
    bench.message(EnttecLabel::kManufacturer, {0x6B, 0x6A, 'D', 'M', 'X', 'k', 'i', 'n', 'g'});
    EXPECT_EQ(bench.widget.facts().name, "DMXking");
    bench.message(EnttecLabel::kDeviceName, {2, 0, 'u', 'l', 't', 'r', 'a'});
    EXPECT_EQ(bench.widget.facts().name, "DMXking ultra");
}

TEST(FtdiWidget, FramesWithLostBytesAndOtherStartCodesShowNothing) {
    FtdiBench bench;
    bench.message(EnttecLabel::kReceivedDmx, {1, 0, 1});
    bench.message(EnttecLabel::kReceivedDmx, {2, 0, 1});
    bench.message(EnttecLabel::kReceivedDmx, {0, 0xCC, 1});
    bench.message(EnttecLabel::kReceivedDmx, Bytes(515));
    bench.message(EnttecLabel::kReceivedDmx, {0});
    EXPECT_THAT(bench.shown, IsEmpty());
    const UsbWidgetFacts facts = bench.widget.facts();
    EXPECT_EQ(facts.lostFrames, 2U);
    EXPECT_EQ(facts.otherCodes, 1U);
    EXPECT_EQ(facts.malformed, 2U);
}

TEST(FtdiWidget, ChangesCountOnceTheFrameBeforeThemIsKnown) {
    const Bytes change{0, 0x04, 0, 0, 0, 0, 50};
    FtdiBench bench;
    bench.message(EnttecLabel::kChangeOfState, change);
    EXPECT_THAT(bench.shown, IsEmpty()) << "another program had asked for changes";
    bench.message(EnttecLabel::kReceivedDmx, {0, 0, 1, 2, 3});
    bench.message(EnttecLabel::kChangeOfState, change);
    ASSERT_EQ(bench.shown.size(), 2U);
    EXPECT_EQ(test::prefixOf(bench.shown[1], 4), (Bytes{1, 50, 3, 0}));
}

TEST(FtdiWidget, ABreakTellsABarePortWhichIsNeverWrittenTo) {
    FtdiBench bench;
    bench.packet(0x70, {0});
    for (int i = 0; i < 3; ++i) bench.packet(i == 0 ? 0x60 : 0x70, {0, 10, 20, 0});
    EXPECT_EQ(bench.widget.facts().kind, "Open DMX");
    EXPECT_FALSE(bench.widget.nextDeadline());
    EXPECT_THAT(bench.requestAfter(1h), IsEmpty());
}

TEST(FtdiWidget, WhereNobodyAnswersItWaitsForBreaks) {
    FtdiBench bench;
    EXPECT_EQ(bench.requestAfter(150ms)[1], 10);
    EXPECT_EQ(bench.requestAfter(400ms)[1], 10);
    EXPECT_THAT(bench.requestAfter(400ms), IsEmpty());
    EXPECT_EQ(bench.widget.facts().kind, "Open DMX");
    bench.packet(0x70, {0});
    for (int i = 0; i < 2; ++i) {
        bench.packet(0x60, {0, 10, 20});
        bench.packet(0x70, {0});
    }
    EXPECT_EQ(bench.shown, std::vector<Bytes>({{10, 20}}));
    EXPECT_EQ(bench.widget.facts().frames, 1U);
}

TEST(FtdiWidget, AProThatWokeUpLateIsAProAllTheSame) {
    FtdiBench bench;
    for (int i = 0; i < 3; ++i) bench.requestAfter(400ms);
    bench.message(EnttecLabel::kReceivedDmx, {0, 0, 4});
    EXPECT_EQ(bench.shown, std::vector<Bytes>({{4}}));
    EXPECT_EQ(bench.widget.facts().kind, "DMX USB Pro");
    EXPECT_EQ(bench.request()[1], 10);
}

TEST(FtdiWidget, BytesThatLookLikeMessagesAreSlotsOnABarePort) {
    FtdiBench bench;
    const Bytes frame{0, 0x7E, 5, 3, 0, 0, 0, 9, 0xE7};
    bench.packet(0x70, {0});
    for (int i = 0; i < 3; ++i) {
        bench.packet(0x60, {0, 1, 2, 3, 4, 5, 6, 7, 8});
        bench.packet(0x70, {0});
    }
    bench.packet(0x60, frame);
    bench.packet(0x70, {0});
    EXPECT_EQ(bench.widget.facts().kind, "Open DMX");
    EXPECT_EQ(bench.shown.back(), Bytes(frame.begin() + 1, frame.end()));
}

TEST(FtdiWidget, AnInterruptionDropsTheMessageThatWasBegun) {
    FtdiBench bench;
    bench.packet(0x60, {0x7E, 5, 4, 0, 0, 0, 1});
    bench.widget.interrupt();
    bench.packet(0x60, {2, 0xE7});
    EXPECT_THAT(bench.shown, IsEmpty());
    bench.message(EnttecLabel::kReceivedDmx, {0, 0, 4});
    EXPECT_EQ(bench.shown.size(), 1U);
}

TEST(NodleWidget, AsksOnceForWhatItHears) {
    Bench<NodleWidget> bench{};
    const Bytes request = bench.request();
    ASSERT_EQ(request.size(), 33U);
    EXPECT_EQ(request[0], 16);
    EXPECT_EQ(request[1], 4);
    EXPECT_THAT(bench.request(), IsEmpty());
    EXPECT_FALSE(bench.widget.nextDeadline());
}

TEST(NodleWidget, BlocksMakeAUniverse) {
    Bench<NodleWidget> bench{};
    Bytes report(33, 7);
    report[0] = 0;
    bench.receive(report);
    report[0] = 15;
    report[32] = 8;
    bench.receive(report);
    ASSERT_EQ(bench.shown.size(), 2U);
    const Bytes& slots = bench.shown[1];
    ASSERT_EQ(slots.size(), 512U);
    EXPECT_EQ(slots[31], 7);
    EXPECT_EQ(slots[32], 0);
    EXPECT_EQ(slots[511], 8);
}

TEST(NodleWidget, OtherReportsAreCounted) {
    Bench<NodleWidget> bench{};
    const Bytes whole(33, 0);
    for (std::size_t size = 0; size < whole.size(); ++size) bench.receive(test::prefixOf(whole, size));
    bench.receive(Bytes(34, 0));
    bench.receive(Bytes(33, 16));
    bench.receive(Bytes(33, 255));
    EXPECT_THAT(bench.shown, IsEmpty());
    EXPECT_EQ(bench.widget.facts().malformed, 35U) << "an empty transfer is no report";
}

TEST(FtdiSetup, IsWhatLibftdiSendsFor250Kilobaud8N2) {
    EXPECT_THAT(
        ftdiSetup(0x0600, 0),
        ElementsAre(UsbControlRequest{0, 0, 1}, UsbControlRequest{2, 0, 1}, UsbControlRequest{3, 0x000C, 0},
                    UsbControlRequest{4, 0x1008, 1}, UsbControlRequest{1, 0x0200, 1},
                    UsbControlRequest{9, 1, 1}, UsbControlRequest{0, 2, 1}));
}

TEST(FtdiSetup, ChipsDifferInClockAndPort) {
    EXPECT_EQ(ftdiSetup(0x0700, 0)[2], (UsbControlRequest{3, 0x0030, 0x0201})) << "FT2232H";
    EXPECT_EQ(ftdiSetup(0x0800, 3)[2], (UsbControlRequest{3, 0x0030, 0x0204})) << "FT4232H, fourth port";
    EXPECT_EQ(ftdiSetup(0x0800, 3)[3], (UsbControlRequest{4, 0x1008, 4}));
    EXPECT_EQ(ftdiSetup(0x0900, 0)[2], (UsbControlRequest{3, 0x0030, 0x0201})) << "FT232H";
    EXPECT_EQ(ftdiSetup(0x0500, 1)[2], (UsbControlRequest{3, 0x000C, 2})) << "FT2232D, second port";
    EXPECT_EQ(ftdiSetup(0x1000, 0)[2], (UsbControlRequest{3, 0x000C, 0})) << "FT-X";
    EXPECT_EQ(ftdiPortCount(0x6001), 1);
    EXPECT_EQ(ftdiPortCount(0x6010), 2);
    EXPECT_EQ(ftdiPortCount(0x6011), 4);
}

}  // namespace
}  // namespace hazer::protocol
