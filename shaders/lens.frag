#version 410 core
// Radiance of a lens seen from a direction: the intensity sent there over the lens' area as seen from there.
#include "include/real.glsl"
#include "include/beam_profile.glsl"

in vec3 toEyeM;
flat in vec4 light;
flat in vec4 cone;
flat in vec4 lens;

uniform float extinctionPerM;

out vec4 radiance;

#ifdef WEB
#include "include/web_picture.glsl"
#endif

// Glass and dust scatter about this share of the peak everywhere; without it a lens is black from the side, which no lens is.
const float STRAY_SHARE = 2.0e-4;

void main() {
    float distanceM = length(toEyeM);
    float cosAxis = -toEyeM.z / distanceM;
    if (cosAxis <= 0.0) discard;
#ifdef WEB
    float relative = webAt(toEyeM);
#else
    float sinAxis = length(toEyeM.xy) / distanceM;
    float relative = cosAxis > cone.x ? (cone.w > 0.0 ? softProfile(atan(sinAxis, cosAxis), cone.z, cone.w) : 1.0) : 0.0;
#endif
    float areaM2 = PI * lens.x * lens.x;
    radiance = vec4(light.rgb * ((relative / cosAxis + STRAY_SHARE) / areaM2 * exp(-extinctionPerM * distanceM)), 1.0);
}
