// How the volume of noise (render/noise_volume.h) becomes the density of the haze. Compiled as GLSL and as C++.
// A period is the edge of the volume.

// A wave of parabolas between -1 and 1 with the period 1: a sine to the eye, without the cost of one.
Real softWave(Real phase) {
    Real from = phase - floor(phase) - Real(0.5);
    return from * (Real(8.0) - Real(16.0) * abs(from));
}

// Where in the volume [periods] to look for what is at a place that has drifted with the wind. Waves of given phases push the swirls to and
// fro, so that the smoke rolls instead of being carried along like a picture. Each is a shear, one after the other: they keep volumes, so that
// the mean density stays, and they fit the period.
Real3 stirred(Real3 place, Real3 wave) {
    const Real PUSH = Real(0.035);
    place.x += PUSH * softWave(Real(2.0) * place.y + wave.x);
    place.y += PUSH * softWave(Real(2.0) * place.z + wave.y);
    place.z += PUSH * softWave(Real(2.0) * place.x + wave.z);
    return place;
}

// Mip level for looks along a ray that stand some texels apart, through a pixel as wide as some texels: what is smaller has faded to its mean.
// Even looks add up to the integral of swirls as long as these are no smaller than the looks are apart, and each level keeps swirls down to two
// of its texels; a quarter instead of the half that follows from this has the least error, since texels also blur across the ray.
Real swirlLevel(Real texelsApart, Real texelsAcross) { return log2(max(max(Real(0.25) * texelsApart, texelsAcross), Real(1.0))); }

// Density relative to the mean. stored: 0..1 with a mean of 1/2; amount 0: even, 1: between 0 and twice the mean.
Real swirlDensity(Real stored, Real amount) { return Real(1.0) + amount * (Real(2.0) * stored - Real(1.0)); }
