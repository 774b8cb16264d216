// Writes IES files for tests.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace hazer::test {

/// From `first` to `last` in equal steps.
inline std::vector<double> anglesFrom(double first, double last, int count) {
    std::vector<double> list;
    for (int i = 0; i < count; ++i) list.push_back(first + (last - first) * i / (count - 1));
    return list;
}

/// An LM-63 file as numbers. What stands here by default makes no difference to the web.
struct IesText {
    std::string header = "IESNA:LM-63-2002";
    std::string tilt = "TILT=NONE";
    double multiplier = 1.0;
    int type = 1;
    double ballastFactor = 1.0;
    double ballastLampFactor = 1.0;
    std::vector<double> verticalDeg{0.0, 90.0};
    std::vector<double> horizontalDeg{0.0};
    std::function<double(double horizontalDeg, double verticalDeg)> candela = [](double, double) {
        return 1.0;
    };

    std::string text() const {
        std::string out = header.empty() ? "" : header + "\n[TEST] made for a test\n";
        out += fmt::format("{}\n1 -1 {} {} {} {} 2 0.1 0.1 0\n{} {} 100\n", tilt, multiplier,
                           verticalDeg.size(), horizontalDeg.size(), type, ballastFactor, ballastLampFactor);
        for (const double v : verticalDeg) out += fmt::format("{} ", v);
        out += "\n";
        for (const double h : horizontalDeg) out += fmt::format("{} ", h);
        out += "\n";
        for (const double h : horizontalDeg) {
            for (std::size_t i = 0; i < verticalDeg.size(); ++i) {
                // Long lines are broken, as the standard has it.
                out += fmt::format("{}{}", candela(h, verticalDeg[i]), i % 12 == 11 ? "\n" : " ");
            }
            out += "\n";
        }
        return out;
    }
};

}  // namespace hazer::test
