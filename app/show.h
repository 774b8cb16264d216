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
#include <vector>

#include "app/show_input.h"
#include "app/show_recording.h"
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

/// A fixture as it is patched, before its GDTF is read.
struct ShowFixture {
    std::string name;  ///< Unique in the show.
    std::string gdtf;  ///< Name of a fixture in hazer's library, or a path relative to the show.
    std::string mode;
    protocol::UniverseId universe;
    int slot = 1;  ///< 1..512: where its first channel is.
    glm::dvec3 positionM{0.0};
    glm::dvec3 rotationDeg{0.0};  ///< About world X, then Y, then Z.
    std::map<std::string, double>
        held;              ///< Attribute values that win over DMX, in the units of Fixture::hold.
    std::size_t line = 0;  ///< In the show file, for messages about what the GDTF turns out to hold.
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

    /// The camera of that name. Throws ShowError, which lists the names there are.
    const ShowCamera& camera(std::string_view name) const;
};

/// Whether a recording of the show follows the time code of Art-Net.
bool followsTimeCode(const Show& show);

/// Parses the text of a show. `file` is used in messages and to resolve relative paths; nothing is opened.
/// Throws ShowError.
Show parseShow(std::string_view text, const std::filesystem::path& file);

/// Reads a show of at most 16 MiB. Throws ShowError.
Show loadShow(const std::filesystem::path& file);

/// The pose of something that stands at `positionM`, turned by `rotationDeg` about world X, then Y, then Z.
glm::dmat4 worldFromPlaced(const glm::dvec3& positionM, const glm::dvec3& rotationDeg);

}  // namespace hazer::app
