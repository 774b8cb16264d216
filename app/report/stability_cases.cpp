#include "app/report/stability_cases.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace hazer::app {
namespace {

using render::Camera;
using render::Scene;

/// A point of white light at 6 m that shines straight down in thin haze, seen from the side.
StabilityCase plain(std::string name) {
    StabilityCase one;
    one.name = std::move(name);
    render::Beam beam;
    beam.lensPositionM = {0.0, 0.0, 6.0};
    beam.lensRadiusM = 0.05;
    beam.edge = render::BeamEdge::kFlat;
    beam.fieldAngleRad = glm::radians(30.0);
    beam.beamAngleRad = beam.fieldAngleRad;
    beam.intensityCd = 1e5;
    beam.showsLens = false;
    one.scene.beams.push_back(beam);
    one.camera = {{7.0, -5.0, 2.5}, {0.0, 0.0, 3.5}, {0.0, 0.0, 1.0}, glm::radians(50.0)};
    return one;
}

render::Beam& beamOf(StabilityCase& one) {
    return one.scene.beams.front();
}

/// `change` is made to the plain case.
template <typename Change>
StabilityCase with(std::string name, Change change, Expectation expectation = Expectation::kOracle) {
    StabilityCase one = plain(std::move(name));
    change(one);
    one.expectation = expectation;
    return one;
}

void addBody(Scene& scene, int mesh, const glm::dvec3& centerM, const glm::dvec3& sizeM) {
    render::MeshInstance body;
    body.mesh = mesh;
    body.worldFromMesh = glm::scale(glm::translate(glm::dmat4(1.0), centerM), sizeM);
    body.material.albedo = render::Color(0.0f);
    body.material.specular = 0.0f;
    scene.instances.push_back(body);
}

void move(StabilityCase& one, const glm::dvec3& by) {
    beamOf(one).lensPositionM += by;
    one.camera.positionM += by;
    one.camera.targetM += by;
}

void addAngles(std::vector<StabilityCase>& cases) {
    for (const double half :
         {0.01, 0.05, 0.1, 0.5, 2.0, 45.0, 60.0, 85.0, 89.99, 90.0, 90.01, 120.0, 170.0, 179.0}) {
        cases.push_back(with(fmt::format("half angle {:g} deg", half), [&](StabilityCase& one) {
            beamOf(one).fieldAngleRad = glm::radians(2.0 * half);
        }));
    }
    for (const double half : {0.01, 0.1}) {
        cases.push_back(
            with(fmt::format("half angle {:g} deg, a point source", half), [&](StabilityCase& one) {
                beamOf(one).fieldAngleRad = glm::radians(2.0 * half);
                beamOf(one).lensRadiusM = 0.0;
            }));
    }
    cases.push_back(
        with("zero-length cone: half angle 0", [](StabilityCase& one) { beamOf(one).fieldAngleRad = 0.0; }));
    cases.push_back(with("half angle 179 deg, soft", [](StabilityCase& one) {
        beamOf(one).edge = render::BeamEdge::kSoft;
        beamOf(one).fieldAngleRad = glm::radians(358.0);
        beamOf(one).beamAngleRad = glm::radians(250.0);
    }));
    for (const double beamShare : {0.02, 0.5, 0.999}) {
        cases.push_back(with(fmt::format("soft edge, half the light at {:g} of the field", beamShare),
                             [&](StabilityCase& one) {
                                 beamOf(one).edge = render::BeamEdge::kSoft;
                                 beamOf(one).beamAngleRad = beamShare * beamOf(one).fieldAngleRad;
                             }));
    }
    cases.push_back(with("soft edge, field of 170 deg", [](StabilityCase& one) {
        beamOf(one).edge = render::BeamEdge::kSoft;
        beamOf(one).fieldAngleRad = glm::radians(170.0);
        beamOf(one).beamAngleRad = glm::radians(100.0);
    }));
}

void addHaze(std::vector<StabilityCase>& cases) {
    for (const float extinction : {0.0f, 1e-6f, 0.1f, 1.0f, 10.0f}) {
        cases.push_back(with(fmt::format("extinction {:g} /m", extinction), [&](StabilityCase& one) {
            one.scene.haze.extinctionPerM = extinction;
            one.scene.haze.scatteringPerM = 0.01f;
            // In a fog of 10 /m nothing is seen from afar.
            if (extinction >= 1.0f) one.camera.positionM = {1.2, -1.0, 5.2};
            if (extinction >= 1.0f) one.camera.targetM = {0.0, 0.0, 5.0};
        }));
    }
    for (const float g : {-0.99f, 0.0f, 0.99f}) {
        cases.push_back(with(fmt::format("one lobe, g = {:g}", g), [&](StabilityCase& one) {
            one.scene.haze.phase = {g, g, 1.0f};
        }));
    }
    cases.push_back(with(
        "no haze", [](StabilityCase& one) { one.scene.haze.scatteringPerM = 0.0f; }, Expectation::kDark));
}

void addIntensities(std::vector<StabilityCase>& cases) {
    for (const double candela : {1e-3, 1.0, 1e9}) {
        cases.push_back(with(fmt::format("{:g} cd", candela),
                             [&](StabilityCase& one) { beamOf(one).intensityCd = candela; }));
    }
    cases.push_back(with("a million candela beside a candle", [](StabilityCase& one) {
        beamOf(one).intensityCd = 1e6;
        render::Beam candle = beamOf(one);
        candle.intensityCd = 1.0;
        candle.lensPositionM = {2.0, -1.0, 4.0};
        one.scene.beams.push_back(candle);
    }));
    cases.push_back(with(
        "no light",
        [](StabilityCase& one) {
            beamOf(one).intensityCd = 0.0;
            beamOf(one).fluxLm = 0.0;
        },
        Expectation::kDark));
}

/// Pixels on the axis or over the lens are means over what varies within them.
void addCameras(std::vector<StabilityCase>& cases) {
    const auto look = [&](const char* name, const glm::dvec3& from, const glm::dvec3& to,
                          Expectation expectation) {
        cases.push_back(with(
            name,
            [&](StabilityCase& one) {
                one.camera.positionM = from;
                one.camera.targetM = to;
            },
            expectation));
    };
    look("camera at the lens, along the beam", {0.0, 0.0, 6.0}, {0.0, 0.0, 0.0}, Expectation::kLight);
    look("camera at the lens, across the beam", {0.0, 0.0, 6.0}, {5.0, 0.0, 6.0}, Expectation::kAnything);
    look("camera a hair before the lens", {0.0, 0.0, 5.999}, {0.0, 0.0, 20.0}, Expectation::kLight);
    look("camera on the axis, into the lens", {0.0, 0.0, 1.0}, {0.0, 0.0, 6.0}, Expectation::kLight);
    look("camera on the axis, down the beam", {0.0, 0.0, 3.0}, {0.0, 0.0, -20.0}, Expectation::kOracle);
    look("camera behind the lamp", {0.1, 0.1, 8.0}, {0.0, 0.0, 0.0}, Expectation::kOracle);
    look("lamp behind the camera", {0.5, 0.2, 2.0}, {3.0, 1.0, -4.0}, Expectation::kOracle);
    look("camera inside, across", {0.3, 0.1, 2.0}, {4.0, 0.5, 2.2}, Expectation::kOracle);
    // The side of the cone: tan 15 deg = 0.26795, with the lens 5 cm wide at z = 6.
    look("camera on the side of the cone, along it", {0.05 + 2.0 * 0.26795, 0.0, 4.0},
         {0.05 + 4.0 * 0.26795, 0.0, 2.0}, Expectation::kOracle);
    for (const double farM : {1e3, 1e5}) {
        cases.push_back(
            with(fmt::format("stage {:g} km from the origin", farM / 1e3), [&](StabilityCase& one) {
                move(one, {farM, -0.5 * farM, 10.0});
            }));
        cases.push_back(with(
            fmt::format("lamp {:g} km away", farM / 1e3),
            [&](StabilityCase& one) {
                one.camera.positionM = {farM, 0.0, 3.0};
            },
            Expectation::kAnything));
    }
    cases.push_back(with("field of view 0.1 deg",
                         [](StabilityCase& one) { one.camera.verticalFovRad = glm::radians(0.1); }));
    cases.push_back(with("field of view 170 deg",
                         [](StabilityCase& one) { one.camera.verticalFovRad = glm::radians(170.0); }));
}

void addLenses(std::vector<StabilityCase>& cases) {
    for (const double radiusM : {0.0, 1e-4, 1.0}) {
        cases.push_back(with(fmt::format("lens radius {:g} m", radiusM),
                             [&](StabilityCase& one) { beamOf(one).lensRadiusM = radiusM; }));
    }
    cases.push_back(with("a pencil from a wide lens", [](StabilityCase& one) {
        beamOf(one).lensRadiusM = 0.3;
        beamOf(one).fieldAngleRad = glm::radians(0.6);
    }));
}

void addBodies(std::vector<StabilityCase>& cases) {
    cases.push_back(with(
        "lamp inside a wall",
        [](StabilityCase& one) {
            addBody(one.scene, 0, {0.0, 0.0, 6.0}, {4.0, 4.0, 1.0});
        },
        Expectation::kShaded));
    cases.push_back(with(
        "zero-length cone: a plate at the lens",
        [](StabilityCase& one) {
            addBody(one.scene, 0, {0.0, 0.0, 5.96}, {1.0, 1.0, 0.02});
        },
        Expectation::kAnything));
    cases.push_back(with(
        "camera inside a body",
        [](StabilityCase& one) { addBody(one.scene, 0, one.camera.positionM, glm::dvec3(2.0)); },
        Expectation::kDark));
    cases.push_back(with(
        "a body as thin as paper in the beam",
        [](StabilityCase& one) {
            addBody(one.scene, 0, {0.0, 0.0, 3.0}, {0.5, 0.5, 1e-4});
        },
        Expectation::kLight));
    cases.push_back(with("a body of no size", [](StabilityCase& one) {
        addBody(one.scene, 0, {0.0, 0.0, 3.0}, glm::dvec3(0.0));
    }));
    cases.push_back(with("a floor ten kilometres wide", [](StabilityCase& one) {
        addBody(one.scene, 1, {0.0, 0.0, 0.0}, {1e4, 1e4, 1.0});
    }));
}

}  // namespace

