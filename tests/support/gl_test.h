// A base for tests that draw: one context for the whole program, and no GL error may happen in a test.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "render/gl/headless_context.h"
#include "render/renderer.h"

namespace hazer::test {

/// Draws with one shared Renderer on a surfaceless context. Skips, with the reason, where there is no
/// OpenGL 4.1.
class GlTest : public testing::Test {
 protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;
    void TearDown() override;

    render::Renderer& renderer() { return *renderer_; }

    /// Radiance of a scene, `width` x `height`.
    render::FloatImage draw(const render::Scene& scene, const render::Camera& camera, int width, int height,
                            render::Settings settings = {});

 private:
    static std::unique_ptr<render::gl::HeadlessContext> context_;
    static std::unique_ptr<render::Renderer> renderer_;
    static std::string whyNot_;
    int errorsBefore_ = 0;
};

/// The folder with the project's shaders, found from this source file's tree (compiled in by CMake).
std::filesystem::path shaderFolder();

}  // namespace hazer::test
