// From the wire to the pixel: real ArtDmx over loopback into a running session, and a look at the light that
// comes out.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <thread>

#include "app/session.h"
#include "protocol/sender.h"
#include "render/gl/headless_context.h"
#include "tests/support/datagram.h"

namespace hazer::app {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kHangHeightM = 6.0;

/// A dark room with a floor, one fixture hung above its middle, and a camera that looks straight at the floor
/// from above it (its up is +Y), so that a place on the floor is a place in the picture by simple proportion.
std::string roomWith(const std::string& gdtf, const std::string& haze) {
    return fmt::format(
        "[haze]\n{}\n"
        "[[camera]]\nname='above'\nposition=[0,-0.001,30]\ntarget=[0,0,0]\nfov=20\n"
        "[[camera]]\nname='side'\nposition=[0,-16,3]\ntarget=[0,0,3]\nfov=30\n"
        "[[fixture]]\nname='lamp'\ngdtf='{}'\nmode='Standard'\nuniverse=7\nslot=3\nposition=[0,0,{}]\n"
        "[[object]]\ntype='floor'\nsize=[60,60]\ncolor=[0.5,0.5,0.5]\nspecular=0\n",
        haze, gdtf, kHangHeightM);
}

const char* const kClearAir = "extinction=0\nscattering=0";
const char* const kHazyAir = "extinction=0.02\nscattering=0.02";

/// Levels of the lamp by attribute, in the units of Fixture::encode.
using Levels = std::vector<std::pair<std::string, double>>;

/// A running show, a desk that talks to it, and its picture.
class Wire {
 public:
    explicit Wire(const std::string& show)
        : session_(parseShow(show, "wire.toml"), {.listen = true, .ports = {.artNet = 0, .sacn = 0}}),
          desk_("127.0.0.1", session_.port()) {
        session_.settings().width = kWidth;
        session_.settings().height = kHeight;
    }

    Session& session() { return session_; }

    void use(const std::string& camera) { session_.camera() = session_.show().camera(camera).camera; }

    /// Sends the levels, waits until they stand, lets the mechanics arrive and draws.
    render::FloatImage draw(const Levels& levels) {
        const PatchedFixture& lamp = *session_.patch().find("lamp");
        protocol::Slots slots{};
        // Slots of 0 would turn a head as far as it goes; unless told otherwise it shall point down.
        lamp.fixture.encode("Pan", 0.0, slots);
        lamp.fixture.encode("Tilt", 0.0, slots);
        for (const auto& [attribute, value] : levels) {
            EXPECT_TRUE(lamp.fixture.encode(attribute, value, slots)) << attribute;
        }
        desk_.send(firstUniverse(lamp)->number, slots);
        await(++sent_);
        session_.advance(0.0);
        session_.settle();
        session_.draw();
        return session_.renderer().readRadiance();
    }

 private:
    void await(std::uint64_t count) {
        const auto patience = protocol::Clock::now() + std::chrono::seconds(10);
        while (session_.counters().dmx < count) {
            ASSERT_LT(protocol::Clock::now(), patience) << "ArtDmx was sent but did not arrive";
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    Session session_;
    protocol::ArtNetSender desk_;
    std::uint64_t sent_ = 0;
};

class WireTest : public ::testing::Test {
 protected:
    static void SetUpTestSuite() { context_ = std::make_unique<render::gl::HeadlessContext>(); }
    static void TearDownTestSuite() { context_.reset(); }

 private:
    static std::unique_ptr<render::gl::HeadlessContext> context_;
};

std::unique_ptr<render::gl::HeadlessContext> WireTest::context_;

/// Rec. 709 luminance [cd/m2].
double luminanceAt(const render::FloatImage& image, int x, int y) {
    const float* rgb = image.at(x, y);
    return 0.2126 * static_cast<double>(rgb[0]) + 0.7152 * static_cast<double>(rgb[1]) +
           0.0722 * static_cast<double>(rgb[2]);
}

template <typename Visit>
void forEachPixel(const render::FloatImage& image, Visit visit) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) visit(x, y, luminanceAt(image, x, y));
    }
}

double sumOf(const render::FloatImage& image) {
    double sum = 0.0;
    forEachPixel(image, [&](int, int, double light) { sum += light; });
    return sum;
}

double brightest(const render::FloatImage& image) {
    double most = 0.0;
    forEachPixel(image, [&](int, int, double light) { most = std::max(most, light); });
    return most;
}

int countAbove(const render::FloatImage& image, double limit) {
    int count = 0;
    forEachPixel(image, [&](int, int, double light) { count += light > limit ? 1 : 0; });
    return count;
}

