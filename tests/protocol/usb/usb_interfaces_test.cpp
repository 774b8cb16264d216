#include "protocol/usb/usb_interfaces.h"

#include <gtest/gtest.h>

#include <fstream>

#include "protocol/usb/usb_universes.h"

namespace hazer::protocol {
namespace {

/// A sysfs of its own, with devices as folders.
class UsbInterfaces : public testing::Test {
 protected:
    UsbInterfaces() { std::filesystem::remove_all(sysfs_); }
    ~UsbInterfaces() override { std::filesystem::remove_all(sysfs_); }

    void plug(const std::string& port,
              std::initializer_list<std::pair<const char*, const char*>> attributes) {
        const auto folder = sysfs_ / "bus/usb/devices" / port;
        std::filesystem::create_directories(folder);
        for (const auto& [name, text] : attributes) std::ofstream(folder / name) << text << '\n';
    }

    std::filesystem::path sysfs_ = std::filesystem::path(testing::TempDir()) /
                                   testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(UsbInterfaces, AreFoundByTheirIds) {
    plug("2-1", {{"idVendor", "0403"},
                 {"idProduct", "6001"},
                 {"busnum", "2"},
                 {"devnum", "117"},
                 {"bcdDevice", "0600"},
                 {"manufacturer", "ENTTEC"},
                 {"product", "DMX USB PRO"},
                 {"serial", "EN123456"}});
    plug("1-1.4", {{"idVendor", "16d0"}, {"idProduct", "0830"}, {"busnum", "1"}, {"devnum", "3"}});
    plug("1-1.4:1.0", {{"bInterfaceClass", "03"}});
    plug("usb1", {{"idVendor", "1d6b"}, {"idProduct", "0002"}, {"busnum", "1"}, {"devnum", "1"}});
    const auto found = findUsbInterfaces(sysfs_);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].port, "1-1.4");
    EXPECT_EQ(found[0].family, UsbFamily::kNodle);
    EXPECT_EQ(describe(found[0]), "USB device 16d0:0830");
    EXPECT_TRUE(namesDmx(found[0]));
    EXPECT_EQ(found[1].bus, 2);
    EXPECT_EQ(found[1].device, 117);
    EXPECT_EQ(found[1].bcdDevice, 0x0600);
    EXPECT_EQ(found[1].serial, "EN123456");
    EXPECT_EQ(describe(found[1]), "ENTTEC DMX USB PRO");
}

TEST_F(UsbInterfaces, AreNoneWhereThereIsNoUsb) {
    EXPECT_TRUE(findUsbInterfaces(sysfs_).empty());
}

TEST_F(UsbInterfaces, SayNothingThatATerminalWouldObey) {
    plug("1-1", {{"idVendor", "0403"},
                 {"idProduct", "6001"},
                 {"busnum", "1"},
                 {"devnum", "2"},
                 {"product", "\x1b[2J\xff"},
                 {"serial", std::string(5000, 'a').c_str()}});
    const auto found = findUsbInterfaces(sysfs_);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, "\uFFFD[2J\uFFFD");
    EXPECT_LE(found[0].serial.size(), 64U);
}

TEST_F(UsbInterfaces, WithBrokenNumbersAreNone) {
    plug("1-1", {{"idVendor", "0403"}, {"idProduct", "6001"}, {"busnum", "1"}, {"devnum", "999"}});
    plug("1-2", {{"idVendor", "0403"}, {"idProduct", "60010000"}, {"busnum", "1"}, {"devnum", "9"}});
    plug("1-3", {{"idVendor", ""}});
    EXPECT_TRUE(findUsbInterfaces(sysfs_).empty());
}

TEST(UsbInterface, ABareChipDoesNotSayWhatItIsFor) {
    EXPECT_FALSE(namesDmx({.manufacturer = "FTDI", .name = "FT232R USB UART"}));
    EXPECT_TRUE(namesDmx({.manufacturer = "FTDI", .name = "DMX USB PRO"}));
    EXPECT_TRUE(namesDmx({.manufacturer = "DMXking.com", .name = "ultra"}));
    EXPECT_TRUE(namesDmx({.manufacturer = "Enttec", .name = "USB"}));
}

TEST(UsbRules, LetPeopleOpenEveryDeviceThatHazerKnows) {
    std::ifstream file(HAZER_USB_RULES);
    const std::string rules{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(rules.empty());
    for (const UsbId& id : kUsbIds) {
        char line[80];
        std::snprintf(line, sizeof line, "ATTR{idVendor}==\"%04x\", ATTR{idProduct}==\"%04x\"", id.vendor,
                      id.product);
        EXPECT_NE(rules.find(line), std::string::npos) << line;
    }
}

TEST(UsbUniverses, AreNumberedInTheOrderOfAppearanceAndKept) {
    UsbUniverses universes({});
    EXPECT_EQ(universes.of("B"), 1);
    EXPECT_EQ(universes.of("A"), 2);
    EXPECT_EQ(universes.of("B"), 1);
}

TEST(UsbUniverses, AShowMayBindThem) {
    UsbUniverses universes({{"A", 2}, {"B", 40}, {"C", std::nullopt}});
    EXPECT_EQ(universes.of("B"), 40);
    EXPECT_EQ(universes.of("C"), 1);
    EXPECT_EQ(universes.of("D"), 3) << "2 is kept for A";
    EXPECT_EQ(universes.of("A"), 2);
}

TEST(UsbUniverses, MayBeginElsewhereAndEnd) {
    UsbUniverses universes({}, 65535);
    EXPECT_EQ(universes.of("A"), 65535);
    EXPECT_EQ(universes.of("B"), std::nullopt);
}

}  // namespace
}  // namespace hazer::protocol
