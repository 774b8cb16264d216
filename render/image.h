// Pictures in memory, and in and out of files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace hazer::render {

/// Linear light, RGB interleaved, row 0 on top. Scene radiance in cd/m^2, Rec. 709 primaries (what an OpenEXR
/// file without chromaticities means); saturated colours may have negative components.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;

    const float* at(int x, int y) const {
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        return rgb.data() + 3 * pixel;
    }
};

/// Display-ready sRGB, 8 bits, RGB interleaved, row 0 on top.
struct ByteImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Largest picture that is read: number of pixels, so that a broken header cannot ask for all memory.
inline constexpr std::size_t kMaxImagePixels = std::size_t{1} << 26;

/// Write a picture; radiance goes to .exr (32-bit float), display pictures to .png. They write to a temporary
/// name beside the target and rename, so that a full disk leaves no half picture and an older one stands.
/// Throw RenderError.
void writeImage(const FloatImage& image, const std::filesystem::path& file);
void writeImage(const ByteImage& image, const std::filesystem::path& file);

/// Read a picture of any format that OpenImageIO knows; grey becomes RGB, further channels (alpha) are left
/// out. Values are taken as they stand in the file. Throw RenderError if it is missing, broken or has more
/// than kMaxImagePixels.
FloatImage readFloatImage(const std::filesystem::path& file);
ByteImage readByteImage(const std::filesystem::path& file);

}  // namespace hazer::render
