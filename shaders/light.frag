#version 410 core
// A beam: its light scattered by the haze along the pixel's ray, and its light on the surface at the ray's end.
#include "include/real.glsl"
#include "include/phase.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#include "include/gauss_legendre.glsl"
#include "include/surface.glsl"
#include "include/beam_input.glsl"

#if defined(GOBO) || defined(SHADOW)
#define APERTURE 1
#endif

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
uniform float leastPieces;      // pieces of the lit stretch, 4 nodes each
uniform int uniformSamples;     // UNIFORM: samples along the ray
uniform float uniformRangeM;    // UNIFORM: where a ray that hits nothing ends
uniform mat3 worldFromView;
uniform vec3 noiseOrigin;       // camera in the noise's periods
uniform float noisePerM;        // periods a metre
uniform vec3 noiseWave;         // phases of the waves that stir it
uniform float noiseAmount;

out vec4 radiance;

const vec3 AXIS = vec3(0.0, 0.0, -1.0);

vec3 toLamp(vec3 v) { return vec3(dot(row0.xyz, v), dot(row1.xyz, v), dot(row2.xyz, v)); }

float pixelAngle() { return 2.0 * viewTangent.y / viewportPx.y; }

vec3 viewDirection() { return normalize(vec3((2.0 * gl_FragCoord.xy / viewportPx - 1.0) * viewTangent, -1.0)); }

#ifdef GOBO
// Transmission of the gobo where a direction crosses it. footprintM: width of what is looked at, at axialM from the apex.
vec3 goboAt(vec3 direction, float axialM, float footprintM, bool onSurface) {
    vec2 tangent = direction.xy / -direction.z;
    vec2 q = vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.y * tangent.y - gobo.z * tangent.x);
    float size = float(textureSize(goboImages, 0).x);
    float blurM = footprintM / axialM;
    if (gobo.w >= 0.0) {
        // Circle of confusion on the gobo, as a tangent: exit pupil times the error of vergence (thin lens).
        blurM = max(blurM, 2.0 * lens.x * abs(1.0 / max(axialM - light.w, 1e-3) - gobo.w));
    }
    float texels = max(blurM * length(gobo.yz) * 0.5 * size, 1.0);
    vec2 uv = 0.5 + 0.5 * vec2(q.x, -q.y);
    if (!onSurface) return textureLod(goboImages, vec3(uv, gobo.x), log2(texels)).rgb;
    // A blurred edge drawn large shows the steps of a single coarse texel; four taps one level finer round them off.
    float level = max(log2(texels) - 1.0, 0.0);
    float apart = 0.5 * (texels - 1.0) / size;
    return 0.25 * (textureLod(goboImages, vec3(uv + apart, gobo.x), level).rgb + textureLod(goboImages, vec3(uv - apart, gobo.x), level).rgb +
                   textureLod(goboImages, vec3(uv + vec2(apart, -apart), gobo.x), level).rgb +
                   textureLod(goboImages, vec3(uv - vec2(apart, -apart), gobo.x), level).rgb);
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

// The two hooks of beam_integral.glsl.
vec3 transmissionAt(LampSample here) {
    vec3 value = vec3(1.0);
#ifdef SHADOW
    value *= visibilityAt(here.direction * here.distanceM);
#endif
#ifdef GOBO
    float toEyeM = here.pathM - (here.distanceM - light.w / here.cosAxis);
    value *= goboAt(here.direction, here.distanceM * here.cosAxis, pixelAngle() * toEyeM, false);
#endif
    return value;
}

float densityAt(float t) {
#ifdef NOISE
    vec3 place = noiseOrigin + worldFromView * viewDirection() * (t * noisePerM);
    // Waves that move push the swirls to and fro, so that the smoke rolls instead of being carried along like a picture.
    place += 0.035 * sin(6.2831853 * (2.0 * place.yzx + noiseWave));
    return max(1.0 + noiseAmount * 4.2 * (texture(noiseVolume, place).r - 0.5), 0.0);
#else
    return 1.0;
#endif
}

#include "include/beam_integral.glsl"

#ifdef SURFACES
// Light of the beam that the surface at the ray's end sends to the eye, before the haze between.
vec3 onSurface(LampRay ray, BeamOptics optics, vec4 geometry) {
    float s = geometry.z - ray.tClosest;
    float r = sqrt(ray.h * ray.h + s * s);
    LampSample here = lampSample(ray, ray.h / r, s / r, light.w);
    float axialM = r * here.cosAxis;
    if (here.cosAxis < cone.x || axialM < light.w) return vec3(0.0);
    vec3 normal = toLamp(unpackNormal(geometry.xy));
    float cosIn = -dot(normal, here.direction);
    if (cosIn <= 0.0) return vec3(0.0);
    float lensToSurfaceM = r - light.w / here.cosAxis;
    vec3 illuminanceLx = vec3(beamProfile(optics, here.cosAxis, here.sinAxis) * exp(-extinctionPerM * lensToSurfaceM) * cosIn / (r * r));
#ifdef GOBO
    float slant = max(-dot(ray.along, normal), 0.2);
    illuminanceLx *= goboAt(here.direction, axialM, pixelAngle() * geometry.z / slant, true);
#endif
#ifdef SHADOW
    // Stepping off the surface by a texel of the map keeps it from shadowing itself.
    illuminanceLx *= visibilityAt(here.direction * r + normal * (1.5 * lens.y * axialM));
#endif
    vec4 material = texelFetch(materialBuffer, ivec2(gl_FragCoord.xy), 0);
    vec3 halfway = normalize(-here.direction - ray.along);
    // Blinn-Phong, normalised so that a lobe reflects what `specular` says (Akenine-Moeller et al., Real-Time Rendering, ch. 9).
    float gloss = (geometry.w + 8.0) / (8.0 * PI) * pow(max(dot(normal, halfway), 0.0), geometry.w);
    return illuminanceLx * (material.rgb / PI + material.a * gloss);
}
#endif

void main() {
    vec4 geometry = texelFetch(geometryBuffer, ivec2(gl_FragCoord.xy), 0);
    LampRay ray = lampRay(vec3(row0.w, row1.w, row2.w), toLamp(viewDirection()), AXIS);
    BeamOptics optics = BeamOptics(cone.x, cone.y, light.w, cone.z, cone.w);
    vec3 relative = vec3(0.0);
#ifdef AIR
    HazeMedium haze = HazeMedium(extinctionPerM, scatteringPerM, phaseLobes.x, phaseLobes.y, phaseLobes.z);
#ifdef UNIFORM
    relative += beamInAirUniform(ray, optics, haze, min(geometry.z, uniformRangeM), uniformSamples);
#else
    relative += beamInAir(ray, optics, haze, geometry.z, leastPieces);
#endif
#endif
#ifdef SURFACES
    if (geometry.z < SKY_DISTANCE_M) relative += onSurface(ray, optics, geometry) * exp(-extinctionPerM * geometry.z);
#endif
    if (relative == vec3(0.0)) discard;
    radiance = vec4(relative * light.rgb, 1.0);
}
