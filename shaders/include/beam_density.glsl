// Uneven haze. Compiled as GLSL and as C++.
//
// Whoever includes this provides
//     Real densityAround(Real t, Real apartM);   haze density relative to the mean, t [m] from the eye, for looks apartM apart
// Needs beam_integral.glsl.

// Mean density along a part of an arc (shares of it, 0..1), weighted by the light that comes from there: what even haze gives is multiplied by it
// (ratio estimator). Exact for even haze, and an error only in proportion to how uneven it is. `nodes` >= 1 is how many intervals there are; the
// last one is cut short where that is no whole number, so that the mean follows it without steps.
Real densityOf(LampRay ray, BeamOptics optics, HazeMedium haze, Arc arc, Real from, Real to, Real nodes) {
    Real apart = (to - from) / nodes;
    Real apartPerH = apart / ray.h;
    Real sum = Real(0.0);
    Real weights = Real(0.0);
    Real node = Real(0.0);
    do {
        Real width = min(nodes - node, Real(1.0));
        Real jacobian;
        LampSample here = arcSample(ray, arc, from + (node + Real(0.5) * width) * apart, optics.apexToLensM, jacobian);
        Real weight = beamKernel(here, optics, haze) * jacobian * width;
        // ds = r^2 / h du, s = r sin u
        Real apartM = here.distanceM * here.distanceM * jacobian * apartPerH;
        sum += weight * densityAround(ray.tClosest - here.distanceM * here.cosScatter, apartM);
        weights += weight;
        node += Real(1.0);
    } while (node < nodes);
    return weights > Real(0.0) ? sum / weights : Real(1.0);
}

Real cubicPower(Real4 c, Real y) { return c.x + y * (c.y + y * (c.z + y * c.w)); }

// The cubic closest to a function (least squares over `count` >= 4 places in the middles of even intervals of -1..1) as powers of y, from the
// means of f, f y, f y^2 and f y^3 over them, by polynomials that are orthogonal over these very places: 1, y, y^2 - m2, y^3 - m4 / m2 y, with
// m2, m4, m6 the means of powers of y.
Real4 evenCubic(Real4 means, Real count) {
    Real u = Real(1.0) / (count * count);
    Real m2 = (Real(1.0) - u) / Real(3.0);
    Real m4 = (Real(1.0) - u) * (Real(3.0) - Real(7.0) * u) / Real(15.0);
    Real m6 = (Real(1.0) - u) * (Real(3.0) + u * (Real(31.0) * u - Real(18.0))) / Real(21.0);
    Real even = (means.z - m2 * means.x) / (m4 - m2 * m2);
    Real odd = (means.w - m4 / m2 * means.y) / (m6 - m4 * m4 / m2);
    return Real4(means.x - m2 * even, means.y / m2 - m4 / m2 * odd, even, odd);
}
