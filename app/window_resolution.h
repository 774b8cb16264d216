// How finely the picture is drawn: at the window's own pixels, or coarser where the machine is slow.
#pragma once

#include <glm/glm.hpp>

namespace hazer::app {

/// Pixels drawn per pixel shown, along each edge. Follows the frame time unless a person sets it.
class WindowResolution {
 public:
    bool isAutomatic() const { return isAutomatic_; }
    void setAutomatic(bool isAutomatic);

    double factor() const { return factor_; }

    /// kMinFactor..1; switches the automatic off.
    void setFactor(double factor);

    /// Takes the time that a recent picture took to draw, panels apart; 0: not known yet. The automatic waits
    /// for a few pictures, then goes coarser above kSlowMs, or finer where that would stay well below it.
    void add(double pictureMs);

    /// The size to draw, at least 1 x 1, for a framebuffer of `shown` pixels.
    glm::ivec2 drawnSize(const glm::ivec2& shown) const;

    static constexpr double kMinFactor = 0.25;
    static constexpr double kSlowMs = 50.0;

 private:
    void decide(double pictureMs);

    /// Times come back some frames late: the first after a change still belong to the old factor.
    static constexpr int kLateFrames = 4;
    static constexpr int kJudgedFrames = 4;

    bool isAutomatic_ = true;
    double factor_ =
        0.5;  ///< A fast machine is at 1 after a blink; a slow one is spared its slowest pictures.
    double fastestMs_ = 0.0;  ///< Of the pictures that are judged.
    int frames_ = 0;          ///< Since the last decision.
    int verySlowInARow_ = 0;  ///< Since the last decision.
};

}  // namespace hazer::app
