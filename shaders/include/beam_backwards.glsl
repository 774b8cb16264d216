// A lamp that shines backwards, too: half angles above 90 degrees. Compiled as GLSL and as C++.
//
// All but a cone is lit, the mirror image of the one that a half angle of 180 degrees less this one's would light. So a ray has up to two lit
// parts: before the dark cone and behind it. Such a lamp is a point; it has no lens plane. Needs beam_integral.glsl.

// Part 0 is that before the dark cone, part 1 that behind it, from the eye to tEnd [m].
LitPart litPartBackwards(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, int part) {
    LampRay turned = ray;
    turned.axisAcross = -ray.axisAcross;
    turned.axisAlong = -ray.axisAlong;
    Real darkFrom;
    Real darkTo;
    bool meets = coneTangents(turned, -optics.cosCut, optics.sinCut, darkFrom, darkTo);
    Real from = tangentAt(ray, -ray.tClosest);
    Real to = tangentAt(ray, tEnd - ray.tClosest);
    darkFrom = meets ? darkFrom : to;
    darkTo = meets ? darkTo : to;
    return litBetween(ray, haze, part == 0 ? from : max(from, darkTo), part == 0 ? min(to, darkFrom) : to);
}

// Integral over a lit part of a soft profile [rad/sr]: cut where the ray comes closest to the axis, where a profile may have its tip.
Real integrateBackwards(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit) {
    Real length = sqrt(ray.axisAcross * ray.axisAcross + ray.axisAlong * ray.axisAlong);
    Real middle = ray.axisAcross > Real(0.0) ? tangentTowards(ray.axisAcross, ray.axisAlong, length) : lit.to;
    middle = clamp(middle, lit.from, lit.to);
    Real sum = Real(0.0);
    int side = 0;
    do {
        LitPart piece = lit;
        piece.from = side == 0 ? lit.from : middle;
        piece.to = side == 0 ? middle : lit.to;
        sum += piece.from < piece.to ? integrateSmooth(ray, optics, haze, piece, 2) : Real(0.0);
        ++side;
    } while (side < 2);
    return sum;
}
