// The scenes whose pictures are kept, and how they are drawn.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/scene.h"
#include "tests/support/image_compare.h"

namespace hazer::test {

/// One entry of scenes.json.
struct GoldenScene {
    std::string name;            ///< Stem of the reference files.
    std::string what;            ///< What a person should see in the picture.
    std::filesystem::path show;  ///< In app/shows (`show`), or in tests/golden/shows (`own_show`).
    std::string cameraName;      ///< A camera of the show; empty: `camera`.
    std::optional<render::Camera> camera;
    int width = 256;
    int height = 144;
    /// Attribute values that are held, by fixture and attribute, in the units of fixtures::Fixture::hold.
    std::map<std::string, std::map<std::string, double>> set;
    bool demoProgramme = false;  ///< The lights do what the demo programme asks for at `timeS`.
    double timeS = 0.0;          ///< Moves the noise.
    std::string view = "light";  ///< Or "error" or "cost", as in `hazer render --view`.
    double maxError = 0.0;       ///< As in render::Settings.
    Tolerance radiance;          ///< In cd/m^2, or what the view is in.
    Tolerance display;           ///< In steps of 1/255.
};

/// The two pictures of a scene.
struct GoldenPictures {
    render::FloatImage radiance;  ///< cd/m^2, cut at kBrightestCdPerM2, or the numbers of a view.
    render::ByteImage display;
};

/// References are half floats, which end at 65504; only lenses are brighter, and the display picture shows
/// them.
inline constexpr float kBrightestCdPerM2 = 60000.0f;

/// Reads tests/golden/scenes.json. Throws std::exception with what is wrong in it.
std::vector<GoldenScene> loadScenes();

/// Draws a scene with the current OpenGL context.
GoldenPictures drawScene(const GoldenScene& scene);

/// Where the reference pictures are.
std::filesystem::path referenceFolder();
std::filesystem::path radianceReference(const GoldenScene& scene);
std::filesystem::path displayReference(const GoldenScene& scene);

}  // namespace hazer::test
