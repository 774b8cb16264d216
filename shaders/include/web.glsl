// Looks up a photometric web: the intensity of a lamp in every direction, relative to its peak. Compiled as GLSL and as C++.
//
// The web is a picture of WEB_AZIMUTHS x WEB_THETAS texels (render/ies_web.h). A column is an azimuth around the axis, from the lamp's +X
// towards its +Y: counter-clockwise, looking along the beam. The picture repeats that way. A row is an angle theta from the axis, -Z: the
// first is the axis, the last the way back, and theta / 180 degrees is the square of the row's share of the height, since what is narrow
// stands near the axis.
//
// Whoever includes this provides:
//     Real webTexel(Real2 place);   the picture at texture coordinates, bilinear, repeating in x

const int WEB_AZIMUTHS = 720;
const int WEB_THETAS = 513;

// Texture coordinates of a direction (lamp frame, of any length but 0).
Real2 webPlace(Real3 direction) {
    Real across = length(Real2(direction.x, direction.y));
    Real share = sqrt(atan(across, -direction.z) / PI);
    // On the axis every azimuth is the same direction, and an arc tangent of 0 / 0 is none.
    Real turns = across > Real(0.0) ? atan(direction.y, direction.x) / (Real(2.0) * PI) : Real(0.0);
    return Real2(turns + Real(0.5) / Real(WEB_AZIMUTHS), (share * Real(WEB_THETAS - 1) + Real(0.5)) / Real(WEB_THETAS));
}

// Relative intensity, 0..1, towards a direction.
Real webAt(Real3 direction) { return webTexel(webPlace(direction)); }
