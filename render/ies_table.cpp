#include "render/ies_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "render/error.h"

namespace hazer::render {
namespace {

struct AngleRange {
    double least;
    double most;
};

/// Horizontal angles this close to 0, 90, 180, 270 or 360 degrees are meant to be it.
constexpr double kSameAngleDeg = 0.01;

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool startsWith(std::string_view text, std::string_view upperCasePrefix) {
    return text.size() >= upperCasePrefix.size() &&
           std::equal(upperCasePrefix.begin(), upperCasePrefix.end(), text.begin(),
                      [](char wanted, char c) { return wanted == upper(c); });
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t from = text.find_first_not_of(kBlanks);
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

/// What a message may repeat of a file: short and printable.
std::string quoted(std::string_view text) {
    constexpr std::size_t kLongest = 24;
    std::string shown(text.substr(0, kLongest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.size() > kLongest ? shown + "..." : shown;
}

bool isSameAngle(double a, double b) {
    return std::abs(a - b) <= kSameAngleDeg;
}

/// The text of the file as lines first, then as numbers.
class IesReader {
 public:
    IesReader(std::string_view bytes, std::string_view name) : text_(bytes), name_(name) {}

    [[noreturn]] void fail(std::string_view reason) const {
        throw RenderError(fmt::format("cannot read web '{}', line {}: {}", name_, line_, reason));
    }

    bool atEnd() const { return next_ >= text_.size(); }

    std::string_view nextLine() {
        ++line_;
        const std::size_t end = std::min(text_.find('\n', next_), text_.size());
        const std::string_view line = text_.substr(next_, end - next_);
        next_ = end + 1;
        return trimmed(line);
    }

    /// From here on line numbers count the breaks between numbers.
    void beginNumbers() { ++line_; }

    double number(std::string_view what) {
        const std::string_view token = nextToken();
        if (token.empty()) {
            fail(fmt::format("the file ends before {}; it was cut short", what));
        }
        double value = 0.0;
        const char* from = token.data() + (token.front() == '+' ? 1 : 0);
        const char* to = token.data() + token.size();
        const auto [end, error] = std::from_chars(from, to, value);
        if (error != std::errc() || end != to || !std::isfinite(value)) {
            fail(fmt::format("'{}' is no number, but {} should be here", quoted(token), what));
        }
        return value;
    }

    double numberIn(std::string_view what, double least, double most) {
        const double value = number(what);
        if (value < least || value > most) {
            fail(fmt::format("{} is {:g}; it can be {:g} to {:g}", what, value, least, most));
        }
        return value;
    }

    /// The edition of 1986 writes whole numbers with a point, too.
    int wholeNumberIn(std::string_view what, int least, int most) {
        const double value = numberIn(what, least, most);
        if (value != std::floor(value)) fail(fmt::format("{} is {:g}, no whole number", what, value));
        return static_cast<int>(value);
    }

    std::vector<double> angles(std::string_view what, int count, double least, double most) {
        std::vector<double> list;
        for (int i = 0; i < count; ++i) {
            const double angle = numberIn(what, least, most);
            if (!list.empty() && angle <= list.back()) {
                fail(fmt::format("{} {:g} follows {:g}; the angles must rise", what, angle, list.back()));
            }
            list.push_back(angle);
        }
        return list;
    }

    void expectNoNumber() {
        const std::string_view token = nextToken();
        const bool isNumber = !token.empty() && ((token.front() >= '0' && token.front() <= '9') ||
                                                 token.front() == '-' || token.front() == '.');
        if (isNumber) fail("there are more values than the numbers of angles say");
    }

 private:
    /// Up to the next blank, comma or line break; empty at the end of the text.
    std::string_view nextToken() {
        constexpr std::string_view kSeparators = " \t\r\n,";
        while (next_ < text_.size() && kSeparators.find(text_[next_]) != std::string_view::npos) {
            if (text_[next_] == '\n') ++line_;
            ++next_;
        }
        if (atEnd()) return {};
        const std::size_t end = std::min(text_.find_first_of(kSeparators, next_), text_.size());
        const std::string_view token = text_.substr(next_, end - next_);
        next_ = end;
        return token;
    }

    std::string_view text_;
    std::string_view name_;
    std::size_t next_ = 0;
    int line_ = 0;
};

/// Year of the edition from the first line; 1986 where it names none.
int editionOf(std::string_view firstLine) {
    if (!startsWith(firstLine, "IES")) return 1986;
    for (const int year : {1995, 2002, 2019}) {
        if (firstLine.find(std::to_string(year)) != std::string_view::npos) return year;
    }
    return 1991;
}

/// Skips to behind the TILT line. Returns what stands behind the equals sign.
std::string_view findTilt(IesReader& reader, int& edition) {
    constexpr std::string_view kTilt = "TILT";
    for (bool first = true; !reader.atEnd(); first = false) {
        const std::string_view line = reader.nextLine();
        if (first) edition = editionOf(line);
        if (!startsWith(line, kTilt)) continue;
        const std::string_view value = trimmed(line.substr(kTilt.size()));
        if (value.starts_with('=')) return trimmed(value.substr(1));
    }
    reader.fail("there is no TILT= line up to the end; is this an IES (LM-63) file?");
}

/// How the lamp's light depends on how its luminaire is tilted. Lamps of the stage burn in any position.
void skipTiltTable(IesReader& reader) {
    constexpr double kAny = 1e6;
    reader.wholeNumberIn("the lamp's position in the luminaire", 1, 3);
    const int count = reader.wholeNumberIn("the number of tilt angles", 1, kMaxIesAngles);
    reader.angles("tilt angle", count, -360.0, 360.0);
    for (int i = 0; i < count; ++i) reader.numberIn("a factor of the tilt angles", 0.0, kAny);
}

void readTilt(IesReader& reader, std::string_view tilt, IesTable& table) {
    const bool included = startsWith(tilt, "INCLUDE");
    if (!included && !startsWith(tilt, "NONE")) {
        reader.fail(
            fmt::format("TILT={} names another file, which is not read; say TILT=NONE", quoted(tilt)));
    }
    reader.beginNumbers();
    if (!included) return;
    skipTiltTable(reader);
    table.warning = "the dependence on tilt (TILT=INCLUDE) is not applied; the lamp shines as if not tilted";
}

/// A whole circle whose last plane, which is the first again, is left out gets it.
void closeCircle(IesTable& table) {
    table.horizontalDeg.front() = 0.0;
    table.horizontalDeg.push_back(360.0);
    const auto planeEnd = table.candela.begin() + static_cast<std::ptrdiff_t>(table.verticalDeg.size());
    const std::vector<double> first(table.candela.begin(), planeEnd);
    table.candela.insert(table.candela.end(), first.begin(), first.end());
}

/// True if the last plane is as far from 360 degrees as planes are from each other.
bool lacksLastPlane(const std::vector<double>& angles) {
    double widest = 0.0;
    for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
    return angles.back() > 180.0 && 360.0 - angles.back() <= widest + kSameAngleDeg;
}

/// Puts the ends of type C's horizontal angles exactly on the symmetry that they mean; false if they mean
/// none.
bool settleSymmetry(IesTable& table) {
    constexpr AngleRange kSymmetries[] = {{0.0, 90.0}, {0.0, 180.0}, {0.0, 360.0}, {90.0, 270.0}};
    std::vector<double>& angles = table.horizontalDeg;
    if (angles.size() == 1) return true;
    for (const AngleRange& symmetry : kSymmetries) {
        if (!isSameAngle(angles.front(), symmetry.least) || !isSameAngle(angles.back(), symmetry.most))
            continue;
        angles.front() = symmetry.least;
        angles.back() = symmetry.most;
        return std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) == angles.end();
    }
    if (!isSameAngle(angles.front(), 0.0) || !lacksLastPlane(angles)) return false;
    closeCircle(table);
    return true;
}

AngleRange verticalRange(IesType type) {
    if (type == IesType::kC) return {0.0, 180.0};
    return type == IesType::kB ? AngleRange{-180.0, 180.0} : AngleRange{-90.0, 90.0};
}

AngleRange horizontalRange(IesType type) {
    if (type == IesType::kC) return {0.0, 360.0};
    return type == IesType::kB ? AngleRange{-90.0, 90.0} : AngleRange{-180.0, 180.0};
}

struct Counts {
    int vertical;
    int horizontal;
};

/// The two lines that stand before the angles. Returns the factor of all values in `factor`.
Counts readHeader(IesReader& reader, int edition, IesTable& table, double& factor) {
    constexpr double kAny = 1e12;
    reader.numberIn("the number of lamps", 0.0, kAny);
    reader.numberIn("the lumens of a lamp", -kAny, kAny);
    factor = reader.numberIn("the candela multiplier", 1e-9, kMaxIesCandela);
    Counts counts{};
    counts.vertical = reader.wholeNumberIn("the number of vertical angles", 2, kMaxIesAngles);
    counts.horizontal = reader.wholeNumberIn("the number of horizontal angles", 1, kMaxIesAngles);
    table.type = static_cast<IesType>(reader.wholeNumberIn("the photometric type", 1, 3));
    if (table.type != IesType::kC && counts.horizontal < 2) {
        reader.fail("a web of type A or B needs two or more horizontal angles");
    }
    reader.wholeNumberIn("the type of units", 1, 2);
    for (const char* size : {"the width", "the length", "the height"}) reader.numberIn(size, -kAny, kAny);
    factor *= reader.numberIn("the ballast factor", 1e-9, 1e3);
    const double ballastLamp = reader.numberIn("the ballast-lamp factor", 0.0, 1e12);
    // Kept for the future in 2002; since 2019 it says how the file came about, as digits.
    if (edition < 2002) factor *= ballastLamp;
    reader.numberIn("the input watts", -kAny, kAny);
    return counts;
}

void readCandela(IesReader& reader, double factor, IesTable& table) {
    const std::size_t count = table.verticalDeg.size() * table.horizontalDeg.size();
    double peak = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double candela = factor * reader.numberIn("an intensity", 0.0, kMaxIesCandela);
        if (candela > kMaxIesCandela) {
            reader.fail(fmt::format("an intensity is {:g} cd; at most {:g} can be", candela, kMaxIesCandela));
        }
        table.candela.push_back(candela);
        peak = std::max(peak, candela);
    }
    if (peak <= 0.0) reader.fail("all intensities are 0; such a lamp gives no light");
}

}  // namespace

IesTable parseIesTable(std::string_view bytes, std::string_view name) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    IesReader reader(bytes, name);
    if (bytes.size() > kMaxIesBytes) reader.fail("the file is larger than a mebibyte, which no web needs");
    IesTable table;
    int edition = 0;
    readTilt(reader, findTilt(reader, edition), table);
    double factor = 0.0;
    const Counts counts = readHeader(reader, edition, table, factor);
    const AngleRange vertical = verticalRange(table.type);
    table.verticalDeg = reader.angles("vertical angle", counts.vertical, vertical.least, vertical.most);
    const AngleRange horizontal = horizontalRange(table.type);
    table.horizontalDeg =
        reader.angles("horizontal angle", counts.horizontal, horizontal.least, horizontal.most);
    readCandela(reader, factor, table);
    reader.expectNoNumber();
    if (table.type == IesType::kC && !settleSymmetry(table)) {
        reader.fail(
            fmt::format("horizontal angles from {:g} to {:g} mean no symmetry of type C; they go "
                        "from 0 to 0, 90, 180 or 360, or from 90 to 270",
                        table.horizontalDeg.front(), table.horizontalDeg.back()));
    }
    return table;
}

}  // namespace hazer::render
