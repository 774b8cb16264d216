// A frame of a running show as a view: how wrong its pixels are, or what they cost.
#pragma once

#include "app/picture_view.h"
#include "app/session.h"

namespace hazer::app {

struct SessionView {
    render::FloatImage numbers;
    const char* unit;
    double from;  ///< What falseColor() shows darkest,
    double to;    ///< and brightest.
};

/// How far the light of the frame that was drawn last is from a converged picture of it, see errorView().
SessionView drawErrorView(Session& session);

/// How many integrals of a beam in the air each pixel of the frame takes.
SessionView drawCostView(Session& session);

}  // namespace hazer::app
