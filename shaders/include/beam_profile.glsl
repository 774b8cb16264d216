// How the intensity of a beam falls off from its axis. Compiled as GLSL and as C++.

// Where the profile is cut: this share of the peak is subtracted as a pedestal, so that no edge ring shows.
const Real PROFILE_CUT = Real(0.005);

// Relative intensity, 1 on the axis, at angle psi [rad] from it: exp(-ln 2 (psi / beamHalfAngle)^exponent), a super-Gaussian that is
// 50 % at the beam angle and, with exponent = ln(ln 10 / ln 2) / ln(field / beam), 10 % at the field angle.
Real softProfile(Real psi, Real beamHalfAngle, Real exponent) {
    Real value = exp2(-pow(psi / beamHalfAngle, exponent));
    return max((value - PROFILE_CUT) / (Real(1.0) - PROFILE_CUT), Real(0.0));
}
