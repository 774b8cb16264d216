#include "app/beam_optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "app/light_color.h"
#include "fixtures/color.h"

namespace hazer::app {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Widths at half the peak that frosts scatter at 1: makers have a light one first, and heavier ones after
/// it. No file says how heavy.
constexpr std::array<double, fixtures::kMaxFrosts> kFrostDeg{8.0, 16.0, 24.0};

/// Middles of neighbouring gobos on a wheel, in radii of their field.
constexpr double kGoboPitch = 2.2;

/// A wheel this close to a slot stands in it, as a share of the way to the next.
constexpr double kInSlot = 1e-3;

/// Where the beam goes through an animation disk whose file does not say: in radii of the disk.
constexpr fixtures::AnimationSystem kUsualDisk{{{{0.0, 0.6}, {0.0, 0.6}, {0.0, 0.6}}}, 0.35};

/// A beam shaper spreads an oval this much wider than high.
constexpr double kMostOval = 0.6;

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

void appendImage(const render::ApertureImage& image, render::Aperture& aperture) {
    const auto free =
        std::ranges::find_if(aperture.images, [](const render::ApertureImage& i) { return i.gobo < 0; });
    if (free != aperture.images.end()) *free = image;
}

/// A place of a wheel in the beam, counted from 0 and around.
int goboAt(const fixtures::Wheel& wheel, int slot, const GoboLookup& goboFor) {
    const int count = static_cast<int>(wheel.slots.size());
    const auto& image = wheel.slots[static_cast<std::size_t>((slot % count + count) % count)].image;
    return image == nullptr ? render::kOpenSlot : goboFor(image);
}

/// Two neighbours of a wheel on their way through the beam.
render::ApertureImage betweenSlots(const fixtures::GoboState& gobo, const GoboLookup& goboFor) {
    const double from = std::floor(gobo.slot);
    const double share = gobo.slot - from;
    const int slot = static_cast<int>(from) - 1;
    render::ApertureImage image;
    image.gobo = goboAt(*gobo.wheel, slot, goboFor);
    image.rotationRad = glm::radians(gobo.rotationDeg);
    image.center = {-share * kGoboPitch, 0.0};
    image.neighbor = goboAt(*gobo.wheel, slot + 1, goboFor);
    image.toNeighbor = {kGoboPitch, 0.0};
    return image;
}

/// A gobo that stands in the middle is the beam's own; what moves through the beam, or lies over another one,
/// is in its aperture.
void addGobos(const fixtures::BeamState& state, const GoboLookup& goboFor, render::Beam& beam) {
    for (const fixtures::GoboState& gobo : state.gobos) {
        const bool isBetween = gobo.wheel != nullptr && std::abs(gobo.slot - std::round(gobo.slot)) > kInSlot;
        if (isBetween) {
            const render::ApertureImage image = betweenSlots(gobo, goboFor);
            if (image.gobo != render::kOpenSlot || image.neighbor != render::kOpenSlot)
                appendImage(image, beam.aperture);
        } else if (gobo.image == nullptr) {
            continue;
        } else if (beam.gobo < 0) {
            beam.gobo = goboFor(gobo.image);
            beam.goboRotationRad = glm::radians(gobo.rotationDeg);
        } else {
            appendImage({goboFor(gobo.image), glm::radians(gobo.rotationDeg)}, beam.aperture);
        }
    }
}

/// The beam goes through the disk where the path ends on which it came in.
void addAnimation(const fixtures::AnimationState& animation, const GoboLookup& goboFor,
                  render::Aperture& aperture) {
    if (animation.image == nullptr || animation.insertion < 0.5) return;
    const fixtures::WheelSlot* slot = animation.nearestSlot();
    const fixtures::AnimationSystem disk = slot != nullptr && slot->animation ? *slot->animation : kUsualDisk;
    if (!(disk.radius > 0.0)) return;
    appendImage({goboFor(animation.image), glm::radians(animation.positionDeg), -disk.path[2] / disk.radius,
                 1.0 / disk.radius},
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
    const glm::dvec2 normal = turned(along, -0.5 * kPi);
    // However a blade is turned, it is out of the beam at 0.
    return {turned(normal, glm::radians(blade.rotationDeg) + shaperRad),
            glm::dot(normal, 0.5 * (endA + endB))};
}

void addBlades(const fixtures::ShaperState& shaper, render::Aperture& aperture) {
    for (std::size_t i = 0; i < shaper.blades.size(); ++i) {
        const fixtures::BladeState& blade = shaper.blades[i];
        if (blade.a <= 0.0 && blade.b <= 0.0) continue;
        aperture.blades[i] = bladeEdge(blade, bladeSide(i), glm::radians(shaper.rotationDeg));
    }
    aperture.softness = kSoftestEdge * shaper.softness;
}

void setShape(const fixtures::BeamState& state, render::Beam& beam) {
    if (state.type == fixtures::BeamType::kRectangle) {
        const glm::dvec2 half = glm::normalize(glm::dvec2(state.rectangleRatio, 1.0));
        // Half the light at the beam angle, none from the field angle on.
        const double soft = std::clamp(1.0 - beam.beamAngleRad / beam.fieldAngleRad, 0.0, 1.0);
        beam.aperture.rectangle = {half, 2.0 * soft * std::min(half.x, half.y)};
        beam.edge = render::BeamEdge::kFlat;
    } else if (state.oval > 0.0) {
        const double turnRad = glm::radians(state.ovalAngleDeg);
        const glm::dmat2 axes(turned({1.0, 0.0}, turnRad), turned({0.0, 1.0}, turnRad));
        const double height = 1.0 - kMostOval * std::min(state.oval, 1.0);
        beam.aperture.stretch = axes * glm::dmat2(1.0, 0.0, 0.0, height) * glm::transpose(axes);
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

/// Widths of what scatters one after the other add as their squares do.
void addFrost(const fixtures::BeamState& state, render::Beam& beam) {
    double squared = 0.0;
    for (std::size_t i = 0; i < kFrostDeg.size(); ++i)
        squared += std::pow(glm::radians(kFrostDeg[i]) * std::clamp(state.frosts[i], 0.0, 1.0), 2.0);
    beam.frostRad = std::sqrt(squared);
}

glm::dmat3 turnedFacet(const glm::dmat3& copyFromBeam, double rad) {
    const glm::dmat3 turn(std::cos(rad), std::sin(rad), 0.0, -std::sin(rad), std::cos(rad), 0.0, 0.0, 0.0,
                          1.0);
    return turn * copyFromBeam * glm::transpose(turn);
}

std::vector<fixtures::PrismFacet> unknownFacets() {
    std::vector<fixtures::PrismFacet> facets(kUnknownFacets);
    for (int i = 0; i < kUnknownFacets; ++i) {
        const glm::dvec2 shift = turned({0.0, kUnknownFacetShift}, 2.0 * kPi * i / kUnknownFacets);
        facets[static_cast<std::size_t>(i)].copyFromBeam[2] = glm::dvec3(shift, 1.0);
    }
    return facets;
}

std::span<const fixtures::PrismFacet> facetsOf(const fixtures::PrismState& prism) {
    static const std::vector<fixtures::PrismFacet> unknown = unknownFacets();
    const fixtures::WheelSlot* slot = prism.nearestSlot();
    return slot != nullptr && !slot->facets.empty() ? slot->facets : unknown;
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

void tint(const fixtures::ColorCie& filter, render::Beam& beam) {
    const glm::dvec3 light = glm::dvec3(beam.color) * fixtures::transmissionOf(filter);
    const double share = luminance(light);
    beam.fluxLm *= std::max(share, 0.0);
    if (share > 0.0) beam.color = render::Color(light / share);
}

render::Beam copyOf(const render::Beam& beam, const fixtures::PrismFacet& facet,
                    const glm::dmat3& copyFromBeam) {
    const FacetPicture through = pictureThrough(glm::dmat2(copyFromBeam) * beam.aperture.stretch);
    const double fieldTangent = std::tan(0.5 * beam.fieldAngleRad);
    render::Beam copy = beam;
    const glm::dvec2 shift = glm::dvec2(copyFromBeam[2]) * fieldTangent;
    copy.worldFromBeam = beam.worldFromBeam * turnTo(glm::normalize(glm::dvec3(shift, -1.0)));
    if (!copy.lensNormal) copy.lensNormal = -beam.worldFromBeam[2];
    copy.beamAngleRad = scaledAngle(beam.beamAngleRad, through.scale);
    copy.fieldAngleRad = scaledAngle(beam.fieldAngleRad, through.scale);
    tint(facet.color, copy);
    copy.aperture.stretch = glm::dmat2(1.0);
    const bool onlyTurns = through.narrow > kRoundPicture && glm::determinant(through.picture) > 0.0;
    if (onlyTurns && isRound(copy.aperture)) {
        copy.goboRotationRad += std::atan2(through.picture[0].y, through.picture[0].x);
    } else {
        copy.aperture.stretch = through.picture;
    }
    return copy;
}

/// Replaces the beams from `first` on by their copies. Of too many, some stand for all.
void passPrism(const fixtures::PrismState& prism, std::size_t first, std::vector<render::Beam>& beams) {
    const std::vector<render::Beam> before(beams.begin() + static_cast<std::ptrdiff_t>(first), beams.end());
    const std::span<const fixtures::PrismFacet> facets = facetsOf(prism);
    const std::size_t all = before.size() * facets.size();
    const std::size_t count = std::min(all, kMostCopies);
    const double turnRad = glm::radians(prism.rotationDeg);
    beams.resize(first);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t copy = i * all / count;
        const fixtures::PrismFacet& facet = facets[copy % facets.size()];
        beams.push_back(
            copyOf(before[copy / facets.size()], facet, turnedFacet(facet.copyFromBeam, turnRad)));
        beams.back().fluxLm *= static_cast<double>(before.size()) / static_cast<double>(count);
    }
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

void appendCopies(const fixtures::BeamState& state, const render::Beam& beam,
                  std::vector<render::Beam>& beams) {
    const std::size_t first = beams.size();
    beams.push_back(beam);
    for (const fixtures::PrismState& prism : state.prisms) {
        if (prism.insertion >= 0.5) passPrism(prism, first, beams);
    }
}

}  // namespace hazer::app
