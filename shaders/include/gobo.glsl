// What a gobo lets through. Needs beam_pixel.glsl.
uniform sampler2DArray goboImages;

// A direction on the gobo: the field of the beam is the unit disc.
vec2 goboPlace(vec3 direction) {
    vec2 tangent = direction.xy / -direction.z;
    return vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.y * tangent.y - gobo.z * tangent.x);
}

// Width of the blur on the gobo in texels, at least 1. footprintM: width of what is looked at, at axialM from the apex.
float goboBlurTexels(float axialM, float footprintM) {
    float blurM = footprintM / axialM;
    if (gobo.w >= 0.0) {
        // Circle of confusion on the gobo, as a tangent: exit pupil times the error of vergence (thin lens).
        blurM = max(blurM, 2.0 * lens.x * abs(1.0 / max(axialM - light.w, 1e-3) - gobo.w));
    }
    return max(blurM * length(gobo.yz) * 0.5 * float(textureSize(goboImages, 0).x), 1.0);
}

vec3 goboTexel(vec2 uv, float level) { return textureLod(goboImages, vec3(uv, gobo.x), level).rgb; }

vec3 goboInAir(vec3 direction, float axialM, float footprintM) {
    vec2 q = goboPlace(direction);
    return goboTexel(0.5 + 0.5 * vec2(q.x, -q.y), log2(goboBlurTexels(axialM, footprintM)));
}

vec3 goboOnSurface(vec3 direction, float axialM, float footprintM) {
    vec2 q = goboPlace(direction);
    vec2 uv = 0.5 + 0.5 * vec2(q.x, -q.y);
    // A blurred edge drawn large shows the steps of a single coarse texel; four taps one level finer round them off.
    float texels = goboBlurTexels(axialM, footprintM);
    float level = max(log2(texels) - 1.0, 0.0);
    float apart = 0.5 * (texels - 1.0) / float(textureSize(goboImages, 0).x);
    return 0.25 * (goboTexel(uv + apart, level) + goboTexel(uv - apart, level) + goboTexel(uv + vec2(apart, -apart), level) +
                   goboTexel(uv - vec2(apart, -apart), level));
}
