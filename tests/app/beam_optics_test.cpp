// From a fixture's wheels, blades, frost and prisms to beams.
#include "app/beam_optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/light_color.h"
#include "app/rig.h"

namespace hazer::app {
namespace {

constexpr double kPi = 3.14159265358979323846;

fixtures::BeamState litBeam() {
    fixtures::BeamState state;
    state.fluxLm = 10000.0;
    state.beamAngleDeg = 15.0;
    state.fieldAngleDeg = 20.0;
    return state;
}

std::shared_ptr<const fixtures::WheelImage> image() {
    return std::make_shared<const fixtures::WheelImage>();
}

/// Handles are given out in the order of asking: 7, 8 ...
render::Beam through(const fixtures::BeamState& state) {
    render::Beam beam = beamFromState(state).value();
    int next = 7;
    applyOptics(
        state, [&next](const auto&) { return next++; }, beam);
    return beam;
}

/// Light that the beam's blades leave at a place of its cross-section.
bool isOpenAt(const render::Aperture& aperture, const glm::dvec2& place) {
    for (const render::ApertureEdge& blade : aperture.blades) {
        if (glm::dot(blade.normal, place) >= blade.distance) return false;
    }
    return true;
}

glm::dvec3 directionOf(const render::Beam& beam) {
    return -beam.worldFromBeam[2];
}

TEST(BeamOptics, NothingInTheWayLeavesTheBeam) {
    const fixtures::BeamState state = litBeam();
    EXPECT_EQ(through(state), beamFromState(state).value());
    std::vector<render::Beam> beams;
    appendCopies(state, through(state), beams);
    EXPECT_EQ(beams, std::vector{through(state)});
}

TEST(BeamOptics, TheFirstGoboIsTheBeamsAndOthersLieOverIt) {
    fixtures::BeamState state = litBeam();
    state.gobos[1].image = image();
    state.gobos[1].rotationDeg = 90.0;
    state.gobos[2].image = image();
    state.gobos[2].rotationDeg = -30.0;
    const render::Beam beam = through(state);
    EXPECT_EQ(beam.gobo, 7);
    EXPECT_NEAR(beam.goboRotationRad, 0.5 * kPi, 1e-12);
    EXPECT_EQ(beam.aperture.images[0].gobo, 8);
    EXPECT_NEAR(beam.aperture.images[0].rotationRad, -kPi / 6.0, 1e-12);
    EXPECT_EQ(beam.aperture.images[1].gobo, -1);
}

/// Three slots: a picture, nothing, another picture. Handles are 7 for all that has one.
struct ThreeSlots {
    ThreeSlots() {
        wheel.slots.resize(3);
        wheel.slots[0].image = wheel.slots[2].image = image();
    }

    render::Beam at(double slot) const {
        fixtures::BeamState state = litBeam();
        state.gobos[0].wheel = &wheel;
        state.gobos[0].slot = slot;
        state.gobos[0].image = state.gobos[0].nearestSlot()->image;
        state.gobos[0].rotationDeg = 30.0;
        render::Beam beam = beamFromState(state).value();
        applyOptics(
            state, [](const auto&) { return 7; }, beam);
        return beam;
    }

