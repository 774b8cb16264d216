#version 410 core
// Interpolates the light in the air between the nodes of the coarse grid; pixels where that will not do are left out.
uniform sampler2D judgedNodes;  // see air_nodes.frag; linearly filtered
uniform int nodeStep;

out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 node = pixel / nodeStep;
    if (pixel != node * nodeStep && texelFetch(judgedNodes, node, 0).a < 1.0) discard;
    vec2 place = vec2(pixel) / float(nodeStep) + 0.5;
    radiance = vec4(textureLod(judgedNodes, place / vec2(textureSize(judgedNodes, 0)), 0.0).rgb, 1.0);
}
