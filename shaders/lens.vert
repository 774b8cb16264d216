#version 410 core
// The lenses of lit fixtures, as discs.
#include "include/beam_input.glsl"
layout(location = 0) in vec3 corner;  // cos and sin around the axis; z is not used
layout(location = 1) in vec4 beamRow0;
layout(location = 2) in vec4 beamRow1;
layout(location = 3) in vec4 beamRow2;
layout(location = 4) in vec4 beamLight;
layout(location = 5) in vec4 beamCone;
layout(location = 8) in vec4 beamLens;

uniform mat4 clipFromView;

out vec3 toEyeM;  // lamp space
flat out vec4 light;
flat out vec4 cone;
flat out vec4 lens;

void main() {
    light = beamLight;
    cone = beamCone;
    lens = beamLens;
    // A hair in front of the body's own front, so that the two do not fight over depth.
    vec3 pointM = vec3(corner.xy * beamLens.x, -(beamLight.w + 0.004));
    toEyeM = vec3(beamRow0.w, beamRow1.w, beamRow2.w) - pointM;
    vec3 view = -(beamRow0.xyz * toEyeM.x + beamRow1.xyz * toEyeM.y + beamRow2.xyz * toEyeM.z);
    gl_Position = clipFromView * vec4(view, 1.0);
}
