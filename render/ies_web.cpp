#include "render/ies_web.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/error.h"
#include "render/web_formulas.h"

namespace hazer::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegPerRad = 180.0 / kPi;

/// Angle from the axis of a row, which need not be whole.
double thetaOfRow(double row) {
    const double share = row / (kWebThetas - 1);
    return kPi * share * share;
}

double azimuthOfColumn(int column) {
    return 2.0 * kPi * column / kWebAzimuths;
}

/// Between which two angles of a list one lies: at share `fraction` of the way from `index` to the next.
struct Spot {
    bool inside = false;  ///< Nothing was measured outside the list.
    std::size_t index = 0;
    double fraction = 0.0;
};

Spot spotIn(const std::vector<double>& angles, double angle) {
    constexpr double kRoundingDeg = 1e-9;
    if (angles.size() == 1) return {true, 0, 0.0};
    if (angle < angles.front() - kRoundingDeg || angle > angles.back() + kRoundingDeg) return {};
    const auto above = std::upper_bound(angles.begin() + 1, angles.end() - 1, angle);
    const auto index = static_cast<std::size_t>(above - angles.begin()) - 1;
    const double fraction = (angle - angles[index]) / (angles[index + 1] - angles[index]);
    return {true, index, std::clamp(fraction, 0.0, 1.0)};
}

double interpolated(const IesTable& table, const Spot& horizontal, const Spot& vertical) {
    if (!horizontal.inside || !vertical.inside) return 0.0;
    const auto alongPlane = [&](std::size_t plane) {
        return std::lerp(table.at(plane, vertical.index), table.at(plane, vertical.index + 1),
                         vertical.fraction);
    };
    const double here = alongPlane(horizontal.index);
    return horizontal.fraction == 0.0
               ? here
               : std::lerp(here, alongPlane(horizontal.index + 1), horizontal.fraction);
}

/// Type C: the azimuth [deg, 0..360) as the file's planes have it.
double foldedAzimuth(const std::vector<double>& planes, double azimuthDeg) {
    if (planes.front() == 90.0) {
        if (azimuthDeg < 90.0) return 180.0 - azimuthDeg;
        return azimuthDeg > 270.0 ? 540.0 - azimuthDeg : azimuthDeg;
    }
    double folded = azimuthDeg;
    if (planes.back() <= 180.0 && folded > 180.0) folded = 360.0 - folded;
    if (planes.back() <= 90.0 && folded > 90.0) folded = 180.0 - folded;
    return folded;
}

/// A list of type A or B that begins with 0 stands for both sides.
double mirrored(const std::vector<double>& angles, double angle) {
    return angles.front() == 0.0 ? std::abs(angle) : angle;
}

struct FileAngles {
    double horizontalDeg;
    double verticalDeg;
};

/// Types A and B: the inverse of what IesType says.
FileAngles fileAngles(IesType type, double theta, double azimuth) {
    const double right = std::sin(theta) * std::cos(azimuth);
    const double up = std::sin(theta) * std::sin(azimuth);
    const double ahead = std::cos(theta);
    if (type == IesType::kB) return {std::asin(right) * kDegPerRad, std::atan2(up, ahead) * kDegPerRad};
    return {std::atan2(right, ahead) * kDegPerRad, std::asin(up) * kDegPerRad};
}

/// Intensities [cd] of one row of the grid.
void resampleRow(const IesTable& table, double theta, std::vector<double>& row) {
    for (int column = 0; column < kWebAzimuths; ++column) {
        const double azimuth = azimuthOfColumn(column);
        FileAngles at{foldedAzimuth(table.horizontalDeg, azimuth * kDegPerRad), theta * kDegPerRad};
        if (table.type != IesType::kC) {
            at = fileAngles(table.type, theta, azimuth);
            at.horizontalDeg = mirrored(table.horizontalDeg, at.horizontalDeg);
            at.verticalDeg = mirrored(table.verticalDeg, at.verticalDeg);
        }
        row[static_cast<std::size_t>(column)] = interpolated(
            table, spotIn(table.horizontalDeg, at.horizontalDeg), spotIn(table.verticalDeg, at.verticalDeg));
    }
}

/// What a row says about the web, over its peak.
struct RowSummary {
    double mean = 0.0;
    double largest = 0.0;
};

