#version 410 core
#include "include/surface.glsl"

in vec3 viewPositionM;
in vec3 viewNormal;

uniform vec3 albedo;
uniform float specular;
uniform float shininess;

layout(location = 0) out vec4 geometry;
layout(location = 1) out vec4 material;

void main() {
    float distanceM = length(viewPositionM);
    vec3 normal = normalize(viewNormal);
    // A surface seen from behind is lit as if it were its own other side: stage cloth and planes have two faces.
    if (dot(normal, viewPositionM) > 0.0) normal = -normal;
    geometry = vec4(packNormal(normal), distanceM, shininess);
    material = vec4(albedo, specular);
}
