#version 410 core
// Halves a picture: 13 taps that do not flicker (Jimenez 2014, "Next generation post processing in Call of Duty").
uniform sampler2D source;
uniform vec2 sourceTexel;

out vec4 color;

vec3 tap(vec2 uv, float x, float y) { return texture(source, uv + sourceTexel * vec2(x, y)).rgb; }

void main() {
    vec2 uv = gl_FragCoord.xy * 2.0 * sourceTexel;
    vec3 inner = tap(uv, -1.0, -1.0) + tap(uv, 1.0, -1.0) + tap(uv, -1.0, 1.0) + tap(uv, 1.0, 1.0);
    vec3 corners = tap(uv, -2.0, -2.0) + tap(uv, 2.0, -2.0) + tap(uv, -2.0, 2.0) + tap(uv, 2.0, 2.0);
    vec3 sides = tap(uv, 0.0, -2.0) + tap(uv, -2.0, 0.0) + tap(uv, 2.0, 0.0) + tap(uv, 0.0, 2.0);
    color = vec4(inner * 0.125 + corners * 0.03125 + sides * 0.0625 + tap(uv, 0.0, 0.0) * 0.125, 1.0);
}
