// Includes and features of shader text.
#include "render/gl/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/error.h"
#include "tests/support/temporary_folder.h"

namespace hazer::test {
namespace {

using testing::HasSubstr;

class ShaderSource : public testing::Test {
 protected:
    TemporaryFolder folder_;
};

TEST_F(ShaderSource, IncludesEachFileOnceAndKeepsLineNumbers) {
    folder_.write("a.frag",
                  "#version 410 core\n#include \"include/b.glsl\"\n#include \"include/b.glsl\"\nint last;\n");
    folder_.write("include/b.glsl", "#include \"include/b.glsl\"\nint b;\n");
    const std::string text = render::gl::expandShader(folder_.path(), "a.frag", {});
    EXPECT_EQ(text.find("int b;"), text.rfind("int b;"));
    EXPECT_THAT(text, HasSubstr("#line 4 1\nint last;"));
}

TEST_F(ShaderSource, FeaturesFollowTheVersionLine) {
    folder_.write("a.frag", "#version 410 core\nint a;\n");
    EXPECT_THAT(render::gl::expandShader(folder_.path(), "a.frag", {"GOBO", "SHADOW"}),
                testing::StartsWith("#version 410 core\n#define GOBO 1\n#define SHADOW 1\n"));
}

TEST_F(ShaderSource, AMissingFileIsNamedWithWhoWantsIt) {
    folder_.write("a.frag", "#version 410 core\n#include \"include/none.glsl\"\n");
    try {
        render::gl::expandShader(folder_.path(), "a.frag", {});
        FAIL();
    } catch (const render::RenderError& error) {
        EXPECT_THAT(error.what(), HasSubstr("none.glsl"));
        EXPECT_THAT(error.what(), HasSubstr("a.frag:2"));
    }
}

}  // namespace
}  // namespace hazer::test
