// The light in the air by brute force: what the fast ways are held against. Compiled as GLSL and as C++.
//
// Whoever includes this provides
//     bool seesLamp(Real3 pointM);             does a point (lamp space) see the lamp?
//     Real3 apertureAt(LampSample here);       what a gobo lets through, 0..1
//     Real densityAt(Real t);                  haze density relative to the mean, t [m] from the eye
// Needs beam_integral.glsl.

Real3 arcPoint(LampRay ray, Arc arc, Real x) { return ray.across * ray.h + ray.along * arcPlace(ray, arc, x); }

// The integral over a part that nothing cuts up: half of the samples on either side of the axis, four Gauss-Legendre nodes a piece.
Real3 integrateSampled(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit, int samples) {
    Real middle = ray.axisAcross > Real(0.0)
                      ? tangentTowards(ray.axisAcross, ray.axisAlong, length(Real2(ray.axisAcross, ray.axisAlong))) : FARTHEST_TANGENT;
    middle = clamp(middle, lit.from, lit.to);
    int pieces = max(samples / 8, 1);
    Real length = Real(1.0) / Real(pieces);
    Real3 sum = Real3(Real(0.0));
    for (int side = 0; side < 2; ++side) {
        Arc arc = makeArc(lit.singular, side == 0 ? lit.from : middle, side == 0 ? middle : lit.to);
        for (int piece = 0; piece < pieces; ++piece) {
            for (int i = 0; i < 4; ++i) {
                Real x = (Real(piece) + gaussNode4(i)) * length;
                Real jacobian;
                LampSample here = arcSample(ray, arc, x, optics.apexToLensM, jacobian);
                Real kernel = gaussWeight4(i) * length * jacobian * beamKernel(here, optics, haze);
                sum += Real3(kernel * densityAt(ray.tClosest + arcPlace(ray, arc, x)));
            }
        }
    }
    return sum;
}

// The integral over an arc with obstacles: even samples, the lit part of each known to 1/1024 where it has an edge.
Real3 integrateSampledObstacles(LampRay ray, BeamOptics optics, HazeMedium haze, Arc arc, int samples) {
    Real apart = Real(1.0) / Real(samples);
    Real3 sum = Real3(Real(0.0));
    bool before = seesLamp(arcPoint(ray, arc, Real(0.0)));
    for (int i = 0; i < samples; ++i) {
        Real from = Real(i) * apart;
        Real to = from + apart;
        bool after = seesLamp(arcPoint(ray, arc, to));
        Real edge = from;
        Real beyond = to;
        for (int k = 0; k < (before != after ? 10 : 0); ++k) {
            Real middle = Real(0.5) * (edge + beyond);
            bool same = seesLamp(arcPoint(ray, arc, middle)) == before;
            edge = same ? middle : edge;
            beyond = same ? beyond : middle;
        }
        Real start = before ? from : after ? edge : to;
        Real end = after ? to : before ? edge : start;
        Real x = Real(0.5) * (start + end);
        Real jacobian;
        LampSample here = arcSample(ray, arc, x, optics.apexToLensM, jacobian);
        Real kernel = (end - start) * jacobian * beamKernel(here, optics, haze);
        sum += apertureAt(here) * (kernel * densityAt(ray.tClosest + arcPlace(ray, arc, x)));
        before = after;
    }
    return sum;
}

// Radiance for a lamp of 1 cd [1/m^2] by the thesis' method: samples evenly spaced over the whole ray from the eye to tEnd [m], most of them
// outside the beam.
Real3 beamInAirUniform(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, int samples) {
    Real stepM = tEnd / Real(samples);
    Real3 sum = Real3(Real(0.0));
    for (int i = 0; i < samples; ++i) {
        Real t = (Real(i) + Real(0.5)) * stepM;
        Real s = t - ray.tClosest;
        Real r = sqrt(ray.h * ray.h + s * s);
        LampSample here = lampSample(ray, ray.h / r, s / r, optics.apexToLensM);
        bool beforeLens = optics.apexToLensM > Real(0.0) && r * here.cosAxis < optics.apexToLensM;
        if (here.cosAxis < optics.cosCut || beforeLens) continue;
        Real3 value = apertureAt(here) * (beamKernel(here, optics, haze) * densityAt(t) / (r * r));
#ifdef SHADOW
        value *= seesLamp(here.direction * r) ? Real(1.0) : Real(0.0);
#endif
        sum += value;
    }
    return sum * (haze.scatteringPerM * stepM);
}
