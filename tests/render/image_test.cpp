#include "render/image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "render/error.h"
#include "tests/support/temporary_folder.h"

namespace hazer::render {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
 protected:
    std::size_t filesInFolder() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
    }

    const fs::path& folder() const { return folder_.path(); }

 private:
    test::TemporaryFolder folder_;
};

FloatImage radiance() {
    return {2, 2, {0.0f, 0.5f, 1e6f, -0.25f, 1e-4f, 3.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}};
}

ByteImage display() {
    return {3, 1, {0, 1, 2, 127, 128, 129, 253, 254, 255}};
}

ByteImage largeDisplay() {
    ByteImage image{256, 256, {}};
    std::uint32_t state = 1;
    for (int i = 0; i < 3 * 256 * 256; ++i) {
        state = state * 1664525u + 1013904223u;
        image.rgb.push_back(static_cast<std::uint8_t>(state >> 24));
    }
    return image;
}

template <typename Action>
std::string messageOf(Action action) {
    try {
        action();
    } catch (const RenderError& error) {
        return error.what();
    }
    return "no error";
}

/// Makes every file of this process end after so many bytes, as a full disk does.
class FileSizeLimit {
 public:
    explicit FileSizeLimit(rlim_t bytes) : formerHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &former_);
        const rlimit limit{bytes, former_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, formerHandler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
    rlimit former_{};
    void (*formerHandler_)(int);
};

TEST_F(ImageFile, ExrKeepsEveryBitOfRadiance) {
    const fs::path file = folder() / "a.exr";
    writeImage(radiance(), file);
    const FloatImage read = readFloatImage(file);
    EXPECT_EQ(read.width, 2);
    EXPECT_EQ(read.height, 2);
    EXPECT_EQ(read.rgb, radiance().rgb);
}

TEST_F(ImageFile, AtFindsTheRowFromTheTop) {
    const FloatImage image = radiance();
    EXPECT_EQ(image.at(1, 0)[0], -0.25f);
    EXPECT_EQ(image.at(0, 1)[2], 3.0f);
}

TEST_F(ImageFile, PngKeepsEveryByte) {
    const fs::path file = folder() / "a.PNG";
    writeImage(display(), file);
    const ByteImage read = readByteImage(file);
    EXPECT_EQ(read.width, 3);
    EXPECT_EQ(read.height, 1);
    EXPECT_EQ(read.rgb, display().rgb);
}

TEST_F(ImageFile, WritingReplacesAndLeavesNothingElseBehind) {
    const fs::path file = folder() / "a.png";
    writeImage(largeDisplay(), file);
    writeImage(display(), file);
    EXPECT_EQ(readByteImage(file).width, 3);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, MissingFolderIsNamed) {
    const std::string message = messageOf([&] { writeImage(display(), folder() / "no" / "a.png"); });
    EXPECT_NE(message.find((folder() / "no").string()), std::string::npos) << message;
    EXPECT_NE(message.find("create it"), std::string::npos) << message;
}

TEST_F(ImageFile, ExtensionThatDoesNotFitIsRefused) {
    EXPECT_NE(messageOf([&] { writeImage(display(), folder() / "a.exr"); }).find(".png"), std::string::npos);
    EXPECT_NE(messageOf([&] { writeImage(radiance(), folder() / "a.xyz"); }).find("'.xyz'"),
              std::string::npos);
    EXPECT_NE(messageOf([&] { writeImage(radiance(), folder() / "a"); }).find(".exr"), std::string::npos);
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(ImageFile, FullDiskLeavesTheOlderPicture) {
    const fs::path file = folder() / "a.png";
    writeImage(display(), file);
    std::string message;
    {
        const FileSizeLimit limit(4096);
        message = messageOf([&] { writeImage(largeDisplay(), file); });
    }
    EXPECT_NE(message.find("File too large"), std::string::npos) << message;
    EXPECT_EQ(readByteImage(file).rgb, display().rgb);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, FolderInTheWayIsReportedAndNoTemporaryStays) {
    const fs::path file = folder() / "a.png";
    fs::create_directory(file);
    EXPECT_NE(messageOf([&] { writeImage(display(), file); }).find("cannot write"), std::string::npos);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, MissingPictureIsNamed) {
    const fs::path file = folder() / "none.png";
    EXPECT_NE(messageOf([&] { readByteImage(file); }).find(file.string()), std::string::npos);
}

TEST_F(ImageFile, TruncatedPictureIsRefused) {
    const fs::path file = folder() / "a.png";
    writeImage(largeDisplay(), file);
    const std::uintmax_t whole = fs::file_size(file);
    for (const std::uintmax_t size : {std::uintmax_t{0}, std::uintmax_t{7}, std::uintmax_t{40}, whole / 2}) {
        fs::resize_file(file, size);
        EXPECT_NE(messageOf([&] { readByteImage(file); }), "no error") << size << " bytes";
    }
}

TEST_F(ImageFile, HeaderThatAsksForTooMuchIsRefusedBeforeAllocating) {
    // A PNM header is plain text: 60000 x 60000 pixels and no data.
    const fs::path file = folder() / "huge.ppm";
    std::ofstream(file) << "P6\n60000 60000\n255\n";
    EXPECT_NE(messageOf([&] { readByteImage(file); }).find("60000 x 60000"), std::string::npos);
}

TEST_F(ImageFile, GreyBecomesRgb) {
    const fs::path file = folder() / "grey.pgm";
    std::ofstream(file) << "P5\n2 1\n255\n\x10\x20";
    EXPECT_EQ(readByteImage(file).rgb, (std::vector<std::uint8_t>{16, 16, 16, 32, 32, 32}));
}

}  // namespace
}  // namespace hazer::render
