/* gl_util.h -- the few OpenGL ES 3 chores every pass shares, with one way to report failure.
 *
 * Builders never stop half-way: they remember the first failure in `struct gl_status` and return
 * the name 0, which OpenGL ignores. Whoever builds a whole looks at the status once, at the end. */
#ifndef KINGYO_PLATFORM_RENDER_GL_UTIL_H
#define KINGYO_PLATFORM_RENDER_GL_UTIL_H

#include <GLES3/gl3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/hal.h"

#define GL_RING 3u     /* Textures in turn, where each frame brings new texels. */
#define GL_TEXTURE_SURE 2048u /* Texels a side, ... */
#define GL_LAYERS_SURE 256u   /* ... and layers of an array: what OpenGL ES 3.0 promises. */

/* The first failure, in one line that says what and where; empty while all is well. */
struct gl_status {
    char text[HAL_TEXT_SIZE];
};

/* Keeps the first message only; later ones follow from it. */
void gl_fail(struct gl_status *status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
bool gl_is_well(const struct gl_status *status);

struct gl_texture_desc {
    GLenum internal_format, format; /* Of 8-bit components where there are pixels. */
    uint32_t width, height;
    uint32_t layers;       /* 0: a plain 2D texture; else an array. */
    const uint8_t *pixels; /* Null: contents undefined. */
    bool mipmaps;
    bool nearest; /* Texels as they are: 32-bit floats have no other way. */
    GLenum wrap; /* 0: GL_CLAMP_TO_EDGE. */
};

/* One that is larger than this driver takes is refused with both sizes. */
GLuint gl_texture(struct gl_status *status, const char *name, const struct gl_texture_desc *desc);

/* A buffer of `size` bytes; `data` may be null for one that is filled every frame. */
GLuint gl_buffer(GLenum target, const void *data, size_t size);

/* Replaces the whole of the buffer bound to `target`, in a fresh store: the driver need not wait
 * for the frame that still reads the last one. */
void gl_buffer_refill(GLenum target, const void *data, size_t size);

/* GL_RING equal textures, without pixels: the one to fill is never the one last drawn from. */
struct gl_ring {
    GLuint textures[GL_RING];
    uint32_t now;
};

void gl_ring_open(struct gl_status *status, const char *name, struct gl_ring *ring,
                  const struct gl_texture_desc *desc);
void gl_ring_close(struct gl_ring *ring);

/* Goes on to the texture that has rested longest, and returns it. */
GLuint gl_ring_turn(struct gl_ring *ring);
GLuint gl_ring_texture(const struct gl_ring *ring);

/* Where a pass draws: a framebuffer and its size in pixels. */
struct gl_target {
    GLuint framebuffer;
    uint32_t width, height;
    GLuint color;   /* Texture, or renderbuffer when `samples` > 1. */
    GLuint depth;   /* Renderbuffer or 0. */
    GLuint resolve; /* Texture's framebuffer that gl_target_resolve() fills, or 0. */
    GLuint texture; /* What later passes sample. */
};

struct gl_target_desc {
    GLenum internal_format; /* GL_RGBA8, GL_R8. */
    uint32_t width, height;
    uint32_t samples; /* 0, 1: none. */
    bool depth;
    GLenum wrap; /* 0: GL_CLAMP_TO_EDGE. */
};

void gl_target_open(struct gl_status *status, const char *name, struct gl_target *target,
                    const struct gl_target_desc *desc);
void gl_target_close(struct gl_target *target);
void gl_target_bind(const struct gl_target *target);

/* Makes `texture` hold what was drawn. What the texture does not keep, samples and depth, is given
 * up: a tiled GPU then never writes it to memory. */
void gl_target_resolve(const struct gl_target *target);

void gl_bind_texture(uint32_t unit, GLenum kind, GLuint texture);

/* Describes the floats of an interleaved buffer, bound to GL_ARRAY_BUFFER now. */
void gl_attribute_floats(GLuint location, GLint count, size_t stride, size_t offset);

#endif
