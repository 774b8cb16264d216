#version 410 core
// Radiance to what a display shows: bloom, exposure, AgX, sRGB, dither.
#include "include/display.glsl"

uniform sampler2D radianceBuffer;
uniform sampler2D bloomBuffer;
uniform vec2 blocksPerPx;  // pixels to texture coordinates of the bloom
uniform float exposure;    // 1 / (1.2 * 2^EV100): maps radiance to sensor full scale (ISO 12232, q = 0.65)
uniform float bloomShare;

layout(location = 0) out vec4 color;    // for the antialias pass; alpha is the brightness
layout(location = 1) out vec4 display;  // the picture, where the antialias pass finds nothing to do

void main() {
    vec3 light = texture(radianceBuffer, gl_FragCoord.xy / vec2(textureSize(radianceBuffer, 0))).rgb;
#ifdef BLOOM
    light = mix(light, texture(bloomBuffer, gl_FragCoord.xy * blocksPerPx).rgb, bloomShare);
#endif
    vec3 shown = dithered(displayed(light * exposure), gl_FragCoord.xy);
    color = vec4(shown, brightness(shown));
    display = vec4(shown, 1.0);
}
