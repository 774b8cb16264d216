// The option --size of commands that draw.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace hazer::app {

/// Pixels.
struct Size {
    int width = 1280;
    int height = 720;
};

/// Adds --size WIDTHxHEIGHT to a command; each edge is 1 to 8192, and `size` is what stands unless given.
void addSizeOption(CLI::App& command, Size& size);

}  // namespace hazer::app
