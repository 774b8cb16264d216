// IES photometric files (LM-63): what a goniophotometer measured, as the file lists it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hazer::render {

/// How the file's two angles make a direction. In the lamp's frame (light along -Z, +X right and +Y up seen
/// along the beam), with h the horizontal and v the vertical angle (IES LM-75):
///     C   (sin v cos h, sin v sin h, -cos v)    a pole on the axis, h counter-clockwise seen along the beam
///     B   (sin h, cos h sin v, -cos h cos v)    poles left and right: floodlights
///     A   (cos v sin h, sin v, -cos v cos h)    poles above and below: headlamps
enum class IesType { kC = 1, kB = 2, kA = 3 };

/// One measured web. Angles [deg] are strictly increasing. Type C: vertical 0..180; horizontal one angle for
/// a round beam, 0..90 for a quarter, 0..180 or 90..270 for a half, 0..360 for the whole circle. Types A and
/// B: an angle whose list begins with 0 is mirrored to the other side.
struct IesTable {
    IesType type = IesType::kC;
    std::vector<double> verticalDeg;
    std::vector<double> horizontalDeg;
    std::vector<double> candela;  ///< [cd] with all factors of the file; all vertical angles of each
                                  ///< horizontal one in turn.
    std::string warning;          ///< What was not applied, in a sentence; empty: nothing.

    double at(std::size_t horizontal, std::size_t vertical) const {
        return candela[horizontal * verticalDeg.size() + vertical];
    }
};

/// At most this many angles of either kind, and this many bytes.
inline constexpr int kMaxIesAngles = 721;
inline constexpr std::size_t kMaxIesBytes = std::size_t{1} << 20;
/// No value is above this [cd].
inline constexpr double kMaxIesCandela = 1e9;

/// Reads ANSI/IES LM-63 of 1986 (no first line that says so), 1991, 1995, 2002 and 2019. Intensity = value x
/// multiplier x ballast factor, up to 1995 also x ballast-lamp factor: later editions keep something else in
/// that place. Nothing is scaled to lumens. TILT=INCLUDE is read and not applied, which `warning` says.
/// `name` is what messages call the file. Throws RenderError, with the line, for whatever is not such a file.
IesTable parseIesTable(std::string_view bytes, std::string_view name);

}  // namespace hazer::render
