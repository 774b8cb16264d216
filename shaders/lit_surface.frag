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

// Illuminance [lx] of the surface for a lamp of 1 cd; `here` is the surface as the lamp sees it.
vec3 illuminance(LampSample here, float distanceToEyeM, vec3 normal, float slant) {
    float axialM = here.distanceM * here.cosAxis;
    float cosIn = -dot(normal, here.direction);
    if (here.cosAxis < cone.x || axialM < light.w || cosIn <= 0.0) return vec3(0.0);
    float lensToSurfaceM = here.distanceM - light.w / here.cosAxis;
    vec3 lux = vec3(beamProfile(beamOptics(), here) * exp(-extinctionPerM * lensToSurfaceM) * cosIn /
                    (here.distanceM * here.distanceM));
#ifdef GOBO
    lux *= goboOnSurface(here.direction, axialM, pixelAngle() * distanceToEyeM / slant);
#endif
#ifdef SHADOW
    lux *= surfaceVisibility(here.direction * here.distanceM, normal);
#endif
    return lux;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float distanceM = pixelDistance();
    if (distanceM >= SKY_DISTANCE_M) discard;
    vec4 shape = texelFetch(shapeBuffer, pixel, 0);
    float shininess = shape.z * MAX_SHININESS;
    LampRay ray = pixelRay();
    float s = distanceM - ray.tClosest;
    float r = sqrt(ray.h * ray.h + s * s);
    LampSample here = lampSample(ray, ray.h / r, s / r, light.w);
    vec3 normal = toLamp(unpackNormal(shape.xy));
    vec3 lux = illuminance(here, distanceM, normal, max(-dot(ray.along, normal), 0.2));
    if (lux == vec3(0.0)) discard;
    vec4 material = texelFetch(materialTable, materialTexel(shape.w), 0);
    vec3 halfway = normalize(-here.direction - ray.along);
    // Blinn-Phong, normalised so that a lobe reflects what `specular` says (Akenine-Moeller et al., Real-Time Rendering, ch. 9).
    float gloss = (shininess + 8.0) / (8.0 * PI) * pow(max(dot(normal, halfway), 0.0), shininess);
    vec3 reflected = lux * (material.rgb / PI + material.a * gloss);
    radiance = vec4(reflected * exp(-extinctionPerM * distanceM) * light.rgb, 1.0);
}
