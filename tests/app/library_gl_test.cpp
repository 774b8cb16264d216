// What the optics of the library's fixtures do to the picture: each hangs over a floor without haze, a camera
// above looks down at its light.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/fixture_library.h"
#include "app/light_color.h"
#include "app/paths.h"
#include "app/rig.h"
#include "app/session.h"
#include "fixtures/gdtf.h"
#include "render/gl/headless_context.h"
#include "render/mesh.h"
#include "render/renderer.h"

namespace hazer::app {
namespace {

constexpr int kEdge = 96;
constexpr double kHangHeightM = 6.0;
constexpr double kHalfViewM = 2.4;

/// Light on the floor. Places are in metres, x to the right and y up.
class Floor {
 public:
    explicit Floor(render::FloatImage image) : image_(std::move(image)) {}

    /// Of everything that `isCounted(x, y)`.
    double light(const std::function<bool(double, double)>& isCounted) const {
        double sum = 0.0;
        forEach([&](double x, double y, const glm::dvec3& color) {
            if (isCounted(x, y)) sum += luminance(color);
        });
        return sum;
    }

    double light() const {
        return light([](double, double) { return true; });
    }

    /// Of the half of the floor that lies towards a direction.
    double lightTowards(const glm::dvec2& direction) const {
        return light([&](double x, double y) { return x * direction.x + y * direction.y > 0.0; });
    }

    glm::dvec3 color(const std::function<bool(double, double)>& isCounted) const {
        glm::dvec3 sum(0.0);
        forEach([&](double x, double y, const glm::dvec3& color) {
            if (isCounted(x, y)) sum += color;
        });
        return sum;
    }

    glm::dvec2 middle() const {
        glm::dvec2 sum(0.0);
        forEach(
            [&](double x, double y, const glm::dvec3& color) { sum += luminance(color) * glm::dvec2(x, y); });
        return sum / light();
    }

    /// Standard deviations along x and y.
    glm::dvec2 spread() const {
        const glm::dvec2 mean = middle();
        glm::dvec2 sum(0.0);
        forEach([&](double x, double y, const glm::dvec3& color) {
            const glm::dvec2 off = glm::dvec2(x, y) - mean;
            sum += luminance(color) * off * off;
        });
        return glm::sqrt(sum / light());
    }

    double brightest() const {
        double most = 0.0;
        forEach([&](double, double, const glm::dvec3& color) { most = std::max(most, luminance(color)); });
        return most;
    }

    /// The steepest step from one pixel to the next, as a share of the brightest one.
    double steepest() const {
        double most = 0.0;
        for (int y = 0; y < kEdge; ++y) {
            for (int x = 1; x < kEdge; ++x) most = std::max(most, std::abs(at(x, y) - at(x - 1, y)));
        }
        return most / brightest();
    }

    /// Spots that do not touch, above a fifth of the brightest light.
    int spots() const {
        std::vector<bool> seen(kEdge * kEdge);
        const double least = 0.2 * brightest();
        int count = 0;
        for (int start = 0; start < kEdge * kEdge; ++start) {
            if (seen[static_cast<std::size_t>(start)] || at(start % kEdge, start / kEdge) < least) continue;
            ++count;
            std::vector<int> open{start};
            while (!open.empty()) {
                const int pixel = open.back();
                open.pop_back();
                const int x = pixel % kEdge;
                const int y = pixel / kEdge;
                if (seen[static_cast<std::size_t>(pixel)] || at(x, y) < least) continue;
                seen[static_cast<std::size_t>(pixel)] = true;
                if (x > 0) open.push_back(pixel - 1);
                if (x + 1 < kEdge) open.push_back(pixel + 1);
                if (y > 0) open.push_back(pixel - kEdge);
                if (y + 1 < kEdge) open.push_back(pixel + kEdge);
            }
        }
        return count;
    }

    /// The mean difference of two floors, as a share of their light. The other one may be turned by a quarter
    /// counter-clockwise first.
    double difference(const Floor& other, bool isOtherTurned = false) const {
        double sum = 0.0;
        for (int y = 0; y < kEdge; ++y) {
            for (int x = 0; x < kEdge; ++x) {
                sum += std::abs(at(x, y) - (isOtherTurned ? other.at(kEdge - 1 - y, x) : other.at(x, y)));
            }
        }
        return sum / (light() + other.light());
    }

 private:
    double at(int x, int y) const {
        const float* const rgb = image_.at(x, y);
        return luminance({rgb[0], rgb[1], rgb[2]});
    }

