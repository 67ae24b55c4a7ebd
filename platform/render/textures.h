/* textures.h -- the baked pictures, uploaded once. */
#ifndef KINGYO_PLATFORM_RENDER_TEXTURES_H
#define KINGYO_PLATFORM_RENDER_TEXTURES_H

#include "platform/render/gl_util.h"

struct textures {
    GLuint caustics;    /* Array: one loop of light on the floor. */
    GLuint patterns;    /* Array: red patches and scales. */
    GLuint environment; /* What the water mirrors. */
    GLuint wood;
    GLuint paper;
};

void textures_open(struct gl_status *status, struct textures *textures);
void textures_close(struct textures *textures);

#endif
