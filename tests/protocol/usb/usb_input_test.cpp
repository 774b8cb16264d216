// The real libusb and a device that is not there: from the plug to the universe, and all that may go wrong
// between.
#include "protocol/usb/usb_input.h"

#include <gmock/gmock.h>
#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "protocol/usb/enttec_message.h"
#include "protocol/usb/ftdi_setup.h"
#include "tests/protocol/loopback.h"
#include "tests/protocol/usb/fake_usb.h"

namespace hazer::protocol {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::comesTrue;
using test::FakeUsbDescription;
using test::FakeUsbDevice;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Quicker than people plug, so that tests need not wait.
UsbConfig quickConfig() {
    UsbConfig config;
    config.lookEvery = 20ms;
    return config;
}

/// What an ENTTEC Pro replies to what it is asked.
Bytes proAnswer(const Bytes& request) {
    if (request.size() < 2) return {};
    switch (static_cast<EnttecLabel>(request[1])) {
        case EnttecLabel::kSerialNumber:
            return packEnttec(EnttecLabel::kSerialNumber, Bytes{0x56, 0x34, 0x12, 0x00});
        case EnttecLabel::kParameters:
            return packEnttec(EnttecLabel::kParameters, Bytes{44, 1, 9, 1, 40});
        default:
            return {};
    }
}

Bytes proFrame(const Bytes& slots) {
    Bytes data{0, 0};
    data.insert(data.end(), slots.begin(), slots.end());
    return packEnttec(EnttecLabel::kReceivedDmx, data);
}

void sendOpenFrame(FakeUsbDevice& device, const Bytes& slots) {
    Bytes frame{0};
    frame.insert(frame.end(), slots.begin(), slots.end());
    device.sendSerial(frame);
    device.sendSerial({0}, 0x70);
}

/// Even root may open only what its mode allows, on this thread and those that it starts.
class ObeysPermissions {
 public:
    ObeysPermissions() {
        syscall(SYS_capget, &header_, before_.data());
        auto without = before_;
        without[0].effective &= ~(1U << CAP_DAC_OVERRIDE | 1U << CAP_DAC_READ_SEARCH);
        syscall(SYS_capset, &header_, without.data());
    }
    ~ObeysPermissions() { syscall(SYS_capset, &header_, before_.data()); }
    ObeysPermissions(const ObeysPermissions&) = delete;
    ObeysPermissions& operator=(const ObeysPermissions&) = delete;

 private:
    __user_cap_header_struct header_{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> before_{};
};

class UsbInputTest : public testing::Test {
 protected:
    void SetUp() override {
        if (!test::FakeUsbBus::isPossible())
            GTEST_SKIP() << "needs libumockdev-preload.so; ctest loads it, and so does umockdev-wrapper";
        bus_ = std::make_unique<test::FakeUsbBus>();
    }

    void start(const UsbConfig& config = quickConfig()) {
        input_ = std::make_unique<UsbInput>(config, store_);
    }

    Universe universe(std::uint16_t number) {
        UniverseSet set;
        store_.latch(set, Clock::now());
        return set[{Transport::kDmx, number}];
    }

    bool shows(std::uint16_t number, std::uint8_t firstSlot) {
        return comesTrue([&] { return universe(number).slots[0] == firstSlot; });
    }

    std::vector<UsbLineStatus> devices() { return input_->devices(); }

    bool becomes(UsbState state) {
        return comesTrue([&] { return devices().size() == 1 && devices()[0].state == state; });
    }

    std::string problem() {
        becomes(UsbState::kFailed);
        return devices().empty() ? "no device" : devices()[0].problem;
    }

