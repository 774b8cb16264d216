// Light that the haze scatters out of one beam towards the eye: the integral over the angle at the lamp. Compiled as GLSL and as C++.
// Single scattering: L = scattering / h * integral p(u) I(psi) G V exp(-extinction * path) du, see docs/rendering.md.
//
// Whoever includes this provides, for what stands in the beam's way and for uneven haze:
//     Real3 transmissionAt(LampSample here);   gobo and shadow, 0..1
//     Real densityAt(Real t);                  haze density relative to the mean, t [m] from the eye
// Needs phase.glsl, beam_ray.glsl, beam_medium.glsl, gauss_legendre.glsl.

// What is smooth at a sample: phase function, attenuation, profile.
Real beamKernel(LampSample here, BeamOptics optics, HazeMedium haze) {
    return phaseTwoLobes(here.cosScatter, haze.forwardG, haze.backwardG, haze.forwardWeight) * exp(-haze.extinctionPerM * here.pathM) *
           beamProfile(optics, here);
}

// The stretch of the ray, from the eye to tEnd [m], that the beam lights and that matters.
bool litStretch(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, OUT(Real) sFrom, OUT(Real) sTo) {
    Real limit = tEnd + abs(ray.tClosest) + ray.h;
    if (!coneInterval(ray, optics.cosCut, optics.sinCut, limit, sFrom, sTo)) return false;
    clipToLens(ray, optics.apexToLensM, sFrom, sTo);
    sFrom = max(sFrom, -ray.tClosest);
    sTo = min(sTo, tEnd - ray.tClosest);
    if (sFrom >= sTo) return false;
    clipToThickHaze(ray, haze.extinctionPerM, sFrom, sTo);
    return sFrom < sTo;
}

// The stretch that smooths a lobe, see Arc.
Real lobeStretch(Real g) {
    Real bounded = clamp(g, Real(-0.9), Real(0.9));
    return (Real(1.0) - bounded) / (Real(1.0) + bounded);
}

// A part of the lit stretch in the variable of integration, w with tan(phi / 2) = stretch * tan(w / 2), phi the scattering angle. For
// stretch = (1 - g) / (1 + g) a Henyey-Greenstein lobe times d(phi)/dw is no more than the square root of cos^2(w/2) + stretch^2 sin^2(w/2),
// so that a sharp lobe costs no extra nodes; for stretch = 1, w is phi. Half angles are told as vectors: near 0 and 180 degrees, a ray into
// or out of the lens, they keep all their digits.
struct Arc {
    Real2 from;    // unit, w / 2 at the near end
    Real stretch;
    Real piece;    // w / 2 of one piece [rad]
    int pieces;
};

// Longest piece, as half of w [rad], that four nodes integrate.
const Real LONGEST_PIECE = Real(0.4);

// The arc from sFrom to sTo; empty (no pieces) if there is nothing between them.
Arc makeArc(LampRay ray, Real sFrom, Real sTo, Real stretch, Real leastPieces) {
    Real2 from = halfScatterAngle(ray, sFrom);
    Real2 to = halfScatterAngle(ray, sTo);
    Arc arc;
    arc.from = normalize(Real2(from.x * stretch, from.y));
    arc.stretch = stretch;
    to = normalize(Real2(to.x * stretch, to.y));
    Real whole = atan(arc.from.x * to.y - arc.from.y * to.x, arc.from.x * to.x + arc.from.y * to.y);
    arc.pieces = sFrom < sTo ? int(ceil(max(leastPieces, whole / LONGEST_PIECE))) : 0;
    arc.piece = whole / Real(max(arc.pieces, 1));
    return arc;
}

// Turns a vector by an angle of at most LONGEST_PIECE; the series' remainders are below 1e-6.
Real2 turned(Real2 v, Real angle) {
    Real x = angle * angle;
    Real c = Real(1.0) - x * (Real(0.5) - x * (Real(1.0 / 24.0) - x * Real(1.0 / 720.0)));
    Real s = angle * (Real(1.0) - x * (Real(1.0 / 6.0) - x * Real(1.0 / 120.0)));
    return Real2(v.x * c - v.y * s, v.y * c + v.x * s);
}

// The sample at w / 2 = `halfAngle`; d(phi)/dw but for the factor of two comes back in `jacobian`.
LampSample arcSample(LampRay ray, Real2 halfAngle, Real stretch, Real apexToLensM, OUT(Real) jacobian) {
    Real a = halfAngle.x;
    Real b = halfAngle.y * stretch;
    Real scale = Real(1.0) / (a * a + b * b);
    jacobian = stretch * scale;
    return lampSample(ray, Real(2.0) * a * b * scale, (b * b - a * a) * scale, apexToLensM);
}

