// Box truss, as stages are hung from.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "render/mesh.h"
#include "render/mesh_builder.h"

namespace hazer::render {
namespace {

/// Tubes of the common 290 mm truss (50 mm chords, 20 mm lacing), as a share of its width.
constexpr float kChordRadiusPerWidth = 0.5f * 50.0f / 290.0f;
constexpr float kLacingRadiusPerWidth = 0.5f * 20.0f / 290.0f;
constexpr int kTubeSides = 6;
/// A truss that is longer than so many of its widths gets flatter lacing, not more of it.
constexpr double kMostBays = 1000.0;

/// One side of the truss: where the axes of its two chords cross the YZ plane.
struct Side {
    glm::vec2 firstChordM;
    glm::vec2 secondChordM;
};

void appendZigZag(Mesh& mesh, const Side& side, float lengthM, int bays, float radiusM) {
    const auto corner = [&](int i) {
        const float x = lengthM * (static_cast<float>(i) / static_cast<float>(bays) - 0.5f);
        return glm::vec3(x, i % 2 == 0 ? side.firstChordM : side.secondChordM);
    };
    for (int i = 0; i < bays; ++i) appendBar(mesh, corner(i), corner(i + 1), radiusM, kTubeSides);
}

}  // namespace

Mesh makeTruss(double lengthM, double widthM) {
    assert(lengthM > 0.0 && widthM > 0.0);
    const auto length = static_cast<float>(lengthM);
    const auto width = static_cast<float>(widthM);
    const float chordRadiusM = width * kChordRadiusPerWidth;
    const float half = 0.5f * width - chordRadiusM;
    const std::array<glm::vec2, 4> chords{glm::vec2(-half, -half), glm::vec2(half, -half),
                                          glm::vec2(half, half), glm::vec2(-half, half)};
    // Diagonals of about 45 degrees.
    const int bays = static_cast<int>(std::clamp(std::round(lengthM / widthM), 1.0, kMostBays));
    Mesh mesh;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        appendBar(mesh, {-0.5f * length, chords[i]}, {0.5f * length, chords[i]}, chordRadiusM, kTubeSides);
        appendZigZag(mesh, {chords[i], chords[(i + 1) % chords.size()]}, length, bays,
                     width * kLacingRadiusPerWidth);
    }
    return mesh;
}

}  // namespace hazer::render
