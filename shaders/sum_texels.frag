#version 410 core
// Adds up texels: each pixel those of its own square of the source.
uniform sampler2D source;

out vec4 sum;

const int EDGE = 32;  // kSumEdge of render/passes/texel_sum.cpp

void main() {
    ivec2 from = ivec2(gl_FragCoord.xy) * EDGE;
    ivec2 to = min(from + EDGE, textureSize(source, 0));
    sum = vec4(0.0);
    for (int y = from.y; y < to.y; ++y) {
        for (int x = from.x; x < to.x; ++x) sum += texelFetch(source, ivec2(x, y), 0);
    }
}
