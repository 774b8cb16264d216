#include "app/beam_optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/light_color.h"
#include "render/photometry.h"

namespace hazer::app {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Widths at half the peak that frosts scatter at 1: makers have a light one first, and heavier ones after
/// it. No file says how heavy.
constexpr std::array<double, fixtures::kMaxFrosts> kFrostDeg{8.0, 16.0, 24.0};

/// Of a Gaussian: width at 10 % of the peak, and of the disc that blurs as much, over the width at 50 %.
constexpr double kTenthOverHalf = 1.8226;
constexpr double kDiscOverHalf = 1.6986;

/// Middles of neighbouring gobos on a wheel, in radii of their field.
constexpr double kGoboPitch = 2.2;

/// The part of an animation disk that the beam goes through, in radii of the disk.
constexpr double kAnimationMiddle = 0.6;
constexpr double kAnimationRadius = 0.35;

/// A beam shaper spreads an oval this much wider than high.
constexpr double kMostOval = 0.6;

constexpr double kWidestOvalRad = 1.55;

/// Barn doors stand before the lens: their edges are as soft as this, where those of blades are sharp.
constexpr double kSoftestEdge = 0.6;

constexpr std::size_t kMostCopies = 64;

/// A picture whose shortest axis is more than this of its longest is not seen to be stretched.
constexpr double kRoundPicture = 0.95;

/// Copies of a prism whose file has no facets.
constexpr int kUnknownFacets = 3;
constexpr double kUnknownFacetShift = 0.7;

glm::dvec2 turned(const glm::dvec2& v, double rad) {
    return {std::cos(rad) * v.x - std::sin(rad) * v.y, std::sin(rad) * v.x + std::cos(rad) * v.y};
}

double rounded(const fixtures::WheelState& wheel) {
    return wheel.slot - std::round(wheel.slot);
}

void appendImage(const render::ApertureImage& image, render::Aperture& aperture) {
    const auto free =
        std::ranges::find_if(aperture.images, [](const render::ApertureImage& i) { return i.gobo < 0; });
    if (free != aperture.images.end()) *free = image;
}

/// A gobo that stands in the middle is the beam's own; what moves through the beam, or lies over another one,
/// is in its aperture.
void addGobos(const fixtures::BeamState& state, const GoboLookup& goboFor, render::Beam& beam) {
    for (const fixtures::GoboState& gobo : state.gobos) {
        if (gobo.image == nullptr) continue;
        const double rotationRad = glm::radians(gobo.rotationDeg);
        const double shift = -rounded(gobo) * kGoboPitch;
        if (beam.gobo < 0 && shift == 0.0) {
            beam.gobo = goboFor(gobo.image);
            beam.goboRotationRad = rotationRad;
        } else {
            appendImage({goboFor(gobo.image), rotationRad, {shift, 0.0}, 1.0}, beam.aperture);
        }
    }
}

void addAnimation(const fixtures::AnimationState& animation, const GoboLookup& goboFor,
                  render::Aperture& aperture) {
    if (animation.image == nullptr || animation.insertion < 0.5) return;
    appendImage({goboFor(animation.image),
                 glm::radians(animation.positionDeg),
                 {-kAnimationMiddle / kAnimationRadius, 0.0},
                 1.0 / kAnimationRadius},
                aperture);
}

/// The side that a blade comes in from, before the shaper turns: -Y, -X, +Y, +X.
glm::dvec2 bladeSide(std::size_t blade) {
    return turned({0.0, -1.0}, -0.5 * kPi * static_cast<double>(blade));
}

render::ApertureEdge bladeEdge(const fixtures::BladeState& blade, const glm::dvec2& side, double shaperRad) {
    // Clockwise, a blade at -Y has its end A at +X.
    const glm::dvec2 towardsA = turned(side, 0.5 * kPi);
    const glm::dvec2 endA = side * (1.0 - 2.0 * blade.a) + towardsA;
    const glm::dvec2 endB = side * (1.0 - 2.0 * blade.b) - towardsA;
    const glm::dvec2 along = glm::normalize(endA - endB);
    const glm::dvec2 normal = turned(turned(along, -0.5 * kPi), glm::radians(blade.rotationDeg));
    return {turned(normal, shaperRad), glm::dot(normal, 0.5 * (endA + endB))};
}

void addBlades(const fixtures::ShaperState& shaper, render::Aperture& aperture) {
    for (std::size_t i = 0; i < shaper.blades.size(); ++i) {
        const fixtures::BladeState& blade = shaper.blades[i];
        if (blade.a <= 0.0 && blade.b <= 0.0) continue;
        aperture.blades[i] = bladeEdge(blade, bladeSide(i), glm::radians(shaper.rotationDeg));
    }
    aperture.softness = kSoftestEdge * shaper.softness;
}

/// The share of a beam's light that an oval lets through which is as wide as its field, and `height` as high.
double lightInOval(const render::Beam& beam, double height) {
    if (height >= 1.0) return 1.0;
    constexpr int kRings = 64;
    const render::BeamShape shape = render::beamShape(beam);
    const double fieldTangent = std::tan(std::min(shape.fieldHalfAngleRad, kWidestOvalRad));
    double inside = 0.0;
    double all = 0.0;
    for (int i = 0; i < kRings; ++i) {
        const double psiRad = shape.cutHalfAngleRad * (i + 0.5) / kRings;
        const double light = render::relativeIntensity(shape, psiRad) * std::sin(psiRad);
        const double radius = psiRad < kWidestOvalRad ? std::tan(psiRad) / fieldTangent : 1.0;
        // Where the ring meets the oval's edge.
        const double sine = (1.0 / (radius * radius) - 1.0) / (1.0 / (height * height) - 1.0);
        inside += light * 2.0 / kPi * std::asin(std::sqrt(std::clamp(sine, 0.0, 1.0)));
        all += light;
    }
    return inside / all;
}

double lightInStretch(const render::Beam& beam) {
    return lightInOval(beam, std::abs(glm::determinant(beam.aperture.stretch)));
}

/// A beam's own shape takes no light: it comes out in a smaller area.
void setShape(const fixtures::BeamState& state, render::Beam& beam) {
    render::Aperture& aperture = beam.aperture;
    if (state.type == fixtures::BeamType::kRectangle) {
        aperture.shape = render::ApertureShape::kRectangle;
        aperture.halfSize = glm::normalize(glm::dvec2(state.rectangleRatio, 1.0));
        beam.fluxLm *= 0.25 * kPi / (aperture.halfSize.x * aperture.halfSize.y);
        // As soft as a round beam of these angles is.
        aperture.softness = std::max(aperture.softness, 1.0 - beam.beamAngleRad / beam.fieldAngleRad);
    } else if (state.oval > 0.0) {
        aperture.shape = render::ApertureShape::kOval;
        aperture.halfSize = {1.0, 1.0 - kMostOval * std::min(state.oval, 1.0)};
        aperture.shapeTurnRad = glm::radians(state.ovalAngleDeg);
        beam.fluxLm /= lightInOval(beam, aperture.halfSize.y);
    }
}

/// Two colours of a wheel side by side. The beam has the brighter one of each primary, the aperture takes off
/// what either lacks.
void splitColor(const fixtures::BeamState& state, render::Beam& beam) {
    const double share = state.colorSplit.secondShare;
    if (share <= 0.0) return;
    std::array<glm::dvec3, 2> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec3& xyz = state.colorSplit.colorXyz[i];
        colors[i] = glm::dvec3(lightColorFromXyz(xyz)) * std::max(xyz.y, 0.0);
    }
    const glm::dvec3 both = glm::max(colors[0], colors[1]);
    const double light = luminance(both);
    if (!(light > 0.0)) return;
    const glm::dvec3 divisor = glm::max(both, 1e-9);
    beam.color = render::Color(both / light);
    beam.fluxLm = state.fluxLm * light;
    beam.aperture.split = {{1.0, 0.0}, 1.0 - 2.0 * share};
    beam.aperture.color = glm::vec3(colors[0] / divisor);
    beam.aperture.beyondColor = glm::vec3(colors[1] / divisor);
}

