#include "app/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;

render::ByteImage greyPicture(int width, int height) {
    return {width, height,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3,
                                      128)};
}

bool isEmptyFolder(const std::filesystem::path& folder) {
    return std::filesystem::is_empty(folder);
}

TEST(Film, appearsWhenItIsWhole) {
    if (!canMakeFilms()) GTEST_SKIP() << "there is no ffmpeg here";
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "a.mp4";
    Film film(file, {64, 36, 25.0});
    for (int frame = 0; frame < 5; ++frame) film.add(greyPicture(64, 36));
    EXPECT_FALSE(std::filesystem::exists(file));
    film.finish();
    EXPECT_GT(std::filesystem::file_size(file), 500u);
}

TEST(Film, goesAwayUnfinished) {
    if (!canMakeFilms()) GTEST_SKIP() << "there is no ffmpeg here";
    const test::TemporaryFolder folder;
    {
        Film film(folder.path() / "a.mp4", {64, 36, 25.0});
        film.add(greyPicture(64, 36));
    }
    EXPECT_TRUE(isEmptyFolder(folder.path()));
}

TEST(Film, refusesOddSizes) {
    if (!canMakeFilms()) GTEST_SKIP() << "there is no ffmpeg here";
    EXPECT_THROW(Film("a.mp4", {63, 36, 25.0}), std::runtime_error);
}

TEST(Film, saysThatItCannotWriteThere) {
    if (!canMakeFilms()) GTEST_SKIP() << "there is no ffmpeg here";
    try {
        Film film("/nowhere/a.mp4", {64, 36, 25.0});
        // More than a pipe holds, so that an encoder that has ended is noticed here or in the end.
        for (int frame = 0; frame < 50; ++frame) film.add(greyPicture(64, 36));
        film.finish();
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/a.mp4"));
    }
}

TEST(Film, needsFfmpegOnThePath) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    EXPECT_FALSE(canMakeFilms());
    EXPECT_THROW(Film("a.mp4", {64, 36, 25.0}), std::runtime_error);
    setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace hazer::app
