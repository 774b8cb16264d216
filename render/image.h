// Pictures in memory, and in and out of files (OpenImageIO).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hazer::render {

/// Linear light, RGB interleaved, row 0 on top. Scene radiance in cd/m^2, Rec. 709 primaries (what an OpenEXR file without
/// chromaticities means); saturated colours may have negative components.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;

    const float* at(int x, int y) const { return rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)); }
};

/// Display-ready sRGB, 8 bits, RGB interleaved, row 0 on top.
struct ByteImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Write a picture; the extension chooses the format (.exr: 32-bit float; .png). They write to a temporary name beside the target
/// and rename, so that a full disk leaves no half picture. Throw RenderError.
void writeImage(const FloatImage& image, const std::filesystem::path& file);
void writeImage(const ByteImage& image, const std::filesystem::path& file);

FloatImage readFloatImage(const std::filesystem::path& file);
ByteImage readByteImage(const std::filesystem::path& file);

}  // namespace hazer::render