/// Scattering adds to the widths as their squares do.
void addFrost(const fixtures::BeamState& state, render::Beam& beam) {
    double squared = 0.0;
    for (std::size_t i = 0; i < kFrostDeg.size(); ++i)
        squared += std::pow(glm::radians(kFrostDeg[i]) * std::clamp(state.frosts[i], 0.0, 1.0), 2.0);
    if (squared <= 0.0) return;
    const double scattered = std::sqrt(squared);
    beam.beamAngleRad = std::hypot(beam.beamAngleRad, scattered);
    beam.fieldAngleRad =
        std::max(std::hypot(beam.fieldAngleRad, kTenthOverHalf * scattered), beam.beamAngleRad);
    beam.edge = render::BeamEdge::kSoft;
    beam.frostRad = kDiscOverHalf * scattered;
}

glm::dmat3 turnedFacet(const glm::dmat3& copyFromBeam, double rad) {
    const glm::dmat3 turn(std::cos(rad), std::sin(rad), 0.0, -std::sin(rad), std::cos(rad), 0.0, 0.0, 0.0,
                          1.0);
    return turn * copyFromBeam * glm::transpose(turn);
}

std::vector<fixtures::PrismFacet> facetsOf(const fixtures::PrismState& prism) {
    const fixtures::WheelSlot* slot = prism.nearestSlot();
    if (slot != nullptr && !slot->facets.empty()) return slot->facets;
    std::vector<fixtures::PrismFacet> facets(kUnknownFacets);
    for (int i = 0; i < kUnknownFacets; ++i) {
        const glm::dvec2 shift = turned({0.0, kUnknownFacetShift}, 2.0 * kPi * i / kUnknownFacets);
        facets[static_cast<std::size_t>(i)].copyFromBeam[2] = glm::dvec3(shift, 1.0);
    }
    return facets;
}

/// What a prism's facet does to the picture besides moving it: scale * picture.
struct FacetPicture {
    double scale = 1.0;
    double narrow = 1.0;      ///< The shortest axis over the longest.
    glm::dmat2 picture{1.0};  ///< Its longest axis has length 1.
};

