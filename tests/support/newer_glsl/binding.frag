#version 410 core
// Names a texture slot in the shader, which came with GLSL 4.20: for the check of the OpenGL floor to refuse.
layout(binding = 1) uniform sampler2D picture;
out vec4 color;
void main() { color = texture(picture, vec2(0.5)); }
