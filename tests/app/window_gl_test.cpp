// The real program in a real window, on a display that nobody sees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/command.h"
#include "app/paths.h"
#include "app/program_search.h"
#include "tests/support/datagram.h"
#include "tests/support/process.h"

namespace hazer::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::string freePort() {
    return std::to_string(test::OccupiedPort().port());
}

TEST(Window, showsAFewPicturesAndCloses) {
    const auto xvfb = findProgram("xvfb-run");
    if (!xvfb) GTEST_SKIP() << "xvfb-run is not installed (Debian packages xvfb and xauth)";
    // At the end GLFW unloads the graphics driver, and a leak checker can no longer tell that what it kept is
    // its.
    const test::ProcessResult result =
        test::runProcess(xvfb->string(),
                         {"-a", "-s", "-screen 0 640x360x24", HAZER_PROGRAM, "live",
                          (showFolder() / "thesis.toml").string(), "--port", freePort(), "--frames", "4"},
                         {{"ASAN_OPTIONS", "detect_leaks=0"}});
    EXPECT_EQ(result.exitCode, kExitOk) << result.output << result.errors;
    EXPECT_THAT(result.errors + result.output, Not(HasSubstr("OpenGL:")));
}

TEST(Window, aDisplayThatIsNotThereIsOneSentence) {
    const test::ProcessResult result = test::runProcess(HAZER_PROGRAM, {"live", "--frames", "1"},
                                                        {{"DISPLAY", ":54321"}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(result.exitCode, kExitNoGl);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.errors, StartsWith("hazer: no window can be opened ("));
    EXPECT_THAT(result.errors, HasSubstr("hazer render"));
}

}  // namespace
}  // namespace hazer::app
