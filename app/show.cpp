#include "app/show.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <sstream>

#include "app/light_color.h"
#include "app/nearest_name.h"
#include "app/show_light.h"
#include "app/show_limits.h"
#include "app/show_rig.h"
#include "app/toml_nesting.h"
#include "app/toml_reader.h"

namespace hazer::app {
namespace {

constexpr std::uintmax_t kMostBytes = 16u * 1024u * 1024u;

constexpr Limits kLight{0.0, 1e6};  // cd/m2, lx
constexpr Limits kSize{0.0, 1e5};   // m
constexpr Limits kPerMetre{0.0, 10.0};

// In the order of protocol::Transport.
const std::vector<std::string> kProtocols{"artnet", "sacn", "dmx", "any"};
// The universes of each.
constexpr Limits kUniverses[]{{0, 32767}, {1, 63999}, {1, 65535}, {1, 63999}};

// In the order of RigProtocol.
const std::vector<std::string> kRigProtocols{"both", "sacn", "artnet"};

// In the order of ObjectShape.
const std::vector<std::string> kShapes{"floor",  "wall",   "box",   "cylinder", "sphere",
                                       "teapot", "person", "truss", "deck",     "model"};

glm::dvec3 defaultSizeM(ObjectShape shape) {
    switch (shape) {
        case ObjectShape::kFloor:
            return {20.0, 20.0, 0.0};
        case ObjectShape::kWall:
            return {20.0, 6.0, 0.0};
        case ObjectShape::kTeapot:
            return {1.0, 1.0, 0.4};
        case ObjectShape::kPerson:
            return {1.0, 1.0, 1.75};
        case ObjectShape::kTruss:
            return {4.0, 0.3, 0.3};
        case ObjectShape::kDeck:
            return {2.0, 1.0, 0.4};
        case ObjectShape::kBox:
        case ObjectShape::kCylinder:
        case ObjectShape::kSphere:
        case ObjectShape::kModel:
            break;
    }
    return glm::dvec3(1.0);
}

/// Which components of the size the shape uses: those must not be 0.
glm::bvec3 usedSize(ObjectShape shape) {
    switch (shape) {
        case ObjectShape::kFloor:
        case ObjectShape::kWall:
        case ObjectShape::kTruss:
            return {true, true, false};
        case ObjectShape::kTeapot:
        case ObjectShape::kPerson:
            return {false, false, true};
        case ObjectShape::kBox:
        case ObjectShape::kCylinder:
        case ObjectShape::kSphere:
        case ObjectShape::kDeck:
        case ObjectShape::kModel:
            break;
    }
    return glm::bvec3(true);
}

/// A single lobe. The other one has no weight; it stands where the integrator expects it.
render::PhaseFunction oneLobe(float g) {
    return g >= 0.0f ? render::PhaseFunction{g, 0.0f, 1.0f} : render::PhaseFunction{0.0f, g, 0.0f};
}

render::PhaseFunction readPhase(TomlReader reader) {
    render::PhaseFunction phase;
    const Limits belowOne{-0.99, 0.99};
    if (reader.has("g")) {
        const auto g = static_cast<float>(reader.requiredNumber("g", belowOne));
        for (const char* key : {"forward_g", "backward_g", "forward_weight"}) {
            if (reader.has(key))
                reader.fail(fmt::format("[phase] has both 'g' and '{}'; keep one of them", key));
        }
        reader.refuseUnknownKeys();
        return oneLobe(g);
    }
    phase.forwardG = static_cast<float>(reader.number("forward_g", phase.forwardG, belowOne));
    phase.backwardG = static_cast<float>(reader.number("backward_g", phase.backwardG, belowOne));
    phase.forwardWeight = static_cast<float>(reader.number("forward_weight", phase.forwardWeight, kShare));
    reader.refuseUnknownKeys();
    return phase;
}

render::Haze readHaze(TomlReader reader) {
    render::Haze haze;
    haze.extinctionPerM = static_cast<float>(reader.number("extinction", haze.extinctionPerM, kPerMetre));
    haze.scatteringPerM = static_cast<float>(reader.number("scattering", haze.extinctionPerM, kPerMetre));
    haze.noise.amount = static_cast<float>(reader.number("noise", haze.noise.amount, kShare));
    haze.noise.scaleM = static_cast<float>(reader.number("noise_scale", haze.noise.scaleM, {0.01, 1e4}));
    haze.noise.windMps = glm::vec3(reader.vector("wind", glm::dvec3(haze.noise.windMps), {-100.0, 100.0}));
    haze.noise.turbulence =
        static_cast<float>(reader.number("turbulence", haze.noise.turbulence, {0.0, 4.0}));
    haze.noise.seed = static_cast<std::uint32_t>(reader.integer("seed", 1, {0.0, 2147483647.0}));
    if (const auto phase = reader.table("phase")) haze.phase = readPhase(*phase);
    haze.deltaEddington = reader.flag("delta_eddington", false);
    reader.refuseUnknownKeys();
    return haze;
}

render::Ambient readAmbient(TomlReader reader) {
    render::Ambient ambient;
    ambient.color = rec2020FromRec709(reader.vector("color", glm::dvec3(1.0), kColor));
    ambient.illuminanceLx = static_cast<float>(reader.number("illuminance", 0.0, kLight));
    reader.refuseUnknownKeys();
    return ambient;
}

float readExposure(TomlReader reader, float otherwise) {
    const float ev100 = static_cast<float>(reader.number("ev100", otherwise, {-20.0, 40.0}));
    reader.refuseUnknownKeys();
    return ev100;
}

ShowCamera readCamera(TomlReader& reader) {
    ShowCamera named;
    named.name = reader.requiredText("name");
    render::Camera& camera = named.camera;
    camera.positionM = reader.vector("position", camera.positionM, kLength);
    camera.targetM = reader.vector("target", camera.targetM, kLength);
    camera.verticalFovRad =
        glm::radians(reader.number("fov", glm::degrees(camera.verticalFovRad), {0.1, 170.0}));
    if (glm::distance(camera.positionM, camera.targetM) < 1e-6) {
        reader.fail(
            fmt::format("camera '{}' looks at the place where it stands; move its target", named.name));
    }
    reader.refuseUnknownKeys();
    return named;
}

ShowAddress readAddress(TomlReader& reader, std::size_t protocol) {
    const auto number = static_cast<std::uint16_t>(reader.requiredInteger("universe", kUniverses[protocol]));
    return {
        1, {{static_cast<protocol::Transport>(protocol), number}}, reader.requiredInteger("slot", {1, 512})};
}

/// A break after the first. Unless it says otherwise, its protocol is that of the fixture.
void readBreak(TomlReader& reader, std::size_t protocol, std::vector<ShowAddress>& addresses) {
    const int number = reader.requiredInteger("number", {2, fixtures::kMaxBreak});
    const auto place = std::ranges::lower_bound(addresses, number, {}, &ShowAddress::dmxBreak);
    if (place != addresses.end() && place->dmxBreak == number)
        reader.fail(fmt::format("break {} is there twice; keep one of them", number));
    ShowAddress address = readAddress(reader, reader.choice("protocol", kProtocols, protocol));
    address.dmxBreak = number;
    addresses.insert(place, std::move(address));
    reader.refuseUnknownKeys();
}

ShowFixture readFixture(TomlReader& reader) {
    ShowFixture fixture;
    fixture.line = reader.line();
    fixture.name = reader.requiredText("name");
    fixture.gdtf = reader.requiredText("gdtf");
    fixture.mode = reader.requiredText("mode");
    const std::size_t protocol = reader.choice("protocol", kProtocols, 0);
    fixture.addresses.push_back(readAddress(reader, protocol));
    for (TomlReader& further : reader.tables("break")) readBreak(further, protocol, fixture.addresses);
    fixture.positionM = reader.vector("position", glm::dvec3(0.0), kLength);
    fixture.rotationDeg = reader.vector("rotation", glm::dvec3(0.0), kAngle);
    fixture.held = reader.numbers("set");
    reader.refuseUnknownKeys();
    return fixture;
}

render::Material readMaterial(TomlReader& reader) {
    render::Material material;
    const std::string_view albedo = reader.oneOf("albedo", "color").value_or("albedo");
    material.albedo = rec2020FromRec709(reader.vector(albedo, glm::dvec3(0.5), kColor));
    material.specular = static_cast<float>(reader.number("specular", material.specular, kShare));
    material.shininess = static_cast<float>(reader.number("shininess", material.shininess, {1.0, 1000.0}));
    return material;
}

void refuseFlatSize(const TomlReader& reader, const ShowObject& object, const std::string& shape) {
    const glm::bvec3 used = usedSize(object.shape);
    for (int axis = 0; axis < 3; ++axis) {
        if (used[axis] && object.sizeM[axis] <= 0.0) {
            reader.fail(fmt::format("the size of a {} must be above 0 along {}", shape, "xyz"[axis]));
        }
    }
}

ShowObject readObject(TomlReader& reader, const std::filesystem::path& folder) {
    ShowObject object;
    const std::size_t shape = reader.requiredChoice("type", kShapes);
    object.shape = static_cast<ObjectShape>(shape);
    object.line = reader.line();
    object.name = reader.text("name", "");
    object.positionM = reader.vector("position", glm::dvec3(0.0), kLength);
    object.rotationDeg = reader.vector("rotation", glm::dvec3(0.0), kAngle);
    object.sizeM = reader.vector("size", defaultSizeM(object.shape), kSize, true);
    refuseFlatSize(reader, object, kShapes[shape]);
    if (object.shape == ObjectShape::kModel) object.modelFile = folder / reader.requiredText("file");
    object.material = readMaterial(reader);
    object.castsShadow = reader.flag("shadow", object.shape != ObjectShape::kFloor);
    object.isFurther = reader.flag("further", false);
    reader.refuseUnknownKeys();
    return object;
}

ShowRig readRig(TomlReader& reader, const std::filesystem::path& folder) {
    ShowRig rig;
    const std::string file = reader.text("rig", "");
    if (!file.empty()) rig.file = folder / file;
    if (file.empty() && reader.has("rig_protocol"))
        reader.fail("'rig_protocol' does nothing without a 'rig'; name one or take it out");
    rig.protocol = static_cast<RigProtocol>(reader.choice("rig_protocol", kRigProtocols, 0));
    return rig;
}

void refuseRepeatedNames(const Show& show) {
    std::set<std::string> names;
    const auto take = [&](const std::string& name, std::size_t line, const char* what) {
        if (names.insert(name).second) return;
        failInShow(show.file, line,
                   fmt::format("a second {} is named '{}'; each needs a name of its own", what, name));
    };
    for (const ShowFixture& fixture : show.fixtures) take(fixture.name, fixture.line, "fixture");
    for (const ShowLight& light : show.lights) take(light.name, light.line, "fixture or light");
}

/// A show without inputs listens to Art-Net as soon as a recording follows its time code.
void refuseUnheardTimeCode(const Show& show) {
    const auto isArtNet = [](const ShowInput& input) {
        return input.transport == protocol::Transport::kArtNet;
    };
    if (show.inputs.empty() || std::ranges::any_of(show.inputs, isArtNet)) return;
    for (const ShowRecording& recording : show.recordings) {
        if (recording.clock != PlaybackClock::kTimeCode) continue;
        failInShow(show.file, recording.line,
                   "time code comes by Art-Net, which no input of the show listens to; add an [[input]] with "
                   "protocol = \"artnet\" or take follow out");
    }
}

void readLists(TomlReader& reader, Show& show) {
    const std::filesystem::path folder = show.file.parent_path();
    for (TomlReader& input : reader.tables("input")) {
        if (isRecordingInput(input)) {
            show.recordings.push_back(readRecording(input, folder));
        } else {
            show.inputs.push_back(readInput(input));
        }
    }
    refuseContradictions(show.inputs, show.file);
    refuseUnheardTimeCode(show);
    for (TomlReader& camera : reader.tables("camera")) show.cameras.push_back(readCamera(camera));
    for (TomlReader& fixture : reader.tables("fixture")) show.fixtures.push_back(readFixture(fixture));
    for (TomlReader& light : reader.tables("light")) show.lights.push_back(readLight(light, folder));
    for (TomlReader& object : reader.tables("object")) {
        show.objects.push_back(readObject(object, folder));
    }
    if (show.cameras.empty()) show.cameras.push_back({"default", render::Camera{}});
}

Show readShow(TomlReader reader, const std::filesystem::path& file) {
    Show show;
    show.file = file;
    show.title = reader.text("title", file.stem().string());
    show.backgroundCdPerM2 = rec2020FromRec709(reader.vector("background", glm::dvec3(0.0), kLight));
    show.hasInertia = reader.flag("inertia", true);
    if (const auto haze = reader.table("haze")) show.haze = readHaze(*haze);
    if (const auto exposure = reader.table("exposure")) {
        show.exposureEv100 = readExposure(*exposure, show.exposureEv100);
    }
    if (const auto ambient = reader.table("ambient")) show.ambient = readAmbient(*ambient);
    readLists(reader, show);
    show.rig = readRig(reader, file.parent_path());
    reader.refuseUnknownKeys();
    refuseRepeatedNames(show);
    return show;
}

std::string readText(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) {
        throw ShowError(fmt::format("{}: the show cannot be read: {}", file.string(), error.message()));
    }
    if (size > kMostBytes)
        throw ShowError(fmt::format("{}: a show of more than 16 MiB is refused", file.string()));
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        throw ShowError(fmt::format("{}: the show cannot be read; check its permissions", file.string()));
    return text.str();
}

}  // namespace

