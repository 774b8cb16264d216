#version 410 core
// A beam's light that the haze scatters towards the eye along the pixel's ray.
#include "include/real.glsl"
#include "include/phase.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#include "include/gauss_legendre.glsl"
#ifdef WEB
float webAt(vec3 direction);  // see web_picture.glsl
#endif
#include "include/beam_medium.glsl"
#include "include/beam_pixel.glsl"

uniform float extinctionPerM;
uniform float scatteringPerM;
uniform vec3 phaseLobes;         // forward g, backward g, weight of the forward lobe
uniform sampler2D profileRules;  // render/profile_rule.h
uniform int shadowIntervals;     // of the stretch that something may shade
uniform int shadowBisections;    // of an interval at an edge of a shadow
uniform int profilePairs;         // of nodes on either side of the axis
uniform int goboTaps;            // over the lit stretch
uniform float goboTolerance;     // how far what is smooth along a gobo's line may be from a cubic, a share
uniform float goboLevelsApart;   // how far its blur may differ along a line that a table serves, in mip levels
uniform int noiseNodes;          // over the lit stretch
uniform int sampleCount;         // SAMPLED: over the lit stretch; UNIFORM: over the whole ray
uniform float uniformRangeM;     // UNIFORM: where a ray that hits nothing ends

uniform float countedAs;  // COUNT: what one integral of this pixel counts

out vec4 radiance;

#ifdef GOBO
#include "include/gobo.glsl"
vec3 apertureAt(LampSample here) {
    float toEyeM = here.pathM - (here.distanceM - light.w / here.cosAxis);
    return goboInAir(here.direction, here.distanceM * here.cosAxis, pixelAngle() * toEyeM);
}
#else
vec3 apertureAt(LampSample here) { return vec3(1.0); }
#endif

#ifdef SHADOW
#include "include/shadow.glsl"
#else
bool seesLamp(vec3 pointM) { return true; }
#endif

#ifdef WEB
#include "include/web_picture.glsl"
#endif

#ifdef NOISE
#include "include/haze_noise.glsl"
#else
float densityAt(float t) { return 1.0; }
float densityAround(float t, float apartM) { return 1.0; }
#endif

bool hasProfileRule() { return lens.y >= 0.0; }

vec4 profileRule(float share) {
    vec2 texels = vec2(textureSize(profileRules, 0));
    return textureLod(profileRules, vec2(share * (texels.x - 1.0) + 0.5, lens.y + 0.5) / texels, 0.0);
}

#ifdef SHADOW
#ifdef SHADOW_FACES
// Six maps: a straight line stays straight in space alone.
vec3 shadePlace(vec3 pointM) { return pointM; }
float placeWeight(vec3 place) { return 1.0; }
bool placeSeesLamp(vec3 place) { return seesLamp(place); }
#else
vec3 shadePlace(vec3 pointM) {
    ShadowFace face = shadowFace(0);
    float perM = 1.0 / max(-pointM.z, face.tile.w);
    return vec3(withinTile(face, pointM.xy * perM * face.map.xy + face.map.zw) / vec2(textureSize(shadowAtlas, 0)), shadowNearness(face) * perM);
}
float placeWeight(vec3 place) { return place.z; }
bool placeSeesLamp(vec3 place) { return place.z >= textureLod(shadowAtlas, place.xy, 0.0).r; }
#endif
#else
vec3 shadePlace(vec3 pointM) { return pointM; }
float placeWeight(vec3 place) { return 1.0; }
bool placeSeesLamp(vec3 place) { return true; }
#endif

#include "include/beam_arc.glsl"
#include "include/beam_integral.glsl"
#include "include/beam_density.glsl"
#include "include/beam_shade.glsl"
#include "include/beam_reference.glsl"
#if defined(GOBO) && !defined(UNIFORM) && !defined(SAMPLED)
uniform sampler2DArray goboTables;
vec4 goboTableTexel(vec2 place, float layer);
#include "include/gobo_table.glsl"
vec4 goboTableTexel(vec2 place, float layer) {
    return textureLod(goboTables, vec3(place / vec2(GOBO_TABLE_WIDTH, GOBO_TABLE_HEIGHT), layer), 0.0);
}
#include "include/beam_gobo.glsl"
#endif

#ifdef WEB
#include "include/beam_web.glsl"
#endif
#ifdef BACKWARDS
#include "include/beam_backwards.glsl"
#endif
#ifdef LINE
#include "include/beam_line_filter.glsl"
#include "include/beam_line.glsl"
uniform float beamRangeM;

BeamLine beamLine() {
    return makeBeamLine(vec3(row0.w, row1.w, row2.w), vec3(row0.x, row1.x, row2.x), vec3(row0.y, row1.y, row2.y), vec3(row0.z, row1.z, row2.z),
                        pixelAngle(), beamOptics());
}

BeamLine axisLine = beamLine();

float rayShareAt(LampSample here) {
    return rayShare(axisLine, here.distanceM * here.cosAxis, lineDepth(axisLine, here.direction * here.distanceM));
}

