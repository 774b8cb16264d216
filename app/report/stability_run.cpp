#include "app/report/stability_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "app/report/oracle_air.h"
#include "app/show.h"
#include "render/camera.h"

namespace hazer::app {
namespace {

using render::FloatImage;

FloatImage drawPlainly(render::Renderer& renderer, const render::Scene& scene, const render::Camera& camera,
                       int size) {
    render::Settings settings;
    settings.width = size;
    settings.height = size;
    settings.bloom = false;
    renderer.render(scene, camera, settings);
    return renderer.readRadiance();
}

double sumAt(const FloatImage& picture, const glm::ivec2& pixel) {
    const float* rgb = picture.at(pixel.x, pixel.y);
    return static_cast<double>(rgb[0]) + rgb[1] + rgb[2];
}

/// Over a lens, and on the axis as seen from it, a pixel holds the mean of what varies within it.
bool isNearLens(const render::Scene& scene, const render::Camera& camera, int size, const glm::ivec2& pixel) {
    constexpr double kNearPx = 3.0;
    const glm::dvec2 tangent = render::viewTangent(camera, 1.0);
    for (const render::Beam& beam : scene.beams) {
        const glm::dvec3 view =
            glm::transpose(render::worldFromView(camera)) * (beam.lensPositionM - camera.positionM);
        if (view.z >= 0.0) continue;
        const glm::dvec2 place =
            0.5 * (glm::dvec2(view.x, -view.y) / (-view.z * tangent) + 1.0) * double(size);
        const double radiusPx = 0.5 * beam.lensRadiusM / (-view.z * tangent.y) * size;
        if (glm::distance(place, glm::dvec2(pixel) + 0.5) < kNearPx + radiusPx) return true;
    }
    return false;
}

std::vector<glm::ivec2> comparablePixels(const StabilityCase& one, int size) {
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (!isNearLens(one.scene, one.camera, size, {x, y})) pixels.emplace_back(x, y);
        }
    }
    return pixels;
}

float brightestOf(const FloatImage& picture) {
    return *std::max_element(picture.rgb.begin(), picture.rgb.end());
}

float brightestWithoutBodies(StabilityCase one, render::Renderer& renderer, int size) {
    one.scene.instances.clear();
    return brightestOf(drawPlainly(renderer, one.scene, one.camera, size));
}

/// One error for each pixel that the oracle has an answer for.
std::vector<double> relativeErrors(const FloatImage& picture, const std::vector<glm::ivec2>& pixels,
                                   const std::vector<double>& expected) {
    if (expected.empty()) return {};
    const double darkest = 1e-3 * *std::max_element(expected.begin(), expected.end());
    std::vector<double> errors;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] < 0.0) continue;
        const double scale = std::max(expected[i], darkest);
        const double error = std::abs(sumAt(picture, pixels[i]) - expected[i]);
        // Of what a float cannot tell from nothing, nothing is right.
        const bool isNothing = scale < double{std::numeric_limits<float>::min()};
        if (!isNothing || error > scale) errors.push_back(isNothing ? 1.0 : error / scale);
    }
    return errors;
}

std::string numbersVerdict(const StabilityRow& row) {
    if (row.notFinite > 0) return fmt::format("{} rays are no numbers", row.notFinite);
    if (row.belowZero > 0) return fmt::format("{} rays are below 0", row.belowZero);
    return "ok";
}

std::string errorVerdict(const StabilityRow& row) {
    if (row.medianError > kStabilityMedianError) return fmt::format("median error {:.1e}", row.medianError);
    if (row.p99Error > kStabilityP99Error) return fmt::format("error {:.1e} at 99 %", row.p99Error);
    return "ok";
}

/// A lamp and a camera whose every number may be extreme.
StabilityCase randomCase(std::mt19937& random) {
    const auto even = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    const auto anyScale = [&](double from, double to) {
        return std::exp(even(std::log(from), std::log(to)));
    };
    std::normal_distribution<double> normal;
    const auto anyDirection = [&] {
        return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    };
    StabilityCase one;
    render::Beam beam;
    beam.showsLens = false;
    beam.lensRadiusM = even(0.0, 1.0) < 0.3 ? 0.0 : anyScale(1e-3, 0.5);
    beam.fieldAngleRad =
        glm::radians(2.0 * (even(0.0, 1.0) < 0.7 ? anyScale(0.01, 90.0) : even(90.0, 179.0)));
    beam.edge = even(0.0, 1.0) < 0.5 ? render::BeamEdge::kFlat : render::BeamEdge::kSoft;
    beam.beamAngleRad = even(0.1, 1.0) * beam.fieldAngleRad;
    beam.intensityCd = anyScale(1e-3, 1e9);
    beam.lensPositionM = anyScale(1e-2, 1e5) * anyDirection();
    one.scene.beams.push_back(beam);
    const float extinction = even(0.0, 1.0) < 0.1 ? 0.0f : static_cast<float>(anyScale(1e-4, 10.0));
    one.scene.haze.extinctionPerM = extinction;
    one.scene.haze.scatteringPerM = std::max(extinction, 1e-4f);
    one.scene.haze.phase.forwardG = static_cast<float>(even(-0.95, 0.95));
    const double awayM = anyScale(1e-2, 300.0);
    one.camera.positionM = beam.lensPositionM + awayM * anyDirection();
    one.camera.targetM = beam.lensPositionM + 0.7 * awayM * anyDirection();
    one.camera.verticalFovRad = glm::radians(even(20.0, 120.0));
    return one;
}

