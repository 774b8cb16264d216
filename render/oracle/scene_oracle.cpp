#include "render/oracle/scene_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "render/camera.h"

namespace hazer::render::oracle {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A ray that meets nothing ends here; see docs/rendering.md.
constexpr double kSkyM = 1e5;

/// Parts of a stretch where a gobo, a web or uneven haze leaves the integrand with kinks.
constexpr int kUnevenParts = 48;

/// What of a share of light, scattered with the mean cosine g and the mean square g^2 (second Legendre
/// moment), is left when the second moment goes straight on.
struct Lobe {
    double share;
    double meanCosine;
};

Lobe withoutPeak(const Lobe& lobe) {
    const double straightOn = lobe.share * lobe.meanCosine * lobe.meanCosine;
    const double left = lobe.share - straightOn;
    return {left, (lobe.share * lobe.meanCosine - straightOn) / left};
}

HazeModel hazeModel(const Haze& haze) {
    Lobe forward{haze.phase.forwardWeight, haze.phase.forwardG};
    const double backwardShare = 1.0 - forward.share;
    if (haze.deltaEddington && forward.share * forward.meanCosine > 0.0) forward = withoutPeak(forward);
    const double scattered = forward.share + backwardShare;
    const double scatteringPerM = haze.scatteringPerM * scattered;
    const double absorptionPerM = static_cast<double>(haze.extinctionPerM) - haze.scatteringPerM;
    return {std::max(absorptionPerM + scatteringPerM, 0.0), scatteringPerM, forward.meanCosine,
            haze.phase.backwardG, forward.share / scattered};
}

/// Schlick's Fresnel term of a coat that reflects `headOn`, and along itself all, or fifty times as much.
double fresnel(double cosine, double headOn) {
    return glm::mix(headOn, std::min(1.0, 50.0 * headOn), std::pow(1.0 - cosine, 5.0));
}

double tangentOf(double cosine) {
    return std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) / cosine;
}

/// A rough coat over a diffuse ground [1/sr], by the book (Walter et al. 2007; Heitz 2014): the distribution
/// of Trowbridge and Reitz with Smith's shadowing told by the tangents of the angles.
glm::dvec3 reflectancePerSr(const Material& material, const glm::dvec3& normal, const glm::dvec3& toLamp,
                            const glm::dvec3& toEye) {
    const double headOn = material.specular;
    const double cosIn = glm::dot(normal, toLamp);
    const double cosOut = std::max(glm::dot(normal, toEye), 1e-4);
    const glm::dvec3 halfway = glm::normalize(toLamp + toEye);
    const double cosHalf = glm::dot(normal, halfway);
    const double roughness = std::sqrt(2.0 / (material.shininess + 2.0));
    const double slope = tangentOf(cosHalf) / roughness;
    const double distribution =
        1.0 / (kPi * std::pow(roughness * cosHalf * cosHalf * (1.0 + slope * slope), 2.0));
    const auto hidden = [roughness](double cosine) {
        return 0.5 * (std::hypot(1.0, roughness * tangentOf(cosine)) - 1.0);
    };
    const double shadowing = 1.0 / (1.0 + hidden(cosIn) + hidden(cosOut));
    const double glossy =
        fresnel(glm::dot(halfway, toLamp), headOn) * distribution * shadowing / (4.0 * cosIn * cosOut);
    const double ground = (1.0 - fresnel(cosIn, headOn)) * (1.0 - fresnel(cosOut, headOn)) / kPi;
    return glm::dvec3(material.albedo) * ground + glossy;
}

}  // namespace

SceneOracle::SceneOracle(Scene scene, const Camera& camera, int width, int height, Library library)
    : scene_(std::move(scene)),
      camera_(camera),
      width_(width),
      height_(height),
      pixelRad_(2.0 * std::tan(0.5 * camera.verticalFovRad) / height),
      library_(std::move(library)),
      haze_(hazeModel(scene_.haze)),
      bodies_(scene_, library_.meshes, camera.positionM) {
    for (const Beam& beam : scene_.beams) lamps_.push_back(makeLamp(beam, library_.webs));
}

Ray SceneOracle::worldRay(double x, double y) const {
    const glm::dvec3 inView((x - 0.5 * width_) * pixelRad_, (0.5 * height_ - y) * pixelRad_, -1.0);
    return {camera_.positionM, worldFromView(camera_) * glm::normalize(inView), kSkyM};
}

bool SceneOracle::isClearOfOutlines(double x, double y) const {
    const auto firstHit = [this](const Ray& ray) { return bodies_.firstHit(ray.originM, ray.direction); };
    const auto here = firstHit(worldRay(x, y));
    static constexpr std::array<glm::dvec2, 4> kBeside{
        {{0.01, 0.0}, {-0.01, 0.0}, {0.0, 0.01}, {0.0, -0.01}}};
    return std::all_of(kBeside.begin(), kBeside.end(), [&](const glm::dvec2& step) {
        const auto beside = firstHit(worldRay(x + step.x, y + step.y));
        if (!here || !beside) return here.has_value() == beside.has_value();
        return here->instance == beside->instance &&
               std::abs(here->distanceM - beside->distanceM) < 0.01 * here->distanceM;
    });
}

