#include "render/gobo_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/gobo_table_formulas.h"

namespace hazer::render {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Transmission of one channel, 0..1, as a texture unit finds it: bilinear, dark beyond the edge. x and y in
/// texels of the level from its middle, y upwards.
float bilinear(const std::vector<std::uint8_t>& rgba, int size, int channel, float x, float y) {
    const float column = x + 0.5f * static_cast<float>(size - 1);
    const float row = 0.5f * static_cast<float>(size - 1) - y;
    const auto left = static_cast<int>(std::floor(column));
    const auto top = static_cast<int>(std::floor(row));
    const auto texel = [&](int right, int below) {
        const int tx = left + right;
        const int ty = top + below;
        const bool isInside = tx >= 0 && tx < size && ty >= 0 && ty < size;
        return isInside ? static_cast<float>(rgba[at(4 * (ty * size + tx) + channel)]) : 0.0f;
    };
    const float fx = column - static_cast<float>(left);
    const float fy = row - static_cast<float>(top);
    return ((1.0f - fy) * ((1.0f - fx) * texel(0, 0) + fx * texel(1, 0)) +
            fy * ((1.0f - fx) * texel(0, 1) + fx * texel(1, 1))) /
           255.0f;
}

/// What one blur level lets through, on a square of cells around the table's disc: all that the lines see.
struct Field {
    int size = 0;                 ///< Cells along an edge; even.
    double radius = 0.0;          ///< Of the table's disc [cells].
    std::vector<float> byColumn;  ///< Columns from left to right, each upwards.
    std::vector<float> byRow;     ///< Rows upwards, each from left to right.

    /// Place of a column or row's middle, from the centre [cells].
    double place(int index) const { return index - 0.5 * (size - 1); }
};

Field makeField(const GoboPicture& picture, int channel, int level, const GoboProfile& profile,
                int texelsPerCell) {
    glsl::GoboTableFormulas<double> formulas;
    const double tableRadius = formulas.goboTableRadius(profile.exponent);
    const double cellsPerUnit = 0.5 * kGoboSize / texelsPerCell;
    Field field;
    field.radius = tableRadius * cellsPerUnit;
    // Two cells around it: lines end between cells.
    field.size = 2 * (static_cast<int>(std::ceil(field.radius)) + 2);
    field.byColumn.assign(at(field.size * field.size), 0.0f);
    field.byRow = field.byColumn;
    const int texels = kGoboSize >> level;
    const double texelsPerUnit = 0.5 * texels;
    for (int row = 0; row < field.size; ++row) {
        for (int column = 0; column < field.size; ++column) {
            const double x = field.place(column) / cellsPerUnit;
            const double y = field.place(row) / cellsPerUnit;
            const double q = std::hypot(x, y);
            if (q > tableRadius + 2.0 / cellsPerUnit) continue;
            const float light =
                bilinear(picture.levels[at(level)], texels, channel, static_cast<float>(x * texelsPerUnit),
                         static_cast<float>(y * texelsPerUnit));
            if (light == 0.0f) continue;
            const float value = light * static_cast<float>(formulas.goboTableProfile(q, profile.beamOverField,
                                                                                     profile.exponent));
            field.byColumn[at(column * field.size + row)] = value;
            field.byRow[at(row * field.size + column)] = value;
        }
    }
    return field;
}

/// All parallel lines of one direction, a cell apart where they cross the axis along which they are not
/// stepped. Joseph's projection (1982): a line is looked at once in every column (or row, whichever it
/// crosses more steeply), between the two nearest cells.
class ParallelLines {
 public:
    /// `turn` in turns, 0 <= turn < 0.5: where the lines' normal points.
    ParallelLines(const Field& field, double turn);

    /// Adds up what the lines meet.
    void integrate();

    /// M_0..M_3 of the line at a signed distance [cells] from the centre, between the lines that there are.
    glm::vec4 moments(double distance) const;

 private:
    void place();
    void addStep(int step);
    void finish();

