#version 410 core
// All that stands in a beam's way, as one picture: gobos over each other, an iris, blades, a rectangle, two colours (render/aperture.h).
// IMAGE_0..4: there is that picture; a loop over them takes twice as long on a processor. PROFILE: the beam's profile is in it.
#include "include/real.glsl"
#include "include/aperture.glsl"
#include "include/beam_profile.glsl"

const int IMAGES = 5;
const int BLADES = 4;

uniform sampler2DArray goboImages;
uniform float size;               // texels along an edge
uniform vec4 onField;             // columns of a matrix: places on the picture to places of the aperture, where the field is the unit disc
uniform float widening;           // that this matrix does at most
uniform vec4 imageDisc[IMAGES];   // middle, radius, layer (< 0: open)
uniform vec2 imageTurn[IMAGES];   // cos and sin of the rotation
uniform vec3 imageNeighbor[IMAGES];  // from the middle to that of the neighbour, layer of the neighbour (< 0: open)
uniform float gateRadius;
uniform float irisRadius;
uniform int bladeCount;
uniform vec3 blades[BLADES];      // normal, distance
uniform vec3 rectangle;           // half size, softness
uniform float softness;
uniform vec3 split;               // normal, distance
uniform vec3 nearColor;
uniform vec3 farColor;
uniform vec3 profile;             // tangent of half the field angle, half angle of 50 % [rad], exponent

out vec4 through;

vec3 throughImage(int i, vec2 place) {
    // Discs do not meet: each place is on the side of one of them.
    vec2 way = imageNeighbor[i].xy;
    bool beyond = dot(place - imageDisc[i].xy, way) > 0.5 * dot(way, way);
    vec3 disc = imageDisc[i].xyz + (beyond ? vec3(way, 0.0) : vec3(0.0));
    float layer = beyond ? imageNeighbor[i].z : imageDisc[i].w;
    vec2 q = onApertureImage(place, imageTurn[i], disc);
    float texels = widening / disc.z;
    vec3 texel = textureLod(goboImages, vec3(0.5 + 0.5 * vec2(q.x, -q.y), max(layer, 0.0)), max(log2(texels), 0.0)).rgb;
    return layer < 0.0 ? vec3(throughIris(q, 1.0, texels * 2.0 / size)) : texel;
}

void main() {
    // Row 0 is the top of the picture.
    vec2 place = mat2(onField.xy, onField.zw) * (vec2(2.0, -2.0) * gl_FragCoord.xy / size + vec2(-1.0, 1.0));
    float texel = widening * 2.0 / size;
    float width = max(softness, texel);
    // The gate is as sharp as the edge of a gobo.
    float share = throughIris(place, gateRadius - texel, texel) * throughIris(place, irisRadius, width);
    for (int i = 0; i < bladeCount; ++i) share *= throughBlade(place, blades[i], width);
    share *= throughRectangle(place, rectangle.xy, max(rectangle.z, texel));
#ifdef PROFILE
    share *= softProfile(atan(length(place) * profile.x), profile.y, profile.z);
#endif
    vec3 light = mix(farColor, nearColor, throughBlade(place, split, width)) * share;
#ifdef IMAGE_0
    light *= throughImage(0, place);
#endif
#ifdef IMAGE_1
    light *= throughImage(1, place);
#endif
#ifdef IMAGE_2
    light *= throughImage(2, place);
#endif
#ifdef IMAGE_3
    light *= throughImage(3, place);
#endif
#ifdef IMAGE_4
    light *= throughImage(4, place);
#endif
    through = vec4(light, 1.0);
}
