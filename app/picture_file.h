// Pictures of the last frame as files.
#pragma once

#include <filesystem>

#include "render/renderer.h"

namespace hazer::app {

enum class OutputKind { kPicture, kFilm };

/// What the extension asks for: .png and .exr are pictures, .mp4 a film. Throws std::runtime_error on
/// anything else.
OutputKind outputKind(const std::filesystem::path& file);

/// Writes the last frame: .exr holds the scene's light in cd/m^2, .png what a screen shows. Makes the folder
/// if it is missing. Throws render::RenderError or as makeFolder().
void writePicture(render::Renderer& renderer, const std::filesystem::path& file);

/// The name of one of many frames: %d or %04d in the file's name becomes the index; without it, _0000 is put
/// before the extension.
std::filesystem::path numberedFile(const std::filesystem::path& file, int index);

/// Makes a folder, and those that it lies in, if it is missing. Throws std::runtime_error.
void makeFolder(const std::filesystem::path& folder);

/// Makes the folder that the file will lie in. Throws as makeFolder().
void makeFolderOf(const std::filesystem::path& file);

}  // namespace hazer::app
