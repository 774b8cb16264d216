#version 410 core
// Smooths the steps of edges in the finished picture: blends along the edge where neighbours differ in brightness. Follows the idea of
// Lottes 2009, "FXAA", in its short form: direction from four diagonal neighbours, a narrow and a wide blend.
uniform sampler2D source;
uniform vec2 texel;

out vec4 color;

float brightness(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

vec3 at(vec2 offset) { return texture(source, gl_FragCoord.xy * texel + offset * texel).rgb; }

void main() {
    vec3 here = at(vec2(0.0));
    float center = brightness(here);
    float nw = brightness(at(vec2(-1.0, 1.0)));
    float ne = brightness(at(vec2(1.0, 1.0)));
    float sw = brightness(at(vec2(-1.0, -1.0)));
    float se = brightness(at(vec2(1.0, -1.0)));
    float darkest = min(center, min(min(nw, ne), min(sw, se)));
    float brightest = max(center, max(max(nw, ne), max(sw, se)));
    color = vec4(here, 1.0);
    // Below this contrast no step is seen; most pixels leave here.
    if (brightest - darkest < max(0.03, 0.12 * brightest)) return;
    vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
    along = clamp(along / (min(abs(along.x), abs(along.y)) + 0.03 * (nw + ne + sw + se) + 1.0 / 128.0), -3.0, 3.0);
    vec3 narrow = 0.5 * (at(along * (-1.0 / 6.0)) + at(along * (1.0 / 6.0)));
    vec3 wide = 0.5 * narrow + 0.25 * (at(along * -0.5) + at(along * 0.5));
    float wideBrightness = brightness(wide);
    color.rgb = wideBrightness < darkest || wideBrightness > brightest ? narrow : wide;
}
