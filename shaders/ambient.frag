#version 410 core
// What is there before any lamp is lit: surfaces in the ambient light, else the background, behind haze.
#include "include/surface.glsl"

uniform sampler2D geometryBuffer;
uniform sampler2D materialBuffer;
uniform vec3 ambientIlluminanceLx;
uniform vec3 backgroundCdPerM2;
uniform float extinctionPerM;

out vec4 radiance;

const float INVERSE_PI = 0.318309886;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float distanceM = texelFetch(geometryBuffer, pixel, 0).z;
    vec3 light = backgroundCdPerM2;
    if (distanceM < SKY_DISTANCE_M) {
        // The background is what one sees through haze already; only surfaces stand in it at a known distance.
        light = texelFetch(materialBuffer, pixel, 0).rgb * ambientIlluminanceLx * (INVERSE_PI * exp(-extinctionPerM * distanceM));
    }
    radiance = vec4(light, 1.0);
}
