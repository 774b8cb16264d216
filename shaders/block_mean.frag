#version 410 core
// A block of 4 x 4 pixels:
//     rgb    mean radiance
//     alpha  how much its quarters differ, in the display's scale of brightness
#include "include/display.glsl"

uniform sampler2D radianceBuffer;  // linearly filtered: a tap between four pixels is their mean
uniform float exposure;

out vec4 block;

vec3 quarter(float x, float y) {
    return texture(radianceBuffer, (4.0 * gl_FragCoord.xy + vec2(x, y)) / vec2(textureSize(radianceBuffer, 0))).rgb;
}

void main() {
    vec3 a = quarter(-1.0, -1.0);
    vec3 b = quarter(1.0, -1.0);
    vec3 c = quarter(-1.0, 1.0);
    vec3 d = quarter(1.0, 1.0);
    vec3 range = agxCurve(exposure * max(max(a, b), max(c, d))) - agxCurve(exposure * min(min(a, b), min(c, d)));
    block = vec4(0.25 * (a + b + c + d), max(range.r, max(range.g, range.b)));
}
