#version 410 core
// Bodies into the surface buffers.
layout(location = 0) in vec3 positionM;
layout(location = 1) in vec3 normal;

uniform mat4 viewFromMesh;
uniform mat3 viewFromMeshNormal;
uniform mat4 clipFromView;

out vec3 viewPositionM;
out vec3 viewNormal;

void main() {
    vec4 view = viewFromMesh * vec4(positionM, 1.0);
    viewPositionM = view.xyz;
    viewNormal = viewFromMeshNormal * normal;
    gl_Position = clipFromView * view;
}
