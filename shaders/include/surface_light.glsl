// How a surface reflects a lamp's light. Compiled as GLSL and as C++.
//
// A rough, clear coat over a diffuse ground: reflectance distribution [1/sr], radiance over illuminance,
//     f = albedo (1 - F(in)) (1 - F(out)) / pi + D F G / (4 cosIn cosOut)
// D  of Trowbridge and Reitz 1975 (GGX), with Smith's G for light and eye together (Heitz 2014); alpha^2 = 2 / (shininess + 2) is the width
//    that a Blinn-Phong exponent stands for (Walter et al. 2007).
// F  of Schlick 1994, from `specular` head-on to 1 along the surface (less than that below 2 %, which no clear body has); what it reflects,
//    the ground does not get, on the way in and on the way out. So no more leaves a surface than arrives, and without `specular` exactly
//    albedo / pi is left.

// Share reflected by the coat, for the cosine of the angle to what mirrors.
Real coatReflectance(Real cosAngle, Real specular) {
    Real grazing = min(Real(50.0) * specular, Real(1.0));
    Real away = Real(1.0) - cosAngle;
    Real away2 = away * away;
    return specular + (grazing - specular) * away2 * away2 * away;
}

// cosIn, cosOut: from the normal, above 0; cosHalf and cosApart: between the direction halfway and the normal, and the light. `diffuse` is to be
// multiplied with the albedo. All [1/sr].
void surfaceReflection(Real cosIn, Real cosOut, Real cosHalf, Real cosApart, Real specular, Real shininess, OUT(Real) diffuse,
                       OUT(Real) glossy) {
    Real width = Real(2.0) / (shininess + Real(2.0));
    Real peak = cosHalf * cosHalf * (width - Real(1.0)) + Real(1.0);
    Real facing = cosIn * sqrt(cosOut * cosOut * (Real(1.0) - width) + width) + cosOut * sqrt(cosIn * cosIn * (Real(1.0) - width) + width);
    glossy = coatReflectance(cosApart, specular) * width * Real(0.5) / (PI * peak * peak * facing);
    diffuse = (Real(1.0) - coatReflectance(cosIn, specular)) * (Real(1.0) - coatReflectance(cosOut, specular)) / PI;
}
