// Gobos to test with: those of the library, and drawn ones.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/gobo_picture.h"

namespace hazer::test {

struct NamedGobo {
    std::string name;
    render::GoboPicture picture;
};

/// Drawn from a function of the unit disc (x to the right, y up), `true` where light passes; its edges are
/// smoothed.
render::GoboPicture drawnGobo(const std::function<bool(double x, double y)>& isOpen);

render::GoboPicture whiteGobo();

/// A letter F: no turn and no mirror image is like another.
render::GoboPicture letterGobo();

/// Spokes, bars, the letter, noise, white.
std::vector<NamedGobo> drawnGobos();

/// The wheels of the moving spot in fixtures/library.
std::vector<NamedGobo> libraryGobos();

}  // namespace hazer::test
