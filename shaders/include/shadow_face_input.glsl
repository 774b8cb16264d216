// Hands a beam's shadow map from the vertices of its hull to the pixels: the three texels of its record (render/shadow_projection.h). Needs
// beam_input.glsl.
#ifndef SHADOW_FACES
uniform samplerBuffer shadowFaces;

flat out vec4 shadowMap;
flat out vec4 shadowTile;
flat out vec4 shadowWindow;

void passShadowFace() {
    int record = 3 * int(beamShadow.x);
    shadowMap = texelFetch(shadowFaces, record);
    shadowTile = texelFetch(shadowFaces, record + 1);
    shadowWindow = texelFetch(shadowFaces, record + 2);
}
#else
// Which of its six maps a wide lamp needs, only the pixel knows.
void passShadowFace() {}
#endif
