// The exceptions of the render module.
#pragma once

#include <stdexcept>

namespace hazer::render {

/// Something a person can mend: a missing shader, a picture that cannot be read or written. what() is one
/// sentence.
class RenderError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// No OpenGL 4.1 core context can be had. what() says why and what to try.
class NoGlError : public RenderError {
 public:
    using RenderError::RenderError;
};

}  // namespace hazer::render