    const Field& field_;
    const std::vector<float>& cells_;
    double alongStep_;    ///< Component of the lines' direction along the axis of steps.
    double alongOther_;   ///< And along the other one.
    double normalOther_;  ///< Component of the normal along the other axis.
    int middle_;          ///< Index of the line through the centre.
    int first_ = 0;       ///< Lines that cross the disc.
    int last_ = -1;
    std::vector<float> perHalfLength_;  ///< 1 / half length of the chord [1/cell].
    std::vector<float> start_;          ///< xi where the line crosses the axis of steps' zero.
    std::vector<float> steps_;          ///< Steps in half the chord.
    std::array<std::vector<float>, 4> sums_;
};

ParallelLines::ParallelLines(const Field& field, double turn)
    : field_(field),
      cells_(std::abs(std::sin(2.0 * kPi * turn)) >= std::abs(std::cos(2.0 * kPi * turn)) ? field.byColumn
                                                                                          : field.byRow) {
    // The normal is (cos, sin), the direction (-sin, cos).
    const double c = std::cos(2.0 * kPi * turn);
    const double s = std::sin(2.0 * kPi * turn);
    const bool byColumn = &cells_ == &field.byColumn;
    alongStep_ = byColumn ? -s : c;
    alongOther_ = byColumn ? c : -s;
    normalOther_ = byColumn ? s : c;
    middle_ = static_cast<int>(std::ceil(field.radius / std::abs(normalOther_)));
    place();
}

void ParallelLines::place() {
    const int count = 2 * middle_ + 1;
    perHalfLength_.assign(at(count), 0.0f);
    start_ = steps_ = perHalfLength_;
    sums_.fill(perHalfLength_);
    first_ = count;
    for (int line = 0; line < count; ++line) {
        const double crossing = line - middle_;
        const double distance = crossing * normalOther_;
        // A chord shorter than this is noise, and its neighbour's values serve.
        if (std::abs(distance) > field_.radius - 0.25) continue;
        const double halfLength = std::sqrt(field_.radius * field_.radius - distance * distance);
        perHalfLength_[at(line)] = static_cast<float>(1.0 / halfLength);
        start_[at(line)] = static_cast<float>(crossing * alongOther_ / halfLength);
        steps_[at(line)] = static_cast<float>(halfLength * std::abs(alongStep_));
        first_ = std::min(first_, line);
        last_ = line;
    }
}

void ParallelLines::addStep(int step) {
    const double here = field_.place(step);
    const double slope = alongOther_ / alongStep_;
    // Line i crosses this column at the cell `shift` + i.
    const double shift = slope * here - middle_ + 0.5 * (field_.size - 1);
    const int whole = static_cast<int>(std::floor(shift));
    const auto share = static_cast<float>(shift - whole);
    const double halfChord = std::sqrt(std::max(field_.radius * field_.radius - here * here, 0.0)) + 1.0;
    const int from =
        std::max({first_, static_cast<int>(std::ceil(-halfChord - slope * here)) + middle_, -whole});
    const int to = std::min(
        {last_, static_cast<int>(std::floor(halfChord - slope * here)) + middle_, field_.size - 2 - whole});
    const auto along = static_cast<float>(here / alongStep_);
    const float* cell = cells_.data() + static_cast<std::ptrdiff_t>(step) * field_.size + whole;
    const float* perHalfLength = perHalfLength_.data();
    const float* start = start_.data();
    const float* steps = steps_.data();
    float* sum0 = sums_[0].data();
    float* sum1 = sums_[1].data();
    float* sum2 = sums_[2].data();
    float* sum3 = sums_[3].data();
    for (int i = from; i <= to; ++i) {
        const float xi = along * perHalfLength[i] + start[i];
        // The share of this step that lies on the chord.
        float value = (1.0f - (xi < 0.0f ? -xi : xi)) * steps[i] + 0.5f;
        value = value < 0.0f ? 0.0f : value;
        value = value > 1.0f ? 1.0f : value;
        value *= cell[i] + share * (cell[i + 1] - cell[i]);
        sum0[i] += value;
        value *= xi;
        sum1[i] += value;
        value *= xi;
        sum2[i] += value;
        sum3[i] += value * xi;
    }
}

void ParallelLines::finish() {
    for (int line = first_; line <= last_; ++line) {
        const float stepXi = 1.0f / steps_[at(line)];
        const float power0 = sums_[0][at(line)] * stepXi;
        const float power1 = sums_[1][at(line)] * stepXi;
        const float power2 = sums_[2][at(line)] * stepXi;
        const float power3 = sums_[3][at(line)] * stepXi;
        sums_[0][at(line)] = power0;
        sums_[1][at(line)] = power1;
        sums_[2][at(line)] = 1.5f * power2 - 0.5f * power0;
        sums_[3][at(line)] = 2.5f * power3 - 1.5f * power1;
    }
}

void ParallelLines::integrate() {
    for (int step = 0; step < field_.size; ++step) addStep(step);
    finish();
}

glm::vec4 ParallelLines::moments(double distance) const {
    const double wanted = std::clamp(distance / normalOther_ + middle_, static_cast<double>(first_),
                                     static_cast<double>(last_));
    const int line = std::min(static_cast<int>(wanted), last_ - 1);
    const auto f = static_cast<float>(wanted - line);
    glm::vec4 result;
    for (int k = 0; k < 4; ++k) {
        const float* sum = &sums_[at(k)][at(line)];
        if (line == first_ || line + 2 > last_) {
            result[k] = sum[0] + f * (sum[1] - sum[0]);
            continue;
        }
        // Cubic (Catmull and Rom 1974): a straight line between lines would blur.
        const float slope = sum[1] - sum[-1];
        const float bend = 2.0f * sum[-1] - 5.0f * sum[0] + 4.0f * sum[1] - sum[2];
        const float twist = 3.0f * (sum[0] - sum[1]) + sum[2] - sum[-1];
        result[k] = sum[0] + 0.5f * f * (slope + f * (bend + f * twist));
    }
    return result;
}

/// The same line, seen the other way round.
glm::vec4 reversed(const glm::vec4& moments) {
    return {moments.x, -moments.y, moments.z, -moments.w};
}

/// c_i = f_i - (f_i-1 - 2 f_i + f_i+1) / 12: the polygon through these runs through the middle of a smooth
/// function's error instead of along one side of it (Condat, Blu, Unser 2005, quasi-interpolation).
glm::vec4 lessBend(const glm::vec4& before, const glm::vec4& here, const glm::vec4& after) {
    return here - (before - 2.0f * here + after) / 12.0f;
}

std::vector<glm::vec4> lessBentAround(const std::vector<glm::vec4>& moments, int turns) {
    std::vector<glm::vec4> result;
    result.reserve(moments.size());
    const int rows = static_cast<int>(moments.size()) / turns;
    for (int row = 0; row < rows; ++row) {
        const glm::vec4* m = &moments[at(row * turns)];
        for (int i = 0; i < turns; ++i)
            result.push_back(lessBend(m[(i + turns - 1) % turns], m[i], m[(i + 1) % turns]));
    }
    return result;
}

std::vector<glm::vec4> lessBentOutwards(const std::vector<glm::vec4>& moments, int turns) {
    std::vector<glm::vec4> result = moments;
    const int rows = static_cast<int>(moments.size()) / turns;
    // The last two rows stay: at the rim the chord shrinks to nothing, and there is no row beyond.
    for (int row = 0; row < rows - 2; ++row) {
        for (int i = 0; i < turns; ++i) {
            const int index = row * turns + i;
            // Before the first row lie the lines on the other side of the middle.
            const glm::vec4 before =
                row > 0 ? moments[at(index - turns)] : reversed(moments[at(turns + (i + turns / 2) % turns)]);
            result[at(index)] = lessBend(before, moments[at(index)], moments[at(index + turns)]);
        }
    }
    return result;
}

/// Half as many cells along an edge where the gobo is so blurred that it loses nothing.
int texelsPerCell(int level) {
    return level < 3 ? 1 : 2;
}

/// Writes a blur level into its place of a layer; the first column stands once more after the last.
void store(const std::vector<glm::vec4>& moments, const glm::ivec4& place, int width, std::uint16_t* layer) {
    for (int row = 0; row < place.w; ++row) {
        for (int column = 0; column <= place.z; ++column) {
            const glm::vec4& value = moments[at(row * place.z + column % place.z)];
            std::uint16_t* texel =
                layer + 4 * (static_cast<std::ptrdiff_t>(place.y + row) * width + place.x + column);
            for (int k = 0; k < 4; ++k) texel[k] = glm::packHalf1x16(value[k]);
        }
    }
}

}  // namespace

