#version 410 core
// Radiance to what a display shows: bloom, exposure, AgX (Sobotka; constants as in Filament), sRGB, dither.
uniform sampler2D radianceBuffer;
uniform sampler2D bloomBuffer;
uniform vec2 viewportPx;
uniform float exposure;    // 1 / (1.2 * 2^EV100): maps radiance to sensor full scale (ISO 12232, q = 0.65)
uniform float bloomShare;

out vec4 color;

vec3 agx(vec3 rec2020) {
    mat3 inset = transpose(mat3(0.856627, 0.0951212, 0.0482516, 0.137319, 0.761242, 0.101439, 0.111898, 0.0767994, 0.811302));
    mat3 outset = transpose(mat3(1.1271, -0.110607, -0.0164939, -0.14133, 1.157824, -0.0164939, -0.14133, -0.110607, 1.251936));
    const float lowest = -12.47393;
    const float highest = 4.026069;
    vec3 x = clamp((log2(max(inset * rec2020, 1e-10)) - lowest) / (highest - lowest), 0.0, 1.0);
    vec3 x2 = x * x;
    vec3 x4 = x2 * x2;
    vec3 curve = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
    return pow(max(outset * curve, 0.0), vec3(2.2));
}

vec3 rec709FromRec2020(vec3 c) {
    return vec3(dot(vec3(1.660491, -0.587641, -0.072850), c), dot(vec3(-0.124550, 1.132900, -0.008349), c),
                dot(vec3(-0.018151, -0.100579, 1.118730), c));
}

vec3 encodeSrgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c));
}

// Triangular noise of +-1 step of 8 bits, fixed in the picture: it hides the bands of dark haze. Hash: Jimenez 2014, interleaved gradient noise.
float ditherAt(vec2 pixel) {
    float a = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    float b = fract(52.9829189 * fract(dot(pixel + 37.0, vec2(0.06711056, 0.00583715))));
    return (a - b) / 255.0;
}

void main() {
    vec3 light = texelFetch(radianceBuffer, ivec2(gl_FragCoord.xy), 0).rgb;
#ifdef BLOOM
    light = mix(light, texture(bloomBuffer, gl_FragCoord.xy / viewportPx).rgb, bloomShare);
#endif
    color = vec4(encodeSrgb(rec709FromRec2020(agx(light * exposure))) + ditherAt(gl_FragCoord.xy), 1.0);
}
