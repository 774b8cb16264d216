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

#ifdef LINE
Real rayShareAt(LampSample here);  // see beam_line.glsl and air.frag
#endif

// Relative intensity towards a sample of the beam; with LINE, what of it is drawn by rays.
Real beamProfile(BeamOptics optics, LampSample here) {
#if defined(WEB)
    Real relative = webAt(here.direction);
#elif defined(FLAT_PROFILE)
    Real relative = Real(1.0);
#else
    Real relative = optics.exponent > Real(0.0) ? softProfile(atan(here.sinAxis, here.cosAxis), optics.beamHalfAngle, optics.exponent) : Real(1.0);
#endif
#ifdef LINE
    relative *= rayShareAt(here);
#endif
    return relative;
}