/// Where the light lies on average, in pixels from the upper left corner, pixel centres at .5.
glm::dvec2 centroid(const render::FloatImage& image) {
    glm::dvec2 weighted(0.0);
    double sum = 0.0;
    forEachPixel(image, [&](int x, int y, double light) {
        weighted += light * glm::dvec2(x + 0.5, y + 0.5);
        sum += light;
    });
    return weighted / sum;
}

/// Where a point of the world is in the picture: a pinhole camera, worked out here and not by the renderer.
glm::dvec2 project(const render::Camera& camera, const glm::dvec3& pointM) {
    const glm::dvec3 forward = glm::normalize(camera.targetM - camera.positionM);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 offset = pointM - camera.positionM;
    const double focalPixels = kHeight / 2.0 / std::tan(camera.verticalFovRad / 2.0);
    const double depth = glm::dot(offset, forward);
    return {kWidth / 2.0 + focalPixels * glm::dot(offset, right) / depth,
            kHeight / 2.0 - focalPixels * glm::dot(offset, up) / depth};
}

/// Where a hung fixture points: -Z, tilted about X, then panned about Z, counter-clockwise seen from the
/// axis' tip.
glm::dvec3 directionOf(double panDeg, double tiltDeg) {
    const double pan = glm::radians(panDeg);
    const double tilt = glm::radians(tiltDeg);
    return {-std::sin(pan) * std::sin(tilt), std::cos(pan) * std::sin(tilt), -std::cos(tilt)};
}

/// Where the moving beam of the library has its tilt axis, through which its light comes: 0.4 m below the
/// clamp.
const glm::dvec3 kMovingBeamAxisM(0.0, 0.0, kHangHeightM - 0.4);

glm::dvec3 floorPoint(const glm::dvec3& directionDown) {
    return kMovingBeamAxisM + directionDown * (kMovingBeamAxisM.z / -directionDown.z);
}

TEST_F(WireTest, isDarkAtDimmerZero) {
    Wire wire(roomWith("moving-spot", kHazyAir));
    EXPECT_GT(brightest(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}})), 1.0);
    EXPECT_EQ(brightest(wire.draw({{"Dimmer", 0.0}, {"Shutter1", 1.0}})), 0.0);
}

TEST_F(WireTest, isDarkWithTheShutterClosed) {
    Wire wire(roomWith("moving-spot", kHazyAir));
    EXPECT_EQ(brightest(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 0.0}})), 0.0);
}

TEST_F(WireTest, brightnessIsProportionalToTheDimmer) {
    Wire wire(roomWith("moving-spot", kHazyAir));
    for (const char* camera : {"above", "side"}) {
        wire.use(camera);
        const double full = sumOf(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}}));
        ASSERT_GT(full, 0.0);
        for (const double dimmer : {0.75, 0.5, 0.25, 0.1}) {
            const double share = sumOf(wire.draw({{"Dimmer", dimmer}, {"Shutter1", 1.0}})) / full;
            EXPECT_NEAR(share / dimmer, 1.0, 0.01) << camera << " at " << dimmer;
        }
    }
}

struct Aim {
    double panDeg;
    double tiltDeg;
};

TEST_F(WireTest, theBeamFallsWherePanAndTiltSay) {
    Wire wire(roomWith("moving-beam", kClearAir));
    for (const Aim aim : {Aim{0.0, 0.0}, {0.0, 30.0}, {90.0, 30.0}, {-135.0, 20.0}, {200.0, -35.0}}) {
        const render::FloatImage image =
            wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"Pan", aim.panDeg}, {"Tilt", aim.tiltDeg}});
        const glm::dvec2 expected =
            project(wire.session().camera(), floorPoint(directionOf(aim.panDeg, aim.tiltDeg)));
        const glm::dvec2 seen = centroid(image);
        EXPECT_NEAR(seen.x, expected.x, 1.0) << "pan " << aim.panDeg << ", tilt " << aim.tiltDeg;
        EXPECT_NEAR(seen.y, expected.y, 1.0) << "pan " << aim.panDeg << ", tilt " << aim.tiltDeg;
    }
}

TEST_F(WireTest, theBeamStandsInTheAirBetweenLampAndFloor) {
    Wire wire(roomWith("moving-beam", kHazyAir));
    wire.use("side");
    const glm::dvec3 direction = directionOf(-90.0, 30.0);
    const render::FloatImage image =
        wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"Pan", -90.0}, {"Tilt", 30.0}});
    for (const double distanceM : {1.5, 2.5, 4.0}) {
        const glm::dvec2 inside = project(wire.session().camera(), kMovingBeamAxisM + distanceM * direction);
        const int x = static_cast<int>(inside.x);
        const int y = static_cast<int>(inside.y);
        const double beside = std::max(luminanceAt(image, x - 15, y), luminanceAt(image, x + 15, y));
        EXPECT_GT(luminanceAt(image, x, y), 10.0 * beside + 0.1) << distanceM << " m from the lamp";
    }
}

