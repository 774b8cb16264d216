// Calls functions of OpenGL 4.3 and 4.5 unguarded, for the check of the OpenGL floor to refuse. Compiled,
// never run.
#include <epoxy/gl.h>

void callNewerGl() {
    glDispatchCompute(1, 1, 1);
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
}
