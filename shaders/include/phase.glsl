// Phase functions [1/sr]: their integral over the sphere is 1. Compiled as GLSL and as C++.
// cosTheta is the cosine between the direction the light travels and the direction it is scattered to.

// Henyey and Greenstein 1941, "Diffuse radiation in the galaxy". g in (-1, 1); > 0 scatters forward.
Real phaseHenyeyGreenstein(Real cosTheta, Real g) {
    Real d = Real(1.0) + g * g - Real(2.0) * g * cosTheta;
    return (Real(1.0) - g * g) / (Real(4.0) * PI * d * sqrt(d));
}

// Two lobes: a strong forward one and a weak backward one, as glycol droplets have.
Real phaseTwoLobes(Real cosTheta, Real forwardG, Real backwardG, Real forwardWeight) {
    // Both lobes behind one division.
    Real forward = Real(1.0) + forwardG * forwardG - Real(2.0) * forwardG * cosTheta;
    Real backward = Real(1.0) + backwardG * backwardG - Real(2.0) * backwardG * cosTheta;
    forward *= sqrt(forward);
    backward *= sqrt(backward);
    Real forwardPeak = forwardWeight * (Real(1.0) - forwardG * forwardG);
    Real backwardPeak = (Real(1.0) - forwardWeight) * (Real(1.0) - backwardG * backwardG);
    return (forwardPeak * backward + backwardPeak * forward) / (Real(4.0) * PI * forward * backward);
}