    fixtures::Wheel wheel;
};

TEST(BeamOptics, AGoboBesideTheMiddleShowsItsNeighborToo) {
    const ThreeSlots wheel;
    const render::ApertureImage leaving = wheel.at(1.1).aperture.images[0];
    EXPECT_EQ(wheel.at(1.1).gobo, -1);
    EXPECT_EQ(leaving.gobo, 7);
    EXPECT_NEAR(leaving.center.x, -0.22, 1e-9);
    EXPECT_NEAR(leaving.rotationRad, kPi / 6.0, 1e-12);
    EXPECT_EQ(leaving.neighbor, render::kOpenSlot);
    EXPECT_NEAR(leaving.center.x + leaving.toNeighbor.x, 1.98, 1e-9);
    // From the last slot on comes the first; a shake that goes back from slot 1 shows slot 3.
    EXPECT_EQ(wheel.at(3.5).aperture.images[0].neighbor, 7);
    EXPECT_EQ(wheel.at(2.5).aperture.images[0].gobo, render::kOpenSlot);
    EXPECT_NEAR(wheel.at(0.9).aperture.images[0].center.x, -1.98, 1e-9);
}

// Nothing jumps where a wheel comes to stand, or where another slot becomes the nearest.
TEST(BeamOptics, AWheelMovesWithoutJumps) {
    const ThreeSlots wheel;
    EXPECT_TRUE(isOpen(wheel.at(1.0004).aperture));
    EXPECT_EQ(wheel.at(0.9996).gobo, 7);
    for (const double slot : {1.0011, 1.4999, 1.5, 1.5001, 1.9989}) {
        const render::ApertureImage image = wheel.at(slot).aperture.images[0];
        EXPECT_EQ(image.gobo, 7) << slot;
        EXPECT_NEAR(image.center.x, -2.2 * (slot - 1.0), 1e-9) << slot;
    }
    EXPECT_TRUE(isOpen(wheel.at(2.0).aperture));
}

TEST(BeamOptics, AnAnimationDiskIsLargerThanTheBeamAndCoversIt) {
    fixtures::BeamState state = litBeam();
    state.animation.image = image();
    EXPECT_TRUE(isOpen(through(state).aperture));
    state.animation.insertion = 1.0;
    const render::ApertureImage disk = through(state).aperture.images[0];
    EXPECT_EQ(disk.gobo, 7);
    EXPECT_GT(disk.radius, glm::length(disk.center) + 1.0);
}

// The beam's middle is where the path ends, its edge a cut-out's radius from there (GDTF AnimationSystem).
TEST(BeamOptics, AnAnimationDiskLiesWhereItsFileSays) {
    fixtures::Wheel wheel;
    wheel.slots.resize(1);
    wheel.slots[0].animation = fixtures::AnimationSystem{{{{1.0, 1.0}, {0.2, 0.6}, {-0.5, 0.1}}}, 0.25};
    fixtures::BeamState state = litBeam();
    state.animation.wheel = &wheel;
    state.animation.image = image();
    state.animation.insertion = 1.0;
    const render::ApertureImage disk = through(state).aperture.images[0];
    const auto onDisk = [&](const glm::dvec2& place) { return (place - disk.center) / disk.radius; };
    EXPECT_NEAR(glm::distance(onDisk({0.0, 0.0}), glm::dvec2(-0.5, 0.1)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(onDisk({0.0, 1.0}), glm::dvec2(-0.5, 0.35)), 0.0, 1e-12);
}

// Blades come in from their sides, seen from the fixture: 1 from below, 2 from the left, 3 from above, 4 from
// the right.
TEST(BeamOptics, BladesComeInFromTheirSides) {
    constexpr std::array kSides{glm::dvec2(0.0, -1.0), glm::dvec2(-1.0, 0.0), glm::dvec2(0.0, 1.0),
                                glm::dvec2(1.0, 0.0)};
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        fixtures::BeamState state = litBeam();
        state.shaper.blades[i].a = state.shaper.blades[i].b = 0.25;
        const render::Aperture aperture = through(state).aperture;
        // A quarter of the way across: half a radius from the middle.
        EXPECT_FALSE(isOpenAt(aperture, 0.51 * kSides[i])) << i;
        EXPECT_TRUE(isOpenAt(aperture, 0.49 * kSides[i])) << i;
        EXPECT_TRUE(isOpenAt(aperture, -0.99 * kSides[i])) << i;
    }
}

// End A is the first that one meets clockwise: of the blade from below, the one on the right.
TEST(BeamOptics, BladesTilt) {
    fixtures::BeamState state = litBeam();
    state.shaper.blades[0].a = 0.5;
    state.shaper.blades[0].b = 0.0;
    const render::Aperture aperture = through(state).aperture;
    EXPECT_FALSE(isOpenAt(aperture, {0.9, -0.2}));
    EXPECT_TRUE(isOpenAt(aperture, {-0.9, -0.2}));
    EXPECT_FALSE(isOpenAt(aperture, {0.0, -0.51}));
    EXPECT_TRUE(isOpenAt(aperture, {0.0, -0.49}));
}

TEST(BeamOptics, BladesTurnCounterClockwise) {
    fixtures::BeamState state = litBeam();
    state.shaper.blades[0].a = state.shaper.blades[0].b = 0.25;
    state.shaper.blades[0].rotationDeg = 30.0;
    // The edge from below rises to the right.
    EXPECT_FALSE(isOpenAt(through(state).aperture, {0.7, -0.2}));
    EXPECT_TRUE(isOpenAt(through(state).aperture, {-0.7, -0.7}));
    // However it is turned, it comes in from outside of the beam, without a jump.
    state.shaper.blades[0].a = state.shaper.blades[0].b = 1e-4;
    for (const double deg : {-45.0, 20.0, 45.0}) {
        state.shaper.blades[0].rotationDeg = deg;
        EXPECT_NEAR(through(state).aperture.blades[0].distance, 1.0, 3e-4) << deg;
    }
    state.shaper.blades[0].a = state.shaper.blades[0].b = 0.25;
    state.shaper.blades[0].rotationDeg = 0.0;
    state.shaper.rotationDeg = 90.0;
    // All blades a quarter turn on: the one from below comes from the right.
    EXPECT_FALSE(isOpenAt(through(state).aperture, {0.6, 0.0}));
    EXPECT_TRUE(isOpenAt(through(state).aperture, {0.0, -0.6}));
}

TEST(BeamOptics, IrisAndSoftness) {
    fixtures::BeamState state = litBeam();
    state.iris = 0.4;
    state.shaper.softness = 0.5;
    EXPECT_EQ(through(state).aperture.irisRadius, 0.4);
    EXPECT_GT(through(state).aperture.softness, 0.1);
}

// The light of either side, and all of it, are those of the wheel's colours.
TEST(BeamOptics, SplitColorsKeepTheirLight) {
    fixtures::BeamState state = litBeam();
    state.colorSplit.colorXyz = {glm::dvec3(0.30, 0.20, 0.05), glm::dvec3(0.10, 0.15, 0.40)};
    state.colorSplit.secondShare = 0.25;
    const render::Beam beam = through(state);
    EXPECT_EQ(beam.aperture.split.distance, 0.5);
    const glm::dvec3 brightest = glm::dvec3(beam.color) * beam.fluxLm;
    const std::array sides{glm::dvec3(beam.aperture.color), glm::dvec3(beam.aperture.beyondColor)};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const glm::dvec3 light = brightest * sides[i];
        EXPECT_NEAR(luminance(light), 10000.0 * state.colorSplit.colorXyz[i].y, 1.0);
        EXPECT_LE(std::max({sides[i].r, sides[i].g, sides[i].b}), 1.0 + 1e-6);
    }
}

// Scattering a Gaussian by a Gaussian adds their squares; the fixture's own beam stays what it is.
TEST(BeamOptics, FrostsAdd) {
    fixtures::BeamState state = litBeam();
    state.frosts = {1.0, 0.5, 0.0};
    const render::Beam beam = through(state);
    EXPECT_NEAR(beam.frostRad, std::hypot(8.0, 8.0) * kPi / 180.0, 1e-12);
    EXPECT_EQ(beam.beamAngleRad, beamFromState(state)->beamAngleRad);
    EXPECT_EQ(beam.fluxLm, 10000.0);
    state.frosts = {};
    EXPECT_EQ(through(state).frostRad, 0.0);
}

TEST(BeamOptics, RectanglesHaveHalfTheLightAtTheBeamAngle) {
    fixtures::BeamState state = litBeam();
    state.type = fixtures::BeamType::kRectangle;
    const render::Beam beam = through(state);
    ASSERT_TRUE(beam.aperture.rectangle);
    const auto [half, softness] = *beam.aperture.rectangle;
    EXPECT_NEAR(glm::length(half), 1.0, 1e-12);
    EXPECT_NEAR(half.x / half.y, state.rectangleRatio, 1e-12);
    // The middle of the ramp, on the shorter side.
    EXPECT_NEAR((half.y - 0.5 * softness) / half.y, 0.75, 1e-12);
    EXPECT_EQ(beam.edge, render::BeamEdge::kFlat);
    EXPECT_EQ(beam.fluxLm, 10000.0);
}

TEST(BeamOptics, BeamShapersStretch) {
    fixtures::BeamState state = litBeam();
    state.type = fixtures::BeamType::kSpot;
    state.oval = 1.0;
    state.ovalAngleDeg = 90.0;
    const render::Beam beam = through(state);
    EXPECT_NEAR(glm::distance(beam.aperture.stretch * glm::dvec2(0.0, 1.0), glm::dvec2(0.0, 1.0)), 0.0,
                1e-12);
    EXPECT_NEAR(glm::length(beam.aperture.stretch * glm::dvec2(1.0, 0.0)), 0.4, 1e-12);
    EXPECT_EQ(beam.fluxLm, 10000.0);
}

class Prism : public ::testing::Test {
 protected:
    Prism() {
        wheel_.slots.resize(1);
        state_ = litBeam();
        state_.prisms[0].wheel = &wheel_;
        state_.prisms[0].insertion = 1.0;
    }

