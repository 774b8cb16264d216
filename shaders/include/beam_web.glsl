// The integral over a photometric web, whose shape is anybody's guess. Compiled as GLSL and as C++. Needs beam_integral.glsl.
//
// Most webs are brightest around the axis and fade into stray light far out. The lit part is cut where it enters and leaves the cones of one and
// of three beam half angles, so that nodes stand densely where the light is.

// What of from..to (tangents) lies in the cone of a half angle [rad]. If nothing does, they meet where the ray comes closest to the axis.
void shrinkToCone(LampRay ray, Real halfAngle, INOUT(Real) from, INOUT(Real) to) {
    if (halfAngle >= Real(0.5) * PI) return;
    Real coneFrom;
    Real coneTo;
    if (!coneTangents(ray, cos(halfAngle), sin(halfAngle), coneFrom, coneTo)) {
        Real length = sqrt(ray.axisAcross * ray.axisAcross + ray.axisAlong * ray.axisAlong);
        coneFrom = ray.axisAcross > Real(0.0) ? tangentTowards(ray.axisAcross, ray.axisAlong, length) : from;
        coneTo = coneFrom;
    }
    Real first = clamp(coneFrom, from, to);
    to = clamp(coneTo, from, to);
    from = first;
}

// A part of the lit part.
LitPart partOf(LitPart lit, Real from, Real to) {
    lit.from = from;
    lit.to = to;
    return lit;
}

// Integral over the lit part [rad/sr]: five parts, those inside the outer cone in two pieces of four nodes each.
Real integrateWeb(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit) {
    Real outerFrom = lit.from;
    Real outerTo = lit.to;
    shrinkToCone(ray, Real(3.0) * optics.beamHalfAngle, outerFrom, outerTo);
    Real innerFrom = outerFrom;
    Real innerTo = outerTo;
    shrinkToCone(ray, optics.beamHalfAngle, innerFrom, innerTo);
    Real sum = Real(0.0);
    int part = 0;
    do {
        Real from = part == 0 ? lit.from : part == 1 ? outerFrom : part == 2 ? innerFrom : part == 3 ? innerTo : outerTo;
        Real to = part == 0 ? outerFrom : part == 1 ? innerFrom : part == 2 ? innerTo : part == 3 ? outerTo : lit.to;
        if (from < to) sum += integrateSmooth(ray, optics, haze, partOf(lit, from, to), part == 0 || part == 4 ? 1 : 2);
        ++part;
    } while (part < 5);
    return sum;
}
