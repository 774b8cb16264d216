// Reading LM-63 files: every edition, and whatever else bytes may be.
#include "render/ies_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/error.h"
#include "tests/render/ies_text.h"

namespace hazer::test {
namespace {

using render::IesTable;
using render::IesType;
using testing::ElementsAre;
using testing::HasSubstr;

IesTable parsed(const std::string& text) {
    return render::parseIesTable(text, "lamp.ies");
}

std::string refusal(const std::string& text) {
    try {
        parsed(text);
    } catch (const render::RenderError& error) {
        return error.what();
    }
    return "";
}

const char* const kSmall1986 =
    "A lamp of the year 1986\r\n"
    "made by nobody\r\n"
    "TILT=NONE\r\n"
    "1.0, 1000.0, 2.0, 3, 2, 1, 1, .5 .5 0\r\n"
    "0.5 0.8 150\r\n"
    "0.,45.,+90.\r\n"
    "0 90\r\n"
    "100 80\r\n"
    "6E1\r\n"
    "50,40\r\n"
    "30\r\n";

TEST(IesTable, ReadsTheEditionOf1986AcrossLineBreaksAndCommas) {
    const IesTable table = parsed(kSmall1986);
    EXPECT_EQ(table.type, IesType::kC);
    EXPECT_THAT(table.verticalDeg, ElementsAre(0.0, 45.0, 90.0));
    EXPECT_THAT(table.horizontalDeg, ElementsAre(0.0, 90.0));
    // Multiplier 2, ballast 0.5, ballast-lamp 0.8.
    EXPECT_THAT(table.candela,
                testing::Pointwise(testing::DoubleNear(1e-9), {80.0, 64.0, 48.0, 40.0, 32.0, 24.0}));
    EXPECT_EQ(table.at(1, 0), 40.0);
    EXPECT_EQ(table.warning, "");
}

TEST(IesTable, TheThirdFactorCountsUpTo1995) {
    IesText file;
    file.multiplier = 3.0;
    file.ballastFactor = 0.5;
    file.ballastLampFactor = 1.1;
    for (const char* header : {"", "IESNA91", "IESNA:LM-63-1995"}) {
        file.header = header;
        EXPECT_NEAR(parsed(file.text()).candela.front(), 1.65, 1e-12) << header;
    }
    // In 2019 this 1.1 says "from a laboratory, not interpolated".
    for (const char* header : {"IESNA:LM-63-2002", "IES:LM-63-2019"}) {
        file.header = header;
        EXPECT_NEAR(parsed(file.text()).candela.front(), 1.5, 1e-12) << header;
    }
}

TEST(IesTable, ReadsATableOfTiltsAndSaysThatItIsNotApplied) {
    IesText file;
    file.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.7";
    const IesTable table = parsed(file.text());
    EXPECT_EQ(table.candela.front(), 1.0);
    EXPECT_THAT(table.warning, HasSubstr("TILT=INCLUDE"));
}

TEST(IesTable, TakesBlanksAroundTheTiltAndItsNameInAText) {
    IesText file;
    file.tilt = "TILTED it was not\n  Tilt = none ";
    EXPECT_EQ(parsed(file.text()).candela.size(), 2u);
}

TEST(IesTable, ReadsEveryTypeAndSymmetry) {
    IesText file;
    for (const auto& [first, last] : {std::pair{0.0, 90.0}, {0.0, 180.0}, {90.0, 270.0}, {0.0, 360.0}}) {
        file.horizontalDeg = anglesFrom(first, last, 5);
        EXPECT_EQ(parsed(file.text()).horizontalDeg, file.horizontalDeg);
    }
    file.horizontalDeg = file.verticalDeg = anglesFrom(-90.0, 90.0, 7);
    file.type = 2;
    EXPECT_EQ(parsed(file.text()).type, IesType::kB);
    file.type = 3;
    EXPECT_EQ(parsed(file.text()).type, IesType::kA);
}

TEST(IesTable, ClosesACircleThatLacksItsLastPlane) {
    IesText file;
    file.horizontalDeg = anglesFrom(0.0, 315.0, 8);
    file.candela = [](double horizontal, double) { return 1.0 + horizontal; };
    const IesTable table = parsed(file.text());
    EXPECT_EQ(table.horizontalDeg.back(), 360.0);
    EXPECT_EQ(table.at(8, 1), table.at(0, 1));
    EXPECT_EQ(table.candela.size(), 9u * 2u);
}

TEST(IesTable, TakesADosEndOfFileAndAByteOrderMark) {
    const IesText file;
    EXPECT_EQ(parsed("\xEF\xBB\xBF" + file.text() + "\x1A\r\n").candela.size(), 2u);
}

std::string withNumbers(const std::string& numbers) {
    return "IESNA:LM-63-2002\nTILT=NONE\n" + numbers;
}

TEST(IesTable, RefusesWithTheLineAndTheReason) {
    EXPECT_EQ(refusal("no such file\nas this\n"),
              "cannot read web 'lamp.ies', line 2: there is no TILT= line up to the end; is this an IES "
              "(LM-63) file?");
    EXPECT_EQ(refusal(""),
              "cannot read web 'lamp.ies', line 0: there is no TILT= line up to the end; is this an "
              "IES (LM-63) file?");
    EXPECT_EQ(refusal("TILT=lamp.tlt\n"),
              "cannot read web 'lamp.ies', line 1: TILT=lamp.tlt names another file, "
              "which is not read; say TILT=NONE");
    EXPECT_EQ(refusal(withNumbers("1 -1 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n5 abc\n")),
              "cannot read web 'lamp.ies', line 7: 'abc' is no number, but an intensity should be here");
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n5")),
                HasSubstr("it was cut short"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n5 5 5")),
                HasSubstr("more values than"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n0 0")), HasSubstr("no light"));
}

TEST(IesTable, RefusesNumbersOutOfRange) {
    const std::string rest = " 0 0 0\n1 1 9\n0 90\n0\n5 5\n";
    ASSERT_EQ(refusal(withNumbers("1 -1 1 2 1 1 2" + rest)), "");
    EXPECT_THAT(refusal(withNumbers("1 -1 0 2 1 1 2" + rest)), HasSubstr("candela multiplier"));
    EXPECT_THAT(refusal(withNumbers("1 -1 -2 2 1 1 2" + rest)), HasSubstr("candela multiplier"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 722 1 1 2" + rest)),
                HasSubstr("number of vertical angles is 722"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 1 1 1 2" + rest)), HasSubstr("number of vertical angles is 1"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2.5 1 1 2" + rest)), HasSubstr("no whole number"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1e9 1 2" + rest)), HasSubstr("number of horizontal angles"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 0 1 2" + rest)), HasSubstr("number of horizontal angles"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 4 2" + rest)), HasSubstr("photometric type"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 2 2" + rest)), HasSubstr("two or more horizontal angles"));
    EXPECT_THAT(refusal(withNumbers("1 -1 1 2 1 1 3" + rest)), HasSubstr("type of units"));
    EXPECT_THAT(refusal(withNumbers("1 nan 1 2 1 1 2" + rest)), HasSubstr("'nan' is no number"));
    EXPECT_THAT(refusal(withNumbers("1 1e999 1 2 1 1 2" + rest)), HasSubstr("'1e999' is no number"));
}

TEST(IesTable, RefusesBadIntensities) {
    const std::string before = "1 -1 10 2 1 1 2 0 0 0\n1 1 9\n0 90\n0\n";
    for (const char* bad : {"-1", "nan", "inf", "-inf", "2e9", "1e308", "5e8", "0x10", "--1"}) {
        EXPECT_NE(refusal(withNumbers(before + "5 " + bad)), "") << bad;
    }
}

TEST(IesTable, RefusesAnglesThatDoNotRiseOrMeanNothing) {
    IesText file;
    for (const std::vector<double>& angles :
         {std::vector{0.0, 0.0}, {0.0, 50.0, 40.0}, {-1.0, 90.0}, {0.0, 181.0}}) {
        file.verticalDeg = angles;
        EXPECT_NE(refusal(file.text()), "");
    }
    file.verticalDeg = {0.0, 90.0};
    for (const std::vector<double>& angles : {std::vector{0.0, 45.0},
                                              {10.0, 90.0},
                                              {0.0, 50.0, 100.0, 150.0, 200.0},
                                              {0.0, 90.001, 90.005},
                                              {90.0, 180.0},
                                              {0.0, 361.0}}) {
        file.horizontalDeg = angles;
        EXPECT_NE(refusal(file.text()), "") << file.text();
    }
}

TEST(IesTable, RefusesWhatIsTooLarge) {
    EXPECT_THAT(refusal(std::string(render::kMaxIesBytes + 1, ' ')), HasSubstr("larger than"));
    EXPECT_EQ(refusal(IesText().text() + std::string(render::kMaxIesBytes - 500, ' ')), "");
}

TEST(IesTable, RefusesEveryPrefixThatLacksANumber) {
    IesText included;
    included.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.7";
    IesText floodlight;
    floodlight.type = 2;
    floodlight.horizontalDeg = floodlight.verticalDeg = anglesFrom(-90.0, 90.0, 5);
    for (const std::string& whole : {std::string(kSmall1986), included.text(), floodlight.text()}) {
        const std::size_t lastNumber = whole.find_last_of(" ,\n", whole.find_last_of("0123456789")) + 1;
        for (std::size_t size = 0; size <= lastNumber; ++size) {
            // In a block of exactly its size, where a sanitizer sees any read beyond.
            const std::vector<char> prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_THROW(render::parseIesTable({prefix.data(), prefix.size()}, "cut.ies"),
                         render::RenderError)
                << size;
        }
        EXPECT_NO_THROW(parsed(whole));
    }
}

TEST(IesTable, MessagesRepeatNothingThatIsNotPrintable) {
    const std::string message = refusal(withNumbers("1 -1 \x01\x7f\xff" + std::string(500, 'x')));
    EXPECT_LT(message.size(), 150u);
    for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~');
}

}  // namespace
}  // namespace hazer::test
