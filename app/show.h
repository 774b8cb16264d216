// The show file: one TOML that names the rig, the scene, the haze, the cameras and the inputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/show_input.h"
#include "app/show_recording.h"
#include "fixtures/fixture.h"
#include "protocol/dmx.h"
#include "render/scene.h"

namespace hazer::app {

/// A show that cannot be used. what() is one sentence: file, line, what is wrong, what would be right.
class ShowError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

struct ShowCamera {
    std::string name;
    render::Camera camera;
};

/// Where a DMX break of a fixture starts.
struct ShowAddress {
    int dmxBreak = 1;  ///< 1..fixtures::kMaxBreak.
    /// Never empty. Of several that are heard, the highest level of each slot counts.
    std::vector<protocol::UniverseId> universes;
    int slot = 1;  ///< 1..512: where the break's first channel is.
};

/// What only a rig knows of a fixture.
struct RigFixture {
    fixtures::FixtureTypePtr type;  ///< Never null; ShowFixture::gdtf is its name in the rig.
    glm::dmat4 worldFromFixture{1.0};
    fixtures::Fittings fittings;
    std::vector<std::pair<std::string, double>> presets;  ///< Attributes until DMX arrives, as `held`.
    std::optional<glm::dvec3> focusM;                     ///< Where it points until then.
};

/// A fixture as it is patched. Of one that no rig brings, the GDTF is not read yet.
struct ShowFixture {
    std::string name;  ///< Unique in the show.
    std::string gdtf;  ///< Name of a fixture in hazer's library, or a path relative to the show.
    std::string mode;
    std::vector<ShowAddress> addresses;  ///< Each break once, ascending; none: not patched.
    glm::dvec3 positionM{0.0};
    glm::dvec3 rotationDeg{0.0};  ///< About world X, then Y, then Z.
    std::map<std::string, double>
        held;              ///< Attribute values that win over DMX, in the units of Fixture::hold.
    std::size_t line = 0;  ///< In the show file, for messages about what the GDTF turns out to hold.
    std::optional<RigFixture> rig;
};

/// A gobo is a flat picture before the lamp: at 90 degrees its edge would be infinitely far away. Half angle.
inline constexpr double kWidestGoboRad = 89.0 * 3.14159265358979323846 / 180.0;

/// A light given by numbers, with no fixture around it and no DMX. Its lens is not drawn.
struct ShowLight {
    std::string name;                ///< Unique among lights and fixtures.
    render::Beam beam;               ///< Whole but for the handles of its gobo and web.
    std::filesystem::path goboFile;  ///< As ShowObject::modelFile; empty: none.
    std::filesystem::path webFile;   ///< The same; LM-63, in place of the beam's angles.
    std::size_t line = 0;            ///< In the show file.
};

enum class ObjectShape : std::uint8_t {
    kFloor,
    kWall,
    kBox,
    kCylinder,
    kSphere,
    kTeapot,
    kPerson,
    kTruss,
    kDeck,
    kModel
};

/// Something that light falls on.
struct ShowObject {
    ObjectShape shape = ObjectShape::kBox;
    std::string name;
    glm::dvec3 positionM{0.0};
    glm::dvec3 rotationDeg{0.0};  ///< About world X, then Y, then Z.

    /// Edges of a box, deck, cylinder or sphere [m]. Floor and wall: width and depth or height. Truss: x is
    /// its length, y its width. Person and teapot: z is the height. Model: a factor on each axis.
    glm::dvec3 sizeM{1.0};

    std::filesystem::path
        modelFile;  ///< Of a kModel; relative to the folder of the show as written, absolute here.
    render::Material material;
    bool castsShadow = true;
    bool isFurther = false;  ///< Hidden unless further objects are shown.
    std::size_t line = 0;    ///< In the show file.
};

/// Which networks the universes of a rig, which are numbers from 1, are heard on.
enum class RigProtocol : std::uint8_t {
    kBoth,   ///< Both of the next.
    kSacn,   ///< sACN universes of the same number.
    kArtNet  ///< Art-Net Port-Addresses of a number that is one lower.
};

/// The MVR of a show as the show names it.
struct ShowRig {
    std::filesystem::path file;  ///< As ShowObject::modelFile; empty: none.
    RigProtocol protocol = RigProtocol::kBoth;
    std::size_t line = 0;
};

/// The scene objects of a rig: meshes that are read from the archive when they are drawn.
struct ShowScenery {
    struct Use {
        std::size_t file = 0;  ///< Into files.
        glm::dmat4 worldFromMesh{1.0};
    };
    std::filesystem::path archive;
    std::vector<std::string> files;  ///< As the scene names them.
    std::vector<Use> uses;
};

/// A whole show. Colours are linear Rec. 709 in the file and Rec. 2020 here, as the renderer has them.
struct Show {
    std::filesystem::path file;
    std::string title;
    render::Color backgroundCdPerM2{0.0f};
    render::Haze haze;
    render::Ambient ambient;
    float exposureEv100 = 8.0f;
    bool hasInertia = true;  ///< Motors of fixtures have speed and acceleration.
    std::vector<ShowInput> inputs;
    std::vector<ShowRecording> recordings;
    std::vector<ShowCamera> cameras;  ///< Never empty: a show without any gets one named "default".
    std::vector<ShowFixture> fixtures;
    std::vector<ShowLight> lights;
    std::vector<ShowObject> objects;
    ShowRig rig;
    ShowScenery scenery;                ///< Of the rig.
    std::vector<std::string> warnings;  ///< About the rig: what was read over, and what stands in for what.

    /// The camera of that name. Throws ShowError, which lists the names there are.
    const ShowCamera& camera(std::string_view name) const;
};

/// Whether a recording of the show follows the time code of Art-Net.
bool followsTimeCode(const Show& show);

/// Parses the text of a show. `file` is used in messages and to resolve relative paths; nothing is opened,
/// and of a rig only the name is known. Throws ShowError.
Show parseShow(std::string_view text, const std::filesystem::path& file);

/// Reads a show of at most 16 MiB with its rig, or an MVR as a show of its own. Throws ShowError.
Show loadShow(const std::filesystem::path& file);

/// The pose of something that stands at `positionM`, turned by `rotationDeg` about world X, then Y, then Z.
glm::dmat4 worldFromPlaced(const glm::dvec3& positionM, const glm::dvec3& rotationDeg);

}  // namespace hazer::app
