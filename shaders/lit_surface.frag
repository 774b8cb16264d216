#version 410 core
// A beam's light on the surface at the end of the pixel's ray.
#include "include/real.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#ifdef WEB
float webAt(vec3 direction);  // see web_picture.glsl
#endif
#include "include/beam_medium.glsl"
#include "include/surface.glsl"
#include "include/surface_light.glsl"
#include "include/beam_pixel.glsl"

uniform sampler2D shapeBuffer;
uniform sampler2D materialTable;
uniform float extinctionPerM;

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

// A surface that the lamp may light, in the lamp's frame.
struct LitPoint {
    vec3 positionM;  // from the apex
    vec3 normal;     // unit
    vec3 toEye;      // unit
    float eyeM;      // distance to the eye
    float distanceM; // from the apex
    float cosIn;     // of the light's angle to the normal
};

LitPoint scaled(LitPoint here, float scale) {
    return LitPoint(here.positionM * scale, here.normal * scale, here.toEye * scale, here.eyeM * scale, here.distanceM * scale,
                    here.cosIn * scale);
}

// Is it in the beam, before the lens, and turned to the lamp?
bool isLit(LitPoint here) {
    float axialM = -here.positionM.z;
    return here.eyeM < SKY_DISTANCE_M && axialM >= cone.x * here.distanceM && (light.w <= 0.0 || axialM >= light.w) && here.cosIn > 0.0;
}

// Illuminance [lx] for a lamp of 1 cd.
vec3 illuminance(LitPoint here) {
    float axialM = -here.positionM.z;
    LampSample sampled;
    sampled.distanceM = here.distanceM;
    sampled.direction = here.positionM / here.distanceM;
    sampled.cosAxis = -sampled.direction.z;
    sampled.sinAxis = length(sampled.direction.xy);
    float lensToSurfaceM = here.distanceM - (light.w > 0.0 ? light.w / sampled.cosAxis : 0.0);
    vec3 lux = vec3(beamProfile(beamOptics(), sampled) * exp(-extinctionPerM * lensToSurfaceM) * here.cosIn /
                    (here.distanceM * here.distanceM));
#ifdef GOBO
    // The pixel's footprint on the surface; one seen along itself is cut short.
    float cosOut = dot(here.toEye, here.normal);
    float widthM = pixelAngle() * here.eyeM;
    vec3 across = cross(here.normal, here.toEye);
    float sinOut = length(across) + 1e-6;
    across *= widthM / sinOut;
    vec3 along = (here.normal * cosOut - here.toEye) * (widthM / (sinOut * max(cosOut, 0.1)));
    lux *= goboOnSurface(sampled.direction, axialM, along, across);
#endif
#ifdef SHADOW
    lux *= surfaceVisibility(here.positionM, here.normal, lux != vec3(0.0));
#endif
    return lux;
}

// Radiance for a lamp of 1 cd.
vec3 reflected(LitPoint here, vec4 material, float shininess) {
    vec3 toLamp = here.positionM / -here.distanceM;
    vec3 halfway = normalize(toLamp + here.toEye);
    float diffuse;
    float glossy;
    surfaceReflection(here.cosIn, max(dot(here.normal, here.toEye), 1e-4), max(dot(here.normal, halfway), 0.0), max(dot(toLamp, halfway), 0.0),
                      material.a, shininess, diffuse, glossy);
    return illuminance(here) * (material.rgb * diffuse + glossy) * exp(-extinctionPerM * here.eyeM);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 shape = texelFetch(shapeBuffer, pixel, 0);
    LitPoint here;
    here.eyeM = pixelDistance();
    if (here.eyeM >= SKY_DISTANCE_M) discard;
    here.toEye = -toLamp(viewDirection());
    here.positionM = vec3(row0.w, row1.w, row2.w) - here.eyeM * here.toEye;
    here.distanceM = length(here.positionM);
    here.normal = toLamp(unpackNormal(shape.xy));
    here.cosIn = -dot(here.normal, here.positionM) / here.distanceM;
    vec3 sum = vec3(0.0);
    // A processor that draws several pixels at once runs both sides of a condition, but leaves a loop when the last one is done. What the
    // loop works on has to come out of it, or a compiler would do the work beforehand.
    for (float once = isLit(here) ? 1.0 : 0.0; once > 0.0; once -= 1.0) {
        sum += reflected(scaled(here, once), texelFetch(materialTable, materialTexel(shape.w), 0), shape.z * MAX_SHININESS);
    }
    if (sum == vec3(0.0)) discard;
    radiance = vec4(sum * light.rgb, 1.0);
}