    void addFacet(const glm::dmat3& copyFromBeam) { wheel_.slots[0].facets.push_back({{}, copyFromBeam}); }

    std::vector<render::Beam> copies() const {
        std::vector<render::Beam> beams;
        appendCopies(state_, through(state_), beams);
        return beams;
    }

    fixtures::Wheel wheel_;
    fixtures::BeamState state_;
};

TEST_F(Prism, CopiesShareTheLightAndStandBesideEachOther) {
    addFacet({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 1.0}});
    addFacet({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 1.0}});
    const std::vector<render::Beam> beams = copies();
    ASSERT_EQ(beams.size(), 2u);
    const double tangent = std::tan(10.0 * kPi / 180.0);
    const glm::dvec3 first = directionOf(beams[0]);
    EXPECT_NEAR(first.x / -first.z, tangent, 1e-12);
    EXPECT_NEAR(first.y, 0.0, 1e-12);
    const glm::dvec3 second = directionOf(beams[1]);
    EXPECT_NEAR(second.y / -second.z, -tangent, 1e-12);
    EXPECT_NEAR(beams[0].fluxLm + beams[1].fluxLm, 10000.0, 1.0);
    // One lens, which all shine through.
    for (const render::Beam& beam : beams) {
        EXPECT_TRUE(beam.showsLens);
        EXPECT_EQ(beam.lensNormal, directionOf(through(state_)));
    }
}

