#version 410 core
// Smooths the steps of edges in the finished picture: blends along the edge where neighbours differ in brightness. Follows the idea of
// Lottes 2009, "FXAA", in its short form: direction from four diagonal neighbours, a narrow and a wide blend.
#include "include/display.glsl"

uniform sampler2D source;  // alpha is the brightness

out vec4 color;

float neighbour(ivec2 offset) { return texelFetch(source, clamp(ivec2(gl_FragCoord.xy) + offset, ivec2(0), textureSize(source, 0) - 1), 0).a; }

vec3 at(vec2 offset) { return texture(source, (gl_FragCoord.xy + offset) / vec2(textureSize(source, 0))).rgb; }

void main() {
    vec4 here = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
    float nw = neighbour(ivec2(-1, 1));
    float ne = neighbour(ivec2(1, 1));
    float sw = neighbour(ivec2(-1, -1));
    float se = neighbour(ivec2(1, -1));
    float darkest = min(here.a, min(min(nw, ne), min(sw, se)));
    float brightest = max(here.a, max(max(nw, ne), max(sw, se)));
    color = vec4(here.rgb, 1.0);
    // Below this contrast no step is seen.
    if (brightest - darkest < max(0.03, 0.12 * brightest)) return;
    vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
    along = clamp(along / (min(abs(along.x), abs(along.y)) + 0.03 * (nw + ne + sw + se) + 1.0 / 128.0), -3.0, 3.0);
    vec3 narrow = 0.5 * (at(along * (-1.0 / 6.0)) + at(along * (1.0 / 6.0)));
    vec3 wide = 0.5 * narrow + 0.25 * (at(along * -0.5) + at(along * 0.5));
    float wideBrightness = brightness(wide);
    color.rgb = wideBrightness < darkest || wideBrightness > brightest ? narrow : wide;
}