    template <typename Visit>
    void forEach(Visit visit) const {
        const auto metres = [](int pixel) { return kHalfViewM * ((2.0 * pixel + 1.0) / kEdge - 1.0); };
        for (int y = 0; y < kEdge; ++y) {
            for (int x = 0; x < kEdge; ++x) {
                const float* const rgb = image_.at(x, y);
                visit(metres(x), -metres(y), glm::dvec3(rgb[0], rgb[1], rgb[2]));
            }
        }
    }

    render::FloatImage image_;
};

using Levels = std::vector<std::pair<std::string, double>>;

class LibraryPictures : public ::testing::Test {
 protected:
    void use(const std::string& folder) { type_ = fixtures::loadGdtf(findLibraryFixture(folder).value()); }

    fixtures::Fixture fixtureWith(const Levels& levels) const {
        glm::dmat4 worldFromFixture(1.0);
        worldFromFixture[3] = {0.0, 0.0, kHangHeightM, 1.0};
        fixtures::Fixture fixture("lamp", type_, "Standard", 1, worldFromFixture);
        fixture.hold("Dimmer", 1.0);
        // Sharp on the floor.
        fixture.hold("Focus1", 1.0 - 2.0 / kHangHeightM);
        for (const auto& [attribute, value] : levels)
            EXPECT_TRUE(fixture.hold(attribute, value)) << attribute;
        fixture.settle();
        return fixture;
    }

    Floor floorWith(const Levels& levels) { return draw(fixtureWith(levels).state()); }

    Floor draw(const fixtures::FixtureState& state) {
        render::Scene scene;
        rig_.append(state, scene);
        // Bodies would hide the floor from a camera above.
        scene.instances = {floor_};
        scene.haze.extinctionPerM = scene.haze.scatteringPerM = 0.0f;
        render::Settings settings;
        settings.width = settings.height = kEdge;
        render::Camera camera;
        camera.positionM = {0.0, 0.0, 40.0};
        camera.targetM = {0.0, 0.0, 0.0};
        camera.up = {0.0, 1.0, 0.0};
        camera.verticalFovRad = 2.0 * std::atan(kHalfViewM / camera.positionM.z);
        renderer_.render(scene, camera, settings);
        return Floor(renderer_.readRadiance());
    }

 private:
    render::MeshInstance makeFloor() {
        render::MeshInstance floor;
        floor.mesh = renderer_.addMesh(render::makeBox());
        floor.worldFromMesh[0][0] = floor.worldFromMesh[1][1] = 40.0;
        floor.worldFromMesh[3][2] = -0.5;
        floor.material.specular = 0.0f;
        return floor;
    }