const GoboPicture* SceneOracle::goboOf(const Lamp& lamp) const {
    return lamp.beam.gobo < 0 ? nullptr : &library_.gobos[static_cast<std::size_t>(lamp.beam.gobo)];
}

glm::dvec3 SceneOracle::air(double x, double y) const {
    Ray ray = worldRay(x, y);
    if (const auto hit = bodies_.firstHit(ray.originM, ray.direction)) ray.endM = hit->distanceM;
    glm::dvec3 sum(0.0);
    for (const Lamp& lamp : lamps_) sum += airOf(lamp, ray);
    return sum;
}

std::vector<Stretch> SceneOracle::litPieces(const Lamp& lamp, const Ray& inLamp, int parts) const {
    std::vector<Stretch> pieces;
    for (const Stretch& smooth : smoothStretches(lamp.model, inLamp)) {
        for (const Stretch& lit : litParts(lamp, bodies_, inLamp, smooth)) {
            const std::vector<Stretch> split = splitByAngle(inLamp, lit, parts);
            pieces.insert(pieces.end(), split.begin(), split.end());
        }
    }
    return pieces;
}

glm::dvec3 SceneOracle::airOf(const Lamp& lamp, const Ray& ray) const {
    const Ray inLamp = lamp.inLamp(ray);
    const GoboPicture* gobo = goboOf(lamp);
    const bool isUneven = gobo != nullptr || library_.density || lamp.model.web;
    const std::vector<Stretch> lit = litPieces(lamp, inLamp, isUneven ? kUnevenParts : 1);
    const bool isGrey = gobo == nullptr || gobo->isGrey();
    glm::dvec3 radiance(0.0);
    for (int channel = 0; channel < (isGrey ? 1 : 3); ++channel) {
        const auto transmission = [&](double t) {
            const double dense = library_.density ? library_.density(ray.originM + t * ray.direction) : 1.0;
            if (gobo == nullptr) return dense;
            return dense *
                   throughGobo(lamp, *gobo, inLamp.originM + t * inLamp.direction, pixelRad_ * t)[channel];
        };
        radiance[channel] = airRadiance(lamp.model, haze_, inLamp, lit, transmission);
    }
    if (isGrey) radiance = glm::dvec3(radiance.x);
    return radiance * lamp.shape.peakCd * glm::dvec3(lamp.beam.color);
}

glm::dvec3 SceneOracle::surface(double x, double y) const {
    const Ray ray = worldRay(x, y);
    const auto hit = bodies_.firstHit(ray.originM, ray.direction);
    if (!hit) return scene_.backgroundCdPerM2;
    const Ambient& ambient = scene_.ambient;
    glm::dvec3 light = glm::dvec3(scene_.instances[hit->instance].material.albedo * ambient.color) *
                       (ambient.illuminanceLx / kPi);
    for (const Lamp& lamp : lamps_) light += surfaceOf(lamp, ray, *hit);
    return light * std::exp(-haze_.extinctionPerM * hit->distanceM);
}

glm::dvec3 SceneOracle::surfaceOf(const Lamp& lamp, const Ray& ray, const BodyPoint& hit) const {
    const glm::dvec3 pointM = ray.originM + hit.distanceM * ray.direction;
    const glm::dvec3 inLampM = lamp.inLamp(pointM);
    const glm::dvec3 toLamp = glm::normalize(lamp.apexM - pointM);
    const double cosIn = glm::dot(hit.normal, toLamp);
    const double intensityCd = intensityTowards(lamp.model, inLampM) * lamp.shape.peakCd;
    // The body itself begins where the light ends: the last hundredth of a per cent of the way is left out.
    if (cosIn <= 0.0 || intensityCd <= 0.0 || !isLit(lamp, bodies_, inLampM, 1.0 - 1e-4)) {
        return glm::dvec3(0.0);
    }
    glm::dvec3 lux(intensityCd * cosIn / glm::dot(inLampM, inLampM) *
                   std::exp(-haze_.extinctionPerM * wayFromLensM(lamp.model, inLampM)));
    if (const GoboPicture* gobo = goboOf(lamp)) {
        const double slant = std::max(-glm::dot(ray.direction, hit.normal), 0.2);
        lux *= throughGobo(lamp, *gobo, inLampM, pixelRad_ * hit.distanceM / slant);
    }
    const glm::dvec3 reflectance =
        reflectancePerSr(scene_.instances[hit.instance].material, hit.normal, toLamp, -ray.direction);
    return lux * reflectance * glm::dvec3(lamp.beam.color);
}

}  // namespace hazer::render::oracle
