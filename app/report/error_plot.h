// A plot of error against time, both logarithmic, as SVG that reads well on light and on dark ground.
#pragma once

#include <string>
#include <vector>

namespace hazer::app {

struct PlotPoint {
    double ms = 0.0;      ///< Above 0.
    double error = 0.0;   ///< A share; what is below 1e-7 is drawn there.
    std::string label;    ///< Beside the point; left out where there is no room.
    bool isMain = false;  ///< Drawn larger, and its label is the last to be left out.
};

struct PlotLine {
    std::string name;  ///< Beside its last point.
    std::vector<PlotPoint> points;
};

/// `title` and the names may hold any text. Points that are no positive finite numbers are left out. At most
/// four lines.
std::string errorPlot(const std::string& title, const std::vector<PlotLine>& lines);

}  // namespace hazer::app
