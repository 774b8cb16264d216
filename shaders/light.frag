#version 410 core
// A beam: its light scattered by the haze along the pixel's ray, and its light on the surface at the ray's end.
#include "include/real.glsl"
#include "include/phase.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#include "include/gauss_legendre.glsl"
#include "include/surface.glsl"
#include "include/beam_input.glsl"

flat in vec4 row0;
flat in vec4 row1;
flat in vec4 row2;
flat in vec4 light;
flat in vec4 cone;
flat in vec4 gobo;
flat in vec4 shadow;
flat in vec4 lens;

uniform sampler2D geometryBuffer;
uniform sampler2D materialBuffer;
uniform sampler2DArray goboImages;
uniform sampler2DArrayShadow shadowMaps;
uniform sampler3D noiseVolume;

uniform vec2 viewportPx;
uniform vec2 viewTangent;       // tangents of half the field of view
uniform float extinctionPerM;
uniform float scatteringPerM;
uniform vec3 phaseLobes;        // forward g, backward g, weight of the forward lobe
uniform int pieces;             // stretches of the lit part, 4 Gauss-Legendre nodes each
uniform int uniformSamples;     // UNIFORM: samples along the ray
uniform float uniformRangeM;    // UNIFORM: where a ray that hits nothing ends
uniform mat3 worldFromView;
uniform vec3 noiseOrigin[2];    // camera in the noise's periods, per layer
uniform float noisePerM[2];     // periods a metre, per layer
uniform float noiseAmount;

out vec4 radiance;

const vec3 AXIS = vec3(0.0, 0.0, -1.0);

vec3 toLamp(vec3 v) { return vec3(dot(row0.xyz, v), dot(row1.xyz, v), dot(row2.xyz, v)); }

// Relative intensity in a direction; 0 outside the cut is the caller's business.
float profileAt(float cosAxis, float sinAxis) {
#ifdef SOFT
    return softProfile(atan(sinAxis, cosAxis), cone.z, cone.w);
#else
    return 1.0;
#endif
}

#ifdef GOBO
// Transmission of the gobo where a direction crosses it. footprintM: width of what is looked at, at axialM from the apex.
vec3 goboAt(vec3 direction, float axialM, float footprintM) {
    vec2 tangent = direction.xy / -direction.z;
    vec2 q = vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.y * tangent.y - gobo.z * tangent.x);
    float size = float(textureSize(goboImages, 0).x);
    float blurM = footprintM / axialM;
    if (gobo.w >= 0.0) {
        // Circle of confusion on the gobo, as a tangent: exit pupil times the error of vergence (thin lens).
        blurM = max(blurM, 2.0 * lens.x * abs(1.0 / max(axialM - light.w, 1e-3) - gobo.w));
    }
    float texels = blurM * length(gobo.yz) * 0.5 * size;
    return textureLod(goboImages, vec3(0.5 + 0.5 * q.x, 0.5 - 0.5 * q.y, gobo.x), log2(max(texels, 1.0))).rgb;
}
#endif

#ifdef SHADOW
// Share of the light that reaches the point (lamp space), 0..1.
float visibilityAt(vec3 pointM) {
    float axialM = max(-pointM.z, shadow.z);
    vec2 uv = 0.5 + 0.5 * shadow.y * pointM.xy / axialM;
    // Beyond the far plane there is no caster: 1 compares as lit there, and a float map does not clamp by itself.
    float depth = min(shadow.w / (shadow.w - shadow.z) * (1.0 - shadow.z / axialM), 1.0);
    return texture(shadowMaps, vec4(uv, shadow.x, depth));
}
#endif

#ifdef NOISE
// Haze density relative to the mean, at a distance along the pixel's ray. Two layers of the same tile drift apart, so that the smoke
// rolls instead of being pushed.
float densityAt(vec3 worldDirection, float t) {
    float a = texture(noiseVolume, noiseOrigin[0] + worldDirection * (t * noisePerM[0])).r;
    float b = texture(noiseVolume, noiseOrigin[1] + worldDirection * (t * noisePerM[1])).r;
    return max(1.0 + noiseAmount * (2.0 * a + b - 1.5) * 1.6, 0.0);
}
#endif

// Everything at one sample but the haze's density and the constant factors.
vec3 sampleAt(LampSample here, float pixelAngle) {
    vec3 value = vec3(phaseTwoLobes(here.cosScatter, phaseLobes.x, phaseLobes.y, phaseLobes.z) * exp(-extinctionPerM * here.pathM) *
                      profileAt(here.cosAxis, here.sinAxis));
#ifdef GOBO
    float axialM = here.distanceM * here.cosAxis;
    value *= goboAt(here.direction, axialM, pixelAngle * here.pathM);
#endif
#ifdef SHADOW
    value *= visibilityAt(here.direction * here.distanceM);
#endif
    return value;
}

