/* textures.h -- the baked pictures, uploaded once. */
#ifndef KINGYO_PLATFORM_RENDER_TEXTURES_H
#define KINGYO_PLATFORM_RENDER_TEXTURES_H

#include "platform/render/gl_util.h"

struct textures {
    GLuint caustics;    /* Array: one loop of light on the floor. */
    GLuint patterns;    /* Array: red patches and scales. */
    GLuint environment; /* Environment map that the water mirrors. */
    GLuint wood;
    GLuint paper;
};

void textures_open(struct gl_status *status, struct textures *textures);
/* Returns the pattern layer of a fish with this look. textures_hue() returns the fish's hue, [0,
 * 1]. */
float textures_pattern(uint32_t look);
float textures_hue(uint32_t look);

void textures_close(struct textures *textures);

#endif
