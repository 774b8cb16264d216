// What a display shows for light, from the published equations in double; the shaders use fits to them.
#pragma once

#include <glm/glm.hpp>

namespace hazer::test {

/// sRGB 0..1 for light relative to the sensor's full scale, linear Rec. 2020: AgX (Sobotka, with the
/// polynomial and the constants that Filament publishes), ITU-R BT.2087, IEC 61966-2-1.
glm::dvec3 exactDisplay(const glm::dvec3& rec2020);

/// Linear Rec. 2020 from linear Rec. 709 (ITU-R BT.2087).
glm::dvec3 rec2020FromRec709(const glm::dvec3& rec709);

/// Radiance [cd/m^2] to the sensor's full scale (ISO 12232 saturation with q = 0.65).
double sensorScale(double exposureEv100);

}  // namespace hazer::test