bool followsTimeCode(const Show& show) {
    return std::ranges::any_of(show.recordings, [](const ShowRecording& recording) {
        return recording.clock == PlaybackClock::kTimeCode;
    });
}

const ShowCamera& Show::camera(std::string_view name) const {
    std::vector<std::string> names;
    for (const ShowCamera& candidate : cameras) {
        if (candidate.name == name) return candidate;
        names.push_back(candidate.name);
    }
    throw ShowError(
        fmt::format("{}: no camera is named '{}'.{}", file.string(), name, suggestName(name, names)));
}

Show parseShow(std::string_view text, const std::filesystem::path& file) {
    if (const auto line = lineOfDeepKey(text)) {
        failInShow(file, *line, "a key has too many dots; no key of a show needs them");
    }
    try {
        const toml::table table = toml::parse(text, file.string());
        return readShow(TomlReader(table, file, "the show"), file);
    } catch (const toml::parse_error& error) {
        failInShow(file, error.source().begin.line, std::string(error.description()));
    }
}

Show loadShow(const std::filesystem::path& file) {
    if (isRig(file)) return showOfRig(file);
    Show show = parseShow(readText(file), file);
    if (!show.rig.file.empty()) addRig(show);
    return show;
}

glm::dmat4 worldFromPlaced(const glm::dvec3& positionM, const glm::dvec3& rotationDeg) {
    const glm::dvec3 angle = glm::radians(rotationDeg);
    glm::dmat4 world = glm::translate(glm::dmat4(1.0), positionM);
    world = glm::rotate(world, angle.z, {0.0, 0.0, 1.0});
    world = glm::rotate(world, angle.y, {0.0, 1.0, 0.0});
    return glm::rotate(world, angle.x, {1.0, 0.0, 0.0});
}

}  // namespace hazer::app