std::vector<glm::vec4> goboLineMoments(const GoboPicture& picture, int channel, int level,
                                       const GoboProfile& profile, const GoboLineGrid& grid,
                                       const std::stop_token& stop) {
    const Field field = makeField(picture, channel, level, profile, grid.texelsPerCell);
    std::vector<glm::vec4> moments(at(grid.turns * grid.distances));
    for (int i = 0; i < grid.turns / 2; ++i) {
        if (stop.stop_requested()) return {};
        ParallelLines lines(field, static_cast<double>(i) / grid.turns);
        lines.integrate();
        for (int row = 0; row < grid.distances; ++row) {
            const double distance = field.radius * row / (grid.distances - 1);
            moments[at(row * grid.turns + i)] = lines.moments(distance);
            moments[at(row * grid.turns + i + grid.turns / 2)] = reversed(lines.moments(-distance));
        }
    }
    return lessBentOutwards(lessBentAround(moments, grid.turns), grid.turns);
}

GoboTable buildGoboTable(const GoboPicture& picture, const GoboProfile& profile,
                         const std::stop_token& stop) {
    glsl::GoboTableFormulas<float> formulas;
    GoboTable table;
    table.layers = picture.grey ? 1 : 3;
    table.halves.resize(kGoboTableLayerHalves * at(table.layers));
    for (int layer = 0; layer < table.layers; ++layer) {
        for (int level = 0; level < formulas.GOBO_TABLE_LEVELS; ++level) {
            const glm::ivec4 place(formulas.goboTableLevel(level));
            const GoboLineGrid grid{place.z, place.w, texelsPerCell(level)};
            const std::vector<glm::vec4> moments =
                goboLineMoments(picture, layer, level, profile, grid, stop);
            if (moments.empty()) return {};
            store(moments, place, kGoboTableWidth, &table.halves[kGoboTableLayerHalves * at(layer)]);
        }
    }
    return table;
}

}  // namespace hazer::render
