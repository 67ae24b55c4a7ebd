/* gl_util.h -- OpenGL ES 3 helper functions that every pass shares, with one way to report
 * failures.
 *
 * Functions that create objects never stop at an error: they store the first failure in `struct
 * gl_status` and return the name 0, which OpenGL ignores. The caller checks the status once, at the
 * end. */
#ifndef KINGYO_PLATFORM_RENDER_GL_UTIL_H
#define KINGYO_PLATFORM_RENDER_GL_UTIL_H

#include <GLES3/gl3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/hal.h"

#define GL_RING 3u /* Number of textures used in turn for texels that change each frame. */
#define GL_TEXTURE_SURE 2048u /* Texture size in texels a side that OpenGL ES 3.0 guarantees. */
/* Number of layers of an array texture that OpenGL ES 3.0 guarantees. */
#define GL_LAYERS_SURE 256u

/* The first failure as one line that names the object and the reason; empty while there is none. */
struct gl_status {
    char text[HAL_TEXT_SIZE];
};

/* Stores the message if it is the first. Later failures are consequences and are ignored. */
void gl_fail(struct gl_status *status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
bool gl_is_well(const struct gl_status *status);

struct gl_texture_desc {
    GLenum internal_format, format; /* Has 8-bit components if `pixels` is set. */
    uint32_t width, height;
    uint32_t layers;       /* 0: a plain 2D texture; otherwise the layers of an array. */
    const uint8_t *pixels; /* Initial texels; null: contents undefined. */
    bool mipmaps;
    bool nearest; /* Nearest filtering, the only filter for 32-bit floats. */
    GLenum wrap;  /* Wrap mode; 0: GL_CLAMP_TO_EDGE. */
};

/* Creates a texture. A size larger than the driver supports fails with both sizes in the
 * message. */
GLuint gl_texture(struct gl_status *status, const char *name, const struct gl_texture_desc *desc);

/* Creates a buffer of `size` bytes. `data` may be null for a buffer that is filled every frame. */
GLuint gl_buffer(GLenum target, const void *data, size_t size);

/* Replaces the whole content of the buffer bound to `target` in new storage. The driver then
 * need not wait for the frame that still reads the old content. */
void gl_buffer_refill(GLenum target, const void *data, size_t size);

/* GL_RING equal textures without pixels. The texture being filled is never the one that was last
 * drawn from. */
struct gl_ring {
    GLuint textures[GL_RING];
    uint32_t now;
};

void gl_ring_open(struct gl_status *status, const char *name, struct gl_ring *ring,
                  const struct gl_texture_desc *desc);
void gl_ring_close(struct gl_ring *ring);

/* Advances to the texture that has been unused for the longest time, and returns it. */
GLuint gl_ring_turn(struct gl_ring *ring);
GLuint gl_ring_texture(const struct gl_ring *ring);

/* Render target of a pass: a framebuffer and its size in pixels. */
struct gl_target {
    GLuint framebuffer;
    uint32_t width, height;
    GLuint color;   /* Texture, or renderbuffer when `samples` > 1. */
    GLuint depth;   /* Renderbuffer or 0. */
    GLuint resolve; /* Framebuffer of `texture` that gl_target_resolve() fills, or 0. */
    GLuint texture; /* Texture that later passes sample. */
};

struct gl_target_desc {
    GLenum internal_format; /* GL_RGBA8, GL_R8. */
    uint32_t width, height;
    uint32_t samples; /* Samples a pixel; 0 and 1: no multisampling. */
    bool depth;
    GLenum wrap; /* Wrap mode; 0: GL_CLAMP_TO_EDGE. */
};

void gl_target_open(struct gl_status *status, const char *name, struct gl_target *target,
                    const struct gl_target_desc *desc);
void gl_target_close(struct gl_target *target);
void gl_target_bind(const struct gl_target *target);

/* Copies the drawn picture to `texture`. Samples and depth are invalidated, so that a tiled GPU
 * never writes them to memory. */
void gl_target_resolve(const struct gl_target *target);

void gl_bind_texture(uint32_t unit, GLenum kind, GLuint texture);

/* Describes the float attributes of an interleaved buffer, which must be bound to
 * GL_ARRAY_BUFFER. */
void gl_attribute_floats(GLuint location, GLint count, size_t stride, size_t offset);

#endif
