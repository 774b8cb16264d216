// The beam integral of shaders/include, compiled as C++ and put together as air.frag does, for tests that
// hold it against other ways to the same number.
#pragma once

#include <cmath>
#include <vector>

#include "render/glsl_as_cpp.h"
#include "render/oracle/single_beam.h"
#include "render/photometry.h"
#include "render/profile_rule.h"

namespace hazer::test {

/// One beam in even haze, and the ray that looks at it. Everything is in the beam's frame.
struct BeamView {
    render::BeamShape shape;
    render::oracle::BeamModel beam;
    render::oracle::HazeModel haze;
    render::oracle::Ray ray;
};

inline render::oracle::BeamModel modelOf(const render::BeamShape& shape) {
    return {shape.cutHalfAngleRad, shape.beamHalfAngleRad, shape.exponent,
            render::glsl::Formulas<double>().PROFILE_CUT, shape.apexToLensM};
}

/// Answers the formulas' questions for a soft beam: the rule for its profile, interpolated as a texture does.
template <typename Scalar>
struct SoftAir : render::glsl::EmptyAir<Scalar> {
    std::vector<glm::vec4> rules;

    bool hasProfileRule() const { return !rules.empty(); }
    glm::vec<4, Scalar> profileRule(Scalar share) const {
        using Rule = glm::vec<4, Scalar>;
        if (rules.empty()) return Rule(0);
        const Scalar column = std::clamp(share, Scalar(0), Scalar(1)) * static_cast<Scalar>(rules.size() - 1);
        const auto left = std::min(static_cast<std::size_t>(column), rules.size() - 2);
        return glm::mix(Rule(rules[left]), Rule(rules[left + 1]), column - static_cast<Scalar>(left));
    }
};

/// The shared formulas set up for a view.
template <typename Scalar>
struct BeamFormulas : render::glsl::Formulas<Scalar, SoftAir<Scalar>> {
    using Formulas = render::glsl::Formulas<Scalar, SoftAir<Scalar>>;
    using Vector = typename Formulas::Real3;
    static Scalar scalar(double value) { return static_cast<Scalar>(value); }

    explicit BeamFormulas(const BeamView& view)
        : lampView(this->lampRay(Vector(view.ray.originM), Vector(view.ray.direction), Vector(0, 0, -1))),
          optics{scalar(std::cos(view.beam.cutHalfAngleRad)), scalar(std::sin(view.beam.cutHalfAngleRad)),
                 scalar(view.beam.apexToLensM), scalar(view.beam.beamHalfAngleRad),
                 scalar(view.beam.exponent)},
          haze{scalar(view.haze.extinctionPerM), scalar(view.haze.scatteringPerM), scalar(view.haze.forwardG),
               scalar(view.haze.backwardG), scalar(view.haze.forwardWeight)},
          endM(scalar(view.ray.endM)) {
        if (render::hasProfileRules(view.shape)) this->rules = render::profileRules(view.shape);
    }

    /// As drawn. `pairs` is what a soft profile gets where its rule does not hold.
    double radiance(int pairs = 4) {
        if (optics.cosCut < Scalar(0)) return backwardsRadiance();
        const auto lit = this->litPart(lampView, optics, haze, endM);
        if (!lit.some) return 0.0;
        const auto arc = this->makeArc(lit.singular, lit.from, lit.to);
        const Scalar integral = optics.exponent > Scalar(0)
                                    ? this->integrateSoft(lampView, optics, haze, lit, arc, pairs)
                                    : this->integrateSmooth(lampView, optics, haze, lit, 1);
        return static_cast<double>(integral * haze.scatteringPerM / lampView.h);
    }

    /// As drawn, of a lamp that shines backwards, too.
    double backwardsRadiance() {
        Scalar integral = 0;
        for (const int part : {0, 1}) {
            const auto lit = this->litPartBackwards(lampView, optics, haze, endM, part);
            if (!lit.some) continue;
            integral += optics.exponent > Scalar(0) ? this->integrateBackwards(lampView, optics, haze, lit)
                                                    : this->integrateSmooth(lampView, optics, haze, lit, 1);
        }
        return static_cast<double>(integral * haze.scatteringPerM / lampView.h);
    }

    /// By this many nodes.
    double sampledRadiance(int samples) {
        const auto lit = this->litPart(lampView, optics, haze, endM);
        if (!lit.some) return 0.0;
        const Scalar integral = this->integrateSampled(lampView, optics, haze, lit, samples).x;
        return static_cast<double>(integral * haze.scatteringPerM / lampView.h);
    }

    typename Formulas::LampRay lampView;
    typename Formulas::BeamOptics optics;
    typename Formulas::HazeMedium haze;
    Scalar endM;
};

}  // namespace hazer::test
