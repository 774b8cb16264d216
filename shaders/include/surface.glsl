// What the surface pass stores for a pixel, and how it is packed.
//     geometry: octahedral normal (view space) xy, distance from the camera [m], shininess
//     material: diffuse albedo rgb, specular reflectance

// Where nothing was drawn the distance is this [m].
const float SKY_DISTANCE_M = 1.0e5;

// Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors" (octahedral mapping).
vec2 packNormal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return n.z >= 0.0 ? p : folded;
}

vec3 unpackNormal(vec2 p) {
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}
