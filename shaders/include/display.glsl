// From light to a display's numbers. The curves are fits that need no power and no logarithm; tests hold them against the exact ones.

// AgX's range of light: 2^-12.47393 and 2^4.026069 of the sensor's full scale.
const float AGX_DARKEST = 1.7578e-4;
const float AGX_BRIGHTEST = 16.2917;

// log2 over AgX's range, 0 at its dark end and 1 at its bright end: exponent bits, and a cubic over the mantissa (within 6e-5).
vec3 agxLogarithm(vec3 light) {
    ivec3 bits = floatBitsToInt(clamp(light, AGX_DARKEST, AGX_BRIGHTEST));
    vec3 m = intBitsToFloat((bits & 0x007fffff) | 0x3f800000);
    return vec3(bits >> 23) * 0.06060606 + (-7.0721361 + m * (0.18573914 + m * (-0.06422699 + m * 0.0096496969)));
}

// AgX's curve, in the display's own scale of brightness: about 0..1.
vec3 agxCurve(vec3 light) {
    vec3 x = agxLogarithm(light);
    return max(-0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5))))), 0.0);
}

// AgX (Sobotka; constants as in Filament), linear Rec. 2020 in and out. The display's power of 2.2 is a quintic.
vec3 agx(vec3 rec2020) {
    mat3 inset = transpose(mat3(0.856627, 0.0951212, 0.0482516, 0.137319, 0.761242, 0.101439, 0.111898, 0.0767994, 0.811302));
    mat3 outset = transpose(mat3(1.1271, -0.110607, -0.0164939, -0.14133, 1.157824, -0.0164939, -0.14133, -0.110607, 1.251936));
    vec3 v = max(outset * agxCurve(inset * rec2020), 0.0);
    return v * (-0.00588293 + v * (0.63093967 + v * (0.69796663 + v * (-0.45854163 + v * 0.1350329))));
}

vec3 rec709FromRec2020(vec3 c) {
    return vec3(dot(vec3(1.660491, -0.587641, -0.072850), c), dot(vec3(-0.124550, 1.132900, -0.008349), c),
                dot(vec3(-0.018151, -0.100579, 1.118730), c));
}

// The sRGB curve; its power of 1 / 2.4 is a quartic in the square root.
vec3 encodeSrgb(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    vec3 s = sqrt(c);
    vec3 bright = -0.03700215 + s * (1.44786665 + s * (-0.94473628 + s * (0.84261168 - s * 0.30948544)));
    return mix(12.92 * c, bright, greaterThan(c, vec3(0.0031308)));
}

// What a display shows, 0..1 sRGB, for light relative to the sensor's full scale, linear Rec. 2020.
vec3 displayed(vec3 light) { return encodeSrgb(rec709FromRec2020(agx(light))); }

// How bright a display's colour looks, roughly: Rec. 601 luma.
float brightness(vec3 color) { return dot(color, vec3(0.299, 0.587, 0.114)); }

// Triangular noise of +-1 step of 8 bits, fixed in the picture: it hides the bands of dark haze. What is darker than a step has less, so that
// black stays black. Hash: Jimenez 2014, interleaved gradient noise.
vec3 dithered(vec3 color, vec2 pixel) {
    float even = 2.0 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 1.0;
    float triangular = sign(even) * (1.0 - sqrt(1.0 - abs(even)));
    return color + min(color, 1.0 / 255.0) * triangular;
}
