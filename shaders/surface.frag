#version 410 core
// A body in the ambient light, behind haze, and what the lamps that light it later need to know of it.
#include "include/surface.glsl"

in vec3 viewPositionM;
in vec3 viewNormal;

uniform float shininess;
uniform float materialIndex;
uniform vec3 ambientCdPerM2;  // what it sends of the ambient light
uniform float extinctionPerM;

layout(location = 0) out vec4 radiance;
layout(location = 1) out float distanceM;
layout(location = 2) out vec4 shape;

void main() {
    distanceM = length(viewPositionM);
    vec3 normal = viewNormal;
    // A surface seen from behind is lit as if it were its own other side: stage cloth and planes have two faces.
    if (dot(normal, viewPositionM) > 0.0) normal = -normal;
    radiance = vec4(ambientCdPerM2 * exp(-extinctionPerM * distanceM), 1.0);
    shape = vec4(packNormal(normal), shininess / MAX_SHININESS, materialIndex / MAX_MATERIAL);
}
