#version 410 core
// A hull around each beam: a prism frustum around the cone. Its back faces cover every pixel whose ray meets the beam, also from inside.
#include "include/beam_input.glsl"
layout(location = 0) in vec3 corner;  // cos and sin around the axis, 0 at the lens and 1 at the far end
layout(location = 1) in vec4 beamRow0;
layout(location = 2) in vec4 beamRow1;
layout(location = 3) in vec4 beamRow2;
layout(location = 4) in vec4 beamLight;
layout(location = 5) in vec4 beamCone;
layout(location = 6) in vec4 beamGobo;
layout(location = 7) in vec4 beamShadow;
layout(location = 8) in vec4 beamLens;

uniform mat4 clipFromView;
uniform float beamRangeM;
uniform float circumscribe;  // 1 / cos(pi / corners): makes the prism contain the cone

flat out vec4 row0;
flat out vec4 row1;
flat out vec4 row2;
flat out vec4 light;
flat out vec4 cone;
flat out vec4 gobo;
flat out vec4 shadow;
flat out vec4 lens;

#ifdef SHADOW
#include "include/shadow_face_input.glsl"
#endif

#ifdef LINE
#include "include/real.glsl"
#include "include/beam_line_filter.glsl"
uniform vec2 viewportPx;
uniform vec2 viewTangent;

// The filter's reach, and a little, around the axis at an axial distance [m]. The distance to the eye is convex along the axis, so that between the
// ends the hull is wider than it must be.
float filterReachM(float axialM) {
    return 1.1 * LINE_REACH * 2.0 * viewTangent.y / viewportPx.y * length(vec3(beamRow0.w, beamRow1.w, beamRow2.w + axialM));
}
#endif

// Beams wider than this (half angle 60 degrees) get a prism around everything within range instead.
const float WIDE_COS = 0.5;

vec3 hullCorner() {
    if (beamCone.x < WIDE_COS) {
        return vec3(corner.xy * (beamRangeM * circumscribe), beamRangeM * (1.0 - 2.0 * corner.z));
    }
    float axialM = beamLight.w + corner.z * beamRangeM;
    float radiusM = axialM * beamCone.y / beamCone.x;
#ifdef LINE
    float reachM = filterReachM(axialM);
    radiusM += reachM;
    axialM -= corner.z > 0.0 ? 0.0 : reachM;
#endif
    return vec3(corner.xy * (radiusM * circumscribe), -axialM);
}

void main() {
    row0 = beamRow0;
    row1 = beamRow1;
    row2 = beamRow2;
    light = beamLight;
    cone = beamCone;
    gobo = beamGobo;
    shadow = beamShadow;
    lens = beamLens;
#ifdef SHADOW
    passShadowFace();
#endif
    vec3 fromCamera = hullCorner() - vec3(beamRow0.w, beamRow1.w, beamRow2.w);
    // The rotation's rows are lamp from view; its transpose goes back.
    vec3 view = beamRow0.xyz * fromCamera.x + beamRow1.xyz * fromCamera.y + beamRow2.xyz * fromCamera.z;
    gl_Position = clipFromView * vec4(view, 1.0);
}
