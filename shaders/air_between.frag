#version 410 core
// Interpolates the light in the air between the nodes of the coarse grid; pixels where that will not do are left out.
uniform sampler2D judgedNodes;  // see air_nodes.frag
uniform int nodeStep;

out vec4 radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 node = pixel / nodeStep;
    vec2 share = vec2(pixel - node * nodeStep) / float(nodeStep);
    vec4 a = texelFetch(judgedNodes, node, 0);
    vec4 b = texelFetch(judgedNodes, node + ivec2(1, 0), 0);
    vec4 c = texelFetch(judgedNodes, node + ivec2(0, 1), 0);
    vec4 d = texelFetch(judgedNodes, node + ivec2(1, 1), 0);
    float worst = max(max(abs(a.w), abs(b.w)), max(abs(c.w), abs(d.w)));
    bool isNode = share == vec2(0.0);
    if (!isNode && (a.w < 0.0 || worst > 1.0)) discard;
    radiance = vec4(mix(mix(a.rgb, b.rgb, share.x), mix(c.rgb, d.rgb, share.x), share.y), 1.0);
}
