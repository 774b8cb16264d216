// A film file, made by the ffmpeg program, which is looked for when it is needed.
#pragma once

#include <filesystem>
#include <memory>

#include "render/image.h"

namespace hazer::app {

/// Is there an ffmpeg on PATH?
bool canMakeFilms();

/// What a film file is made of: H.264, 4:2:0, in the container that the file's extension names.
struct FilmFormat {
    int width = 640;   ///< Even, as 4:2:0 needs.
    int height = 360;  ///< Even.
    double framesPerS = 25.0;
};

/// Writes a film frame by frame. The file appears when it is whole: until finish() it has another name, and
/// without finish() it goes away.
class Film {
 public:
    /// Throws std::runtime_error if there is no ffmpeg, or if the size is odd.
    Film(std::filesystem::path file, const FilmFormat& format);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// The picture has the size of the format. Throws std::runtime_error if ffmpeg has ended.
    void add(const render::ByteImage& picture);

    /// Waits for ffmpeg and gives the file its name. Throws std::runtime_error if ffmpeg failed.
    void finish();

 private:
    struct Encoder;
    std::filesystem::path file_;
    std::filesystem::path unfinished_;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace hazer::app
