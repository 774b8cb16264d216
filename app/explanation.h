// hazer explain: what a frame of a show needs, what was left out of it and why.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/show.h"
#include "render/plan_summary.h"

namespace hazer::app {

struct ExplainRequest {
    std::vector<std::string> assignments;  ///< FIXTURE.Attribute=VALUE, see assign().
    std::string camera;                    ///< Empty: the show's first.
    int width = 1280;
    int height = 720;
    render::Integrator integrator = render::Integrator::kAngle;
    bool bloom = true;
};

struct Explanation {
    std::string show;
    std::string camera;
    int width = 0;
    int height = 0;
    render::PlanSummary summary;
    std::vector<std::string> lamps;  ///< What carries each beam of the scene.
};

/// Of the picture that `hazer render` would draw of the show without any DMX. Needs no OpenGL. Throws what
/// loading a show's files and assign() throw.
Explanation explainShow(const Show& show, const ExplainRequest& request);

/// For people: one line of totals, then what is needed, then what is left out with the reason and what that
/// saves.
std::string explanationText(const Explanation& explanation);

/// The same for machines; docs/rendering.md has the keys.
nlohmann::ordered_json explanationJson(const Explanation& explanation);

}  // namespace hazer::app
