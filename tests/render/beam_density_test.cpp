// The cubic that stands for uneven haze along a gobo's line: a fit by least squares, as its definition has
// it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "render/glsl_as_cpp.h"

namespace hazer::test {
namespace {

using Function = std::function<double(double)>;

double place(int i, int count) {
    return (2.0 * i + 1.0) / count - 1.0;
}

glm::dvec4 fit(const Function& f, int count) {
    glm::dvec4 sum(0.0);
    for (int i = 0; i < count; ++i) {
        const double y = place(i, count);
        sum += f(y) * glm::dvec4(1.0, y, y * y, y * y * y);
    }
    render::glsl::Formulas<double> formulas;
    return formulas.evenCubic(sum / static_cast<double>(count), count);
}

TEST(EvenCubic, IsACubicsOwnPowers) {
    const glm::dvec4 cubic(0.7, -1.3, 2.1, 0.4);
    for (const int count : {4, 5, 6, 9, 64}) {
        const glm::dvec4 got =
            fit([&](double y) { return cubic[0] + y * (cubic[1] + y * (cubic[2] + y * cubic[3])); }, count);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(got[k], cubic[k], 1e-9) << count << " places, power " << k;
    }
}

// What is left over has nothing of a cubic in it.
TEST(EvenCubic, LeavesWhatIsOrthogonalToAllCubics) {
    const Function wave = [](double y) { return std::cos(5.0 * y + 0.4) + std::exp(y); };
    render::glsl::Formulas<double> formulas;
    for (const int count : {6, 8, 24}) {
        const glm::dvec4 cubic = fit(wave, count);
        for (int power = 0; power < 4; ++power) {
            double left = 0.0;
            for (int i = 0; i < count; ++i) {
                const double y = place(i, count);
                left += (wave(y) - formulas.cubicPower(cubic, y)) * std::pow(y, power);
            }
            EXPECT_NEAR(left, 0.0, 1e-9) << count << " places, power " << power;
        }
    }
}

}  // namespace
}  // namespace hazer::test