// One piece, but for its length.
Real3 integratePiece(LampRay ray, BeamOptics optics, HazeMedium haze, Real2 from, Real piece, Real stretch) {
    Real jacobian;
#ifdef APERTURE
    // What stands in the way has edges that no polynomial follows: four even taps for it, and one look at all that is smooth.
    LampSample middle = arcSample(ray, turned(from, Real(0.5) * piece), stretch, optics.apexToLensM, jacobian);
    Real even = jacobian * beamKernel(middle, optics, haze);
    Real3 sum = Real3(Real(0.0));
    for (int i = 0; i < 4; ++i) {
        Real unused;
        sum += transmissionAt(arcSample(ray, turned(from, (Real(i) + Real(0.5)) * Real(0.25) * piece), stretch, optics.apexToLensM, unused));
    }
    return sum * (Real(0.25) * even);
#else
    Real sum = Real(0.0);
    for (int i = 0; i < 4; ++i) {
        LampSample here = arcSample(ray, turned(from, gaussNode4(i) * piece), stretch, optics.apexToLensM, jacobian);
        sum += gaussWeight4(i) * jacobian * beamKernel(here, optics, haze);
    }
    return Real3(sum);
#endif
}

// Radiance for a lamp of 1 cd [1/m^2], from the haze up to tEnd [m]: `leastPieces` of 4 nodes each over the lit stretch, and more where a
// wide beam is seen along much of the half circle.
Real3 beamInAir(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, Real leastPieces) {
    Real sFrom;
    Real sTo;
    if (!litStretch(ray, optics, haze, tEnd, sFrom, sTo)) return Real3(Real(0.0));
    // Before the point closest to the lamp the light comes towards the eye and the forward lobe rules, beyond it the backward lobe. A short
    // stretch across that point is smooth anyway; a long one is cut there.
    bool whole = sFrom < Real(0.0) && sTo > Real(0.0) && sTo - sFrom < ray.h;
    Real cut = whole ? sTo : clamp(Real(0.0), sFrom, sTo);
    Real nearShare = angleBetween(ray, sFrom, cut) / angleBetween(ray, sFrom, sTo);
    Arc arc = makeArc(ray, sFrom, cut, whole ? Real(1.0) : lobeStretch(haze.forwardG), leastPieces * nearShare);
    Arc farArc = makeArc(ray, cut, sTo, lobeStretch(haze.backwardG), leastPieces * (Real(1.0) - nearShare));
    Real3 sum = Real3(Real(0.0));
    Real2 at = arc.from;
    int total = arc.pieces + farArc.pieces;
    for (int p = 0; p < total; ++p) {
        if (p == arc.pieces) {
            at = farArc.from;
            arc.stretch = farArc.stretch;
            arc.piece = farArc.piece;
        }
        Real3 pieceSum = arc.piece * integratePiece(ray, optics, haze, at, arc.piece, arc.stretch);
#ifdef NOISE
        // One look at the haze a piece: its swirls are far larger than what a gobo cuts.
        Real2 middle = turned(at, Real(0.5) * arc.piece);
        middle.y *= arc.stretch;
        pieceSum *= densityAt(ray.tClosest + ray.h * Real(0.5) * (middle.y / middle.x - middle.x / middle.y));
#endif
        sum += pieceSum;
        at = turned(at, arc.piece);
    }
    return sum * (haze.scatteringPerM * Real(2.0) / ray.h);
}

// The same by the thesis' method: samples evenly spaced over the whole ray from the eye to tEnd, most of them outside the beam.
Real3 beamInAirUniform(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, int samples) {
    Real stepM = tEnd / Real(samples);
    Real3 sum = Real3(Real(0.0));
    for (int i = 0; i < samples; ++i) {
        Real t = (Real(i) + Real(0.5)) * stepM;
        Real s = t - ray.tClosest;
        Real r = sqrt(ray.h * ray.h + s * s);
        LampSample here = lampSample(ray, ray.h / r, s / r, optics.apexToLensM);
        if (here.cosAxis < optics.cosCut || r * here.cosAxis < optics.apexToLensM) continue;
        Real3 value = transmissionAt(here) * (beamKernel(here, optics, haze) / (r * r));
#ifdef NOISE
        value *= densityAt(t);
#endif
        sum += value;
    }
    return sum * (haze.scatteringPerM * stepM);
}
