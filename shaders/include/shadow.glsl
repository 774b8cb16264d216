// What stands in the beam's way, from the shadow maps (render/shadow_projection.h). Needs beam_pixel.glsl and beam_ray.glsl.
#include "include/shadow_frustum.glsl"

uniform sampler2D shadowAtlas;       // near / axial distance, 0 where nothing casts
uniform samplerBuffer shadowFaces;   // three texels a face

struct ShadowFace {
    vec4 map;    // tangent to texel: scale x, y, offset x, y
    vec4 tile;   // lowest texel x, y, edge - 1, near [m]
    float texel; // tangent of the larger edge of a texel
};

ShadowFace shadowFaceAt(int index) {
    vec4 map = texelFetch(shadowFaces, 3 * index);
    return ShadowFace(map, texelFetch(shadowFaces, 3 * index + 1), 1.0 / min(map.x, map.y));
}

int firstShadowFace() { return int(shadow.x); }

#ifndef SHADOW_FACES
// The one map along the beam is fetched once a pixel.
ShadowFace onlyShadowFace = shadowFaceAt(firstShadowFace());
#endif

// The map that looks at a point of the lamp's frame; the point moves to the frame of that map, and with it a direction.
ShadowFace shadowFaceFor(inout vec3 pointM, inout vec3 direction) {
#ifdef SHADOW_FACES
    int face = shadowFaceOf(pointM);
    pointM = toShadowFace(pointM, face);
    direction = toShadowFace(direction, face);
    return shadowFaceAt(firstShadowFace() + face);
#else
    return onlyShadowFace;
#endif
}

// Depth of a texel of the atlas; beside the tile that of its rim, which is lit.
float shadowDepth(ShadowFace face, vec2 place) {
    return texelFetch(shadowAtlas, ivec2(clamp(place, face.tile.xy, face.tile.xy + face.tile.z)), 0).r;
}

void cutToFace(LampRay ray, int face, inout float sFrom, inout float sTo) {
    int record = 3 * (firstShadowFace() + face);
    vec4 window = texelFetch(shadowFaces, record + 2);
    float nearM = texelFetch(shadowFaces, record + 1).w;
    if (!cutToWindow(toShadowFace(ray.across * ray.h, face), toShadowFace(ray.along, face),
                     ShadowWindow(nearM, window.x, window.y, window.z, window.w), sFrom, sTo)) {
        sTo = sFrom;
    }
}

// Cuts a stretch of the ray to where something may shade it; what is cut off is lit. False if nothing is left.
bool shadowStretch(LampRay ray, inout float sFrom, inout float sTo) {
#ifdef SHADOW_FACES
    // From where the ray enters the first of the six maps to where it leaves the last.
    float firstFrom = sTo;
    float lastTo = sFrom;
    for (int face = 0; face < 6; ++face) {
        float from = sFrom;
        float to = sTo;
        cutToFace(ray, face, from, to);
        if (from < to) {
            firstFrom = min(firstFrom, from);
            lastTo = max(lastTo, to);
        }
    }
    sFrom = firstFrom;
    sTo = lastTo;
#else
    cutToFace(ray, 0, sFrom, sTo);
#endif
    return sFrom < sTo;
}

// Does the point in the air (lamp frame) see the lamp? Never wrong by more than a texel of the map: that far behind a caster the air is
// still lit, so that the air before a lit surface is never in its shadow.
bool seesLamp(vec3 pointM) {
    vec3 unused = vec3(0.0);
    ShadowFace face = shadowFaceFor(pointM, unused);
    float perM = 1.0 / max(-pointM.z, face.tile.w);
    return face.tile.w * (1.0 + face.texel) * perM >= shadowDepth(face, pointM.xy * perM * face.map.xy + face.map.zw);
}

// Steps off a surface before it is looked up, in texels [1]: what a curved body's facets and its smooth normal disagree about.
const float SURFACE_STEP = 1.0;
// A surface is not taken to be steeper than this against the light [tangent].
const float STEEPEST = 10.0;

// Share of the lamp's light, 0..1, that reaches a surface at a point (lamp frame) with a unit normal that faces the lamp. Nine texels
// weighted by a quadratic B-spline, each compared with the surface's own plane at that texel's middle.
float surfaceVisibility(vec3 pointM, vec3 normal) {
    ShadowFace face = shadowFaceFor(pointM, normal);
    float cosIn = clamp(-dot(normal, normalize(pointM)), 0.0, 1.0);
    float stepM = SURFACE_STEP * face.texel * max(-pointM.z, face.tile.w) * sqrt(1.0 - cosIn * cosIn);
    vec3 place3 = pointM + stepM * normal;
    float perM = 1.0 / max(-place3.z, face.tile.w);
    vec2 place = place3.xy * perM * face.map.xy + face.map.zw;
    vec2 fromRim = place - face.tile.xy;
    bool isCovered = -place3.z > face.tile.w && min(fromRim.x, fromRim.y) > 0.0 && max(fromRim.x, fromRim.y) < face.tile.z + 1.0;
    float nearness = face.tile.w * perM;
    // 1 / axial distance is linear over the map on a plane.
    vec2 slope = nearness * normal.xy / (min(dot(normal, place3) * perM, -1e-4) * face.map.xy);
    float steepest = STEEPEST * face.texel * nearness;
    slope = clamp(slope, -steepest, steepest);
    vec2 middle = floor(place) + 0.5;
    vec2 off = place - middle;
    vec3 weightsX = vec3(0.5 * (0.5 - off.x) * (0.5 - off.x), 0.75 - off.x * off.x, 0.5 * (0.5 + off.x) * (0.5 + off.x));
    vec3 weightsY = vec3(0.5 * (0.5 - off.y) * (0.5 - off.y), 0.75 - off.y * off.y, 0.5 * (0.5 + off.y) * (0.5 + off.y));
    nearness *= 1.0 + 0.05 * face.texel + 4e-6;
    // The loop is what skips the work where no map covers the surface.
    int rows = isCovered ? 3 : 0;
    float share = isCovered ? 0.0 : 1.0;
    for (int y = 0; y < rows; ++y) {
        float down = float(y) - 1.0;
        float rowNearness = nearness + slope.y * (down - off.y);
        vec3 depths = vec3(shadowDepth(face, middle + vec2(-1.0, down)), shadowDepth(face, middle + vec2(0.0, down)),
                           shadowDepth(face, middle + vec2(1.0, down)));
        vec3 planes = rowNearness + slope.x * (vec3(-1.0, 0.0, 1.0) - off.x);
        share += weightsY[y] * dot(weightsX, step(depths, planes));
    }
    return share;
}
