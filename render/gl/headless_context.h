// An OpenGL context without a window or a display: EGL on the surfaceless platform.
#pragma once

#include <memory>
#include <string>

namespace hazer::render::gl {

/// Makes a 4.1 core context current on this thread for its lifetime. Throws NoGlError.
class HeadlessContext {
 public:
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Renderer and version of the current context, such as "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
std::string describeContext();

}  // namespace hazer::render::gl
