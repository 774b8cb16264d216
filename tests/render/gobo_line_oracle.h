// Light through a gobo along a view ray, stated independently: plain geometry in double and many even
// samples. Shares no formula with the shaders.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace hazer::test {

/// A lamp of 1 cd with its virtual apex at the origin, no lens, shining along -Z with +Y up.
struct GoboLamp {
    double fieldHalfAngleRad = 0.2;
    double beamHalfAngleRad = 0.2;
    double exponent = 0.0;  ///< Of the super-Gaussian; 0: flat, and nothing beyond the field angle.
    double turnRad = 0.0;   ///< Of the gobo, counter-clockwise looking along the beam.
    double reach = 1.0;     ///< Radius around the axis that is looked at, over the field's.
};

struct GoboHaze {
    double extinctionPerM = 0.03;
    double forwardG = 0.7;  ///< One lobe of Henyey and Greenstein.
};

/// The stretch of a ray that passes within `reach` of the axis, and what it meets.
class GoboRay {
 public:
    /// The picture-independent part; `isCrossing` says whether there is a stretch in front of the eye.
    GoboRay(const GoboLamp& lamp, const GoboHaze& haze, const glm::dvec3& eye, const glm::dvec3& direction,
            int samples);

    bool isCrossing() const { return !samples_.empty(); }

    /// Radiance [cd/m^2] for a scattering coefficient of 1 /m and no gobo.
    double withoutGobo() const;

    /// The same through one channel of a square RGBA picture whose inscribed circle is the field.
    double through(const std::vector<std::uint8_t>& rgba, int channel) const;

    /// The same with weights of the places on the gobo (the unit disc is the field, y upwards).
    double through(const std::vector<std::uint8_t>& rgba, int channel,
                   const std::function<double(const glm::dvec2&)>& weight) const;

    double fromM() const { return fromM_; }
    double toM() const { return toM_; }

 private:
    struct Sample {
        glm::dvec2 onGobo;
        double light = 0.0;
    };
    std::vector<Sample> samples_;
    double fromM_ = 0.0;
    double toM_ = 0.0;
};

}  // namespace hazer::test
