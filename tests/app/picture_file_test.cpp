#include "app/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace hazer::app {
namespace {

using ::testing::StartsWith;

TEST(NumberedFile, fillsThePattern) {
    EXPECT_EQ(numberedFile("a/frame_%04d.png", 7), "a/frame_0007.png");
    EXPECT_EQ(numberedFile("%d.exr", 12), "12.exr");
    EXPECT_EQ(numberedFile("%03dx.exr", 1234), "1234x.exr");
}

TEST(NumberedFile, numbersANameWithoutPattern) {
    EXPECT_EQ(numberedFile("a/look.png", 3), "a/look_0003.png");
}

TEST(NumberedFile, leavesOtherPercentSignsAlone) {
    EXPECT_EQ(numberedFile("50%.png", 1), "50%_0001.png");
}

TEST(OutputKind, isToldByTheExtension) {
    EXPECT_EQ(outputKind("a.png"), OutputKind::kPicture);
    EXPECT_EQ(outputKind("a.exr"), OutputKind::kPicture);
    EXPECT_EQ(outputKind("a.mp4"), OutputKind::kFilm);
    EXPECT_THROW(outputKind("a.jpg"), std::runtime_error);
    EXPECT_THROW(outputKind("png"), std::runtime_error);
}

TEST(MakeFolder, saysWhichOneCannotBeMade) {
    try {
        makeFolder("/dev/null/look");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), StartsWith("/dev/null/look: the folder cannot be made"));
    }
}

}  // namespace
}  // namespace hazer::app
