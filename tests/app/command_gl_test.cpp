// The real program drawing: what it writes, and the mistakes that show only once it draws.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "app/paths.h"
#include "protocol/sender.h"
#include "render/image.h"
#include "tests/render/ies_text.h"
#include "tests/support/datagram.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kOneSpot = (showFolder() / "one-spot.toml").string();

test::ProcessResult render(const std::string& show, std::vector<std::string> arguments,
                           const std::map<std::string, std::string>& environment = {}) {
    arguments.insert(arguments.begin(), {"render", show, "--size", "64x36"});
    return test::runProcess(HAZER_PROGRAM, arguments, environment);
}

double brightest(const render::FloatImage& image) {
    return *std::max_element(image.rgb.begin(), image.rgb.end());
}

class RenderTest : public ::testing::Test {
 protected:
    std::string fileIn(const std::string& name) const { return (folder_.path() / name).string(); }
    const test::TemporaryFolder folder_;
};

TEST_F(RenderTest, writesTheLightOfTheScene) {
    const std::string file = fileIn("new/folder/a.exr");
    const test::ProcessResult lit = render(kOneSpot, {"--set", "spot1.Dimmer=1", "--out", file});
    ASSERT_EQ(lit.exitCode, 0) << lit.errors;
    EXPECT_EQ(lit.output, file + "\n");
    const render::FloatImage image = render::readFloatImage(file);
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 36);
    EXPECT_GT(brightest(image), 10.0);
}

// The error of an empty, dark haze is none; that of a lit one is small but there.
TEST_F(RenderTest, writesErrorAndCostInsteadOfLight) {
    for (const std::string view : {"error", "cost"}) {
        const std::string dark = fileIn("dark.exr");
        ASSERT_EQ(render(kOneSpot, {"--view", view, "--out", dark}).exitCode, 0);
        EXPECT_EQ(brightest(render::readFloatImage(dark)), 0.0) << view;
        const std::string lit = fileIn("lit.exr");
        const test::ProcessResult result =
            render(kOneSpot, {"--set", "spot1.Dimmer=1", "--view", view, "--out", lit});
        ASSERT_EQ(result.exitCode, 0) << result.errors;
        EXPECT_THAT(result.errors, HasSubstr("99 % within"));
        EXPECT_GT(brightest(render::readFloatImage(lit)), 0.0) << view;
        EXPECT_LT(brightest(render::readFloatImage(lit)), view == "error" ? 0.5 : 1.01);
    }
}

