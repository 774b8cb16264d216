#version 410 core
// A beam's light that the haze scatters towards the eye along the pixel's ray.
#include "include/real.glsl"
#include "include/phase.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#include "include/gauss_legendre.glsl"
#if defined(GOBO) || defined(SHADOW)
#define APERTURE 1
#endif
#ifdef WEB
float webAt(vec3 direction);  // see web_picture.glsl
#endif
#include "include/beam_medium.glsl"
#include "include/beam_pixel.glsl"

uniform float extinctionPerM;
uniform float scatteringPerM;
uniform vec3 phaseLobes;       // forward g, backward g, weight of the forward lobe
uniform float leastPieces;     // pieces of the lit stretch, 4 nodes each
uniform int uniformSamples;    // UNIFORM: samples along the ray
uniform float uniformRangeM;   // UNIFORM: where a ray that hits nothing ends

uniform float countedAs;  // COUNT: what one integral of this pixel counts

out vec4 radiance;

#ifdef GOBO
#include "include/gobo.glsl"
#endif
#ifdef SHADOW
#include "include/shadow.glsl"
#endif
#ifdef WEB
#include "include/web_picture.glsl"
#endif
#ifdef NOISE
#include "include/haze_noise.glsl"
#else
float densityAt(float t) { return 1.0; }
#endif

// What stands in the light's way, for beam_integral.glsl.
vec3 transmissionAt(LampSample here) {
    vec3 value = vec3(1.0);
#ifdef SHADOW
    value *= float(seesLamp(here.direction * here.distanceM));
#endif
#ifdef GOBO
    float toEyeM = here.pathM - (here.distanceM - light.w / here.cosAxis);
    value *= goboInAir(here.direction, here.distanceM * here.cosAxis, pixelAngle() * toEyeM);
#endif
    return value;
}

#include "include/beam_integral.glsl"

void main() {
    float endM = pixelDistance();
    HazeMedium haze = HazeMedium(extinctionPerM, scatteringPerM, phaseLobes.x, phaseLobes.y, phaseLobes.z);
#ifdef UNIFORM
    vec3 relative = beamInAirUniform(pixelRay(), beamOptics(), haze, min(endM, uniformRangeM), uniformSamples);
#else
    vec3 relative = beamInAir(pixelRay(), beamOptics(), haze, endM, leastPieces);
#endif
    if (relative == vec3(0.0)) discard;
#ifdef COUNT
    radiance = vec4(countedAs);
#else
    radiance = vec4(relative * light.rgb, 1.0);
#endif
}
