#version 410 core
// Judges the coarse grid of light in the air: may a pixel in the cell between four nodes be interpolated?
//     rgb    the light of the node that is the cell's first corner
//     alpha  1 if so, 0 if not
uniform sampler2D nodes;
uniform sampler2D nodeSum;  // over all nodes
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

// How far a line of four nodes is from a straight one at the inner two.
float bend(vec3 a, vec3 b, vec3 c, vec3 d) { return brightest(max(abs(a + c - 2.0 * b), abs(b + d - 2.0 * c))); }

void main() {
    ivec2 node = ivec2(gl_FragCoord.xy);
    vec3 here = nodeAt(node);
    vec3 right = nodeAt(node + ivec2(1, 0));
    vec3 above = nodeAt(node + ivec2(0, 1));
    vec3 across = nodeAt(node + ivec2(1, 1));
    vec3 w0 = nodeAt(node + ivec2(-1, 0));
    vec3 w1 = nodeAt(node + ivec2(-1, 1));
    vec3 e0 = nodeAt(node + ivec2(2, 0));
    vec3 e1 = nodeAt(node + ivec2(2, 1));
    vec3 s0 = nodeAt(node + ivec2(0, -1));
    vec3 s1 = nodeAt(node + ivec2(1, -1));
    vec3 n0 = nodeAt(node + ivec2(0, 2));
    vec3 n1 = nodeAt(node + ivec2(1, 2));
    float inCell = brightest(max(max(here, right), max(above, across)));
    float around = max(inCell, brightest(max(max(max(w0, w1), max(e0, e1)), max(max(s0, s1), max(n0, n1)))));
    // Bilinear interpolation errs by an eighth of the second difference where light is smooth, by up to a half at a kink.
    float error = 0.25 * max(max(bend(w0, here, right, e0), bend(w1, above, across, e1)), max(bend(s0, here, above, n0), bend(s1, right, across, n1)));
    ivec2 count = textureSize(nodes, 0);
    float mean = brightest(texelFetch(nodeSum, ivec2(0), 0).rgb) / float(count.x * count.y);
    float smoothly = error > tolerance * max(around, mean) ? 0.0 : 1.0;
    // See the loop of lit_surface.frag. Where all nodes are dark there may yet be light between bodies.
    for (float once = smoothly; once > 0.0; once -= 1.0) {
        if (edgeInCell(node * nodeStep)) smoothly -= once;
    }
    judged = vec4(here, smoothly);
}
