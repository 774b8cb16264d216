#include "app/scenery.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "app/paint.h"
#include "fixtures/mvr.h"
#include "fixtures/parse_error.h"
#include "fixtures/text.h"
#include "render/error.h"
#include "render/rig_mesh.h"

namespace hazer::app {
namespace {

constexpr std::size_t kMaxMeshBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxVertices = 3'000'000;  // Of all files together.
constexpr const char* kTooMany = "all meshes together have too many vertices";
constexpr std::size_t kMostWarnings = 20;
/// What has no colour is drawn in a grey that neither shines nor hides what hangs in front.
const render::Color kSceneryPaint(0.3f);
/// Less than this is flat, and has no shape that light could fall on.
constexpr double kSmallestVolume = 1e-18;

/// A part of a mesh file that has one paint.
struct SceneryPart {
    render::MeshId mesh = -1;
    render::Material material;
};

class SceneryReader {
 public:
    SceneryReader(const ShowScenery& scenery, render::AssetSink& assets)
        : scenery_(scenery), archive_(scenery.archive), assets_(assets), parts_(scenery.files.size()) {}

    void appendTo(SetDressing& dressing) {
        for (const ShowScenery::Use& use : scenery_.uses) {
            if (std::abs(glm::determinant(glm::dmat3(use.worldFromMesh))) < kSmallestVolume) continue;
            for (const SceneryPart& part : partsOf(use.file))
                dressing.push_back({{part.mesh, use.worldFromMesh, part.material, true}, false});
        }
    }

    std::vector<std::string> warnings() const {
        std::vector<std::string> sentences = warnings_;
        if (sentences.size() > kMostWarnings) {
            const std::size_t more = sentences.size() - kMostWarnings;
            sentences.resize(kMostWarnings);
            sentences.push_back(fmt::format("{} more meshes are left out.", more));
        }
        return sentences;
    }

 private:
    using Parts = std::vector<SceneryPart>;

    // None where there is nothing to draw.
    const Parts& partsOf(std::size_t file) {
        std::optional<Parts>& parts = parts_[file];
        if (!parts) parts = read(scenery_.files[file]);
        return *parts;
    }

    Parts read(const std::string& name) {
        const auto entry = archive_.find(name, {".3ds", ".glb"});
        if (!entry) return leaveOut(name, "it is not in the rig");
        if (vertices_ > kMaxVertices) return leaveOut(name, kTooMany);
        try {
            const std::vector<render::PaintedMesh> meshes =
                render::parseRigMesh(archive_.read(*entry, kMaxMeshBytes), archive_.nameOf(*entry));
            for (const render::PaintedMesh& painted : meshes) vertices_ += painted.mesh.vertices.size();
            if (vertices_ > kMaxVertices) return leaveOut(name, kTooMany);
            Parts parts;
            for (const render::PaintedMesh& painted : meshes)
                parts.push_back({assets_.addMesh(painted.mesh), materialOf(painted.paint, kSceneryPaint)});
            return parts;
        } catch (const render::RenderError& error) {
            return leaveOut(name, error.what());
        } catch (const fixtures::ParseError& error) {
            return leaveOut(name, error.what());
        }
    }

    Parts leaveOut(const std::string& name, const std::string& reason) {
        warnings_.push_back(fmt::format("the mesh {} is left out: {}.", fixtures::inQuotes(name), reason));
        return {};
    }

    const ShowScenery& scenery_;
    fixtures::MvrArchive archive_;
    render::AssetSink& assets_;
    std::vector<std::optional<Parts>> parts_;  // By file.
    std::vector<std::string> warnings_;
    std::size_t vertices_ = 0;
};

}  // namespace

std::vector<std::string> appendScenery(const ShowScenery& scenery, render::AssetSink& assets,
                                       SetDressing& dressing) {
    if (scenery.uses.empty()) return {};
    try {
        SceneryReader reader(scenery, assets);
        reader.appendTo(dressing);
        return reader.warnings();
    } catch (const fixtures::ParseError& error) {
        throw ShowError(error.what());
    }
}

}  // namespace hazer::app