/// Share of red, green and blue in the light of the whole picture.
glm::dvec3 shares(const render::FloatImage& image) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float* rgb = image.at(x, y);
            sum += glm::dvec3(rgb[0], rgb[1], rgb[2]);
        }
    }
    return sum / (sum.r + sum.g + sum.b);
}

TEST_F(WireTest, hasTheColourOfItsEmitters) {
    Wire wire(roomWith("par-rgbw", kHazyAir));
    const glm::dvec3 red = shares(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"ColorAdd_R", 1.0}}));
    const glm::dvec3 green = shares(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"ColorAdd_G", 1.0}}));
    const glm::dvec3 blue = shares(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"ColorAdd_B", 1.0}}));
    const glm::dvec3 white = shares(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"ColorAdd_W", 1.0}}));
    EXPECT_GT(red.r, 0.9);
    EXPECT_GT(green.g, 0.9);
    EXPECT_GT(blue.b, 0.9);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0 / 3.0, 0.1);
}

TEST_F(WireTest, growsWithZoom) {
    Wire wire(roomWith("moving-wash", kClearAir));
    const auto litPixels = [&](double zoomDeg) {
        const render::FloatImage image =
            wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"ColorAdd_W", 1.0}, {"Zoom", zoomDeg}});
        return countAbove(image, 0.5 * brightest(image));
    };
    const int narrow = litPixels(15.0);
    const int wide = litPixels(30.0);
    // The half-value circle grows with tan(zoom / 2); the floor darkens a little towards its edge besides.
    const double expected = std::pow(std::tan(glm::radians(15.0)) / std::tan(glm::radians(7.5)), 2.0);
    EXPECT_NEAR(static_cast<double>(wide) / narrow, expected, 0.25 * expected);
}

TEST_F(WireTest, goboHolesAreDarkOnTheFloor) {
    Wire wire(roomWith("moving-spot", kClearAir));
    const Levels open{{"Dimmer", 1.0}, {"Shutter1", 1.0}, {"Focus1", 0.7}, {"Zoom", 30.0}};
    Levels patterned = open;
    patterned.emplace_back("Gobo1", 3.0);
    const render::FloatImage without = wire.draw(open);
    const render::FloatImage with = wire.draw(patterned);
    const double limit = 0.5 * brightest(without);
    int lit = 0;
    int dark = 0;
    int passing = 0;
    forEachPixel(without, [&](int x, int y, double light) {
        if (light <= limit) return;
        ++lit;
        dark += luminanceAt(with, x, y) < 0.05 * light ? 1 : 0;
        passing += luminanceAt(with, x, y) > 0.8 * light ? 1 : 0;
    });
    ASSERT_GT(lit, 100);
    EXPECT_GT(dark, lit / 10);
    EXPECT_GT(passing, lit / 20);
}

TEST_F(WireTest, garbageOnThePortIsCountedAndNothingElse) {
    Wire wire(roomWith("moving-spot", kHazyAir));
    const Levels levels{{"Dimmer", 1.0}, {"Shutter1", 1.0}};
    const double before = sumOf(wire.draw(levels));
    test::sendDatagram(wire.session().port(), "this is not Art-Net");
    test::sendDatagram(wire.session().port(), "");
    const auto patience = protocol::Clock::now() + std::chrono::seconds(10);
    while (wire.session().counters().malformed < 2 && protocol::Clock::now() < patience) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(wire.session().counters().malformed, 2u);
    EXPECT_EQ(sumOf(wire.draw(levels)), before);
}

TEST_F(WireTest, anotherUniverseMovesNothing) {
    Wire wire(roomWith("moving-spot", kHazyAir));
    const double before = sumOf(wire.draw({{"Dimmer", 1.0}, {"Shutter1", 1.0}}));
    protocol::ArtNetSender other("127.0.0.1", wire.session().port());
    protocol::Slots zeros{};
    other.send(8, zeros);
    while (wire.session().counters().dmx < 2) std::this_thread::yield();
    wire.session().advance(1.0);
    wire.session().draw();
    EXPECT_EQ(sumOf(wire.session().renderer().readRadiance()), before);
}

}  // namespace
}  // namespace hazer::app