TEST_F(Prism, FacetsTint) {
    addFacet(glm::dmat3(1.0));
    addFacet(glm::dmat3(1.0));
    wheel_.slots[0].facets[1].color = {0.64, 0.33, 21.3};
    const std::vector<render::Beam> beams = copies();
    EXPECT_NEAR(beams[0].fluxLm, 5000.0, 1.0);
    // The lamp is a little warmer than what the filter's colour is told for.
    EXPECT_NEAR(beams[1].fluxLm, 5000.0 * 0.213, 0.1 * 5000.0 * 0.213);
    EXPECT_NEAR(luminance(beams[1].color), 1.0, 1e-6);
    EXPECT_GT(beams[1].color.r, 2.0f * beams[0].color.r);
    EXPECT_LT(beams[1].color.b, 0.2f * beams[0].color.b);
}

TEST_F(Prism, ATurningPrismCarriesItsCopiesRound) {
    addFacet({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 1.0}});
    state_.prisms[0].rotationDeg = 90.0;
    const glm::dvec3 direction = directionOf(copies()[0]);
    EXPECT_NEAR(direction.x, 0.0, 1e-12);
    EXPECT_NEAR(direction.y / -direction.z, std::tan(10.0 * kPi / 180.0), 1e-12);
    // The image itself does not turn with it.
    EXPECT_NEAR(copies()[0].goboRotationRad, 0.0, 1e-12);
}

