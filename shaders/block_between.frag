#version 410 core
// The display between the middles of blocks. Where that will not do, the mask leaves it to the passes to come.
#include "include/block_marks.glsl"
#include "include/display.glsl"

uniform sampler2D markedBlocks;  // see block_mark.frag; linearly filtered
uniform vec2 blocksPerPx;        // pixels to texture coordinates of buffers with a texel a block

layout(location = 0) out vec4 color;    // as in tone_map.frag
layout(location = 1) out vec4 display;

void main() {
    vec4 block = texture(markedBlocks, gl_FragCoord.xy * blocksPerPx);
    gl_FragDepth = block.a == 0.0 ? 0.0 : block.a <= 1.0 ? 0.5 : 1.0;
    vec3 shown = dithered(block.rgb, gl_FragCoord.xy);
    color = vec4(shown, brightness(shown));
    display = vec4(shown, 1.0);
}