/// A beam so narrow on the screen that pixels are means has no rays to compare.
bool hasComparableRays(const StabilityCase& one, int size) {
    const double pixelRad = 2.0 * std::tan(0.5 * one.camera.verticalFovRad) / size;
    return one.scene.beams.front().fieldAngleRad > 8.0 * pixelRad;
}

std::string describeRay(const StabilityCase& one, const glm::ivec2& pixel, double got, double want) {
    const render::Beam& beam = one.scene.beams.front();
    const glm::dvec3 camera = one.camera.positionM - beam.lensPositionM;
    return fmt::format(
        "half angle {:.4g} deg{}, lens {:.3g} m, {:.3g} cd, extinction {:.3g} /m, g {:.2f}; camera {:.4g}, "
        "{:.4g}, "
        "{:.4g} m from the lens, field of view {:.0f} deg, pixel {}, {}: {:.5g} instead of {:.5g} cd/m2",
        glm::degrees(0.5 * beam.fieldAngleRad), beam.edge == render::BeamEdge::kSoft ? " (soft)" : "",
        beam.lensRadiusM, beam.intensityCd, one.scene.haze.extinctionPerM, one.scene.haze.phase.forwardG,
        camera.x, camera.y, camera.z, glm::degrees(one.camera.verticalFovRad), pixel.x, pixel.y, got / 3.0,
        want / 3.0);
}

}  // namespace

StabilityRow countFaults(const std::string& name, const FloatImage& picture) {
    StabilityRow row;
    row.name = name;
    row.rays = picture.rgb.size() / 3;
    for (std::size_t i = 0; i < row.rays; ++i) {
        const float* rgb = &picture.rgb[3 * i];
        const auto any = [&](auto isWrong) { return isWrong(rgb[0]) || isWrong(rgb[1]) || isWrong(rgb[2]); };
        if (any([](float v) { return !std::isfinite(v); })) {
            ++row.notFinite;
        } else if (any([](float v) { return v < 0.0f; })) {
            ++row.belowZero;
        }
    }
    row.verdict = numbersVerdict(row);
    return row;
}

void addErrors(std::vector<double> errors, StabilityRow& row) {
    row.compared = errors.size();
    if (errors.empty()) return;
    std::sort(errors.begin(), errors.end());
    row.medianError = errors[errors.size() / 2];
    row.p99Error = errors[(errors.size() - 1) * 99 / 100];
    row.worstError = errors.back();
}

StabilityRow runCase(const StabilityCase& one, render::Renderer& renderer, int size) {
    const FloatImage picture = drawPlainly(renderer, one.scene, one.camera, size);
    StabilityRow row = countFaults(one.name, picture);
    if (!row.passed()) return row;
    const float brightest = brightestOf(picture);
    if (one.expectation == Expectation::kDark && brightest > 0.0f) {
        row.verdict = fmt::format("{:.2e} cd/m2 where it must be dark", brightest);
    } else if (one.expectation == Expectation::kShaded &&
               brightest > 0.05f * brightestWithoutBodies(one, renderer, size)) {
        row.verdict = fmt::format("{:.2e} cd/m2 through a body", brightest);
    } else if (one.expectation == Expectation::kLight && brightest <= 0.0f) {
        row.verdict = "dark where there must be light";
    } else if (one.expectation == Expectation::kOracle) {
        const std::vector<glm::ivec2> pixels = comparablePixels(one, size);
        addErrors(relativeErrors(picture, pixels,
                                 oracleAir(one.scene, one.camera, size, stabilityMeshes(), pixels)),
                  row);
        row.verdict = errorVerdict(row);
    }
    return row;
}

std::vector<StabilityRow> runRefusals() {
    std::vector<StabilityRow> rows;
    for (const RefusedShow& show : refusedShows()) {
        StabilityRow row;
        row.name = show.name + ": refused";
        row.verdict = "taken";
        try {
            parseShow(show.text, "stability.toml");
        } catch (const ShowError&) {
            row.verdict = "ok";
        }
        rows.push_back(row);
    }
    return rows;
}

StabilityRow runRandomRays(render::Renderer& renderer, std::size_t rays, int compareEach, std::string& worst,
                           const std::function<void()>& step) {
    constexpr int kSize = 64;
    std::mt19937 random(1);
    StabilityRow total;
    total.name = "random extreme rays";
    std::vector<double> errors;
    double worstError = 0.0;
    while (total.rays < rays) {
        step();
        const StabilityCase one = randomCase(random);
        const FloatImage picture = drawPlainly(renderer, one.scene, one.camera, kSize);
        const StabilityRow row = countFaults("", picture);
        total.rays += row.rays;
        total.notFinite += row.notFinite;
        total.belowZero += row.belowZero;
        if (!hasComparableRays(one, kSize)) continue;
        std::vector<glm::ivec2> pixels = comparablePixels(one, kSize);
        std::shuffle(pixels.begin(), pixels.end(), random);
        pixels.resize(std::min(pixels.size(), static_cast<std::size_t>(compareEach)));
        const std::vector<double> expected = oracleAir(one.scene, one.camera, kSize, {}, pixels);
        const std::vector<double> found = relativeErrors(picture, pixels, expected);
        errors.insert(errors.end(), found.begin(), found.end());
        if (found.size() != expected.size()) continue;
        const auto largest = std::max_element(found.begin(), found.end());
        if (largest == found.end() || *largest <= worstError) continue;
        worstError = *largest;
        const auto index = static_cast<std::size_t>(largest - found.begin());
        worst = describeRay(one, pixels[index], sumAt(picture, pixels[index]), expected[index]);
    }
    addErrors(std::move(errors), total);
    total.verdict = numbersVerdict(total);
    if (total.passed()) total.verdict = errorVerdict(total);
    return total;
}

}  // namespace hazer::app
