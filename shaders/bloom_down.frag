#version 410 core
// Halves a level of the bloom: weights 1 3 3 1 in each direction, as four taps between texels. Does not flicker where something small and
// bright moves.
uniform sampler2D source;
uniform vec2 sourceTexel;

out vec4 color;

vec3 tap(float x, float y) { return texture(source, (2.0 * gl_FragCoord.xy + vec2(x, y)) * sourceTexel).rgb; }

void main() { color = vec4(0.25 * (tap(-0.75, -0.75) + tap(0.75, -0.75) + tap(-0.75, 0.75) + tap(0.75, 0.75)), 1.0); }
