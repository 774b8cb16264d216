#include "app/report/error_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hazer::app {
namespace {

constexpr double kWidth = 760.0, kHeight = 480.0;
constexpr double kLeft = 76.0, kRight = 640.0, kTop = 52.0, kBottom = 420.0;
constexpr double kSmallestError = 1e-7;
constexpr double kLetterWidth = 6.4, kLetterHeight = 13.0;

constexpr const char* kStyle =
    "<style>\n"
    "svg{font:12px system-ui,sans-serif}.ground{fill:#fff}\n"
    "text{fill:#333}.title{font-size:15px;font-weight:600}.grid{stroke:#ddd}.axis{stroke:#888}\n"
    ".line{fill:none;stroke-width:2}.c0{stroke:#c2410c}.c1{stroke:#1d5fc4}.c2{stroke:#15803d}.c3{stroke:"
    "#7c3aed}\n"
    ".t0{fill:#c2410c}.t1{fill:#1d5fc4}.t2{fill:#15803d}.t3{fill:#7c3aed}.name{font-weight:600}\n"
    "@media(prefers-color-scheme:dark){.ground{fill:#16181c}text{fill:#ddd}.grid{stroke:#333}.axis{stroke:"
    "#888}\n"
    ".c0{stroke:#ff9d66}.c1{stroke:#7db1ff}.c2{stroke:#71d18f}.c3{stroke:#c3a8ff}\n"
    ".t0{fill:#ff9d66}.t1{fill:#7db1ff}.t2{fill:#71d18f}.t3{fill:#c3a8ff}}\n"
    "</style>\n";

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '<') {
            safe += "&lt;";
        } else if (c == '&') {
            safe += "&amp;";
        } else if (c == '"') {
            safe += "&quot;";
        } else if (static_cast<unsigned char>(c) >= 0x20) {
            safe += c;
        }
    }
    return safe;
}

/// A logarithmic axis over whole decades.
struct Axis {
    int fromDecade = 0;
    int toDecade = 1;
    double fromPx = 0.0;
    double toPx = 1.0;

    double px(double value) const {
        return fromPx + (toPx - fromPx) * (std::log10(value) - fromDecade) / (toDecade - fromDecade);
    }
};

Axis axisOver(const std::vector<double>& values, double fromPx, double toPx) {
    if (values.empty()) return {0, 1, fromPx, toPx};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const int from = static_cast<int>(std::floor(std::log10(*least)));
    return {from, std::max(from + 1, static_cast<int>(std::ceil(std::log10(*most)))), fromPx, toPx};
}

struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& other) const {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
};

std::string textAt(double x, double y, const std::string& classes, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\">{}</text>\n", x, y, classes,
                       escaped(text));
}

/// Draws axes, lines and labels into one text.
class Plot {
 public:
    Plot(const Axis& time, const Axis& error) : time_(time), error_(error) {}

    void addGrid();
    void addLine(const PlotLine& line, std::size_t color);
    void addName(const PlotLine& line, std::size_t color);
    void addLabels(const PlotLine& line, std::size_t color, bool ofMainPoints);
    const std::string& text() const { return text_; }

 private:
    /// Leaves the label out, and says so, where another one stands.
    void addIfFree(double x, double y, const std::string& classes, const std::string& label);

    Axis time_;
    Axis error_;
    std::vector<Box> taken_;
    std::string text_;
};

void Plot::addGrid() {
    const auto line = [this](double x0, double y0, double x1, double y1, const char* classes) {
        text_ +=
            fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"{}\"/>\n", x0, y0, x1, y1, classes);
    };
    for (int decade = time_.fromDecade; decade <= time_.toDecade; ++decade) {
        const double x = time_.px(std::pow(10.0, decade));
        line(x, kTop, x, kBottom, "grid");
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:g} ms</text>\n", x,
                             kBottom + 18.0, std::pow(10.0, decade));
    }
    for (int decade = error_.fromDecade; decade <= error_.toDecade; ++decade) {
        const double y = error_.px(std::pow(10.0, decade));
        line(kLeft, y, kRight, y, "grid");
        text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g} %</text>\n",
                             kLeft - 8.0, y + 4.0, std::pow(10.0, decade + 2));
    }
    line(kLeft, kBottom, kRight, kBottom, "axis");
    line(kLeft, kTop, kLeft, kBottom, "axis");
}

