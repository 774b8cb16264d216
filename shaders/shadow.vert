#version 410 core
// Casters into a lamp's shadow map: depth only.
layout(location = 0) in vec3 positionM;

uniform mat4 clipFromMesh;

void main() { gl_Position = clipFromMesh * vec4(positionM, 1.0); }
