#version 410 core
// Adds a level of the bloom to the next larger one: four taps half a texel off round off the facets of linear interpolation.
uniform sampler2D source;
uniform vec2 sourceTexel;

out vec4 color;

vec3 tap(float x, float y) { return texture(source, (0.5 * gl_FragCoord.xy + vec2(x, y)) * sourceTexel).rgb; }

void main() { color = vec4(0.25 * (tap(-0.5, -0.5) + tap(0.5, -0.5) + tap(-0.5, 0.5) + tap(0.5, 0.5)), 1.0); }
