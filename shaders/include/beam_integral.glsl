// Light that the haze scatters out of one beam towards the eye: the integral over the angle at the lamp. Compiled as GLSL and as C++.
// Single scattering: L = scattering / h * integral p(u) I(psi) G V exp(-extinction * path) du, see docs/rendering.md. The functions here give the
// integral alone, for a lamp of 1 cd [rad/sr].
//
// Whoever includes this provides
//     bool hasProfileRule();           is there a rule for this beam's profile?
//     Real4 profileRule(Real share);   see integrateSoft
// Needs phase.glsl, beam_ray.glsl, beam_medium.glsl, beam_arc.glsl, gauss_legendre.glsl.

// What is smooth at a sample whatever the lamp: phase function and attenuation.
Real hazeKernel(LampSample here, HazeMedium haze) {
    return phaseTwoLobes(here.cosScatter, haze.forwardG, haze.backwardG, haze.forwardWeight) * exp(-haze.extinctionPerM * here.pathM);
}

// The same with the profile of the beam.
Real beamKernel(LampSample here, BeamOptics optics, HazeMedium haze) {
    return hazeKernel(here, haze) * beamProfile(optics, here);
}

// The part of a ray that the beam lights and that matters, as tangents.
struct LitPart {
    bool some;   // there is one
    bool whole;  // it is all of the cone that the ray crosses
    bool fromEye;  // the eye is in the cone
    Real from;
    Real to;
    Real fade;       // over this much of T the light falls to 1/e for want of clear air
    Real2 singular;  // see makeArc
};

// What of the stretch between two tangents matters.
LitPart litBetween(LampRay ray, HazeMedium haze, Real from, Real to) {
    LitPart lit;
    lit.from = from;
    // Thick haze leaves only the near end: the way t + r = tClosest + h T grows until the light has fallen to 1e-5 of what it was.
    lit.fade = Real(1.0) / max(haze.extinctionPerM * ray.h, Real(1e-12));
    lit.to = min(to, from + Real(11.5) * lit.fade);
    lit.some = lit.from < lit.to;
    lit.whole = false;
    lit.fromEye = false;
    lit.singular = arcSingularities(haze);
    return lit;
}

// From the eye to tEnd [m].
LitPart litPart(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd) {
    Real sFrom = -ray.tClosest;
    Real sTo = tEnd - ray.tClosest;
    Real coneFrom = Real(0.0);
    Real coneTo = FARTHEST_TANGENT;
    bool meets = true;
#ifdef WEB
    // A lamp that shines backwards, too, has neither a cone nor a lens plane.
    if (optics.cosCut > Real(0.0)) {
#endif
    clipToLens(ray, optics.apexToLensM, sFrom, sTo);
    meets = coneTangents(ray, optics.cosCut, optics.sinCut, coneFrom, coneTo);
#ifdef WEB
    }
#endif
    LitPart lit = litBetween(ray, haze, max(coneFrom, tangentAt(ray, sFrom)), min(coneTo, tangentAt(ray, sTo)));
    lit.some = lit.some && meets;
    lit.fromEye = lit.from > coneFrom && sFrom == -ray.tClosest;
    lit.whole = lit.from == coneFrom && lit.to == coneTo && coneFrom > Real(0.0) && coneTo < FARTHEST_TANGENT;
    return lit;
}