/// Integral of the web over the sphere [lm]: Gauss-Legendre between rows, where it is linear in the row.
double flux(const std::vector<RowSummary>& rows, double peakCd) {
    glsl::Formulas<double> formulas;
    double sum = 0.0;
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
        for (int i = 0; i < 4; ++i) {
            const double fraction = formulas.gaussNode4(i);
            const double at = static_cast<double>(row) + fraction;
            const double thetaPerRow = 2.0 * kPi * at / ((kWebThetas - 1.0) * (kWebThetas - 1.0));
            sum += formulas.gaussWeight4(i) * std::lerp(rows[row].mean, rows[row + 1].mean, fraction) *
                   std::sin(thetaOfRow(at)) * thetaPerRow;
        }
    }
    return 2.0 * kPi * peakCd * sum;
}

/// Theta of the row behind the last for which `isLit`, where nothing of it is left; pi if that is the last.
template <typename IsLit>
double endOf(const std::vector<RowSummary>& rows, IsLit isLit) {
    std::size_t end = rows.size();
    while (end > 0 && !isLit(rows[end - 1])) --end;
    return thetaOfRow(static_cast<double>(std::min(end, rows.size() - 1)));
}

void measure(const std::vector<RowSummary>& rows, IesWeb& web) {
    // A tenth of a percent, spread over a hemisphere, is most of the light close around a spot.
    constexpr double kCutShare = 1e-5;
    constexpr double kBeamShare = 0.5;
    constexpr double kFieldShare = 0.1;
    double largestMean = 0.0;
    for (const RowSummary& row : rows) largestMean = std::max(largestMean, row.mean);
    const auto meanAbove = [&](double share) {
        return endOf(rows, [&](const RowSummary& row) { return row.mean >= share * largestMean; });
    };
    web.fluxLm = flux(rows, web.peakCd);
    web.cutHalfAngleRad = endOf(rows, [&](const RowSummary& row) { return row.largest >= kCutShare; });
    web.fieldHalfAngleRad = std::min(meanAbove(kFieldShare), web.cutHalfAngleRad);
    web.beamHalfAngleRad = std::min(meanAbove(kBeamShare), web.fieldHalfAngleRad);
}

}  // namespace

double IesWeb::relativeAt(const glm::dvec3& direction) const {
    return glsl::WebFormulas<double>{*this}.webAt(direction);
}

IesWeb makeIesWeb(const IesTable& table) {
    IesWeb web;
    web.warning = table.warning;
    web.peakCd = *std::max_element(table.candela.begin(), table.candela.end());
    web.relative.reserve(static_cast<std::size_t>(kWebAzimuths) * kWebThetas);
    std::vector<RowSummary> rows;
    std::vector<double> candela(kWebAzimuths);
    for (int row = 0; row < kWebThetas; ++row) {
        resampleRow(table, thetaOfRow(row), candela);
        RowSummary summary;
        for (const double value : candela) {
            const double relative = value / web.peakCd;
            web.relative.push_back(static_cast<float>(relative));
            summary.mean += relative / kWebAzimuths;
            summary.largest = std::max(summary.largest, relative);
        }
        rows.push_back(summary);
    }
    measure(rows, web);
    return web;
}

IesWeb parseIesWeb(std::string_view bytes, std::string_view name) {
    IesWeb web = makeIesWeb(parseIesTable(bytes, name));
    if (web.fluxLm <= 0.0) {
        throw RenderError(
            fmt::format("cannot read web '{}': its angles cover too little of the sphere to be drawn", name));
    }
    return web;
}

BeamShape webShape(const Beam& beam, const IesWeb& web) {
    BeamShape shape;
    shape.beamHalfAngleRad = web.beamHalfAngleRad;
    shape.fieldHalfAngleRad = web.fieldHalfAngleRad;
    shape.pictureHalfAngleRad = web.fieldHalfAngleRad;
    shape.cutHalfAngleRad = web.cutHalfAngleRad;
    // A lamp that shines all around has no lens plane to speak of.
    if (web.cutHalfAngleRad < 0.5 * kPi) {
        shape.apexToLensM = std::max(beam.lensRadiusM, 0.0) / std::tan(web.fieldHalfAngleRad);
    }
    shape.peakCd = web.peakCd;
    if (beam.fluxLm > 0.0) shape.peakCd = web.peakCd * beam.fluxLm / web.fluxLm;
    if (beam.intensityCd > 0.0) shape.peakCd = beam.intensityCd;
    return shape;
}

}  // namespace hazer::render
