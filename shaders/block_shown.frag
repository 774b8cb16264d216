#version 410 core
// What the middle of a block shows on the display, and the bloom there.
#include "include/display.glsl"

uniform sampler2D blocks;  // see block_mean.frag
uniform sampler2D coarserBloom;
uniform vec2 coarserTexel;
uniform float exposure;
uniform float bloomShare;

layout(location = 0) out vec4 shown;  // display colour; alpha as in block_mean.frag
layout(location = 1) out vec4 bloom;  // radiance

#ifdef BLOOM
vec3 coarser(float x, float y) { return texture(coarserBloom, (0.5 * gl_FragCoord.xy + vec2(x, y)) * coarserTexel).rgb; }
#endif

void main() {
    vec4 block = texelFetch(blocks, ivec2(gl_FragCoord.xy), 0);
    vec3 light = block.rgb;
#ifdef BLOOM
    // As bloom_up.frag: an even mix of this level and everything coarser.
    vec3 blurred = 0.25 * (coarser(-0.5, -0.5) + coarser(0.5, -0.5) + coarser(-0.5, 0.5) + coarser(0.5, 0.5));
    bloom = vec4(0.5 * (light + blurred), 1.0);
    light = mix(light, bloom.rgb, bloomShare);
#endif
    shown = vec4(displayed(light * exposure), block.a);
}