// A beam without an edge to speak of: four nodes a piece. A part whose tangents have a ratio of five and more is cut into arcs, as far as the
// integrand changes along it, and one in which the light fades after four optical depths. `pieces` is how many even pieces each arc has.
Real integrateSmooth(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit, int pieces) {
    const Real LONG_RATIO = Real(5.0);
    const Real CUT_RATIO = Real(3.0);
    // Far behind the lobes' singularities the light may still fade.
    bool fadesFar = lit.from > Real(1e-3) * lit.fade && lit.to > Real(0.2) * lit.fade;
    Real2 singular = Real2(lit.singular.x, fadesFar ? max(lit.singular.y, lit.fade) : lit.singular.y);
    Real last = min(lit.to, Real(4.0) * singular.y);
    bool fades = lit.to - lit.from > Real(5.0) * lit.fade;
    Real length = Real(1.0) / Real(pieces);
    Real sum = Real(0.0);
    Real from = lit.from;
    int piece = 0;
    do {
        Real first = max(from, Real(0.25) * singular.x);
        Real to = first * LONG_RATIO < last ? first * CUT_RATIO : lit.to;
        to = fades ? min(to, from + Real(4.0) * lit.fade) : to;
        Arc arc = makeArc(singular, from, to);
        for (int i = 0; i < 4; ++i) {
            Real jacobian;
            LampSample here = arcSample(ray, arc, (Real(piece) + gaussNode4(i)) * length, optics.apexToLensM, jacobian);
            sum += gaussWeight4(i) * jacobian * beamKernel(here, optics, haze);
        }
        ++piece;
        bool next = piece == pieces;
        piece = next ? 0 : piece;
        from = next ? to : from;
        fades = fades && !next;
    } while (from < lit.to);
    return sum * length;
}

// A soft beam. If it is crossed from side to side, the profile along the chord depends on one number alone, the share of the cut that the
// chord's middle lies off the axis (as sines), and the rest is smooth: Gauss' rule with the profile as its weight. Its variable is the tangent of
// the angle from the chord's middle over that of its end, -1..1; profileRule gives the nodes +-x, +-y and their weights v, w as (x, y, v, w). Any
// other part is cut where it is closest to the axis and takes pairs of Gauss-Legendre nodes on either side; `pairs` is 2 to 4. One loop serves
// both, since it is loops alone that skip work where pixels are drawn in step.
Real integrateSoft(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit, Arc arc, int pairs) {
    bool byRule = lit.whole && hasProfileRule();
    Real2 middle = Real2(ray.axisAcross, ray.axisAlong);
    Real middleLength = length(middle);
    Real tanEnd = sqrt(max((optics.sinCut - ray.axisNormal) * (optics.sinCut + ray.axisNormal), Real(0.0))) / optics.cosCut;
    Real4 rule = profileRule(ray.axisNormal / optics.sinCut);
    Real axisShare = middle.x > Real(0.0) ? arcShare(arc, tangentTowards(middle.x, middle.y, middleLength))
                                          : middle.y > Real(0.0) ? Real(1.0) : Real(0.0);
    Real sum = Real(0.0);
    int count = byRule ? 1 : pairs;
    int pair = 0;
    do {
        Real2 node = gaussPair(pair, pairs);
        for (int i = 0; i < 4; ++i) {
            Real side = i == 0 || i == 2 ? Real(-1.0) : Real(1.0);
            Real tangent = side * (i < 2 ? rule.x : rule.y) * tanEnd;
            Real cosU = middle.x - tangent * middle.y;
            Real sinU = middle.y + tangent * middle.x;
            Real length = middleLength * sqrt(Real(1.0) + tangent * tangent);
            Real2 towards = sinU > Real(0.0) ? Real2(cosU, length + sinU) : Real2(length - sinU, cosU);
            Real from = i < 2 ? Real(0.0) : axisShare;
            Real width = i < 2 ? axisShare : Real(1.0) - axisShare;
            Real perSquare;
            LampSample here = lampSampleAt(ray, byRule ? towards : arcVector(arc, from + width * (Real(0.5) + side * node.x)),
                                           optics.apexToLensM, perSquare);
            Real weight = byRule ? (i < 2 ? rule.z : rule.w) * tanEnd : node.y * width * arc.turn * perSquare * beamProfile(optics, here);
            sum += weight * hazeKernel(here, haze);
        }
        ++pair;
    } while (pair < count);
    return sum;
}
