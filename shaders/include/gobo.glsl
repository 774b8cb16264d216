// What a gobo lets through. Needs beam_pixel.glsl.
uniform sampler2DArray goboImages;

const int GOBO_LEVELS = 8;  // render/gobo_picture.h

// A direction on the gobo: the field of the beam is the unit disc.
vec2 goboPlace(vec3 direction) {
    vec2 tangent = direction.xy / -direction.z;
    return vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.y * tangent.y - gobo.z * tangent.x);
}

// What a length at axialM from the apex is on the gobo, in texels.
float goboTexels(float tangent) { return tangent * length(gobo.yz) * 0.5 * float(textureSize(goboImages, 0).x); }

// Blur on the gobo, as a tangent, by the diameter of a disc: the circle of confusion, which is the exit pupil times the error of vergence (thin
// lens), and what frost scatters, which have nothing to do with each other.
float goboDefocus(float axialM) {
    float confusion = gobo.w < 0.0 ? 0.0 : 2.0 * lens.x * abs(1.0 / max(axialM - light.w, 1e-3) - gobo.w);
    return length(vec2(confusion, lens.y));
}

// The level of a picture whose texels are this large blurs as defocus does, in texels, at least 1: its looks, a square and a tent, are as wide as a
// disc of that radius. footprintM: width of what is looked at, at axialM from the apex.
float goboBlurTexels(float axialM, float footprintM) {
    return max(goboTexels(max(footprintM / axialM, 0.5 * goboDefocus(axialM))), 1.0);
}

vec3 goboTexel(vec2 uv, float level) { return textureLod(goboImages, vec3(uv, gobo.x), level).rgb; }

vec3 goboInAir(vec3 direction, float axialM, float footprintM) {
    vec2 q = goboPlace(direction);
    return goboTexel(0.5 + 0.5 * vec2(q.x, -q.y), log2(goboBlurTexels(axialM, footprintM)));
}

// A small displacement on a surface (lamp frame) at a point seen in a direction, on the gobo: texture coordinates.
vec2 goboStep(vec3 direction, float axialM, vec3 stepM) {
    vec2 tangent = (stepM.xy + stepM.z * direction.xy / -direction.z) / axialM;
    return 0.5 * vec2(gobo.y * tangent.x + gobo.z * tangent.y, gobo.z * tangent.x - gobo.y * tangent.y);
}

// Mean over a pixel of a surface. longM and shortM: what the pixel covers there, along the way of the eye and across it (lamp frame).
vec3 goboOnSurface(vec3 direction, float axialM, vec3 longM, vec3 shortM) {
    vec2 q = goboPlace(direction);
    vec2 uv = 0.5 + 0.5 * vec2(q.x, -q.y);
    vec2 longUv = goboStep(direction, axialM, longM);
    vec2 shortUv = goboStep(direction, axialM, shortM);
    float size = float(textureSize(goboImages, 0).x);
    float longTexels = length(longUv) * size + 1e-6;
    float shortTexels = length(shortUv) * size + 1e-6;
    float defocus = goboTexels(goboDefocus(axialM));
    // What is out of focus is a pixel at least as large: looks at one are as wide as a disc of 1.5 times its width.
    float discPixel = 0.67 * defocus;
    bool isBlurred = discPixel > max(longTexels, shortTexels);
    longUv *= max(discPixel / longTexels, 1.0);
    shortUv *= max(discPixel / shortTexels, 1.0);
    longTexels = max(longTexels, discPixel);
    shortTexels = max(shortTexels, discPixel);
    // Four taps on a grid turned against the pixel's, each of a whole mip level, half as wide as the pixel is short. One, where the gobo's
    // own texels are larger.
    int taps = max(longTexels, shortTexels) > 1.0 ? 4 : 1;
    float level = max(floor(log2(max(0.5 * min(longTexels, shortTexels), 0.25 * max(longTexels, shortTexels))) + 0.5), 0.0);
    // Along an axis a disc's variance is its diameter squared / 16, that of a look its texel squared / 4, that of the places 5 / 64.
    float looks = exp2(min(max(floor(log2(max(0.4 * defocus, 1.0))), 0.0), float(GOBO_LEVELS - 1)));
    float apart = sqrt(max(defocus * defocus / 16.0 - looks * looks / 4.0, 0.0) * (64.0 / 5.0)) / size;
    level = isBlurred ? log2(looks) : level;
    longUv = isBlurred ? vec2(apart, 0.0) : longUv;
    shortUv = isBlurred ? vec2(0.0, apart) : shortUv;
    vec2 place = taps > 1 ? vec2(0.375, 0.125) : vec2(0.0);
    vec3 sum = vec3(0.0);
    for (int tap = 0; tap < taps; ++tap) {
        sum += goboTexel(uv + place.x * longUv + place.y * shortUv, level);
        place = vec2(-place.y, place.x);
    }
    return sum / float(taps);
}