TEST_F(RenderTest, drawsFixturesOfTheLibrary) {
    const test::ProcessResult result = test::runProcess(
        HAZER_PROGRAM, {"library", "moving-profile", "hazer", "--thumbnails", fileIn("small")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    const render::FloatImage profile = render::readFloatImage(fileIn("small/moving-profile.png"));
    EXPECT_EQ(profile.width, 192);
    EXPECT_GT(brightest(profile), 0.5);
    // The machine itself, by the light that shows bodies.
    EXPECT_GT(brightest(render::readFloatImage(fileIn("small/hazer.png"))), 0.1);
}

// A recording plays in the time of the film: dark for a second, then lit, and the same every time.
TEST_F(RenderTest, playsARecordingTheSameEveryTime) {
    const std::string night =
        folder_.write("night.show", "OLA Show\n1 0\n1000\n1 128,0,128,0,255,255,255,128,0,128\n").string();
    const auto drawn = [&](const std::string& from, const std::string& name) {
        const std::vector<std::string> arguments{"--replay", night,   "--first-universe", "0", "--from",
                                                 from,       "--out", fileIn(name)};
        const test::ProcessResult result = render(kOneSpot, arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return render::readFloatImage(fileIn(name));
    };
    EXPECT_EQ(brightest(drawn("0.9", "a.exr")), 0.0);
    const render::FloatImage lit = drawn("1", "b.exr");
    EXPECT_GT(brightest(lit), 10.0);
    EXPECT_EQ(drawn("1", "c.exr").rgb, lit.rgb);
}

TEST_F(RenderTest, playsTheRecordingOfAShow) {
    folder_.write("night.show", "OLA Show\n1 128,0,128,0,255,255,255,128,0,128\n");
    const std::string show =
        folder_
            .write("a.toml",
                   "[[input]]\nprotocol = \"file\"\npath = \"night.show\"\nfirst_universe = 0\n"
                   "[[fixture]]\nname = \"a\"\ngdtf = \"moving-spot\"\nmode = \"Standard\"\n"
                   "universe = 0\nslot = 1\nposition = [0.0, 0.0, 6.0]\n"
                   "[[object]]\ntype = \"floor\"\n")
            .string();
    const test::ProcessResult result = render(show, {"--out", fileIn("a.exr")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_GT(brightest(render::readFloatImage(fileIn("a.exr"))), 1.0);
    std::filesystem::remove(folder_.path() / "night.show");
    const test::ProcessResult absent = render(show, {"--out", fileIn("b.exr")});
    EXPECT_EQ(absent.exitCode, 2);
    EXPECT_THAT(absent.errors, HasSubstr("night.show: the recording cannot be read"));
}

TEST_F(RenderTest, refusesAFilmOfAView) {
    EXPECT_EQ(render(kOneSpot, {"--view", "cost", "--out", fileIn("a.mp4")}).exitCode, 1);
}

TEST_F(RenderTest, writesNumberedFrames) {
    const test::ProcessResult result =
        render(kOneSpot, {"--seconds", "0.12", "--fps", "25", "--out", fileIn("frame_%04d.png")});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_TRUE(std::filesystem::exists(fileIn("frame_0002.png")));
    EXPECT_FALSE(std::filesystem::exists(fileIn("frame_0003.png")));
    EXPECT_EQ(result.output, fileIn("frame_0000.png") + "\n" + fileIn("frame_0001.png") + "\n" +
                                 fileIn("frame_0002.png") + "\n");
}

TEST_F(RenderTest, drawsWhatTheDeskSends) {
    // A free port: bound, read, let go again.
    const std::uint16_t port = test::OccupiedPort().port();
    const std::string file = fileIn("a.exr");
    protocol::Slots slots{};
    slots.fill(128);
    std::jthread desk([&](const std::stop_token& stop) {
        protocol::ArtNetSender sender("127.0.0.1", port);
        while (!stop.stop_requested()) {
            // Nobody listens until the program has started: what the system says about that is no matter
            // here.
            try {
                sender.send(0, slots);
            } catch (const std::runtime_error&) {
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
    const test::ProcessResult result = render(kOneSpot, {"--listen", "0.5", "--port", std::to_string(port),
                                                         "--set", "spot1.Shutter1=1", "--out", file});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_GT(brightest(render::readFloatImage(file)), 1.0);
}

TEST_F(RenderTest, saysThatNothingArrived) {
    const std::string port = std::to_string(test::OccupiedPort().port());
    const test::ProcessResult result =
        render(kOneSpot, {"--listen", "0.1", "--port", port, "--out", fileIn("a.png")});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.errors, HasSubstr("no DMX arrived"));
    EXPECT_THAT(result.errors, HasSubstr(port));
}

TEST_F(RenderTest, saysThatAValueIsOutOfRange) {
    const test::ProcessResult percent =
        render(kOneSpot, {"--set", "spot1.Dimmer=50", "--set", "spot1.Gobo1=99", "--out", fileIn("a.png")});
    EXPECT_EQ(percent.exitCode, 0);
    EXPECT_THAT(percent.errors, HasSubstr("Dimmer goes from 0 to 1"));
    EXPECT_THAT(percent.errors, HasSubstr("Gobo1 goes from 1 to 12"));
    const test::ProcessResult inRange =
        render(kOneSpot, {"--set", "spot1.Dimmer=1", "--set", "spot1.Pan=-270", "--out", fileIn("a.png")});
    EXPECT_EQ(inRange.errors, "");
}

TEST_F(RenderTest, missingGobo) {
    std::filesystem::copy(libraryFolder() / "moving-spot", folder_.path() / "spot",
                          std::filesystem::copy_options::recursive);
    std::filesystem::remove(folder_.path() / "spot/wheels/stars.png");
    const std::string fixture = "[[fixture]]\nname='a'\ngdtf='spot'\nmode='Basic'\nuniverse=0\nslot=1\n";
    const std::string show = folder_.write("a.toml", fixture).string();
    const test::ProcessResult result = render(show, {"--out", fileIn("a.png")});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.errors, StartsWith("hazer: warning: " + show + ": fixture 'a': "));
    EXPECT_THAT(result.errors, HasSubstr("stars"));
}

TEST_F(RenderTest, unknownFixtureAttributeAndCamera) {
    const test::ProcessResult fixture =
        render(kOneSpot, {"--set", "spot2.Dimmer=1", "--out", fileIn("a.png")});
    EXPECT_EQ(fixture.exitCode, 2);
    EXPECT_THAT(fixture.errors, HasSubstr("Did you mean 'spot1'?"));
    const test::ProcessResult attribute =
        render(kOneSpot, {"--set", "spot1.Tild=1", "--out", fileIn("a.png")});
    EXPECT_EQ(attribute.exitCode, 2);
    EXPECT_THAT(attribute.errors, HasSubstr("Did you mean 'Tilt'?"));
    const test::ProcessResult camera = render(kOneSpot, {"--camera", "moon", "--out", fileIn("a.png")});
    EXPECT_EQ(camera.exitCode, 2);
    EXPECT_THAT(camera.errors, HasSubstr("no camera is named 'moon'"));
    EXPECT_FALSE(std::filesystem::exists(fileIn("a.png")));
}

TEST_F(RenderTest, missingAndBrokenModel) {
    const std::string show =
        folder_.write("a.toml", "\n[[object]]\ntype='model'\nfile='chair.glb'\n").string();
    const test::ProcessResult missing = render(show, {"--out", fileIn("a.png")});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_THAT(missing.errors, StartsWith("hazer: " + show + ":2: "));
    EXPECT_THAT(missing.errors, HasSubstr("chair.glb"));
    folder_.write("chair.glb", "no model at all");
    const test::ProcessResult broken = render(show, {"--out", fileIn("a.png")});
    EXPECT_EQ(broken.exitCode, 2);
    EXPECT_THAT(broken.errors, HasSubstr("chair.glb"));
}

TEST_F(RenderTest, goboOfABareLight) {
    const std::string light =
        "\n[[light]]\nname='a'\nposition=[0,0,6]\ndirection=[0,0,-1]\ncandela=1e5\nhalf_angle=20\ngobo='f."
        "png'\n";
    const std::string show = folder_.write("a.toml", light).string();
    const auto expectSaid = [&](const char* what) {
        const test::ProcessResult result = render(show, {"--out", fileIn("a.exr")});
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_THAT(result.errors, StartsWith("hazer: " + show + ":2: "));
        EXPECT_THAT(result.errors, HasSubstr(what));
        EXPECT_THAT(result.errors, HasSubstr("f.png"));
    };
    expectSaid("cannot be opened");
    folder_.write("f.png", "no picture at all");
    expectSaid("is no picture that can be used");
    std::filesystem::remove(folder_.path() / "f.png");
    std::filesystem::create_directory(folder_.path() / "f.png");
    expectSaid("is a folder");
    std::filesystem::remove(folder_.path() / "f.png");
    std::filesystem::copy(libraryFolder() / "moving-spot/wheels/bars.png", folder_.path() / "f.png");
    const test::ProcessResult lit = render(show, {"--out", fileIn("a.exr")});
    ASSERT_EQ(lit.exitCode, 0) << lit.errors;
    EXPECT_GT(brightest(render::readFloatImage(fileIn("a.exr"))), 0.1);
}

TEST_F(RenderTest, webOfABareLight) {
    const std::string light =
        "\n[[light]]\nname='a'\nposition=[0,0,6]\ndirection=[0,0,-1]\nprofile='web'\nweb='lamp.ies'\n";
    const std::string show = folder_.write("a.toml", light).string();
    const auto expectSaid = [&](const char* what) {
        const test::ProcessResult result = render(show, {"--out", fileIn("a.exr")});
        EXPECT_EQ(result.exitCode, 2);
        EXPECT_THAT(result.errors, HasSubstr("hazer: " + show + ":2: "));
        EXPECT_THAT(result.errors, HasSubstr(what));
        EXPECT_THAT(result.errors, HasSubstr("lamp.ies"));
    };
    expectSaid("cannot be opened");
    const test::IesText lamp{.tilt = "TILT=INCLUDE\n1\n2\n0 90\n1 1", .verticalDeg = {0.0, 60.0, 90.0}};
    folder_.write("lamp.ies", lamp.text().substr(0, 60));
    expectSaid("ends");
    folder_.write("lamp.ies", lamp.text());
    folder_.write("a.toml", light + "gobo='f.png'\n");
    std::filesystem::copy(libraryFolder() / "moving-spot/wheels/bars.png", folder_.path() / "f.png");
    expectSaid("too wide a beam for a gobo");
    folder_.write("a.toml", light + "candela=20000\n");
    const test::ProcessResult lit = render(show, {"--out", fileIn("a.exr")});
    ASSERT_EQ(lit.exitCode, 0) << lit.errors;
    EXPECT_THAT(lit.errors, StartsWith("hazer: warning: " + show + ":2: "));
    EXPECT_THAT(lit.errors, HasSubstr("TILT=INCLUDE"));
    EXPECT_GT(brightest(render::readFloatImage(fileIn("a.exr"))), 0.1);
}

TEST_F(RenderTest, aPlaceThatCannotBeWritten) {
    const test::ProcessResult result = render(kOneSpot, {"--out", "/proc/nowhere/a.png"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr("/proc/nowhere"));
}

TEST_F(RenderTest, aPortInUse) {
    const test::OccupiedPort occupied;
    const std::string port = std::to_string(occupied.port());
    const test::ProcessResult result =
        render(kOneSpot, {"--listen", "0.1", "--port", port, "--out", fileIn("a.png")});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr(port));
}

TEST_F(RenderTest, withoutOpenGl41) {
    const test::ProcessResult result =
        render(kOneSpot, {"--out", fileIn("a.png")}, {{"MESA_GL_VERSION_OVERRIDE", "3.3"}});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.errors, HasSubstr("4.1"));
}

TEST_F(RenderTest, missingShader) {
    std::filesystem::create_directories(folder_.path() / "app");
    std::filesystem::create_directories(folder_.path() / "shaders");
    const std::string show = folder_.write("a.toml", "").string();
    const test::ProcessResult result =
        render(show, {"--out", fileIn("a.png")}, {{"HAZER_DATA", folder_.path().string()}});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.errors, HasSubstr((folder_.path() / "shaders").string()));
}

TEST(Demo, playsToItselfAndTakesAPicture) {
    const test::TemporaryFolder folder;
    // Without ffmpeg: the film alone would take longer than all other tests.
    const test::ProcessResult result = test::runProcess(
        HAZER_PROGRAM, {"demo", "--headless", "--out", folder.path().string()}, {{"PATH", "/nowhere"}});
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_EQ(result.output, (folder.path() / "demo.png").string() + "\n");
    EXPECT_THAT(result.errors, HasSubstr("no ffmpeg"));
    const render::ByteImage picture = render::readByteImage(folder.path() / "demo.png");
    EXPECT_EQ(picture.width, 1280);
    EXPECT_EQ(picture.height, 720);
    const auto lit =
        std::count_if(picture.rgb.begin(), picture.rgb.end(), [](int value) { return value > 64; });
    EXPECT_GT(lit, static_cast<long>(picture.rgb.size() / 20)) << "hardly any light arrived";
}

}  // namespace
}  // namespace hazer::app
