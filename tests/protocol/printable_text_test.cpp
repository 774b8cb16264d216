#include "protocol/printable_text.h"

#include <gtest/gtest.h>

namespace hazer::protocol {
namespace {

const std::string kNo = "\xEF\xBF\xBD";

TEST(PrintableText, KeepsEveryKindOfCharacter) {
    for (const char* text : {"", "Desk 1", "Pult f\xC3\xBCr B\xC3\xBChne", "\xE7\x81\xAF", "\xF0\x9F\x92\xA1",
                             "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"}) {
        EXPECT_EQ(printableText(text), text);
    }
}

TEST(PrintableText, TakesOutControlCharacters) {
    EXPECT_EQ(printableText("a\x1b[31m\n\t\x7f"), "a" + kNo + "[31m" + kNo + kNo + kNo);
    EXPECT_EQ(printableText(std::string_view("a\0b", 3)), "a" + kNo + "b");
    EXPECT_EQ(printableText("\xC2\x9B"), kNo) << "CSI of eight bits";
    EXPECT_EQ(printableText("\xC2\xA0"), "\xC2\xA0");
}

TEST(PrintableText, ReplacesWhatIsNotUtf8) {
    EXPECT_EQ(printableText("\xFC"
                            "ber"),
              kNo + "ber")
        << "Latin-1";
    EXPECT_EQ(printableText("\xC3"), kNo) << "cut short";
    EXPECT_EQ(printableText("\xE7\x81"), kNo + kNo);
    EXPECT_EQ(printableText("\xC0\xAF"), kNo + kNo) << "overlong";
    EXPECT_EQ(printableText("\xE0\x80\xAF"), kNo + kNo + kNo) << "overlong";
    EXPECT_EQ(printableText("\xED\xA0\x80"), kNo + kNo + kNo) << "surrogate";
    EXPECT_EQ(printableText("\xF4\x90\x80\x80"), kNo + kNo + kNo + kNo) << "beyond U+10FFFF";
    EXPECT_EQ(printableText("\xFF\xFE"), kNo + kNo);
}

TEST(PrintableText, CutsBetweenCharacters) {
    EXPECT_EQ(printableText(std::string(100, 'a')), std::string(64, 'a'));
    EXPECT_EQ(printableText(std::string(63, '\xFF')).size(), 63U) << "21 times three bytes";
    EXPECT_EQ(printableText("ab\xC3\xBC", 3), "ab");
    EXPECT_EQ(printableText("ab\xC3\xBC", 4), "ab\xC3\xBC");
}

}  // namespace
}  // namespace hazer::protocol
