// Density of uneven haze along the ray of this pixel. Needs real.glsl and beam_pixel.glsl.
#include "include/haze_swirls.glsl"

uniform sampler3D noiseVolume;
uniform mat3 noiseFromView;
uniform vec3 noiseOrigin;  // camera in the noise's periods
uniform float noisePerM;   // periods a metre
uniform float noiseTexelsPerM;
uniform vec3 noiseWave;  // phases of the waves that stir it
uniform float noiseAmount;

// A metre further along the ray, and a pixel at a metre: once a pixel, since drivers leave in a loop what does not change in it.
vec3 noiseAlong = noiseFromView * viewDirection() * noisePerM;
float noisePixel = pixelAngle() * noiseTexelsPerM;

// Density relative to the mean around a place t [m] from the eye: its mean over what looks so far apart, or a pixel, cannot tell.
float densityAround(float t, float apartM) {
    vec3 place = stirred(noiseOrigin + noiseAlong * t, noiseWave);
    float level = swirlLevel(apartM * noiseTexelsPerM, t * noisePixel);
    return swirlDensity(textureLod(noiseVolume, place, level).r, noiseAmount);
}

// Density at a place.
float densityAt(float t) { return densityAround(t, 0.0); }
