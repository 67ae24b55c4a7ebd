/* textures.h -- the OpenGL textures of the baked pictures, which are uploaded once. */
#ifndef KINGYO_PLATFORM_RENDER_TEXTURES_H
#define KINGYO_PLATFORM_RENDER_TEXTURES_H

#include "platform/render/gl_util.h"

struct textures {
    GLuint caustics;    /* Array texture: one loop of the light pattern on the floor. */
    GLuint patterns;    /* Array texture: the red patches and the scales of the goldfish. */
    GLuint environment; /* Environment map that the water reflects. */
    GLuint wood;
    GLuint paper;
};

void textures_open(struct gl_status *status, struct textures *textures);
/* Returns the layer of `patterns` for a fish with this appearance (`look` of struct scene_fish). */
float textures_pattern(uint32_t look);
/* Returns the hue of a fish with this appearance, [0, 1]. */
float textures_hue(uint32_t look);

void textures_close(struct textures *textures);

#endif
