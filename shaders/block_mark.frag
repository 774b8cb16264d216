#version 410 core
// Decides whether a block is brought to the display by interpolation:
//     rgb    as in block_shown.frag
//     alpha  0 if it is, 1 where the pixels around need to be tone mapped each, EDGE_MARK where they need to be antialiased too
#include "include/block_marks.glsl"

uniform sampler2D shownBlocks;  // see block_shown.frag

out vec4 marked;

// A block may be interpolated if its neighbours lie this close to a line with it, and its quarters differ by no more than that than they do
// along the line. In steps of 8 bits; measured: 99.9 % of pixels are then within 2 steps.
const float STEP = 1.0 / 255.0;
const float MOST_BEND = 2.0 * STEP;
const float MOST_EXCESS = 1.0 * STEP;

vec3 at(int x, int y) { return texelFetch(shownBlocks, clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), textureSize(shownBlocks, 0) - 1), 0).rgb; }

float largest(vec3 c) { return max(c.r, max(c.g, c.b)); }

void main() {
    vec4 here = texelFetch(shownBlocks, ivec2(gl_FragCoord.xy), 0);
    vec3 w = at(-1, 0);
    vec3 e = at(1, 0);
    vec3 s = at(0, -1);
    vec3 n = at(0, 1);
    float bend = largest(max(abs(w + e - 2.0 * here.rgb), abs(s + n - 2.0 * here.rgb)));
    float slope = largest(0.25 * (abs(e - w) + abs(n - s)));
    float excess = here.a - 1.25 * slope;
    bool smoothly = bend < MOST_BEND && excess < MOST_EXCESS;
    // The antialias pass acts on steps of 3 % or 12 %. One between blocks bends the line by its height; one within a block shows at least a
    // quarter in means of 2 x 2 pixels that it cuts, less a slope that it feigns.
    float step = max(0.03, 0.12 * largest(here.rgb));
    bool edge = max(0.25 * bend, excess) > 0.22 * step;
    marked = vec4(here.rgb, edge ? EDGE_MARK : smoothly ? 0.0 : 1.0);
}
