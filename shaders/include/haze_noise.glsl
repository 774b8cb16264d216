// Density of uneven haze. Needs beam_pixel.glsl.
uniform sampler3D noiseVolume;
uniform mat3 worldFromView;
uniform vec3 noiseOrigin;  // camera in the noise's periods
uniform float noisePerM;   // periods a metre
uniform vec3 noiseWave;    // phases of the waves that stir it
uniform float noiseAmount;

// Density relative to the mean, t [m] from the eye.
float densityAt(float t) {
    vec3 place = noiseOrigin + worldFromView * viewDirection() * (t * noisePerM);
    // Waves that move push the swirls to and fro, so that the smoke rolls instead of being carried along like a picture.
    place += 0.035 * sin(6.2831853 * (2.0 * place.yzx + noiseWave));
    return max(1.0 + noiseAmount * 4.2 * (texture(noiseVolume, place).r - 0.5), 0.0);
}
