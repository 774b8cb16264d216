#include "tests/render/gobo_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "render/image.h"

namespace hazer::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kDrawnSize = 1024;

bool isLetter(double x, double y) {
    const bool stem = x > -0.35 && x < -0.15 && std::abs(y) < 0.6;
    const bool top = x > -0.35 && x < 0.4 && y > 0.4 && y < 0.6;
    const bool middle = x > -0.35 && x < 0.2 && y > -0.05 && y < 0.15;
    return stem || top || middle;
}

bool isSpoke(double x, double y) {
    return std::hypot(x, y) > 0.06 && std::fmod(std::atan2(y, x) + kPi, kPi / 6.0) < kPi / 12.0;
}

bool isBar(double x, double) {
    return std::fmod(x + 1.0, 1.0 / 6.0) < 1.0 / 12.0;
}

/// A break-up: three octaves of smooth noise, open where they are above zero.
class Noise {
 public:
    Noise() {
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        for (double& value : lattice_) value = normal(random);
    }
    bool operator()(double x, double y) const {
        return octave(5.0 * (x + 1.0), 5.0 * (y + 1.0)) + octave(10.0 * (x + 1.3), 10.0 * (y + 1.2)) / 2.0 +
                   octave(20.0 * (x + 1.1), 20.0 * (y + 1.4)) / 4.0 >
               0.0;
    }

 private:
    double at(int column, int row) const {
        return lattice_[static_cast<std::size_t>((row % 64) * 64 + column % 64)];
    }
    double octave(double x, double y) const {
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
        const double across = ease(x - column);
        const double down = ease(y - row);
        return (1.0 - down) * ((1.0 - across) * at(column, row) + across * at(column + 1, row)) +
               down * ((1.0 - across) * at(column, row + 1) + across * at(column + 1, row + 1));
    }
    std::vector<double> lattice_ = std::vector<double>(64 * 64);
};

}  // namespace

render::GoboPicture drawnGobo(const std::function<bool(double x, double y)>& isOpen) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(std::size_t{4} * kDrawnSize * kDrawnSize);
    for (int row = 0; row < kDrawnSize; ++row) {
        for (int column = 0; column < kDrawnSize; ++column) {
            const double x = 2.0 * (column + 0.5) / kDrawnSize - 1.0;
            const double y = 1.0 - 2.0 * (row + 0.5) / kDrawnSize;
            for (int c = 0; c < 3; ++c) rgba.push_back(isOpen(x, y) ? 255 : 0);
            rgba.push_back(255);
        }
    }
    return render::makeGoboPicture(rgba.data(), kDrawnSize, kDrawnSize);
}

render::GoboPicture whiteGobo() {
    return drawnGobo([](double, double) { return true; });
}

render::GoboPicture letterGobo() {
    return drawnGobo(isLetter);
}

std::vector<NamedGobo> drawnGobos() {
    return {{"letter", letterGobo()},
            {"spokes", drawnGobo(isSpoke)},
            {"bars", drawnGobo(isBar)},
            {"noise", drawnGobo(Noise())},
            {"white", whiteGobo()}};
}

std::vector<NamedGobo> libraryGobos() {
    std::vector<NamedGobo> gobos;
    for (const auto& file : std::filesystem::directory_iterator(HAZER_GOBO_FOLDER)) {
        const render::ByteImage image = render::readByteImage(file.path());
        std::vector<std::uint8_t> rgba;
        for (std::size_t i = 0; i < image.rgb.size(); ++i) {
            rgba.push_back(image.rgb[i]);
            if (i % 3 == 2) rgba.push_back(255);
        }
        gobos.push_back(
            {file.path().stem().string(), render::makeGoboPicture(rgba.data(), image.width, image.height)});
    }
    std::sort(gobos.begin(), gobos.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return gobos;
}

}  // namespace hazer::test
