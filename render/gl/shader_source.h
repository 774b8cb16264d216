// Shader text: files, their #includes, and the features a variant is compiled with. No GL.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hazer::render::gl {

/// Reads a shader and everything that it includes (`#include "include/x.glsl"`, relative to `folder`, each
/// file once), and puts a
/// `#define NAME 1` for each feature after the #version line. Compiler messages keep the line numbers of the
/// file that they name. Throws RenderError with file and line for a missing file.
std::string expandShader(const std::filesystem::path& folder, const std::string& file,
                         const std::vector<std::string>& features);

}  // namespace hazer::render::gl
