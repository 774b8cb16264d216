#version 410 core
// A hull around the part of each beam where surfaces stand: a prism frustum around the cone, from the nearest surface to the farthest.
#include "include/beam_input.glsl"
layout(location = 0) in vec3 corner;  // cos and sin around the axis, 0 at the near and 1 at the far end
layout(location = 1) in vec4 beamRow0;
layout(location = 2) in vec4 beamRow1;
layout(location = 3) in vec4 beamRow2;
layout(location = 4) in vec4 beamLight;
layout(location = 5) in vec4 beamCone;
layout(location = 6) in vec4 beamGobo;
layout(location = 7) in vec4 beamShadow;
layout(location = 8) in vec4 beamLens;

uniform mat4 clipFromView;
uniform vec3 upInView;       // world Z
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

// A wide lamp's hull (kWideHalfAngleRad, 70 degrees) is a prism around everything within its reach.
const float WIDE_COS = 0.34202014;
// The surfaces at both ends are inside the hull, not on its lids: the hull is a little longer, and a few steps of the depth buffer deeper.
const float SLACK = 1.0e-3;
const float DEPTH_SLACK = 1.0e-6;
const float MUCH_LONGER = 2.0;

// Where the far end of the prism is along an edge, for 1 m along the axis: at right angles to the axis, or flat on the deepest surface, which
// a floor is; there only if all edges reach it before they are much longer.
float farEnd(vec3 edge, float edgeTangent, float farM) {
    vec3 up = vec3(dot(beamRow0.xyz, upInView), dot(beamRow1.xyz, upInView), dot(beamRow2.xyz, upInView));
    float deepM = beamShadow.w + SLACK * abs(beamShadow.w);
    float flattest = up.z - length(up.xy) * edgeTangent;
    bool endsOnFloor = flattest > 0.0 && deepM > 0.0 && deepM < MUCH_LONGER * farM * flattest;
    return endsOnFloor ? deepM / -dot(up, edge) : farM;
}

vec3 hullCorner() {
    float farM = beamShadow.z * (1.0 + SLACK);
    if (beamCone.x < WIDE_COS) return vec3(corner.xy * (farM * circumscribe), farM * (1.0 - 2.0 * corner.z));
    float edgeTangent = circumscribe * beamCone.y / beamCone.x;
    vec3 edge = vec3(corner.xy * edgeTangent, -1.0);
    return edge * (corner.z > 0.0 ? farEnd(edge, edgeTangent, farM) : beamShadow.y * (1.0 - SLACK));
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
    gl_Position.z += DEPTH_SLACK * gl_Position.w;
}
