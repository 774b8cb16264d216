#version 410 core
// All that stands in a beam's way, as one picture: gobos over each other, an iris, blades, a mask, two colours (render/aperture.h).
#include "include/real.glsl"
#include "include/aperture.glsl"

const int IMAGES = 5;
const int BLADES = 4;
const int RECTANGLE = 1;
const int OVAL = 2;

uniform sampler2DArray goboImages;
uniform float size;              // texels along an edge
uniform int imageCount;
uniform vec4 imageDisc[IMAGES];  // middle, radius, layer
uniform vec2 imageTurn[IMAGES];  // cos and sin of the rotation
uniform float irisRadius;
uniform int bladeCount;
uniform vec3 blades[BLADES];     // normal, distance
uniform int shape;
uniform vec2 halfSize;
uniform vec2 shapeTurn;           // cos and sin
uniform float softness;
uniform vec3 split;              // normal, distance
uniform vec3 nearColor;
uniform vec3 farColor;

out vec4 through;

vec3 throughImage(int i, vec2 place) {
    vec2 q = onApertureImage(place, imageTurn[i], imageDisc[i].xyz);
    // A picture's edge texels are dark, and what is beyond is as its edge.
    return textureLod(goboImages, vec3(0.5 + 0.5 * vec2(q.x, -q.y), imageDisc[i].w), max(-log2(imageDisc[i].z), 0.0)).rgb;
}

void main() {
    // Row 0 is the top of the picture.
    vec2 place = vec2(2.0, -2.0) * gl_FragCoord.xy / size + vec2(-1.0, 1.0);
    float texel = 2.0 / size;
    float width = max(softness, texel);
    // The holder is as sharp as that of a gobo.
    float share = throughIris(place, 1.0 - texel, texel) * throughIris(place, irisRadius, width);
    for (int i = 0; i < bladeCount; ++i) share *= throughBlade(place, blades[i], width);
    vec2 onShape = onApertureImage(place, shapeTurn, vec3(0.0, 0.0, 1.0));
    if (shape == RECTANGLE) share *= throughRectangle(onShape, halfSize, width);
    if (shape == OVAL) share *= throughOval(onShape, halfSize, width);
    vec3 light = mix(farColor, nearColor, throughBlade(place, split, width)) * share;
    for (int i = 0; i < imageCount; ++i) light *= throughImage(i, place);
    through = vec4(light, 1.0);
}
