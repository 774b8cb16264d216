// What the surface pass stores for a pixel, and how it is packed.
//     distance   distance from the camera [m]; all that light in the air needs to know
//     shape      octahedral normal (view space) xy in 0..1, shininess over MAX_SHININESS, number of the material over MAX_MATERIAL; means
//                nothing where the distance is SKY_DISTANCE_M
// Materials stand in a table of their own: diffuse albedo rgb, specular reflectance.

// Where nothing was drawn the distance is this [m].
const float SKY_DISTANCE_M = 1.0e5;
const float MAX_SHININESS = 1024.0;
const float MAX_MATERIAL = 65535.0;

// Materials of the table in a row.
const int MATERIAL_ROW = 1024;

// Where in the table the material of a shape stands.
ivec2 materialTexel(float stored) {
    int number = int(stored * MAX_MATERIAL + 0.5);
    return ivec2(number % MATERIAL_ROW, number / MATERIAL_ROW);
}

// The normal may have any length. Cigolle et al. 2014, "A survey of efficient representations for independent unit vectors" (octahedral mapping).
vec2 packNormal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return 0.5 + 0.5 * (n.z >= 0.0 ? p : folded);
}

vec3 unpackNormal(vec2 stored) {
    vec2 p = 2.0 * stored - 1.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return normalize(n);
}