    std::unique_ptr<test::FakeUsbBus> bus_;
    UniverseStore store_;
    std::unique_ptr<UsbInput> input_;
};

TEST_F(UsbInputTest, AProIsSetUpAndItsFramesStandInUniverse1) {
    FakeUsbDevice pro(*bus_, {});
    pro.answerWith(proAnswer);
    start();
    pro.sendSerial(proFrame({11, 22, 33}));
    ASSERT_TRUE(shows(1, 11));
    EXPECT_EQ(universe(1).slots[2], 33);
    EXPECT_EQ(universe(1).slotCount, 3);
    EXPECT_EQ(pro.controlRequests(), ftdiSetup(0x0600, 0));
    ASSERT_TRUE(comesTrue([&] { return pro.written().size() == 5; }));
    EXPECT_EQ(pro.written().back(), (Bytes{0x7E, 8, 1, 0, 0, 0xE7})) << "receive every frame";
    ASSERT_TRUE(comesTrue([&] { return devices().at(0).facts.firmware == "1.44"; }));
    const UsbLineStatus status = devices()[0];
    EXPECT_EQ(status.key, "EN123456");
    EXPECT_EQ(status.name, "ENTTEC DMX USB PRO");
    EXPECT_EQ(status.socket, "1-1");
    EXPECT_EQ(status.universe, (UniverseId{Transport::kDmx, 1}));
    EXPECT_EQ(status.facts.kind, "DMX USB Pro");
    EXPECT_EQ(status.facts.serial, "00123456");
    EXPECT_EQ(status.facts.frames, 1U);
    EXPECT_EQ(status.problem, "");
    const auto universes = store_.status(Clock::now());
    ASSERT_EQ(universes.size(), 1U);
    ASSERT_EQ(universes[0].sources.size(), 1U);
    EXPECT_EQ(universes[0].sources[0].name, "ENTTEC DMX USB PRO");
    EXPECT_EQ(universes[0].sources[0].address, "USB 1-1, EN123456");
}

TEST_F(UsbInputTest, AnOpenInterfaceIsHeardByItsBreaks) {
    FakeUsbDevice open(*bus_, {.manufacturer = "FTDI", .name = "FT232R USB UART", .serial = "A1"});
    start();
    open.sendSerial({0}, 0x70);
    for (int i = 0; i < 3; ++i) sendOpenFrame(open, Bytes(512, 77));
    ASSERT_TRUE(shows(1, 77));
    EXPECT_EQ(universe(1).slots[511], 77);
    ASSERT_TRUE(becomes(UsbState::kReceiving));
    ASSERT_TRUE(comesTrue([&] { return devices().at(0).facts.frames == 2; }));
    EXPECT_EQ(devices()[0].facts.kind, "Open DMX");
    EXPECT_TRUE(open.written().empty()) << "what is written might go out onto the DMX line";
}

TEST_F(UsbInputTest, StreamsMayBeCutAnywhere) {
    FakeUsbDevice pro(*bus_, {});
    start();
    const Bytes example = proFrame({1, 0x7E, 0xE7, 5});
    for (std::size_t cut = 0; cut <= example.size(); ++cut) {
        const Bytes message = proFrame({static_cast<std::uint8_t>(100 + cut), 0x7E, 0xE7, 5});
        const auto middle = message.begin() + static_cast<std::ptrdiff_t>(cut);
        pro.sendSerial(Bytes(message.begin(), middle));
        pro.sendPacket({0x01, 0x60});
        pro.sendSerial(Bytes(middle, message.end()));
        ASSERT_TRUE(shows(1, static_cast<std::uint8_t>(100 + cut))) << "cut at " << cut;
    }
    EXPECT_TRUE(comesTrue([&] { return devices().at(0).facts.frames == example.size() + 1; }));
    EXPECT_EQ(devices()[0].facts.malformed, 0U);
}

TEST_F(UsbInputTest, TwoInterfacesAtOnceHaveAUniverseEach) {
    FakeUsbDevice first(*bus_, {});
    FakeUsbDevice second(*bus_, {.port = "1-2", .device = 3, .serial = "EN777777"});
    start();
    for (std::uint8_t i = 1; i <= 50; ++i) {
        first.sendSerial(proFrame({i, 1}));
        second.sendSerial(proFrame({static_cast<std::uint8_t>(i + 100), 2}));
    }
    EXPECT_TRUE(shows(1, 50));
    EXPECT_TRUE(shows(2, 150));
    ASSERT_EQ(devices().size(), 2U);
    ASSERT_TRUE(
        comesTrue([&] { return devices()[0].facts.frames == 50 && devices()[1].facts.frames == 50; }));
    EXPECT_EQ(devices()[1].key, "EN777777");
}

TEST_F(UsbInputTest, InterfacesWithTheSameSerialNumberAreToldApart) {
    FakeUsbDevice first(*bus_, {.serial = "0"});
    FakeUsbDevice second(*bus_, {.port = "1-2", .device = 3, .serial = "0"});
    start();
    ASSERT_TRUE(comesTrue([&] { return devices().size() == 2; }));
    EXPECT_EQ(devices()[0].key, "0");
    EXPECT_EQ(devices()[1].key, "0@1-2");
    EXPECT_NE(devices()[0].universe, devices()[1].universe);
}

TEST_F(UsbInputTest, AShowBindsSerialNumbersToUniverses) {
    FakeUsbDevice first(*bus_, {});
    FakeUsbDevice second(*bus_, {.port = "1-2", .device = 3, .serial = "EN777777"});
    UsbConfig config = quickConfig();
    config.bindings = {{"EN777777", 40}};
    config.others = UsbOthers::kNone;
    start(config);
    first.sendSerial(proFrame({1}));
    second.sendSerial(proFrame({2}));
    EXPECT_TRUE(shows(40, 2));
    EXPECT_EQ(devices().size(), 1U);
    EXPECT_TRUE(first.hasKernelDriver()) << "it is nobody's business";
}

TEST_F(UsbInputTest, ABareChipIsLeftAloneUnlessAskedFor) {
    FakeUsbDevice modem(*bus_, {.manufacturer = "FTDI", .name = "FT232R USB UART", .serial = "A1"});
    UsbConfig config = quickConfig();
    config.others = UsbOthers::kThoseThatNameDmx;
    start(config);
    std::this_thread::sleep_for(5 * config.lookEvery);
    EXPECT_TRUE(devices().empty());
    EXPECT_TRUE(modem.hasKernelDriver());
    EXPECT_FALSE(input_->usesLibusb());
}

TEST_F(UsbInputTest, WithoutADeviceThereIsNoLibusbAndOnePluggedInLaterIsHeard) {
    start();
    std::this_thread::sleep_for(100ms);
    EXPECT_FALSE(input_->usesLibusb());
    FakeUsbDevice pro(*bus_, {});
    pro.sendSerial(proFrame({9}));
    EXPECT_TRUE(shows(1, 9));
    EXPECT_TRUE(input_->usesLibusb());
    FakeUsbDevice second(*bus_, {.port = "1-2", .device = 3, .serial = "EN777777"});
    second.sendSerial(proFrame({8}));
    EXPECT_TRUE(shows(2, 8));
}

TEST_F(UsbInputTest, UnpluggedInTheMiddleOfAMessageAndPluggedInAgainItKeepsItsUniverse) {
    FakeUsbDevice other(*bus_, {.port = "1-4", .device = 9, .serial = "EN1"});
    auto pro = std::make_unique<FakeUsbDevice>(*bus_, FakeUsbDescription{});
    start();
    pro->sendSerial(proFrame({5}));
    ASSERT_TRUE(shows(1, 5));
    const Bytes message = proFrame(Bytes(50, 6));
    pro->sendSerial(test::prefixOf(message, 30));
    ASSERT_TRUE(comesTrue([&] { return pro->hasSentAll(); }));
    pro.reset();
    ASSERT_TRUE(comesTrue([&] { return devices().size() == 1; }));
    EXPECT_TRUE(universe(1).isLost) << "at once, not after a second";
    EXPECT_EQ(universe(1).slots[0], 5) << "the last look stands";
    other.sendSerial(proFrame({7}));
    EXPECT_TRUE(shows(2, 7)) << "the other one goes on";

    FakeUsbDevice again(*bus_, {.port = "1-3", .device = 4});
    again.sendSerial(Bytes(message.begin() + 30, message.end()));
    again.sendSerial(proFrame({8}));
    EXPECT_TRUE(shows(1, 8));
    EXPECT_EQ(universe(1).slotCount, 1) << "the halves of two messages are none";
}

TEST_F(UsbInputTest, TheKernelsDriverGetsTheInterfaceBack) {
    FakeUsbDevice pro(*bus_, {});
    start();
    ASSERT_TRUE(comesTrue([&] { return pro.isClaimed(); }));
    EXPECT_FALSE(pro.hasKernelDriver());
    input_.reset();
    EXPECT_FALSE(pro.isClaimed());
    EXPECT_TRUE(pro.hasKernelDriver());
}

TEST_F(UsbInputTest, ASecondRunHearsWhatTheFirstOneDid) {
    FakeUsbDevice pro(*bus_, {});
    for (std::uint8_t run = 1; run <= 3; ++run) {
        start();
        pro.sendSerial(proFrame({run}));
        EXPECT_TRUE(shows(1, run));
        input_.reset();
    }
}

TEST_F(UsbInputTest, WithoutPermissionOneSentenceNamesTheRuleAndItIsTriedAgain) {
    FakeUsbDevice pro(*bus_, {});
    const std::string node = bus_->rootFolder() + "/dev/bus/usb/001/002";
    ASSERT_EQ(chmod(node.c_str(), 0), 0);
    {
        const ObeysPermissions here;  // and the threads that begin here
        start();
    }
    const std::string message = problem();
    EXPECT_THAT(message, HasSubstr("ENTTEC DMX USB PRO (EN123456)"));
    EXPECT_THAT(message, HasSubstr("60-hazer-usb.rules"));
    EXPECT_THAT(message, Not(HasSubstr("LIBUSB"))) << message;
    ASSERT_EQ(chmod(node.c_str(), 0600), 0);
    pro.sendSerial(proFrame({4}));
    EXPECT_TRUE(shows(1, 4));
}

TEST_F(UsbInputTest, AnInterfaceThatAnotherProgramUsesIsTakenWhenItIsFree) {
    FakeUsbDevice pro(*bus_, {});
    pro.setBusy(true);
    start();
    EXPECT_THAT(problem(), HasSubstr("another program uses it"));
    pro.setBusy(false);
    pro.sendSerial(proFrame({4}));
    EXPECT_TRUE(shows(1, 4));
    EXPECT_TRUE(comesTrue([&] { return devices()[0].problem.empty(); }));
}

TEST_F(UsbInputTest, ADeviceThatDoesNotAnswerHoldsNobodyUp) {
    FakeUsbDevice mute(*bus_, {.port = "1-2", .device = 3, .serial = "EN777777"});
    mute.setMute(true);
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.sendSerial(proFrame({4}));
    EXPECT_TRUE(shows(1, 4));
    ASSERT_TRUE(comesTrue([&] { return devices().size() == 2 && !devices()[1].problem.empty(); }));
    EXPECT_THAT(devices()[1].problem, HasSubstr("does not answer"));
    const auto before = std::chrono::steady_clock::now();
    input_.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - before, 2s);
}

TEST_F(UsbInputTest, ADeviceThatFallsMuteIsReportedAndHeardAgain) {
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.sendSerial(proFrame({4}));
    ASSERT_TRUE(shows(1, 4));
    pro.setMute(true);
    EXPECT_THAT(problem(), HasSubstr("does not answer"));
    pro.setMute(false);
    pro.sendSerial(proFrame({5}));
    EXPECT_TRUE(shows(1, 5));
}

TEST_F(UsbInputTest, AChipThatReportsNothingInSilenceIsNotTakenForDead) {
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.sendSerial(proFrame({4}));
    ASSERT_TRUE(shows(1, 4));
    pro.setQuiet(true);
    const UsbControlRequest modemStatus{5, 0, 1};
    ASSERT_TRUE(comesTrue([&] { return pro.controlRequests().back() == modemStatus; }))
        << "asked whether it lives";
    pro.sendSerial(proFrame({5}));
    EXPECT_TRUE(shows(1, 5));
    EXPECT_EQ(devices().at(0).problem, "");
    EXPECT_TRUE(comesTrue([&] { return devices().at(0).facts.frames == 2; })) << "it was opened anew";
}

TEST_F(UsbInputTest, AStallIsClearedAndCostsOnlyWhatWasBegun) {
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.sendSerial(proFrame({4}));
    ASSERT_TRUE(shows(1, 4));
    pro.failReads(1, EPIPE);
    ASSERT_TRUE(comesTrue([&] { return pro.clearedHalts() > 0; }));
    pro.sendSerial(proFrame({5}));
    EXPECT_TRUE(shows(1, 5));
    EXPECT_EQ(devices().at(0).problem, "");
}

TEST_F(UsbInputTest, SingleErrorsArePassedOverManyAreReported) {
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.failReads(3, EPROTO);
    pro.sendSerial(proFrame({5}));
    EXPECT_TRUE(shows(1, 5));
    EXPECT_EQ(devices().at(0).problem, "");
    pro.failReads(1'000'000, EPROTO);
    EXPECT_THAT(problem(), HasSubstr("the connection fails"));
    pro.failReads(0, 0);
    pro.sendSerial(proFrame({6}));
    EXPECT_TRUE(shows(1, 6));
}

TEST_F(UsbInputTest, GarbageIsCountedAndChangesNothing) {
    FakeUsbDevice pro(*bus_, {});
    start();
    pro.sendSerial(proFrame({5}));
    ASSERT_TRUE(shows(1, 5));
    Bytes garbage(3000);
    for (std::size_t i = 0; i < garbage.size(); ++i) garbage[i] = static_cast<std::uint8_t>(i * i >> 3U);
    pro.sendSerial(garbage);
    pro.sendSerial(packEnttec(EnttecLabel::kReceivedDmx, Bytes(600)));
    pro.sendPacket({0x01});
    ASSERT_TRUE(comesTrue([&] { return devices().at(0).facts.malformed > 0; }));
    EXPECT_EQ(universe(1).slots[0], 5);
    pro.sendSerial(proFrame({6}));
    EXPECT_TRUE(shows(1, 6));
}

TEST_F(UsbInputTest, ANodleIsAskedForItsInput) {
    FakeUsbDevice nodle(*bus_, {.vendor = 0x16D0,
                                .product = 0x0830,
                                .manufacturer = "DMXControl Projects e.V.",
                                .name = "Nodle U1",
                                .serial = "N1",
                                .isHid = true});
    start();
    ASSERT_TRUE(comesTrue([&] { return nodle.written().size() == 1; }));
    EXPECT_EQ(nodle.written()[0][0], 16);
    EXPECT_EQ(nodle.written()[0][1], 4);
    Bytes report(33, 42);
    report[0] = 0;
    nodle.sendPacket(report);
    report[0] = 15;
    nodle.sendPacket(report);
    EXPECT_TRUE(shows(1, 42));
    EXPECT_TRUE(comesTrue([&] { return universe(1).slots[511] == 42; }));
    EXPECT_TRUE(comesTrue([&] { return devices().at(0).facts.kind == "Nodle"; }));
}

TEST_F(UsbInputTest, ATapHearsEveryFrame) {
    FakeUsbDevice pro(*bus_, {});
    std::mutex mutex;
    std::vector<Bytes> heard;
    UsbConfig config = quickConfig();
    config.tap = [&](UniverseId universe, std::span<const std::uint8_t> slots, WallTime time) {
        const std::lock_guard lock(mutex);
        EXPECT_EQ(universe, (UniverseId{Transport::kDmx, 1}));
        EXPECT_GT(time.time_since_epoch().count(), 0);
        heard.emplace_back(slots.begin(), slots.end());
    };
    start(config);
    pro.sendSerial(proFrame({1, 2}));
    pro.sendSerial(proFrame({3}));
    EXPECT_TRUE(comesTrue([&] {
        const std::lock_guard lock(mutex);
        return heard.size() == 2;
    }));
    input_.reset();
    EXPECT_EQ(heard, (std::vector<Bytes>{{1, 2}, {3}}));
}

}  // namespace
}  // namespace hazer::protocol