/// By the singular values of the facet's matrix: m = u diag(longest, shortest) v^T.
FacetPicture pictureThrough(const glm::dmat2& m) {
    const double xx = m[0][0] * m[0][0] + m[1][0] * m[1][0];
    const double yy = m[0][1] * m[0][1] + m[1][1] * m[1][1];
    const double xy = m[0][0] * m[0][1] + m[1][0] * m[1][1];
    const double longest = std::sqrt(0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy));
    if (!(longest > 1e-3)) return {.scale = 1e-3};
    const double determinant = glm::determinant(m);
    const double narrow = std::max(std::abs(determinant) / (longest * longest), render::kNarrowestStretch);
    const glm::dvec2 u = turned({1.0, 0.0}, 0.5 * std::atan2(2.0 * xy, xx - yy));
    const glm::dvec2 v = glm::transpose(m) * u / longest;
    const double hand = determinant < 0.0 ? -1.0 : 1.0;
    return {longest, narrow,
            glm::outerProduct(u, v) +
                hand * narrow * glm::outerProduct(turned(u, 0.5 * kPi), turned(v, 0.5 * kPi))};
}

/// The turn that brings -Z to a direction by the shortest way.
glm::dmat3 turnTo(const glm::dvec3& direction) {
    return glm::dmat3(glm::mat3_cast(glm::dquat(glm::dvec3(0.0, 0.0, -1.0), direction)));
}

/// An angle that is seen `factor` times as large on the plane before the lamp.
double scaledAngle(double fullAngleRad, double factor) {
    return 2.0 * std::atan(factor * std::tan(0.5 * fullAngleRad));
}

void turnImages(double rad, render::Beam& beam) {
    beam.goboRotationRad += rad;
    render::Aperture& aperture = beam.aperture;
    for (render::ApertureImage& image : aperture.images) {
        image.rotationRad += rad;
        image.center = turned(image.center, rad);
    }
    for (render::ApertureEdge& blade : aperture.blades) blade.normal = turned(blade.normal, rad);
    aperture.split.normal = turned(aperture.split.normal, rad);
    aperture.shapeTurnRad += rad;
}

render::Beam copyOf(const render::Beam& beam, const fixtures::PrismFacet& facet,
                    const glm::dmat3& copyFromBeam) {
    const FacetPicture through = pictureThrough(glm::dmat2(copyFromBeam) * beam.aperture.stretch);
    const double fieldTangent = std::tan(0.5 * beam.fieldAngleRad);
    render::Beam copy = beam;
    const glm::dvec2 shift = glm::dvec2(copyFromBeam[2]) * fieldTangent;
    copy.worldFromBeam = beam.worldFromBeam * turnTo(glm::normalize(glm::dvec3(shift, -1.0)));
    copy.beamAngleRad = scaledAngle(beam.beamAngleRad, through.scale);
    copy.fieldAngleRad = scaledAngle(beam.fieldAngleRad, through.scale);
    copy.fluxLm = beam.fluxLm * facet.color.Y / 100.0;
    if (through.narrow > kRoundPicture && glm::determinant(through.picture) > 0.0) {
        copy.aperture.stretch = glm::dmat2(1.0);
        turnImages(std::atan2(through.picture[0].y, through.picture[0].x), copy);
    } else {
        copy.aperture.stretch = through.picture;
    }
    copy.fluxLm *= lightInStretch(beam) / lightInStretch(copy);
    return copy;
}

std::vector<render::Beam> throughPrism(const fixtures::PrismState& prism,
                                       const std::vector<render::Beam>& beams) {
    std::vector<render::Beam> copies;
    const std::vector<fixtures::PrismFacet> facets = facetsOf(prism);
    for (const render::Beam& beam : beams) {
        for (const fixtures::PrismFacet& facet : facets) {
            copies.push_back(
                copyOf(beam, facet, turnedFacet(facet.copyFromBeam, glm::radians(prism.rotationDeg))));
            copies.back().fluxLm /= static_cast<double>(facets.size());
        }
    }
    return copies;
}

}  // namespace

void applyOptics(const fixtures::BeamState& state, const GoboLookup& goboFor, render::Beam& beam) {
    addGobos(state, goboFor, beam);
    addAnimation(state.animation, goboFor, beam.aperture);
    beam.aperture.irisRadius = std::clamp(state.iris, 0.0, 1.0);
    addBlades(state.shaper, beam.aperture);
    splitColor(state, beam);
    setShape(state, beam);
    addFrost(state, beam);
}

std::vector<render::Beam> throughPrisms(const fixtures::BeamState& state, const render::Beam& beam) {
    std::vector<render::Beam> beams{beam};
    for (const fixtures::PrismState& prism : state.prisms) {
        if (prism.insertion < 0.5) continue;
        beams = throughPrism(prism, beams);
        if (beams.size() > kMostCopies) beams.resize(kMostCopies);
    }
    // One lens, however many copies.
    for (std::size_t i = 1; i < beams.size(); ++i) beams[i].showsLens = false;
    return beams;
}

}  // namespace hazer::app
