#include "app/bare_light.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <map>
#include <string_view>

#include "app/toml_reader.h"
#include "fixtures/container.h"
#include "fixtures/parse_error.h"
#include "fixtures/wheel_image.h"
#include "render/error.h"
#include "render/ies_web.h"

namespace hazer::app {
namespace {

constexpr std::size_t kMostPictureBytes = 16u * 1024u * 1024u;

fixtures::Bytes read(const std::filesystem::path& file, std::size_t maxBytes) {
    if (std::filesystem::is_directory(file)) {
        throw fixtures::ParseError(fmt::format("{}: is a folder; name the file in it", file.string()));
    }
    return fixtures::readFile(file, maxBytes);
}

/// The files of a show's lights as handles.
class LightFiles {
 public:
    LightFiles(const Show& show, render::AssetSink& assets) : show_(show), assets_(assets) {}

    /// The light's beam with its handles.
    render::Beam beamOf(const ShowLight& light) {
        render::Beam beam = light.beam;
        if (!light.goboFile.empty()) beam.gobo = goboFor(light.goboFile);
        if (!light.webFile.empty()) beam.web = webFor(light);
        return beam;
    }

 private:
    struct KnownWeb {
        render::WebId id;
        double fieldHalfAngleRad;
    };

    render::GoboId goboFor(const std::filesystem::path& file) {
        const auto known = gobos_.find(file);
        if (known != gobos_.end()) return known->second;
        const fixtures::WheelImage image =
            fixtures::decodeWheelImage(read(file, kMostPictureBytes), file.string());
        const render::GoboId gobo = assets_.addGobo(image.rgba.data(), image.width, image.height);
        return gobos_.emplace(file, gobo).first->second;
    }

    render::WebId webFor(const ShowLight& light) {
        auto known = webs_.find(light.webFile);
        if (known == webs_.end()) known = webs_.emplace(light.webFile, addWeb(light)).first;
        if (!light.goboFile.empty() && known->second.fieldHalfAngleRad > kWidestGoboRad) {
            throw render::RenderError(
                fmt::format("{}: is too wide a beam for a gobo; leave 'gobo' out", light.webFile.string()));
        }
        return known->second.id;
    }

    KnownWeb addWeb(const ShowLight& light) {
        const fixtures::Bytes bytes = read(light.webFile, render::kMaxIesBytes);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const render::IesWeb web = render::parseIesWeb(text, light.webFile.string());
        if (!web.warning.empty()) {
            spdlog::warn("{}:{}: {}: {}", show_.file.string(), light.line, light.webFile.string(),
                         web.warning);
        }
        return {assets_.addWeb(web), web.fieldHalfAngleRad};
    }

    const Show& show_;
    render::AssetSink& assets_;
    std::map<std::filesystem::path, render::GoboId> gobos_;
    std::map<std::filesystem::path, KnownWeb> webs_;
};

}  // namespace

std::vector<render::Beam> lightBeams(const Show& show, render::AssetSink& assets) {
    LightFiles files(show, assets);
    std::vector<render::Beam> beams;
    for (const ShowLight& light : show.lights) {
        try {
            beams.push_back(files.beamOf(light));
        } catch (const fixtures::ParseError& error) {
            failInShow(show.file, light.line, error.what());
        } catch (const render::RenderError& error) {
            failInShow(show.file, light.line, error.what());
        }
    }
    return beams;
}

}  // namespace hazer::app