std::vector<StabilityCase> stabilityCases() {
    std::vector<StabilityCase> cases;
    addAngles(cases);
    addHaze(cases);
    addIntensities(cases);
    addCameras(cases);
    addLenses(cases);
    addBodies(cases);
    return cases;
}

std::vector<render::Mesh> stabilityMeshes() {
    return {render::makeBox(), render::makePlane()};
}

std::vector<RefusedShow> refusedShows() {
    const auto light = [](const char* key, const char* value) {
        std::string text = "[[light]]\nname = \"a\"\n";
        for (const auto& [name, usual] :
             {std::pair{"position", "[0, 0, 6]"}, std::pair{"direction", "[0, 0, -1]"},
              std::pair{"candela", "1000.0"}, std::pair{"half_angle", "15.0"},
              std::pair{"lens_radius", "0.0"}}) {
            text += fmt::format("{} = {}\n", name, std::string(name) == key ? value : usual);
        }
        return RefusedShow{fmt::format("{} = {} of a light", key, value), text};
    };
    const auto haze = [](const char* key, const char* value) {
        return RefusedShow{fmt::format("{} = {} of the haze", key, value),
                           fmt::format("[haze]\n{} = {}\n", key, value)};
    };
    return {light("position", "[0, nan, 6]"), light("position", "[0, inf, 6]"),
            light("direction", "[0, 0, 0]"),  light("direction", "[nan, 0, 1]"),
            light("candela", "nan"),          light("candela", "-1.0"),
            light("candela", "inf"),          light("half_angle", "nan"),
            light("half_angle", "0.0"),       light("half_angle", "180.0"),
            light("lens_radius", "-0.1"),     light("lens_radius", "nan"),
            haze("extinction", "nan"),        haze("extinction", "-0.1"),
            haze("scattering", "inf"),        haze("noise", "nan"),
            haze("phase", "{g = 1.0}"),       haze("phase", "{g = nan}")};
}

}  // namespace hazer::app
