#include "app/session_view.h"

#include <utility>

namespace hazer::app {
namespace {

/// The light of the last frame's scene, drawn again with other settings.
render::FloatImage drawnWith(Session& session, const render::Settings& settings) {
    const render::Settings before = std::exchange(session.settings(), settings);
    session.draw();
    session.settings() = before;
    return session.renderer().readRadiance();
}

}  // namespace

SessionView drawErrorView(Session& session) {
    const render::FloatImage picture = session.renderer().readRadiance();
    render::Settings converged = session.settings();
    converged.integrator = render::Integrator::kAngle;
    converged.samples = 1024;
    return {errorView(picture, drawnWith(session, converged)), "error relative to the light", 1e-4, 1e-1};
}

SessionView drawCostView(Session& session) {
    render::Settings counting = session.settings();
    counting.countsIntegrals = true;
    return {drawnWith(session, counting), "integrals of a beam per pixel", 0.05, 50.0};
}

}  // namespace hazer::app
