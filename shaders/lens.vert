#version 410 core
// The lenses of lit fixtures, as discs.
#include "include/beam_input.glsl"
layout(location = 0) in vec3 corner;  // cos and sin around the axis; z is not used
layout(location = 1) in vec4 beamRow0;
layout(location = 2) in vec4 beamRow1;
layout(location = 3) in vec4 beamRow2;
layout(location = 4) in vec4 beamLight;
layout(location = 5) in vec4 beamCone;
layout(location = 6) in vec4 beamGobo;
layout(location = 7) in vec4 beamShadow;  // here: where the lens faces, lamp space
layout(location = 8) in vec4 beamLens;

uniform mat4 clipFromView;

out vec3 toEyeM;  // lamp space
flat out vec4 light;
flat out vec4 cone;
flat out vec4 gobo;
flat out vec4 lens;
flat out vec3 normal;

void main() {
    light = beamLight;
    cone = beamCone;
    gobo = beamGobo;
    lens = beamLens;
    normal = beamShadow.xyz;
    vec3 right = normalize(vec3(-normal.z, 0.0, normal.x));
    vec3 onDisc = beamLens.x * (corner.x * right + corner.y * cross(right, normal));
    // A hair in front of the body's own front, so that the two do not fight over depth.
    vec3 pointM = vec3(0.0, 0.0, -beamLight.w) + onDisc + 0.004 * normal;
    toEyeM = vec3(beamRow0.w, beamRow1.w, beamRow2.w) - pointM;
    vec3 view = -(beamRow0.xyz * toEyeM.x + beamRow1.xyz * toEyeM.y + beamRow2.xyz * toEyeM.z);
    gl_Position = clipFromView * vec4(view, 1.0);
}
