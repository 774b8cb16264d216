#version 410 core
// Judges the coarse grid of light in the air: may a pixel between its nodes be interpolated?
//     rgb    the node's light
//     alpha  estimated error of interpolating next to this node over what is allowed; negative where a surface's edge runs through the
//            cell whose first corner this node is
uniform sampler2D nodes;
uniform sampler2D distanceBuffer;
uniform int nodeStep;
uniform float tolerance;  // allowed error relative to the light around, or to the picture's mean if that is more

out vec4 judged;

vec3 nodeAt(ivec2 node) { return texelFetch(nodes, clamp(node, ivec2(0), textureSize(nodes, 0) - 1), 0).rgb; }

float brightest(vec3 c) { return max(c.r, max(c.g, c.b)); }

float inverseDistance(ivec2 pixel) {
    return 1.0 / texelFetch(distanceBuffer, min(pixel, textureSize(distanceBuffer, 0) - 1), 0).r;
}

// Inverse distance is linear over a plane: what is not linear in the cell is an edge.
bool edgeInCell(ivec2 pixel) {
    float near = inverseDistance(pixel);
    float nearX = inverseDistance(pixel + ivec2(nodeStep, 0));
    float nearY = inverseDistance(pixel + ivec2(0, nodeStep));
    float across = inverseDistance(pixel + nodeStep);
    float largest = max(max(near, nearX), max(nearY, across));
    float worst = abs(near + across - nearX - nearY);
    for (int y = 0; y < nodeStep; ++y) {
        for (int x = y == 0 ? 1 : 0; x < nodeStep; ++x) {
            vec2 share = vec2(x, y) / float(nodeStep);
            float here = inverseDistance(pixel + ivec2(x, y));
            float plane = mix(mix(near, nearX, share.x), mix(nearY, across, share.x), share.y);
            worst = max(worst, abs(here - plane));
            largest = max(largest, here);
        }
    }
    return worst > 0.02 * largest;
}

void main() {
    ivec2 node = ivec2(gl_FragCoord.xy);
    vec3 here = nodeAt(node);
    vec3 left = nodeAt(node - ivec2(1, 0));
    vec3 right = nodeAt(node + ivec2(1, 0));
    vec3 below = nodeAt(node - ivec2(0, 1));
    vec3 above = nodeAt(node + ivec2(0, 1));
    float around = brightest(max(here, max(max(left, right), max(below, above))));
    // Bilinear interpolation errs by an eighth of the second difference where light is smooth, by up to a half at a kink.
    float error = 0.25 * max(brightest(abs(left + right - 2.0 * here)), brightest(abs(below + above - 2.0 * here)));
    float mean = brightest(textureLod(nodes, vec2(0.5), 100.0).rgb);
    float relative = around > 0.0 ? error / (tolerance * max(around, mean)) : 0.0;
    judged = vec4(here, edgeInCell(node * nodeStep) ? -1.0 - relative : relative);
}
