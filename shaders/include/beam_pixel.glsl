// A beam and the view ray of this pixel, for the shaders that draw hulls of beams (beam.vert).
#include "include/beam_input.glsl"

flat in vec4 row0;
flat in vec4 row1;
flat in vec4 row2;
flat in vec4 light;
flat in vec4 cone;
flat in vec4 gobo;
flat in vec4 shadow;
flat in vec4 lens;

uniform sampler2D distanceBuffer;
uniform vec2 viewportPx;
uniform vec2 viewTangent;  // tangents of half the field of view
uniform float pixelStep;   // only every so many pixels are drawn

const vec3 AXIS = vec3(0.0, 0.0, -1.0);

vec3 toLamp(vec3 v) { return vec3(dot(row0.xyz, v), dot(row1.xyz, v), dot(row2.xyz, v)); }

float pixelAngle() { return 2.0 * viewTangent.y / viewportPx.y; }

// The centre of the pixel of the whole picture that is drawn here [px].
vec2 pixelCenter() { return (gl_FragCoord.xy - 0.5) * pixelStep + 0.5; }

// Where the ray of this pixel ends [m].
float pixelDistance() { return texelFetch(distanceBuffer, min(ivec2(pixelCenter()), textureSize(distanceBuffer, 0) - 1), 0).r; }

// Of any length.
vec3 viewRay() { return vec3((2.0 * pixelCenter() / viewportPx - 1.0) * viewTangent, -1.0); }

vec3 viewDirection() { return normalize(viewRay()); }

LampRay pixelRay() { return lampRay(vec3(row0.w, row1.w, row2.w), toLamp(viewRay()), AXIS); }

BeamOptics beamOptics() { return BeamOptics(cone.x, cone.y, light.w, cone.z, cone.w); }
