#include "tests/support/gl_test.h"

#include "render/error.h"
#include "render/gl/debug_output.h"

namespace hazer::test {

std::unique_ptr<render::gl::HeadlessContext> GlTest::context_;
std::unique_ptr<render::Renderer> GlTest::renderer_;
std::string GlTest::whyNot_;

std::filesystem::path shaderFolder() {
    return HAZER_SHADER_FOLDER;
}

void GlTest::SetUpTestSuite() {
    try {
        context_ = std::make_unique<render::gl::HeadlessContext>();
        renderer_ = std::make_unique<render::Renderer>(shaderFolder());
    } catch (const render::NoGlError& error) {
        whyNot_ = error.what();
    }
}

void GlTest::TearDownTestSuite() {
    renderer_.reset();
    context_.reset();
}

void GlTest::SetUp() {
    if (!renderer_) GTEST_SKIP() << whyNot_;
    errorsBefore_ = render::gl::debugErrorCount();
}

void GlTest::TearDown() {
    EXPECT_EQ(render::gl::debugErrorCount(), errorsBefore_) << "OpenGL reported errors, see the log above";
}

render::FloatImage GlTest::draw(const render::Scene& scene, const render::Camera& camera, int width,
                                int height, render::Settings settings) {
    settings.width = width;
    settings.height = height;
    renderer_->render(scene, camera, settings);
    return renderer_->readRadiance();
}

}  // namespace hazer::test
