#version 410 core
// Shows the table of a gobo: turns from left to right, distance from the middle upwards.
#include "include/real.glsl"
#include "include/phase.glsl"
#include "include/beam_profile.glsl"
#include "include/beam_ray.glsl"
#include "include/gauss_legendre.glsl"
#include "include/beam_medium.glsl"

vec4 goboTableTexel(vec2 place, float layer);

#include "include/gobo_table.glsl"

uniform sampler2DArray goboTables;
uniform vec2 viewportPx;
uniform float layer;
uniform int level;

out vec4 moments;

vec4 goboTableTexel(vec2 place, float at) {
    return textureLod(goboTables, vec3(place / vec2(GOBO_TABLE_WIDTH, GOBO_TABLE_HEIGHT), at), 0.0);
}

void main() {
    vec2 place = gl_FragCoord.xy / viewportPx;
    moments = goboMoments(GoboLine(place.x, place.y, vec2(1.0, 0.0), 0.0), layer, level);
}
