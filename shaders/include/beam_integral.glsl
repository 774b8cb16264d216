// Light that the haze scatters out of one beam towards the eye: the integral over the angle at the lamp. Compiled as GLSL and as C++.
// Single scattering: L = scattering / h * integral p(u) I(psi) G V exp(-extinction * path) du, see docs/rendering.md.
//
// Whoever includes this provides, for what stands in the beam's way and for uneven haze:
//     Real3 transmissionAt(LampSample here);   gobo and shadow, 0..1
//     Real densityAt(Real t);                  haze density relative to the mean, t [m] from the eye

struct BeamOptics {
    Real cosCut;         // half angle of the cone beyond which there is nothing
    Real sinCut;
    Real apexToLensM;
    Real beamHalfAngle;  // 50 % [rad]
    Real exponent;       // of the super-Gaussian; 0: flat
};

struct HazeMedium {
    Real extinctionPerM;
    Real scatteringPerM;
    Real forwardG;
    Real backwardG;
    Real forwardWeight;
};

Real beamProfile(BeamOptics optics, Real cosAxis, Real sinAxis) {
#ifdef FLAT_PROFILE
    return Real(1.0);
#else
    return optics.exponent > Real(0.0) ? softProfile(atan(sinAxis, cosAxis), optics.beamHalfAngle, optics.exponent) : Real(1.0);
#endif
}

// What a sample contributes, but for the constant factors: phase function, attenuation, profile, and what stands in the way.
Real3 beamSample(LampSample here, BeamOptics optics, HazeMedium haze) {
    Real even = phaseTwoLobes(here.cosScatter, haze.forwardG, haze.backwardG, haze.forwardWeight) *
                   exp(-haze.extinctionPerM * here.pathM) * beamProfile(optics, here.cosAxis, here.sinAxis);
    return transmissionAt(here) * even;
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

// Longest piece, as half of w [rad].
const Real LONGEST_PIECE = Real(0.4);

// Integrates from sFrom to sTo. The variable is w with tan(phi / 2) = stretch * tan(w / 2), phi the scattering angle. For stretch =
// (1 - g) / (1 + g) a Henyey-Greenstein lobe times d(phi)/dw is no more than the square root of cos^2(w/2) + stretch^2 sin^2(w/2), so that
// a sharp forward lobe costs no extra nodes; for stretch = 1, w is phi. At least `leastPieces` equal parts of w with 4 Gauss-Legendre nodes
// each, and more where a wide beam is seen along much of the half circle.
Real3 integrateStretch(LampRay ray, BeamOptics optics, HazeMedium haze, Real sFrom, Real sTo, Real stretch, int leastPieces) {
    // Half angles are told as vectors: near 0 and 180 degrees, a ray into or out of the lens, they keep all their digits.
    Real2 from = halfScatterAngle(ray, sFrom);
    Real2 to = halfScatterAngle(ray, sTo);
    from = normalize(Real2(from.x * stretch, from.y));
    to = normalize(Real2(to.x * stretch, to.y));
    Real whole = atan(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    int pieces = max(leastPieces, int(ceil(whole / LONGEST_PIECE)));
    Real piece = whole / Real(pieces);
    Real3 sum = Real3(Real(0.0));
    for (int p = 0; p < pieces; ++p) {
        Real3 pieceSum = Real3(Real(0.0));
        for (int i = 0; i < 4; ++i) {
            Real angle = (Real(p) + gaussNode4(i)) * piece;
            Real c = cos(angle);
            Real s = sin(angle);
            Real a = from.x * c - from.y * s;
            Real b = (from.y * c + from.x * s) * stretch;
            Real scale = Real(1.0) / (a * a + b * b);
            LampSample here = lampSample(ray, Real(2.0) * a * b * scale, (b * b - a * a) * scale, optics.apexToLensM);
            pieceSum += gaussWeight4(i) * scale * beamSample(here, optics, haze);
        }
#ifdef NOISE
        // One look at the haze a piece: its swirls are far larger than what a gobo cuts.
        Real middle = (Real(p) + Real(0.5)) * piece;
        Real a = from.x * cos(middle) - from.y * sin(middle);
        Real b = (from.y * cos(middle) + from.x * sin(middle)) * stretch;
        pieceSum *= densityAt(ray.tClosest + ray.h * Real(0.5) * (b / a - a / b));
#endif
        sum += pieceSum;
    }
    return sum * (Real(2.0) * stretch * piece / ray.h);
}

// The stretch that smooths a lobe, see integrateStretch.
Real lobeStretch(Real g) {
    Real bounded = clamp(g, Real(-0.9), Real(0.9));
    return (Real(1.0) - bounded) / (Real(1.0) + bounded);
}

// Radiance for a lamp of 1 cd [1/m^2], from the haze up to tEnd [m].
Real3 beamInAir(LampRay ray, BeamOptics optics, HazeMedium haze, Real tEnd, int leastPieces) {
    Real sFrom;
    Real sTo;
    if (!litStretch(ray, optics, haze, tEnd, sFrom, sTo)) return Real3(Real(0.0));
    // Before the point closest to the lamp the light comes towards the eye and the forward lobe rules, beyond it the backward lobe. A short
    // stretch across that point is smooth anyway; a long one is cut there.
    bool across = sFrom < Real(0.0) && sTo > Real(0.0);
    bool whole = across && sTo - sFrom < ray.h;
    Real cut = whole ? sTo : clamp(Real(0.0), sFrom, sTo);
    Real3 sum = Real3(Real(0.0));
    for (int part = 0; part < 2; ++part) {
        Real from = part == 0 ? sFrom : cut;
        Real to = part == 0 ? cut : sTo;
        if (from >= to) continue;
        Real stretch = whole ? Real(1.0) : lobeStretch(part == 0 ? haze.forwardG : haze.backwardG);
        sum += integrateStretch(ray, optics, haze, from, to, stretch, leastPieces);
    }
    return sum * haze.scatteringPerM;
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
        Real3 value = beamSample(here, optics, haze) / (r * r);
#ifdef NOISE
        value *= densityAt(t);
#endif
        sum += value;
    }
    return sum * (haze.scatteringPerM * stepM);
}
