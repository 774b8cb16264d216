#include "render/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "render/error.h"

namespace hazer::render {
namespace {

namespace fs = std::filesystem;

constexpr int kChannels = 3;

RenderError cannotWrite(const fs::path& file, std::string_view reason) {
    return RenderError(fmt::format("cannot write picture '{}': {}", file.string(), reason));
}

RenderError cannotRead(const fs::path& file, std::string_view reason) {
    return RenderError(fmt::format("cannot read picture '{}': {}", file.string(), reason));
}

std::string lastSystemError() {
    return std::generic_category().message(errno);
}

void requireFolderOf(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
        throw cannotWrite(file, fmt::format("there is no folder '{}'; create it first", folder.string()));
    }
}

void requireExtension(const fs::path& file, std::string_view extension, std::string_view content) {
    std::string found = file.extension().string();
    for (char& letter : found) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (found != extension) {
        throw cannotWrite(file, fmt::format("a {} is written as {}, not as '{}'; change the extension",
                                            content, extension, file.extension().string()));
    }
}

/// Encodes in memory, so that whatever goes wrong while storing is seen by us with the system's reason.
std::vector<unsigned char> encode(const fs::path& file, const std::string& format,
                                  const OIIO::ImageSpec& spec, const void* pixels) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format, &memory);
    if (!output) throw cannotWrite(file, OIIO::geterror());
    const bool written =
        output->open(file.filename().string(), spec) && output->write_image(spec.format, pixels);
    const bool closed = output->close();
    if (!written || !closed) throw cannotWrite(file, output->geterror());
    return bytes;
}

fs::path temporaryNameBeside(const fs::path& file) {
    fs::path temporary = file;
    temporary += fmt::format(".{:08x}.part", std::random_device{}());
    return temporary;
}

void store(std::span<const unsigned char> bytes, const fs::path& temporary, const fs::path& file) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) throw cannotWrite(file, lastSystemError());
    fs::rename(temporary, file);
}

void storeWhole(std::span<const unsigned char> bytes, const fs::path& file) {
    const fs::path temporary = temporaryNameBeside(file);
    try {
        store(bytes, temporary, file);
    } catch (const fs::filesystem_error& error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw cannotWrite(file, error.code().message());
    } catch (const RenderError&) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

template <typename Image>
OIIO::ImageSpec specOf(const Image& image, OIIO::TypeDesc type) {
    assert(image.width > 0 && image.height > 0);
    assert(image.rgb.size() ==
           static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * kChannels);
    return OIIO::ImageSpec(image.width, image.height, kChannels, type);
}

/// Repeats the only channel of a grey picture, or drops what comes after blue.
template <typename Value>
std::vector<Value> toRgb(const std::vector<Value>& values, int channels) {
    const auto stride = static_cast<std::size_t>(channels);
    const std::size_t green = channels >= kChannels ? 1 : 0;
    const std::size_t blue = channels >= kChannels ? 2 : 0;
    std::vector<Value> rgb;
    rgb.reserve(values.size() / stride * kChannels);
    for (std::size_t i = 0; i < values.size(); i += stride) {
        rgb.insert(rgb.end(), {values[i], values[i + green], values[i + blue]});
    }
    return rgb;
}

void requireReadableSize(const fs::path& file, const OIIO::ImageSpec& spec) {
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1) {
        throw cannotRead(file, "it is not a flat picture");
    }
    if (spec.image_pixels() > kMaxImagePixels) {
        throw cannotRead(file,
                         fmt::format("{} x {} pixels are more than the {} that are allowed; make it smaller",
                                     spec.width, spec.height, kMaxImagePixels));
    }
}

template <typename Image, typename Value>
Image readImage(const fs::path& file, OIIO::TypeDesc type) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) throw cannotRead(file, "there is no such file");
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw cannotRead(file, OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    requireReadableSize(file, spec);
    const int channels = std::min(spec.nchannels, kChannels + 1);
    std::vector<Value> values(spec.image_pixels() * static_cast<std::size_t>(channels));
    if (!input->read_image(0, 0, 0, channels, type, values.data())) throw cannotRead(file, input->geterror());
    return Image{spec.width, spec.height, toRgb(values, channels)};
}

}  // namespace

void writeImage(const FloatImage& image, const fs::path& file) {
    requireExtension(file, ".exr", "picture of radiance");
    requireFolderOf(file);
    storeWhole(encode(file, "openexr", specOf(image, OIIO::TypeFloat), image.rgb.data()), file);
}

void writeImage(const ByteImage& image, const fs::path& file) {
    requireExtension(file, ".png", "display picture");
    requireFolderOf(file);
    OIIO::ImageSpec spec = specOf(image, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    storeWhole(encode(file, "png", spec, image.rgb.data()), file);
}

FloatImage readFloatImage(const fs::path& file) {
    return readImage<FloatImage, float>(file, OIIO::TypeFloat);
}

ByteImage readByteImage(const fs::path& file) {
    return readImage<ByteImage, std::uint8_t>(file, OIIO::TypeUInt8);
}

}  // namespace hazer::render
