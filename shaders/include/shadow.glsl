// What stands in the beam's way, from the shadow maps (render/shadow_projection.h). Needs beam_pixel.glsl and beam_ray.glsl.
#include "include/shadow_frustum.glsl"

uniform sampler2D shadowAtlas;  // near / axial distance, 0 where nothing casts

struct ShadowFace {
    vec4 map;     // tangent to texel: scale x, y, offset x, y
    vec4 tile;    // lowest texel x, y, edge - 1, near [m]
    vec4 window;  // lowest tangent x, y, highest tangent x, y
};

#ifdef SHADOW_FACES
uniform samplerBuffer shadowFaces;  // three texels a face, see render/shadow_projection.h

ShadowFace shadowFace(int face) {
    int record = 3 * (int(shadow.x) + face);
    return ShadowFace(texelFetch(shadowFaces, record), texelFetch(shadowFaces, record + 1), texelFetch(shadowFaces, record + 2));
}
#else
flat in vec4 shadowMap;
flat in vec4 shadowTile;
flat in vec4 shadowWindow;

ShadowFace shadowFace(int face) { return ShadowFace(shadowMap, shadowTile, shadowWindow); }
#endif

// The map that looks at a point of the lamp's frame; the point moves to the frame of that map, and with it a direction.
ShadowFace shadowFaceFor(inout vec3 pointM, inout vec3 direction) {
#ifdef SHADOW_FACES
    int face = shadowFaceOf(pointM);
    pointM = toShadowFace(pointM, face);
    direction = toShadowFace(direction, face);
    return shadowFace(face);
#else
    return shadowFace(0);
#endif
}

// Tangent of the larger edge of a texel.
float shadowTexel(ShadowFace face) { return 1.0 / min(face.map.x, face.map.y); }

// A place beside the tile is moved to its rim, which is lit.
vec2 withinTile(ShadowFace face, vec2 place) { return clamp(place, face.tile.xy, face.tile.xy + face.tile.z); }

// Depth of a texel of the atlas.
float shadowDepth(vec2 place) { return texelFetch(shadowAtlas, ivec2(place), 0).r; }

// Over the axial distance of a point in the air [m]: the depth of what it may lie behind and still be lit.
float shadowNearness(ShadowFace face) { return face.tile.w * (1.0 + shadowTexel(face)); }

void cutToFace(LampRay ray, int index, inout float sFrom, inout float sTo) {
    ShadowFace face = shadowFace(index);
    ShadowWindow window = ShadowWindow(face.tile.w, face.window.x, face.window.y, face.window.z, face.window.w);
    if (!cutToWindow(toShadowFace(ray.across * ray.h, index), toShadowFace(ray.along, index), window, sFrom, sTo)) sTo = sFrom;
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
    return shadowNearness(face) * perM >= shadowDepth(withinTile(face, pointM.xy * perM * face.map.xy + face.map.zw));
}

// Steps off a surface before it is looked up, in texels [1]: what a curved body's facets and its smooth normal disagree about.
const float SURFACE_STEP = 1.0;
// A surface is not taken to be steeper than this against the light [tangent].
const float STEEPEST = 10.0;

// Is a point (frame of the map) where the map has casters, and not before the first of them?
bool isInWindow(ShadowFace face, vec3 pointM) {
    return -pointM.z > face.tile.w && pointM.x > face.window.x * -pointM.z && pointM.y > face.window.y * -pointM.z &&
           pointM.x < face.window.z * -pointM.z && pointM.y < face.window.w * -pointM.z;
}

// Weights of the texels before, at and after a point, `off` [texel] from the middle one's middle: a quadratic B-spline. The middle one is
// looked up twice.
vec3 splineWeights(float off) {
    return vec3(0.5 * (0.5 - off) * (0.5 - off), 0.375 - 0.5 * off * off, 0.5 * (0.5 + off) * (0.5 + off));
}

// Share of nine texels around a surface's point whose caster the surface does not lie behind: each is compared with the plane of the surface
// at the middle of that texel, so that no offset is needed which would lift a shadow off what casts it.
float filteredVisibility(ShadowFace face, vec3 pointM, vec3 normal, int quads) {
    float texel = shadowTexel(face);
    float cosIn2 = dot(normal, pointM) * dot(normal, pointM) / dot(pointM, pointM);
    vec3 steppedM = pointM + (SURFACE_STEP * texel * -pointM.z * sqrt(max(1.0 - cosIn2, 0.0))) * normal;
    float perM = 1.0 / max(-steppedM.z, face.tile.w);
    vec2 place = steppedM.xy * perM * face.map.xy + face.map.zw;
    // Stays within the tile with all nine; beside its casters it is lit everywhere.
    place = clamp(place, face.tile.xy + 1.0, face.tile.xy + face.tile.z - 0.01);
    vec2 middle = floor(place) + 0.5;
    vec2 off = place - middle;
    float nearness = face.tile.w * perM;
    // 1 / axial distance is linear over the map on a plane.
    vec2 slope = nearness * normal.xy / (min(dot(normal, steppedM) * perM, -1e-4) * face.map.xy);
    slope = clamp(slope, -STEEPEST * texel * nearness, STEEPEST * texel * nearness);
    vec3 weightsX = splineWeights(off.x);
    vec3 weightsY = splineWeights(off.y);
    nearness *= 1.0 + 0.05 * texel + 4e-6;
    // Four squares of 2 x 2 texels, which share the middle row and column.
    vec2 perTexel = 1.0 / vec2(textureSize(shadowAtlas, 0));
    vec2 side = vec2(-0.5);
    float share = 0.0;
    for (int quad = 0; quad < quads; ++quad) {
        vec4 depths = textureGather(shadowAtlas, (middle + side) * perTexel);
        vec2 low = side - 0.5 - off;
        float corner = nearness + slope.x * low.x + slope.y * low.y;
        vec4 plane = vec4(corner + slope.y, corner + slope.x + slope.y, corner + slope.x, corner);
        vec2 x = side.x < 0.0 ? weightsX.xy : weightsX.yz;
        vec2 y = side.y < 0.0 ? weightsY.xy : weightsY.yz;
        share += dot(vec4(x.x * y.y, x.y * y.y, x.y * y.x, x.x * y.x), step(depths, plane));
        side = vec2(-side.y, side.x);
    }
    return share;
}

// Share of the lamp's light, 0..1, that reaches a surface at a point (lamp frame) with a unit normal that faces the lamp. What is not `asked`
// for costs nothing.
float surfaceVisibility(vec3 pointM, vec3 normal, bool asked) {
    ShadowFace face = shadowFaceFor(pointM, normal);
    float share = 1.0;
    // See the loop of lit_surface.frag.
    for (float once = asked && isInWindow(face, pointM) ? 1.0 : 0.0; once > 0.0; once -= 1.0) {
        share = filteredVisibility(face, pointM * once, normal * once, int(4.0 * once));
    }
    return share;
}
