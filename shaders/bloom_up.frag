#version 410 core
// Adds a level of the bloom to the next larger one: a 3 x 3 tent filter.
uniform sampler2D source;
uniform vec2 sourceTexel;
uniform vec2 targetPx;

out vec4 color;

void main() {
    vec2 uv = gl_FragCoord.xy / targetPx;
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            float tent = float((2 - abs(x)) * (2 - abs(y))) / 16.0;
            sum += tent * texture(source, uv + sourceTexel * vec2(x, y)).rgb;
        }
    }
    color = vec4(sum, 1.0);
}
