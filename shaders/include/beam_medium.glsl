// What a beam and the haze are made of. Compiled as GLSL and as C++. Needs beam_profile.glsl and beam_ray.glsl; with
// WEB, web.glsl.

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

// Relative intensity towards a sample of the beam.
Real beamProfile(BeamOptics optics, LampSample here) {
#if defined(WEB)
    return webAt(here.direction);
#elif defined(FLAT_PROFILE)
    return Real(1.0);
#else
    return optics.exponent > Real(0.0) ? softProfile(atan(here.sinAxis, here.cosAxis), optics.beamHalfAngle, optics.exponent) : Real(1.0);
#endif
}