    render::gl::HeadlessContext context_;
    render::Renderer renderer_{shaderFolder()};
    Rig rig_{renderer_};
    render::MeshInstance floor_ = makeFloor();
    fixtures::FixtureTypePtr type_;
};

TEST_F(LibraryPictures, IrisZoomAndFrost) {
    use("moving-profile");
    const Floor open = floorWith({{"Zoom", 24.0}});
    const Floor iris = floorWith({{"Zoom", 24.0}, {"Iris", 0.5}});
    EXPECT_LT(iris.light(), 0.4 * open.light());
    EXPECT_GT(iris.light(), 0.15 * open.light());
    EXPECT_NEAR(iris.spread().x / open.spread().x, 0.5, 0.08);
    const Floor narrow = floorWith({{"Zoom", 12.0}});
    EXPECT_NEAR(narrow.spread().x / open.spread().x, 0.5, 0.08);
    EXPECT_NEAR(narrow.light() / open.light(), 1.0, 0.08);
    const Floor light = floorWith({{"Zoom", 12.0}, {"Frost1", 1.0}});
    const Floor heavy = floorWith({{"Zoom", 12.0}, {"Frost2", 1.0}});
    EXPECT_LT(light.steepest(), 0.6 * narrow.steepest());
    EXPECT_LT(heavy.steepest(), light.steepest());
    EXPECT_GT(heavy.spread().x, light.spread().x);
    EXPECT_GT(light.spread().x, 1.05 * narrow.spread().x);
}

TEST_F(LibraryPictures, EachBladeDarkensItsSide) {
    use("moving-profile");
    const Floor open = floorWith({{"Zoom", 24.0}});
    constexpr std::array kSides{glm::dvec2(0.0, -1.0), glm::dvec2(-1.0, 0.0), glm::dvec2(0.0, 1.0),
                                glm::dvec2(1.0, 0.0)};
    for (std::size_t i = 0; i < kSides.size(); ++i) {
        const std::string blade = "Blade" + std::to_string(i + 1);
        const Floor framed = floorWith({{"Zoom", 24.0}, {blade + "A", 0.35}, {blade + "B", 0.35}});
        EXPECT_LT(framed.lightTowards(kSides[i]), 0.6 * open.lightTowards(kSides[i])) << i;
        EXPECT_GT(framed.lightTowards(-kSides[i]), 0.95 * open.lightTowards(-kSides[i])) << i;
    }
    // The frame turns counter-clockwise: what is left of the light lies across from the blade.
    const Floor turned = floorWith({{"Zoom", 24.0}, {"Blade1A", 0.4}, {"Blade1B", 0.4}, {"ShaperRot", 60.0}});
    EXPECT_NEAR(glm::degrees(std::atan2(turned.middle().y, turned.middle().x)), 150.0, 4.0);
    // One end alone makes a slanted edge: more light is lost on its side, which is the right one.
    const Floor slanted = floorWith({{"Zoom", 24.0}, {"Blade1A", 0.5}});
    EXPECT_LT(slanted.middle().x, -0.02);
    EXPECT_GT(slanted.middle().y, 0.02);
}

TEST_F(LibraryPictures, GobosMultiplyTurnAndMove) {
    use("moving-profile");
    const Levels zoom{{"Zoom", 24.0}};
    const Floor grid = floorWith({{"Zoom", 24.0}, {"Gobo1", 3.0}});
    const Floor letter = floorWith({{"Zoom", 24.0}, {"Gobo2", 7.0}, {"Gobo2Pos", 0.0}});
    const Floor both = floorWith({{"Zoom", 24.0}, {"Gobo1", 3.0}, {"Gobo2", 7.0}, {"Gobo2Pos", 0.0}});
    EXPECT_LT(both.light(), 0.8 * std::min(grid.light(), letter.light()));
    EXPECT_GT(both.light(), 0.02 * letter.light());
    const Floor turned = floorWith({{"Zoom", 24.0}, {"Gobo2", 7.0}, {"Gobo2Pos", 90.0}});
    EXPECT_LT(turned.difference(letter, true), 0.1);
    EXPECT_GT(turned.difference(letter), 0.3);
    const Floor open = floorWith(zoom);
    const Floor flames = floorWith({{"Zoom", 24.0}, {"AnimationWheel1", 2.0}, {"AnimationWheel1Pos", 0.0}});
    const Floor later = floorWith({{"Zoom", 24.0}, {"AnimationWheel1", 2.0}, {"AnimationWheel1Pos", 9.0}});
    EXPECT_LT(flames.light(), 0.8 * open.light());
    EXPECT_GT(flames.light(), 0.1 * open.light());
    EXPECT_GT(flames.difference(later), 0.2);
    // All at once.
    const Floor all = floorWith({{"Zoom", 24.0}, {"Gobo1", 3.0}, {"Gobo2", 7.0}, {"AnimationWheel1", 2.0}});
    EXPECT_LT(all.light(), 0.9 * both.light());
    EXPECT_GT(all.light(), 0.0);
}

TEST_F(LibraryPictures, PrismsMakeSpots) {
    use("moving-profile");
    const Levels pinhole{{"Zoom", 20.0}, {"Gobo1", 8.0}};
    EXPECT_EQ(floorWith(pinhole).spots(), 1);
    const auto withPrism = [&](double slot, double deg) {
        Levels levels = pinhole;
        levels.emplace_back("Prism1", slot);
        levels.emplace_back("Prism1Pos", deg);
        return floorWith(levels);
    };
    EXPECT_EQ(withPrism(2.0, 0.0).spots(), 5);
    const Floor line = withPrism(3.0, 0.0);
    EXPECT_EQ(line.spots(), 4);
    EXPECT_GT(line.spread().x, 3.0 * line.spread().y);
    const Floor upright = withPrism(3.0, 90.0);
    EXPECT_GT(upright.spread().y, 3.0 * upright.spread().x);
}

TEST_F(LibraryPictures, ColorsOfWheelsFlagsAndTemperature) {
    use("moving-profile");
    const auto isLeft = [](double x, double) { return x < -0.1; };
    const auto isRight = [](double x, double) { return x > 0.1; };
    const auto greenOverRed = [](const glm::dvec3& color) { return color.g / color.r; };
    const Floor half = floorWith({{"Zoom", 24.0}, {"Color1WheelIndex", 22.5}});
    const double left = greenOverRed(half.color(isLeft));
    const double right = greenOverRed(half.color(isRight));
    EXPECT_GT(std::max(left, right), 4.0 * std::min(left, right)) << left << " " << right;
    const Floor white = floorWith({{"Zoom", 24.0}});
    const Floor cyan = floorWith({{"Zoom", 24.0}, {"ColorSub_C", 1.0}});
    EXPECT_LT(cyan.color(isLeft).r / cyan.color(isLeft).g, 0.5 / greenOverRed(white.color(isLeft)));
    const Floor warm = floorWith({{"Zoom", 24.0}, {"CTO", 2700.0}});
    const glm::dvec3 warmLight = warm.color(isLeft);
    const glm::dvec3 whiteLight = white.color(isLeft);
    EXPECT_LT(warmLight.b / warmLight.r, 0.5 * whiteLight.b / whiteLight.r);
}

// A camera whose shutter is open for many flashes sees their mean, whatever their kind.
TEST_F(LibraryPictures, StrobesGiveTheirMean) {
    use("moving-profile");
    const double open = floorWith({{"Zoom", 24.0}}).light();
    for (const auto& [attribute, mean] : Levels{{"Shutter1Strobe", 0.5}, {"Shutter1StrobePulse", 0.5}}) {
        fixtures::Fixture fixture = fixtureWith({{"Zoom", 24.0}, {attribute, 10.0}});
        fixture.step(2.0, 2.0);
        EXPECT_NEAR(draw(fixture.state()).light() / open, mean, 0.02) << attribute;
    }
}

TEST_F(LibraryPictures, OvalsAndRectangles) {
    use("oval-wash");
    const Floor round = floorWith({{"Zoom", 10.0}});
    EXPECT_NEAR(round.spread().x / round.spread().y, 1.0, 0.05);
    const Floor oval = floorWith({{"Zoom", 10.0}, {"BeamShaper", 1.0}, {"BeamShaperPos", 0.0}});
    EXPECT_GT(oval.spread().x, 1.5 * oval.spread().y);
    EXPECT_NEAR(oval.light() / round.light(), 1.0, 0.04);
    const Floor upright = floorWith({{"Zoom", 10.0}, {"BeamShaper", 1.0}, {"BeamShaperPos", 90.0}});
    EXPECT_GT(upright.spread().y, 1.5 * upright.spread().x);
    use("digital-light");
    const Floor field = floorWith({{"Zoom", 30.0}});
    EXPECT_NEAR(field.spread().x / field.spread().y, 16.0 / 9.0, 0.08);
}

TEST_F(LibraryPictures, BarnDoorsHaveSoftEdges) {
    use("pc-barndoors");
    const Floor open = floorWith({{"Zoom", 20.0}});
    const Floor doors = floorWith({{"Zoom", 20.0}, {"Blade2A", 0.4}});
    EXPECT_LT(doors.lightTowards({-1.0, 0.0}), 0.8 * open.lightTowards({-1.0, 0.0}));
    const Floor hard = floorWith({{"Zoom", 20.0}, {"Blade2A", 0.4}, {"BladeSoft1A", 0.0}});
    EXPECT_LT(doors.steepest(), 0.7 * hard.steepest());
}

TEST_F(LibraryPictures, CellsAreLitAlone) {
    use("pixel-bar");
    std::array<std::uint8_t, 512> slots{};
    fixtures::Fixture fixture = fixtureWith({{"Zoom", 5.0}, {"Tilt", 0.0}, {"Shutter1", 1.0}});
    slots[0] = slots[1] = 255;  // Cell 1, red and green
    slots[4 * 17 + 2] = 255;    // Cell 18, blue
    fixture.decode(slots);
    fixture.settle();
    const Floor floor = draw(fixture.state());
    const auto isLeft = [](double x, double) { return x < 0.0; };
    const auto isRight = [](double x, double) { return x > 0.0; };
    EXPECT_GT(floor.color(isLeft).r, 5.0 * floor.color(isLeft).b);
    EXPECT_GT(floor.color(isRight).b, 5.0 * floor.color(isRight).r);
}

// Hazers fill the air of a running show, and it clears again.
TEST(LibraryHazer, RaisesTheHazeOfTheShow) {
    const render::gl::HeadlessContext context;
    Session session(
        parseShow("[haze]\nextinction=0.001\nscattering=0.001\n"
                  "[[fixture]]\nname='hazer'\ngdtf='hazer'\nmode='Standard'\nuniverse=1\nslot=1\n",
                  "hazer.toml"),
        {});
    const auto extinction = [&] { return session.scene().haze.extinctionPerM; };
    session.advance(100.0);
    EXPECT_FLOAT_EQ(extinction(), 0.001f);
    session.patch().find("hazer")->fixture.hold("Haze1", 1.0);
    session.advance(30.0);
    const float early = extinction();
    EXPECT_GT(early, 0.0015f);
    session.advance(300.0);
    const float late = extinction();
    EXPECT_GT(late, 1.5f * early);
    EXPECT_FLOAT_EQ(session.scene().haze.scatteringPerM, late);
    session.patch().find("hazer")->fixture.hold("Haze1", 0.0);
    session.advance(3600.0);
    EXPECT_NEAR(extinction(), 0.001f, 1e-6f);
    EXPECT_FLOAT_EQ(session.controls().haze.extinctionPerM, 0.001f);
}

}  // namespace
}  // namespace hazer::app
