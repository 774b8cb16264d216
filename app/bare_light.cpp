#include "app/bare_light.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "app/toml_reader.h"
#include "fixtures/container.h"
#include "fixtures/parse_error.h"
#include "fixtures/wheel_image.h"

namespace hazer::app {
namespace {

constexpr std::size_t kMostPictureBytes = 16u * 1024u * 1024u;

render::GoboId addGobo(const std::filesystem::path& file, render::AssetSink& assets) {
    if (std::filesystem::is_directory(file)) {
        throw fixtures::ParseError(fmt::format("{}: is a folder; name the picture in it", file.string()));
    }
    const fixtures::Bytes bytes = fixtures::readFile(file, kMostPictureBytes);
    const fixtures::WheelImage image = fixtures::decodeWheelImage(bytes, file.string());
    return assets.addGobo(image.rgba.data(), image.width, image.height);
}

}  // namespace

std::vector<render::Beam> lightBeams(const Show& show, render::AssetSink& assets) {
    std::map<std::filesystem::path, render::GoboId> gobos;
    std::vector<render::Beam> beams;
    for (const ShowLight& light : show.lights) {
        render::Beam& beam = beams.emplace_back(light.beam);
        if (light.goboFile.empty()) continue;
        try {
            const auto [gobo, isNew] = gobos.try_emplace(light.goboFile, -1);
            if (isNew) gobo->second = addGobo(light.goboFile, assets);
            beam.gobo = gobo->second;
        } catch (const fixtures::ParseError& error) {
            failInShow(show.file, light.line, error.what());
        }
    }
    return beams;
}

}  // namespace hazer::app