TEST_F(Prism, FacetsScaleAndTurnTheImage) {
    const double c = 2.0 * std::cos(0.3);
    const double s = 2.0 * std::sin(0.3);
    addFacet({{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}});
    state_.gobos[0].image = image();
    const render::Beam copy = copies()[0];
    EXPECT_NEAR(std::tan(0.5 * copy.fieldAngleRad), 2.0 * std::tan(10.0 * kPi / 180.0), 1e-12);
    EXPECT_NEAR(copy.goboRotationRad, 0.3, 1e-12);
    EXPECT_TRUE(isOpen(copy.aperture));
}

/// Where a place of the beam's picture lies on the plane at 1 m before the lamp.
glm::dvec2 shownAt(const render::Beam& copy, const glm::dvec2& place) {
    return copy.aperture.stretch * place * std::tan(0.5 * copy.fieldAngleRad);
}

TEST_F(Prism, AFacetThatStretchesStretchesThePicture) {
    const double s = std::sin(0.4), c = std::cos(0.4);
    const glm::dmat2 stretch =
        glm::dmat2(c, s, -s, c) * glm::dmat2(1.0, 0.0, 0.0, 4.0) * glm::dmat2(c, -s, s, c);
    addFacet(glm::dmat3(stretch));
    state_.gobos[0].image = image();
    const render::Beam copy = copies()[0];
    const double field = std::tan(10.0 * kPi / 180.0);
    EXPECT_NEAR(std::tan(0.5 * copy.fieldAngleRad), 4.0 * field, 1e-12);
    for (const glm::dvec2 place : {glm::dvec2(1.0, 0.0), {0.0, 1.0}, {0.3, -0.6}})
        EXPECT_NEAR(glm::distance(shownAt(copy, place), stretch * place * field), 0.0, 1e-12);
    EXPECT_NEAR(copy.fluxLm, 10000.0, 1.0);
}

TEST_F(Prism, AMirroringFacetMirrors) {
    addFacet({{-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
    const render::Beam copy = copies()[0];
    EXPECT_NEAR(glm::distance(copy.aperture.stretch * glm::dvec2(0.3, 0.5), glm::dvec2(-0.3, 0.5)), 0.0,
                1e-12);
    EXPECT_NEAR(copy.fluxLm, 10000.0, 1.0);
}

TEST_F(Prism, AStretchThatIsUndoneLeavesNothing) {
    addFacet({{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
    state_.prisms[1] = state_.prisms[0];
    state_.prisms[1].rotationDeg = 90.0;
    const render::Beam copy = copies()[0];
    EXPECT_TRUE(isOpen(copy.aperture));
    EXPECT_NEAR(std::tan(0.5 * copy.fieldAngleRad), 2.0 * std::tan(10.0 * kPi / 180.0), 1e-9);
    EXPECT_NEAR(copy.fluxLm, 10000.0, 1.0);
}

TEST_F(Prism, AFacetWithoutWidthStaysFinite) {
    for (const double width : {0.0, 1e-9}) addFacet({{width, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
    addFacet({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
    for (const render::Beam& copy : copies()) {
        EXPECT_TRUE(std::isfinite(copy.fluxLm));
        EXPECT_GT(copy.fieldAngleRad, 0.0);
        EXPECT_GE(std::abs(glm::determinant(copy.aperture.stretch)), 0.99 * render::kNarrowestStretch);
    }
}

TEST_F(Prism, TwoPrismsMultiplyAndAreBounded) {
    for (int i = 0; i < 12; ++i) addFacet({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.1 * i, 0.0, 1.0}});
    state_.prisms[1] = state_.prisms[0];
    // Some stand for all, with all of the light.
    const std::vector<render::Beam> some = copies();
    EXPECT_EQ(some.size(), 64u);
    double flux = 0.0;
    std::set<double> places;
    for (const render::Beam& beam : some) {
        flux += beam.fluxLm;
        places.insert(std::round(1e3 * directionOf(beam).x));
    }
    EXPECT_NEAR(flux, 10000.0, 1.0);
    EXPECT_GT(places.size(), 20u);
    state_.prisms[0].insertion = 0.0;
    EXPECT_EQ(copies().size(), 12u);
}

TEST_F(Prism, WithoutFacetsThereAreThreeCopies) {
    EXPECT_EQ(copies().size(), 3u);
}

}  // namespace
}  // namespace hazer::app
