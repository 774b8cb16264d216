// Prints a shader as the driver gets it, for checks by other programs: expand_shader FOLDER FILE [FEATURE...]
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "render/gl/shader_source.h"

int main(int argc, char** argv) try {
    if (argc < 3) {
        std::cerr << "usage: expand_shader FOLDER FILE [FEATURE...]\n";
        return 1;
    }
    const std::vector<std::string> features(argv + 3, argv + argc);
    std::cout << hazer::render::gl::expandShader(argv[1], argv[2], features);
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
