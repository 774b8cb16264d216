#version 410 core
// All that stands in a beam's way, as one picture: gobos over each other, an iris, blades, a mask, two colours (render/aperture.h). IMAGE_0..4:
// there is that picture; a loop over them takes twice as long on a processor.
#include "include/real.glsl"
#include "include/aperture.glsl"

const int IMAGES = 5;
const int BLADES = 4;
const int RECTANGLE = 1;
const int OVAL = 2;

uniform sampler2DArray goboImages;
uniform float size;              // texels along an edge
uniform vec4 imageDisc[IMAGES];  // middle, radius, layer
uniform vec2 imageTurn[IMAGES];  // cos and sin of the rotation
uniform float irisRadius;
uniform int bladeCount;
uniform vec3 blades[BLADES];     // normal, distance
uniform int shape;
uniform vec2 halfSize;
uniform vec2 shapeTurn;           // cos and sin
uniform vec4 unstretched;         // columns of a matrix: places on the beam to places in the aperture
uniform float widening;           // that this matrix does at most
uniform float softness;
uniform vec3 split;              // normal, distance
uniform vec3 nearColor;
uniform vec3 farColor;

out vec4 through;

vec3 throughImage(int i, vec2 place) {
    vec2 q = onApertureImage(place, imageTurn[i], imageDisc[i].xyz);
    // A picture's edge texels are dark, and what is beyond is as its edge.
    return textureLod(goboImages, vec3(0.5 + 0.5 * vec2(q.x, -q.y), imageDisc[i].w), max(log2(widening / imageDisc[i].z), 0.0)).rgb;
}

void main() {
    // Row 0 is the top of the picture.
    vec2 place = mat2(unstretched.xy, unstretched.zw) * (vec2(2.0, -2.0) * gl_FragCoord.xy / size + vec2(-1.0, 1.0));
    float texel = widening * 2.0 / size;
    float width = max(softness, texel);
    // The holder is as sharp as that of a gobo.
    float share = throughIris(place, 1.0 - texel, texel) * throughIris(place, irisRadius, width);
    for (int i = 0; i < bladeCount; ++i) share *= throughBlade(place, blades[i], width);
    vec2 onShape = onApertureImage(place, shapeTurn, vec3(0.0, 0.0, 1.0));
    if (shape == RECTANGLE) share *= throughRectangle(onShape, halfSize, width);
    if (shape == OVAL) share *= throughOval(onShape, halfSize, width);
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
