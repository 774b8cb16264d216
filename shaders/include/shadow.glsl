// What stands in the beam's way. Needs beam_pixel.glsl.
uniform sampler2DArrayShadow shadowMaps;

// Share of the light that reaches the point (lamp space), 0..1.
float visibilityAt(vec3 pointM) {
    float axialM = max(-pointM.z, shadow.z);
    vec2 uv = 0.5 + 0.5 * shadow.y * pointM.xy / axialM;
    // Beyond the far plane there is no caster: 1 compares as lit there, and a float map does not clamp by itself.
    float depth = min(shadow.w / (shadow.w - shadow.z) * (1.0 - shadow.z / axialM), 1.0);
    return texture(shadowMaps, vec4(uv, shadow.x, depth));
}

// The part of a stretch of the ray that something may shade; false if there is none.
bool shadowStretch(LampRay ray, INOUT(float) sFrom, INOUT(float) sTo) { return true; }

// Does the point in the air (lamp space) see the lamp?
bool seesLamp(vec3 pointM) { return visibilityAt(pointM) > 0.5; }