#ifdef UNIFORM
// The thesis' method: samples evenly spaced from the camera to the ray's end, most of them outside the beam.
vec3 inAir(LampRay ray, float tEnd, float pixelAngle, vec3 worldDirection) {
    float stepM = min(tEnd, uniformRangeM) / float(uniformSamples);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < uniformSamples; ++i) {
        float t = (float(i) + 0.5) * stepM;
        float s = t - ray.tClosest;
        float r = sqrt(ray.h * ray.h + s * s);
        LampSample here = lampSample(ray, ray.h / r, s / r, light.w);
        if (here.cosAxis < cone.x || r * here.cosAxis < light.w) continue;
        vec3 value = sampleAt(here, pixelAngle) / (r * r);
#ifdef NOISE
        value *= densityAt(worldDirection, t);
#endif
        sum += value;
    }
    return sum * (scatteringPerM * stepM);
}
#else
vec3 inAir(LampRay ray, float tEnd, float pixelAngle, vec3 worldDirection) {
    float sFrom, sTo;
    if (!coneInterval(ray, cone.x, cone.y, SKY_DISTANCE_M, sFrom, sTo)) return vec3(0.0);
    clipToLens(ray, light.w, sFrom, sTo);
    sFrom = max(sFrom, -ray.tClosest);
    sTo = min(sTo, tEnd - ray.tClosest);
    clipToThickHaze(ray, extinctionPerM, sFrom, sTo);
    if (sFrom >= sTo) return vec3(0.0);
    float whole = angleBetween(ray, sFrom, sTo);
    float rFrom = sqrt(ray.h * ray.h + sFrom * sFrom);
    vec2 from = vec2(ray.h, sFrom) / rFrom;
    float piece = whole / float(pieces);
    vec3 sum = vec3(0.0);
    for (int p = 0; p < pieces; ++p) {
        vec3 pieceSum = vec3(0.0);
        for (int i = 0; i < 4; ++i) {
            float angle = (float(p) + gaussNode4(i)) * piece;
            float c = cos(angle);
            float s = sin(angle);
            LampSample here = lampSample(ray, from.x * c - from.y * s, from.y * c + from.x * s, light.w);
            pieceSum += gaussWeight4(i) * sampleAt(here, pixelAngle);
        }
#ifdef NOISE
        float middle = (float(p) + 0.5) * piece;
        vec2 u = vec2(from.x * cos(middle) - from.y * sin(middle), from.y * cos(middle) + from.x * sin(middle));
        pieceSum *= densityAt(worldDirection, ray.tClosest + ray.h * u.y / u.x);
#endif
        sum += pieceSum;
    }
    return sum * (scatteringPerM * piece / ray.h);
}
#endif

#ifdef SURFACES
// Light of the beam that the surface at the ray's end sends to the eye, before the haze between.
vec3 onSurface(LampRay ray, vec3 viewDirection, vec4 geometry, float pixelAngle) {
    float s = geometry.z - ray.tClosest;
    float r = sqrt(ray.h * ray.h + s * s);
    LampSample here = lampSample(ray, ray.h / r, s / r, light.w);
    float axialM = r * here.cosAxis;
    if (here.cosAxis < cone.x || axialM < light.w) return vec3(0.0);
    vec3 normal = toLamp(unpackNormal(geometry.xy));
    float cosIn = -dot(normal, here.direction);
    if (cosIn <= 0.0) return vec3(0.0);
    float lensToSurfaceM = r - light.w / here.cosAxis;
    vec3 illuminanceLx = vec3(profileAt(here.cosAxis, here.sinAxis) * exp(-extinctionPerM * lensToSurfaceM) * cosIn / (r * r));
#ifdef GOBO
    float slant = max(-dot(toLamp(viewDirection), normal), 0.2);
    illuminanceLx *= goboAt(here.direction, axialM, pixelAngle * geometry.z / slant);
#endif
#ifdef SHADOW
    // Stepping off the surface by a texel of the map keeps it from shadowing itself.
    illuminanceLx *= visibilityAt(here.direction * r + normal * (1.5 * lens.y * axialM));
#endif
    vec4 material = texelFetch(materialBuffer, ivec2(gl_FragCoord.xy), 0);
    vec3 halfway = normalize(-here.direction - toLamp(viewDirection));
    // Blinn-Phong, normalised so that a lobe reflects what `specular` says (Akenine-Moeller et al., Real-Time Rendering, ch. 9).
    float gloss = (geometry.w + 8.0) / (8.0 * PI) * pow(max(dot(normal, halfway), 0.0), geometry.w);
    return illuminanceLx * (material.rgb / PI + material.a * gloss);
}
#endif

void main() {
    vec4 geometry = texelFetch(geometryBuffer, ivec2(gl_FragCoord.xy), 0);
    vec3 viewDirection = normalize(vec3((2.0 * gl_FragCoord.xy / viewportPx - 1.0) * viewTangent, -1.0));
    float pixelAngle = 2.0 * viewTangent.y / viewportPx.y;
    LampRay ray = lampRay(vec3(row0.w, row1.w, row2.w), toLamp(viewDirection), AXIS);
    vec3 relative = vec3(0.0);
#ifdef AIR
    relative += inAir(ray, geometry.z, pixelAngle, worldFromView * viewDirection);
#endif
#ifdef SURFACES
    if (geometry.z < SKY_DISTANCE_M) {
        relative += onSurface(ray, viewDirection, geometry, pixelAngle) * exp(-extinctionPerM * geometry.z);
    }
#endif
    if (relative == vec3(0.0)) discard;
    radiance = vec4(relative * light.rgb, 1.0);
}
