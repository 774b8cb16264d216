#include "app/report/oracle_air.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/camera.h"
#include "render/glsl_as_cpp.h"
#include "render/oracle/scene_oracle.h"
#include "render/scene_plan.h"

namespace hazer::app {
namespace {

using render::oracle::SceneOracle;

double sum(const glm::dvec3& color) {
    return color.x + color.y + color.z;
}

/// A beam that is drawn as a line where it is thin: there a pixel holds the mean of the rays around it, by
/// the filter of shaders/include/beam_line_filter.glsl.
class FilteredAir {
 public:
    FilteredAir(const SceneOracle& oracle, const render::Beam& beam, const render::Camera& camera, int size)
        : oracle_(oracle), shape_(render::beamShape(beam)), camera_(camera), size_(size) {
        const glm::dvec3 axis = beam.worldFromBeam * glm::dvec3(0.0, 0.0, -1.0);
        const glm::dvec3 lens = pictureOf(beam.lensPositionM);
        const glm::dvec3 beyond = pictureOf(beam.lensPositionM + axis);
        hasAxis_ =
            lens.z > 0.0 && beyond.z > 0.0 && glm::distance(glm::dvec2(lens), glm::dvec2(beyond)) > 0.1;
        lensPx_ = glm::dvec2(lens);
        lensDepthM_ = lens.z;
        depthPerM_ = beyond.z - lens.z;
        along_ = glm::normalize(glm::dvec2(beyond - lens));
        pxM2_ = glm::distance(glm::dvec2(lens), glm::dvec2(beyond)) * lens.z * beyond.z;
    }

    /// Negative where there is no answer: where the beam is on its way from a line to rays.
    double light(const glm::ivec2& pixel) const {
        constexpr double kWidestLinePx = 1.8;
        constexpr double kNarrowestRaysPx = 4.2;
        if (!hasAxis_) return -1.0;
        const glm::dvec2 center = glm::dvec2(pixel) + 0.5;
        const double radiusPx = radiusAt(glm::dot(center - lensPx_, along_));
        if (radiusPx > kNarrowestRaysPx) return sum(oracle_.air(center.x, center.y));
        return radiusPx > kWidestLinePx ? -1.0 : filtered(center);
    }

 private:
    /// Place [px] and depth [m].
    glm::dvec3 pictureOf(const glm::dvec3& pointM) const {
        const glm::dvec3 view = glm::transpose(render::worldFromView(camera_)) * (pointM - camera_.positionM);
        const double perPixel = -view.z * 2.0 * render::viewTangent(camera_, 1.0).y / size_;
        return {0.5 * size_ + view.x / perPixel, 0.5 * size_ - view.y / perPixel, -view.z};
    }

    /// Radius of the beam [px] where its axis is this far from its lens in the picture.
    double radiusAt(double fromLensPx) const {
        const double fromLensM = std::max(
            fromLensPx * lensDepthM_ * lensDepthM_ / (pxM2_ - fromLensPx * lensDepthM_ * depthPerM_), 0.0);
        const double radiusM = (shape_.apexToLensM + fromLensM) * std::tan(shape_.cutHalfAngleRad);
        const double depthM = lensDepthM_ + fromLensM * depthPerM_;
        return radiusM / depthM * size_ / (2.0 * render::viewTangent(camera_, 1.0).y);
    }

    /// Rays across the beam, denser towards its edges, over the filter's reach along it.
    double filtered(const glm::dvec2& center) const {
        constexpr int kAlong = 10;
        constexpr int kAcross = 64;
        render::glsl::Formulas<double> formulas;
        const double reach = formulas.LINE_REACH;
        const glm::dvec2 across(along_.y, -along_.x);
        const double awayPx = glm::dot(center - lensPx_, across);
        double light = 0.0;
        for (int i = 0; i < kAlong; ++i) {
            const double ahead = reach * (2.0 * (i + 0.5) / kAlong - 1.0);
            const double alongPx = glm::dot(center - lensPx_, along_) + ahead;
            const double widest = 1.5 * radiusAt(alongPx);
            for (int k = 0; k < kAcross; ++k) {
                const double angle = std::numbers::pi * (k + 0.5) / kAcross;
                const double place = widest * std::cos(angle);
                const double share = formulas.lineFilter(place - awayPx) * formulas.lineFilter(ahead) *
                                     widest * std::sin(angle);
                if (share == 0.0) continue;
                const glm::dvec2 at = lensPx_ + alongPx * along_ + place * across;
                light += share * sum(oracle_.air(at.x, at.y));
            }
        }
        return light * std::numbers::pi / kAcross * 2.0 * reach / kAlong;
    }

    const SceneOracle& oracle_;
    render::BeamShape shape_;
    render::Camera camera_;
    int size_;
    bool hasAxis_ = false;
    glm::dvec2 lensPx_{0.0};
    double lensDepthM_ = 1.0;
    double depthPerM_ = 0.0;
    glm::dvec2 along_{1.0, 0.0};
    double pxM2_ = 1.0;  ///< Pixels from the lens times both depths, over metres from the lens.
};

bool isDrawnAsLine(const render::Scene& scene, const render::Camera& camera, int size,
                   const std::vector<render::Mesh>& meshes) {
    render::Settings settings;
    settings.width = settings.height = size;
    std::vector<render::MeshBounds> bounds;
    for (const render::Mesh& mesh : meshes)
        bounds.push_back({render::boundingSphere(mesh), render::boundingBox(mesh)});
    return scene.beams.size() == 1 &&
           render::usesFeature(render::planScene(scene, camera, settings, bounds), render::kFeatureLine);
}

}  // namespace

std::vector<double> oracleAir(const render::Scene& scene, const render::Camera& camera, int size,
                              const std::vector<render::Mesh>& meshes,
                              const std::vector<glm::ivec2>& pixels) {
    render::oracle::Library library;
    library.meshes = meshes;
    const SceneOracle oracle(scene, camera, size, size, std::move(library));
    const bool isLine = isDrawnAsLine(scene, camera, size, meshes);
    std::vector<double> light;
    for (const glm::ivec2& pixel : pixels) {
        const glm::dvec2 center = glm::dvec2(pixel) + 0.5;
        if (!oracle.isClearOfOutlines(center.x, center.y)) {
            light.push_back(-1.0);
        } else if (isLine) {
            light.push_back(FilteredAir(oracle, scene.beams.front(), camera, size).light(pixel));
        } else {
            light.push_back(sum(oracle.air(center.x, center.y)));
        }
    }
    return light;
}

}  // namespace hazer::app
