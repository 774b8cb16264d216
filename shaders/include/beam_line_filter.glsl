// The filter that a beam thinner than a few pixels is drawn with. Compiled as GLSL and as C++. Lengths are in pixels.

// Deviation of a pixel's filter, a Gaussian. Wide enough that lines of any slope keep their light to 0.3 % wherever they fall on the grid (its
// Fourier transform at one cycle a pixel is 0.0026), and no wider, or lines get blurred.
const Real LINE_DEVIATION = Real(0.55);
// Beyond this the filter is 0: 0.006 % of it.
const Real LINE_REACH = Real(2.2);
// Beams are lines up to the first radius, rays from the second on, and a mixture in between.
const Real LINE_RADIUS = Real(2.0);
const Real RAY_RADIUS = Real(4.0);

Real lineFilter(Real away) {
    Real x = away / LINE_DEVIATION;
    return abs(away) < LINE_REACH ? exp(Real(-0.5) * x * x) / (LINE_DEVIATION * Real(2.5066282746310002)) : Real(0.0);
}
