#include "render/profile_rule.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/glsl_as_cpp.h"

namespace hazer::render {
namespace {

/// Integrals of x^0, x^2, x^4, x^6 times the weight over 0..1. The weight is the profile at the place of the
/// chord, times d(angle)/dx but for a constant; both are even in x.
std::array<double, 4> evenMoments(const BeamShape& shape, double cosMiddle, double tanEnd) {
    constexpr int kPieces = 16;
    glsl::Formulas<double> formulas;
    std::array<double, 4> moments{};
    for (int piece = 0; piece < kPieces; ++piece) {
        for (int i = 0; i < 4; ++i) {
            const double x = (piece + formulas.gaussNode4(i)) / kPieces;
            const double stretch = 1.0 + x * x * tanEnd * tanEnd;
            const double psi = std::acos(std::min(cosMiddle / std::sqrt(stretch), 1.0));
            double term = formulas.gaussWeight4(i) / kPieces * relativeIntensity(shape, psi) / stretch;
            for (double& moment : moments) {
                moment += term;
                term *= x * x;
            }
        }
    }
    return moments;
}

/// Squares of the nodes are the roots of the polynomial in x^2 that is orthogonal to 1 and x^2 (Golub and
/// Welsch 1969 for the general case; two nodes need no more than a quadratic equation).
glm::vec4 gaussRule(const std::array<double, 4>& m) {
    const double determinant = m[1] * m[1] - m[0] * m[2];
    const double linear = (m[0] * m[3] - m[1] * m[2]) / determinant;
    const double constant = (m[2] * m[2] - m[1] * m[3]) / determinant;
    const double root = std::sqrt(std::max(0.25 * linear * linear - constant, 0.0));
    const double near2 = -0.5 * linear - root;
    const double far2 = -0.5 * linear + root;
    const double farWeight = (m[1] - near2 * m[0]) / (far2 - near2);
    return glm::vec4(
        glm::dvec4(std::sqrt(std::max(near2, 0.0)), std::sqrt(far2), m[0] - farWeight, farWeight));
}

}  // namespace

bool hasProfileRules(const BeamShape& shape) {
    constexpr double kWidestRad = 0.6;
    return shape.exponent > 0.0 && shape.cutHalfAngleRad <= kWidestRad;
}

std::vector<glm::vec4> profileRules(const BeamShape& shape) {
    std::vector<glm::vec4> rules;
    const double sinCut = std::sin(shape.cutHalfAngleRad);
    for (int column = 0; column + 1 < kProfileRuleColumns; ++column) {
        const double sinMiddle = sinCut * column / (kProfileRuleColumns - 1);
        const double cosMiddle = std::sqrt(1.0 - sinMiddle * sinMiddle);
        const double tanEnd =
            std::sqrt(sinCut * sinCut - sinMiddle * sinMiddle) / std::cos(shape.cutHalfAngleRad);
        rules.push_back(gaussRule(evenMoments(shape, cosMiddle, tanEnd)));
    }
    // Along the rim there is no light: the nodes of the column before, and no weight.
    rules.push_back(glm::vec4(rules.back().x, rules.back().y, 0.0f, 0.0f));
    return rules;
}

}  // namespace hazer::render
