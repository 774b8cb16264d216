#include "tests/support/random_air.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/image.h"
#include "render/mesh.h"

namespace hazer::test {
namespace {

using render::Beam;
using render::MeshInstance;
using render::Scene;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDeg = kPi / 180.0;

/// The standard's distributions differ from library to library; these do not.
class Dice {
 public:
    explicit Dice(std::uint32_t seed) : bits_(seed) { bits_.discard(8); }

    double from(double least, double most) { return least + (most - least) * share(); }
    double logFrom(double least, double most) { return least * std::pow(most / least, share()); }
    bool comesTrue(double probability) { return share() < probability; }
    int below(int count) { return static_cast<int>(share() * count); }
    glm::dvec3 inBox(const glm::dvec3& low, const glm::dvec3& high) {
        // One after the other: the order in which arguments are evaluated is anybody's guess.
        const double x = from(low.x, high.x);
        const double y = from(low.y, high.y);
        return {x, y, from(low.z, high.z)};
    }
    glm::dvec3 direction() {
        const double up = from(-1.0, 1.0);
        const double turn = from(0.0, 2.0 * kPi);
        const double across = std::sqrt(1.0 - up * up);
        return {across * std::cos(turn), across * std::sin(turn), up};
    }

 private:
    double share() { return static_cast<double>(bits_()) / 4294967296.0; }

    std::mt19937 bits_;
};

/// Columns of a frame whose -Z points along `axis`.
glm::dmat3 shiningAlong(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, other));
    return {right, glm::cross(right, axis), -axis};
}

Beam randomBeam(Dice& dice) {
    Beam beam;
    beam.lensPositionM = dice.inBox({-4.0, -3.0, 4.0}, {4.0, 3.0, 8.0});
    const glm::dvec3 target = dice.inBox({-2.0, -2.0, 0.0}, {2.0, 2.0, 2.0});
    beam.worldFromBeam = shiningAlong(glm::normalize(target - beam.lensPositionM));
    beam.lensRadiusM = dice.comesTrue(0.2) ? 0.0 : dice.logFrom(0.01, 0.15);
    beam.fieldAngleRad = dice.logFrom(3.0, 70.0) * kRadPerDeg;
    beam.beamAngleRad = dice.from(0.4, 0.95) * beam.fieldAngleRad;
    beam.intensityCd = dice.logFrom(2e4, 2e5);
    const double red = dice.from(0.2, 1.0);
    beam.color = render::Color(red, dice.from(0.2, 1.0), 1.0);
    beam.edge = dice.comesTrue(0.5) ? render::BeamEdge::kSoft : render::BeamEdge::kFlat;
    beam.showsLens = false;
    return beam;
}

void addGobo(Dice& dice, const RandomAirAssets& assets, Beam& beam) {
    beam.gobo = assets.gobos[static_cast<std::size_t>(dice.below(static_cast<int>(assets.gobos.size())))];
    beam.goboRotationRad = dice.from(0.0, 2.0 * kPi);
    beam.focusDistanceM = dice.comesTrue(0.4) ? dice.logFrom(2.0, 20.0) : 0.0;
    // A table for each profile would take its time: soft edges share theirs.
    beam.beamAngleRad = 0.8 * beam.fieldAngleRad;
}

glm::dvec3 shines(const Beam& beam) {
    return -beam.worldFromBeam[2];
}

MeshInstance blackBody(render::MeshId mesh, const glm::dmat4& worldFromMesh) {
    MeshInstance body;
    body.mesh = mesh;
    body.worldFromMesh = worldFromMesh;
    body.material.albedo = render::Color(0.0f);
    body.material.specular = 0.0f;
    return body;
}

/// In the light of a beam: a ball, a box or a bar.
MeshInstance randomCaster(Dice& dice, const RandomAirAssets& assets, const Beam& beam) {
    const double axialM = dice.from(1.0, 4.0);
    const double wideM = beam.lensRadiusM + axialM * std::tan(0.5 * beam.fieldAngleRad);
    const glm::dvec3 off = dice.direction() * (0.8 * wideM);
    const double sizeM = dice.logFrom(0.1, 0.8) * wideM;
    const bool isBall = dice.comesTrue(0.5);
    const bool isBar = !isBall && dice.comesTrue(0.5);
    const double turn = dice.from(0.0, 2.0 * kPi);
    const glm::dvec3 around = dice.direction();
    const glm::dvec3 edges = isBar ? glm::dvec3(0.2 * sizeM, 0.2 * sizeM, 3.0 * sizeM) : glm::dvec3(sizeM);
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), beam.lensPositionM + shines(beam) * axialM + off);
    place = glm::rotate(place, turn, around);
    return blackBody(isBall ? assets.sphere : assets.box, glm::scale(place, edges));
}

/// In the ball around a caster.
bool isInside(const MeshInstance& body, const glm::dvec3& pointM) {
    const glm::dmat4& place = body.worldFromMesh;
    const double diameterM =
        glm::length(glm::dvec3(glm::length(place[0]), glm::length(place[1]), glm::length(place[2])));
    return body.castsShadow && glm::distance(glm::dvec3(place[3]), pointM) < 0.5 * diameterM;
}

