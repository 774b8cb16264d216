// Uneven haze. Compiled as GLSL and as C++.
//
// Whoever includes this provides
//     Real densityAt(Real t);   haze density relative to the mean, t [m] from the eye
// Needs beam_integral.glsl.

// Mean density along an arc, weighted by the light that comes from there: what even haze gives is multiplied by it (ratio estimator). Exact for
// even haze, and an error only in proportion to how uneven it is. `shift` in 0..1 places the nodes within their intervals.
Real densityOf(LampRay ray, BeamOptics optics, HazeMedium haze, Arc arc, int nodes, Real shift) {
    Real apart = Real(1.0) / Real(nodes);
    Real sum = Real(0.0);
    Real weights = Real(0.0);
    int node = 0;
    do {
        Real x = (Real(node) + shift) * apart;
        Real jacobian;
        Real weight = beamKernel(arcSample(ray, arc, x, optics.apexToLensM, jacobian), optics, haze) * jacobian;
        sum += weight * densityAt(ray.tClosest + arcPlace(ray, arc, x));
        weights += weight;
        ++node;
    } while (node < nodes);
    return weights > Real(0.0) ? sum / weights : Real(1.0);
}
