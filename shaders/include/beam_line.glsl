// Light in the air of a beam that is thinner than a few pixels: what a pixel's filter collects of it, instead of what one ray meets. Compiled as
// GLSL and as C++.
//
// Far from its lens a thin beam is a line: a metre of it scatters scattering * p * flux * T candela towards the eye, at the distance D, the depth Z
// (along the camera's axis) and the axial distance z from the apex. In the picture's plane (tangents) the axis is X(q) = X0 + V q, dq = dz / Z^2,
// so that a pixel at x with the filter g holds
//     L = scattering * flux * integral p T (D / Z) g(x - X(q)) dq
// exactly, however the beam lies: V = 0 is one that is seen end-on. Across the axis the filter is spread over the beam's width.
//
// How wide a beam is on the screen changes along it. Its part up to LINE_RADIUS is drawn so, its part from RAY_RADIUS on by rays, with shares that
// add up to 1 at every place in between; so nothing jumps and no light is counted twice.
//
// Whoever includes this provides
//     bool seesLamp(Real3 pointM);   does a point (lamp space) see the lamp?
//     Real densityAt(Real t);        haze density relative to the mean, t [m] from the eye
// Needs beam_line_filter.glsl, beam_integral.glsl.

// The axis as the camera sees it. Lamp space: the axis is -Z, the apex the origin.
struct BeamLine {
    Real3 eyeM;
    Real3 right;     // the camera's axes
    Real3 up;
    Real3 back;
    Real pixel;      // a pixel's edge [tangent]
    Real eyeToAxisM;
    Real2 speed;     // V [m]
    Real breadth;    // radius on the screen [tangent] over radius / depth
    Real tanCut;
};

BeamLine makeBeamLine(Real3 eyeM, Real3 right, Real3 up, Real3 back, Real pixel, BeamOptics optics) {
    BeamLine line;
    line.eyeM = eyeM;
    line.right = right;
    line.up = up;
    line.back = back;
    line.pixel = pixel;
    line.eyeToAxisM = length(Real2(eyeM.x, eyeM.y));
    // The moment of the axis about the eye is (y, -x, 0).
    line.speed = Real2(eyeM.x * up.y - eyeM.y * up.x, eyeM.y * right.x - eyeM.x * right.y);
    line.breadth = line.eyeToAxisM > Real(0.0) ? line.eyeToAxisM / max(length(line.speed), Real(1e-6) * line.eyeToAxisM) : Real(1.0);
    line.tanCut = optics.sinCut / optics.cosCut;
    return line;
}

// Depth of a point.
Real lineDepth(BeamLine line, Real3 pointM) { return dot(line.eyeM - pointM, line.back); }

// Depth of the axis at an axial distance.
Real axisDepth(BeamLine line, Real axialM) { return dot(line.eyeM, line.back) + axialM * line.back.z; }

// Radius of the beam on the screen [px].
Real lineRadius(BeamLine line, Real axialM, Real depthM) {
    return max(axialM, Real(0.0)) * line.tanCut * line.breadth / (max(depthM, Real(1e-6)) * line.pixel);
}

// Share of the light at a place that is drawn by rays.
Real rayShare(BeamLine line, Real axialM, Real depthM) {
    Real x = clamp((lineRadius(line, axialM, depthM) - LINE_RADIUS) / (RAY_RADIUS - LINE_RADIUS), Real(0.0), Real(1.0));
    return x * x * (Real(3.0) - Real(2.0) * x);
}

// Keeps what of from..to fulfils slope * x < bound.
void keepBelow(Real slope, Real bound, INOUT(Real) from, INOUT(Real) to) {
    if (slope > Real(0.0)) to = min(to, bound / slope);
    if (slope < Real(0.0)) from = max(from, bound / slope);
    if (slope == Real(0.0) && bound <= Real(0.0)) to = from;
}

// Nearer than this to the camera nothing is a line [m].
const Real NEAREST_LINE_M = Real(1e-3);

// The part of the axis, as axial distances, that is drawn as a line and seen by a ray that ends tEnd [m] from the eye. False if there is none.
bool lineStretch(BeamLine line, BeamOptics optics, Real tEnd, Real rangeM, OUT(Real) from, OUT(Real) to) {
    from = optics.apexToLensM;
    to = optics.apexToLensM + rangeM;
    Real apexDepth = axisDepth(line, Real(0.0));
    keepBelow(-line.back.z, apexDepth - NEAREST_LINE_M, from, to);
    Real widest = RAY_RADIUS * line.pixel;
    keepBelow(line.tanCut * line.breadth - widest * line.back.z, widest * apexDepth, from, to);
    Real reach2 = (tEnd - line.eyeToAxisM) * (tEnd + line.eyeToAxisM);
    Real reach = sqrt(max(reach2, Real(0.0)));
    from = max(from, -line.eyeM.z - reach);
    to = min(to, -line.eyeM.z + reach);
    return reach2 > Real(0.0) && from < to;
}

