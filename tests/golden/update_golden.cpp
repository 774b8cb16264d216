// Draws the scenes of scenes.json anew and replaces their reference pictures. Arguments: names of scenes;
// none: all.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/gl/headless_context.h"
#include "tests/golden/scene_list.h"
#include "tests/support/image_compare.h"

namespace hazer::test {
namespace {

namespace fs = std::filesystem;

/// Half floats keep 11 bits, ten times finer than any tolerance, in half the space of what writeImage stores.
void writeHalf(const render::FloatImage& image, const fs::path& file) {
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeHalf);
    spec.attribute("compression", "zip");
    const auto output = OIIO::ImageOutput::create(file.string());
    if (!output || !output->open(file.string(), spec) ||
        !output->write_image(OIIO::TypeFloat, image.rgb.data()) || !output->close()) {
        throw std::runtime_error(fmt::format("cannot write '{}': {}", file.string(), OIIO::geterror()));
    }
}

double mean(const render::FloatImage& image) {
    double sum = 0.0;
    for (const float value : image.rgb) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.rgb.size());
}

void printChange(const GoldenScene& scene, const render::FloatImage& after) {
    if (!fs::exists(radianceReference(scene))) {
        fmt::print("{}: new, mean {:.6g} cd/m2\n", scene.name, mean(after));
        return;
    }
    const render::FloatImage before = render::readFloatImage(radianceReference(scene));
    if (before.width != after.width || before.height != after.height) {
        fmt::print("{}: {} x {} becomes {} x {}\n", scene.name, before.width, before.height, after.width,
                   after.height);
        return;
    }
    const Comparison change = compareImages(after, before, scene.radiance);
    fmt::print("{}: mean {:.6g} -> {:.6g} cd/m2; {}\n", scene.name, mean(before), mean(after),
               describe(change, after, before));
}

void update(const GoldenScene& scene) {
    const GoldenPictures pictures = drawScene(scene);
    if (!std::all_of(pictures.radiance.rgb.begin(), pictures.radiance.rgb.end(),
                     [](float value) { return std::isfinite(value); })) {
        throw std::runtime_error(scene.name + ": a pixel is not finite; the reference stays as it is");
    }
    printChange(scene, pictures.radiance);
    fs::create_directories(referenceFolder());
    writeHalf(pictures.radiance, radianceReference(scene));
    writeImage(pictures.display, displayReference(scene));
}

void updateAll(const std::vector<std::string>& names) {
    const render::gl::HeadlessContext context;
    std::vector<std::string> unknown = names;
    for (const GoldenScene& scene : loadScenes()) {
        if (!names.empty() && std::find(names.begin(), names.end(), scene.name) == names.end()) continue;
        std::erase(unknown, scene.name);
        update(scene);
    }
    if (!unknown.empty())
        throw std::runtime_error("there is no scene '" + unknown.front() + "' in scenes.json");
}

}  // namespace
}  // namespace hazer::test

int main(int argumentCount, char** arguments) {
    try {
        hazer::test::updateAll({arguments + 1, arguments + argumentCount});
    } catch (const std::exception& error) {
        fmt::print(stderr, "update_golden: {}\n", error.what());
        return 2;
    }
    return 0;
}