#ifdef GOBO
// Mean over the disc; black around it.
vec3 meanAperture() {
    vec3 sum = vec3(0.0);
    for (int quarter = 0; quarter < 4; ++quarter) sum += goboTexel(vec2(quarter % 2, quarter / 2) * 0.5 + 0.25, 16.0);
    return min(sum / PI, 1.0);
}
#else
vec3 meanAperture() { return vec3(1.0); }
#endif

// What the beam sends to the eye where it is a line, over scattering.
vec3 lineLight(BeamOptics optics, HazeMedium haze, float endM) {
    return meanAperture() * (lens.z * lineRadiance(axisLine, optics, haze, toLamp(viewRay()), endM, beamRangeM));
}
#endif

#ifndef UNIFORM
// How many more looks at obstacles a ray wants that does not cross all of the beam: those that end in it meet a gobo or a shadow where it is bright,
// and from within a beam its gobo and its shadows are seen along their edges.
float obstacleShare(LitPart lit) { return lit.fromEye ? 5.0 : lit.whole ? 1.0 : 1.2; }

// What the lit part of the ray sends to the eye, for integrals see beam_integral.glsl.
vec3 litLight(LampRay ray, BeamOptics optics, HazeMedium haze, LitPart lit) {
    Arc arc = makeArc(lit.singular, lit.from, lit.to);
#ifdef SAMPLED
#if defined(GOBO) || defined(SHADOW)
    return integrateSampledObstacles(ray, optics, haze, arc, sampleCount);
#else
    return integrateSampled(ray, optics, haze, lit, sampleCount);
#endif
#else
#if defined(GOBO) || defined(SHADOW)
    float sFrom = placeAt(ray, lit.from);
    float sTo = placeAt(ray, lit.to);
#endif
#ifdef SHADOW
    float shadeFrom = sFrom;
    float shadeTo = sTo;
    bool shaded = shadowStretch(ray, shadeFrom, shadeTo);
    float shadeShare = arcShare(arc, tangentAt(ray, shadeTo)) - arcShare(arc, tangentAt(ray, shadeFrom));
    int intervals = shaded ? max(int(ceil(float(shadowIntervals) * obstacleShare(lit) * shadeShare)), 4) : 0;
#endif

#if defined(GOBO)
    int cells = int(float(goboTaps) * obstacleShare(lit) * nearLamp(ray));
#ifdef SHADOW
    ShadeLine shade = makeShadeLine(ray, shadeFrom, shadeTo, shadowBisections);
    vec3 sum = integrateGobo(ray, optics, haze, lit.whole, sFrom, sTo, cells, shade, intervals);
#else
    vec3 sum = integrateGobo(ray, optics, haze, lit.whole, sFrom, sTo, cells, ShadeLine(0.0, 0.0, vec3(0.0), vec3(0.0), 0), 0);
#endif
#ifdef LINE
    // A gobo's integral has no profile to carry the share.
    float unused;
    sum *= rayShareAt(arcSample(ray, arc, 0.5, optics.apexToLensM, unused));
#endif
#else
#if defined(FLAT_PROFILE)
    float smoothSum = integrateSmooth(ray, optics, haze, lit, 1);
#elif defined(WEB)
    float smoothSum = integrateWeb(ray, optics, haze, lit);
#elif defined(BACKWARDS)
    float smoothSum = integrateBackwards(ray, optics, haze, lit);
#else
    float smoothSum = integrateSoft(ray, optics, haze, lit, arc, profilePairs);
#endif
#ifdef NOISE
    float looks = float(noiseNodes);
    smoothSum *= densityOf(ray, optics, haze, arc, 0.0, 1.0, looks);
#else
    float looks = 0.0;
#endif
#ifdef SHADOW
    smoothSum = max(smoothSum - integrateDark(ray, optics, haze, arc, shadeFrom, shadeTo, intervals, shadowBisections, looks), 0.0);
#endif
    vec3 sum = vec3(smoothSum);
#endif
    return sum;
#endif
}
#endif

void main() {
    LampRay ray = pixelRay();
    BeamOptics optics = beamOptics();
    HazeMedium haze = HazeMedium(extinctionPerM, scatteringPerM, phaseLobes.x, phaseLobes.y, phaseLobes.z);
    float endM = pixelDistance();
#ifdef UNIFORM
    vec3 relative = beamInAirUniform(ray, optics, haze, min(endM, uniformRangeM), sampleCount);
#elif defined(BACKWARDS)
    vec3 sum = vec3(0.0);
    for (int part = 0; part < 2; ++part) {
        LitPart lit = litPartBackwards(ray, optics, haze, endM, part);
        if (lit.some) sum += litLight(ray, optics, haze, lit);
    }
    vec3 relative = sum * (haze.scatteringPerM / ray.h);
#else
    LitPart lit = litPart(ray, optics, haze, endM);
    vec3 relative = lit.some ? litLight(ray, optics, haze, lit) * (haze.scatteringPerM / ray.h) : vec3(0.0);
#ifdef LINE
    relative += lineLight(optics, haze, endM) * haze.scatteringPerM;
#endif
#endif
    if (relative == vec3(0.0)) discard;
#ifdef COUNT
    radiance = vec4(countedAs);
#else
    radiance = vec4(relative * light.rgb, 1.0);
#endif
}