// Mean of the filter over the cross-section of a beam of this radius, weighted by its light, at a pixel `away` from the axis [1/px].
Real filteredAcross(BeamOptics optics, Real away, Real radius) {
    int spokes = 2 + int(min(Real(4.0) * radius, Real(12.0)));
    Real cut = atan(optics.sinCut, optics.cosCut);
    Real sum = Real(0.0);
    Real weights = Real(0.0);
    for (int ring = 0; ring < 4; ++ring) {
        Real share = gaussNode4(ring);
        Real weight = gaussWeight4(ring) * share;
#ifndef FLAT_PROFILE
        weight *= optics.exponent > Real(0.0) ? softProfile(share * cut, optics.beamHalfAngle, optics.exponent) : Real(1.0);
#endif
        Real around = Real(0.0);
        int spoke = 0;
        do {
            around += lineFilter(away - share * radius * cos(PI * (Real(spoke) + Real(0.5)) / Real(spokes)));
            ++spoke;
        } while (spoke < spokes);
        sum += weight * around / Real(spokes);
        weights += weight;
    }
    return sum / weights;
}

// What a place of the axis sends to the eye through clear air, without scattering and flux [1/sr]. `beside` is a direction across the beam: half way
// to its edge is looked at for bodies in the way, so that one that hides part of the beam takes part of its light.
Real lineKernel(BeamLine line, BeamOptics optics, HazeMedium haze, Real axialM, Real depthM, Real2 beside) {
    Real3 toEye = line.eyeM + Real3(Real(0.0), Real(0.0), axialM);
    Real eyeM = length(toEye);
    Real offM = Real(0.5) * axialM * line.tanCut;
    bool sees = seesLamp(Real3(beside.x * offM, beside.y * offM, -axialM));
    Real phase = phaseTwoLobes(-toEye.z / eyeM, haze.forwardG, haze.backwardG, haze.forwardWeight);
    Real clear = exp(-haze.extinctionPerM * (eyeM + axialM - optics.apexToLensM));
    return sees ? phase * clear * eyeM / depthM * densityAt(eyeM) * (Real(1.0) - rayShare(line, axialM, depthM)) : Real(0.0);
}

// Radiance of the line over scattering, for a flux of 1 lm [1/m]. towards: from the eye to the pixel, 1 of depth (lamp space); tEnd: where its ray
// ends [m]; rangeM: how far from its lens a beam is followed.
Real lineRadiance(BeamLine line, BeamOptics optics, HazeMedium haze, Real3 towards, Real tEnd, Real rangeM) {
    Real from;
    Real to;
    if (!lineStretch(line, optics, tEnd, rangeM, from, to)) return Real(0.0);
    // Places are told from where the ray comes closest to the axis, so that what is subtracted is small.
    Real aside2 = max(towards.x * towards.x + towards.y * towards.y, Real(1e-12));
    Real closestT = -(line.eyeM.x * towards.x + line.eyeM.y * towards.y) / aside2;
    Real origin = clamp(-line.eyeM.z - closestT * towards.z, from, to);
    Real originDepth = axisDepth(line, origin);
    Real3 originM = Real3(-line.eyeM.x, -line.eyeM.y, -line.eyeM.z - origin);
    Real2 off = Real2(dot(towards, line.right), dot(towards, line.up)) - Real2(dot(originM, line.right), dot(originM, line.up)) / originDepth;
    Real first = (from - origin) / (originDepth * axisDepth(line, from));
    Real last = (to - origin) / (originDepth * axisDepth(line, to));
    Real speed = length(line.speed);
    Real closest = clamp(dot(off, line.speed) / max(speed * speed, Real(1e-20)), first, last);
    // What lies within reach of the filter, on either side of the closest place.
    Real reach = LINE_REACH * line.pixel / max(speed, Real(1e-10));
    bool moves = speed > Real(0.0);
    Real away = (moves ? (line.eyeM.y * towards.x - line.eyeM.x * towards.y) / speed : off.x) / line.pixel;
    Real ahead = (moves ? dot(off, line.speed) / speed : off.y) / line.pixel;
    Real sum = Real(0.0);
    for (int side = 0; side < 2; ++side) {
        Real start = side == 0 ? max(first, closest - reach) : closest;
        Real end = side == 0 ? closest : min(last, closest + reach);
        for (int i = 0; i < 4; ++i) {
            Real q = start + gaussNode4(i) * (end - start);
            Real depthM = originDepth / (Real(1.0) - q * originDepth * line.back.z);
            Real axialM = origin + q * originDepth * depthM;
            Real2 beside = i == 0 ? Real2(Real(1.0), Real(0.0)) : i == 1 ? Real2(Real(0.0), Real(1.0))
                         : i == 2 ? Real2(Real(0.0), Real(-1.0)) : Real2(Real(-1.0), Real(0.0));
            Real filtered = lineFilter(ahead - speed * q / line.pixel);
            sum += gaussWeight4(i) * (end - start) * filtered * lineKernel(line, optics, haze, axialM, depthM, beside);
        }
    }
    Real closestDepth = originDepth / (Real(1.0) - closest * originDepth * line.back.z);
    Real radius = lineRadius(line, origin + closest * originDepth * closestDepth, closestDepth);
    return sum * filteredAcross(optics, away, radius) / (line.pixel * line.pixel);
}