void Plot::addLine(const PlotLine& line, std::size_t color) {
    std::string path;
    std::string dots;
    for (const PlotPoint& point : line.points) {
        const double x = time_.px(point.ms);
        const double y = error_.px(point.error);
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', x, y);
        dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" class=\"t{}\"/>\n", x, y,
                            point.isMain ? 6 : 3, color);
    }
    if (path.empty()) return;
    text_ += fmt::format("<path d=\"{}\" class=\"line c{}\"/>\n{}", path, color, dots);
}

void Plot::addIfFree(double x, double y, const std::string& classes, const std::string& label) {
    const Box box{x - 2.0, y - kLetterHeight, x + kLetterWidth * static_cast<double>(label.size()), y + 3.0};
    const auto meets = [&box](const Box& other) { return box.meets(other); };
    if (label.empty() || box.x1 > kWidth || std::any_of(taken_.begin(), taken_.end(), meets)) return;
    taken_.push_back(box);
    text_ += textAt(x, y, classes, label);
}

void Plot::addName(const PlotLine& line, std::size_t color) {
    if (line.points.empty()) return;
    const PlotPoint& last = line.points.back();
    addIfFree(time_.px(last.ms) + 8.0, error_.px(last.error) + 16.0, fmt::format("name t{}", color),
              line.name);
}

void Plot::addLabels(const PlotLine& line, std::size_t color, bool ofMainPoints) {
    for (const PlotPoint& point : line.points) {
        if (point.isMain != ofMainPoints) continue;
        addIfFree(time_.px(point.ms) + 6.0, error_.px(point.error) - 6.0, fmt::format("t{}", color),
                  point.label);
    }
}

bool canBeDrawn(const PlotPoint& point) {
    return std::isfinite(point.ms) && point.ms > 0.0 && std::isfinite(point.error) && point.error >= 0.0;
}

/// The points that can be drawn, from left to right.
PlotLine drawable(PlotLine line) {
    std::erase_if(line.points, [](const PlotPoint& point) { return !canBeDrawn(point); });
    for (PlotPoint& point : line.points) point.error = std::max(point.error, kSmallestError);
    std::stable_sort(line.points.begin(), line.points.end(),
                     [](const PlotPoint& a, const PlotPoint& b) { return a.ms < b.ms; });
    return line;
}

}  // namespace

std::string errorPlot(const std::string& title, const std::vector<PlotLine>& lines) {
    std::vector<PlotLine> drawn;
    std::vector<double> times, errors;
    for (const PlotLine& line : lines) {
        drawn.push_back(drawable(line));
        for (const PlotPoint& point : drawn.back().points) {
            times.push_back(point.ms);
            errors.push_back(point.error);
        }
    }
    Plot plot(axisOver(times, kLeft, kRight), axisOver(errors, kBottom, kTop));
    plot.addGrid();
    for (std::size_t i = 0; i < drawn.size(); ++i) plot.addLine(drawn[i], i);
    for (std::size_t i = 0; i < drawn.size(); ++i) plot.addName(drawn[i], i);
    for (const bool ofMainPoints : {true, false}) {
        for (std::size_t i = 0; i < drawn.size(); ++i) plot.addLabels(drawn[i], i, ofMainPoints);
    }
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" "
               "height=\"{:.0f}\" role=\"img\">\n<title>{}</title>\n",
               kWidth, kHeight, kWidth, kHeight, escaped(title)) +
           kStyle +
           fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" class=\"ground\"/>\n", kWidth, kHeight) +
           textAt(kLeft, 28.0, "title", title) + plot.text() +
           textAt(kLeft, kHeight - 16.0, "axis-title",
                  "rms error against the time of the light in the air of one frame") +
           "</svg>\n";
}

}  // namespace hazer::app
