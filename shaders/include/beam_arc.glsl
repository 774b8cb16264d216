// A part of the ray in the variable that the integral runs over, x in [0, 1]. Compiled as GLSL and as C++. Needs beam_ray.glsl and
// beam_medium.glsl.
//
// A point of the ray is T = tan(phi / 2), phi the scattering angle, told as a vector (1, T) of any length. x runs along the straight line between
// two such vectors, so that T is a ratio of two linear functions of x (a Moebius map). What is smooth along a beam - lobes of Henyey and
// Greenstein, the inverse square - has its singularities at T = +-i tau, on the imaginary axis. The map that takes T to z = (T - scale) /
// (T + scale) lays them all on the unit circle, and the arc inside it on the real axis: the shorter the arc, the faster Gauss-Legendre nodes
// converge, however sharp the lobes. With scale^2 = T(from) T(to) the arc lies in the middle.

struct Arc {
    Real2 from;  // (1, T) / (T + scale): of such vectors z is a linear function
    Real2 to;
    Real turn;   // d(phi) = turn dx / |vector|^2
    Real reach;  // half length of the arc in z, 0..1
    Real scale;
};

// Where a Henyey-Greenstein lobe has its singularity, as tau.
Real lobeTangent(Real g) { return (Real(1.0) - g) / (Real(1.0) + g); }

// The least and the greatest tau there is.
Real2 arcSingularities(HazeMedium haze) {
    Real forward = lobeTangent(haze.forwardG);
    Real backward = lobeTangent(haze.backwardG);
    return Real2(min(Real(1.0), min(forward, backward)), max(Real(1.0), max(forward, backward)));
}

// Between two tangents, from < to. `singular` is the least and the greatest tau: where all of the arc is nearer to 0 (or to infinity) than any, T
// (or 1 / T) itself is the smoothest variable.
Arc makeArc(Real2 singular, Real from, Real to) {
    Arc arc;
    arc.scale = clamp(sqrt(from * to), singular.x, singular.y);
    Real perBoth = Real(1.0) / ((from + arc.scale) * (to + arc.scale));
    Real perFrom = (to + arc.scale) * perBoth;
    Real perTo = (from + arc.scale) * perBoth;
    arc.from = Real2(perFrom, from * perFrom);
    arc.to = Real2(perTo, to * perTo);
    arc.turn = Real(2.0) * (to - from) * perBoth;
    arc.reach = Real(0.5) * arc.turn * arc.scale;
    return arc;
}

Real2 arcVector(Arc arc, Real x) { return arc.from + (arc.to - arc.from) * x; }

// x of a tangent.
Real arcShare(Arc arc, Real tangent) {
    return clamp((arc.from.x - Real(1.0) / (tangent + arc.scale)) / (arc.from.x - arc.to.x), Real(0.0), Real(1.0));
}

// A place of the arc as s [m].
Real arcPlace(LampRay ray, Arc arc, Real x) {
    Real2 at = arcVector(arc, x);
    return Real(0.5) * ray.h * (at.y * at.y - at.x * at.x) / (at.x * at.y);
}

// The sample at a place of the arc; d(u)/dx comes back in `jacobian`.
LampSample arcSample(LampRay ray, Arc arc, Real x, Real apexToLensM, OUT(Real) jacobian) {
    Real perSquare;
    LampSample here = lampSampleAt(ray, arcVector(arc, x), apexToLensM, perSquare);
    jacobian = arc.turn * perSquare;
    return here;
}
