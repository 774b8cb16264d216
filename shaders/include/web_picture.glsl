// The webs of lamps as a texture. Needs `lens`, the beam's input, see beam_input.glsl.
uniform sampler2DArray webImages;

float webTexel(vec2 place) { return textureLod(webImages, vec3(place, lens.z), 0.0).r; }

#include "include/web.glsl"
