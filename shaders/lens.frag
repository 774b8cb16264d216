#version 410 core
// Radiance of a lens seen from a direction: the intensity sent there over the lens' area as seen from there. What stands in the beam's way is
// seen in the lens (GOBO).
#include "include/real.glsl"
#include "include/beam_profile.glsl"

in vec3 toEyeM;
flat in vec4 light;
flat in vec4 cone;
#ifdef GOBO
flat in vec4 gobo;
#endif
flat in vec4 lens;
flat in vec3 normal;

uniform float extinctionPerM;

out vec4 radiance;

#ifdef WEB
#include "include/web_picture.glsl"
#endif
#ifdef GOBO
#include "include/gobo.glsl"
#endif

// Glass and dust scatter about this share of the peak everywhere; without it a lens is black from the side, which no lens is.
const float STRAY_SHARE = 2.0e-4;

void main() {
    float distanceM = length(toEyeM);
    float cosAxis = -toEyeM.z / distanceM;
    float cosLens = dot(toEyeM, normal) / distanceM;
    if (min(cosAxis, cosLens) <= 0.0) discard;
#ifdef WEB
    float relative = webAt(toEyeM);
#else
    float sinAxis = length(toEyeM.xy) / distanceM;
    float relative = cosAxis > cone.x ? (cone.w > 0.0 ? softProfile(atan(sinAxis, cosAxis), cone.z, cone.w) : 1.0) : 0.0;
#endif
    float areaM2 = PI * lens.x * lens.x;
    vec3 sent = vec3(relative / cosLens);
#ifdef GOBO
    sent *= goboInAir(toEyeM, light.w - toEyeM.z, 0.0);
#endif
    radiance = vec4(light.rgb * (sent + STRAY_SHARE) * (exp(-extinctionPerM * distanceM) / areaM2), 1.0);
}