void addHaze(Dice& dice, Scene& scene) {
    const double extinctionPerM = dice.logFrom(0.005, 1.0);
    scene.haze.extinctionPerM = static_cast<float>(extinctionPerM);
    scene.haze.scatteringPerM = static_cast<float>(extinctionPerM * dice.from(0.6, 1.0));
    scene.haze.phase.forwardG = static_cast<float>(dice.from(0.3, 0.85));
    if (!dice.comesTrue(0.4)) return;
    scene.haze.noise.amount = static_cast<float>(dice.from(0.3, 1.0));
    scene.haze.noise.scaleM = static_cast<float>(dice.logFrom(1.0, 4.0));
    scene.timeS = dice.from(0.0, 100.0);
}

/// Beside the stage, inside a beam, or anywhere above with the horizon askew.
render::Camera randomCamera(Dice& dice, const Scene& scene, std::string& what) {
    const int kind = dice.below(3);
    what +=
        std::array{", camera beside", ", camera inside", ", camera askew"}[static_cast<std::size_t>(kind)];
    render::Camera camera;
    camera.verticalFovRad = dice.from(35.0, 75.0) * kRadPerDeg;
    camera.targetM = dice.inBox({-1.0, -1.0, 1.5}, {1.0, 1.0, 4.0});
    if (kind == 0) {
        const double turn = dice.from(0.0, 2.0 * kPi);
        const double awayM = dice.from(5.0, 14.0);
        camera.positionM = {awayM * std::cos(turn), awayM * std::sin(turn), dice.from(0.8, 5.0)};
    } else if (kind == 1) {
        const Beam& beam = scene.beams.front();
        const double axialM = dice.from(1.5, 5.0);
        const double wideM = 0.5 * axialM * std::tan(0.5 * beam.fieldAngleRad);
        camera.positionM = beam.lensPositionM + shines(beam) * axialM + dice.direction() * wideM;
        camera.targetM = camera.positionM + dice.direction();
    } else {
        camera.positionM = dice.inBox({-6.0, -6.0, 0.5}, {6.0, 6.0, 9.0});
        camera.up = dice.direction();
    }
    return camera;
}

render::GoboId addPicture(render::AssetSink& assets, const char* name) {
    const auto file = std::filesystem::path(HAZER_GOBO_FOLDER) / (std::string(name) + ".png");
    const render::ByteImage picture = render::readByteImage(file);
    std::vector<std::uint8_t> rgba;
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        rgba.push_back(picture.rgb[i]);
        if (i % 3 == 2) rgba.push_back(255);
    }
    return assets.addGobo(rgba.data(), picture.width, picture.height);
}

}  // namespace

RandomAirAssets addRandomAirAssets(render::AssetSink& assets) {
    RandomAirAssets all;
    for (const char* name : {"bars", "leaves", "triangle-fan"}) all.gobos.push_back(addPicture(assets, name));
    all.box = assets.addMesh(render::makeBox());
    all.sphere = assets.addMesh(render::makeSphere());
    all.plane = assets.addMesh(render::makePlane());
    return all;
}

RandomAir makeRandomAir(std::uint32_t seed, const RandomAirAssets& assets) {
    Dice dice(seed);
    RandomAir made;
    const int beams = 1 + dice.below(4);
    made.what = fmt::format("seed {}: {} beam{}", seed, beams, beams == 1 ? "" : "s");
    for (int i = 0; i < beams; ++i) {
        made.scene.beams.push_back(randomBeam(dice));
        if (dice.comesTrue(0.5)) addGobo(dice, assets, made.scene.beams.back());
        if (made.scene.beams.back().edge == render::BeamEdge::kSoft) made.what += ", soft";
        if (made.scene.beams.back().gobo >= 0) made.what += ", gobo";
    }
    const int casters = dice.comesTrue(0.6) ? 1 + dice.below(3) : 0;
    for (int i = 0; i < casters; ++i) {
        const auto beam = static_cast<std::size_t>(dice.below(beams));
        made.scene.instances.push_back(randomCaster(dice, assets, made.scene.beams[beam]));
    }
    if (casters > 0) made.what += ", shadow";
    if (dice.comesTrue(0.7)) {
        made.scene.instances.push_back(
            blackBody(assets.plane, glm::scale(glm::dmat4(1.0), glm::dvec3(60.0, 60.0, 1.0))));
        made.scene.instances.back().castsShadow = false;
        made.what += ", floor";
    }
    addHaze(dice, made.scene);
    made.what += fmt::format(", {:.3f} /m", made.scene.haze.extinctionPerM);
    if (made.scene.haze.noise.amount > 0.0f) made.what += ", noise";
    made.camera = randomCamera(dice, made.scene, made.what);
    // From inside a body there is nothing to see but the grain of its shadow map.
    std::erase_if(made.scene.instances,
                  [&](const MeshInstance& body) { return isInside(body, made.camera.positionM); });
    return made;
}

}  // namespace hazer::test
