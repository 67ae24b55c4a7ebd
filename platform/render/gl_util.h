/* gl_util.h -- OpenGL ES 3 helper functions that all passes share, for textures, buffers, render
 * targets and shader programs, and one common way to report failures.
 *
 * Functions that create objects never stop at an error. They store the first failure in `struct
 * gl_status` and return the name 0, which OpenGL ignores. The caller checks the status once, after
 * all objects are created. */
#pragma once

#include <GLES3/gl3.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "platform/hal.h"

/* Number of textures in a ring buffer (struct gl_ring). A ring buffer is used for a texture whose
 * texels change in each frame. */
#define GL_RING 3u
/* Side of a texture in texels that is supported by every OpenGL ES 3.0 driver. */
#define GL_TEXTURE_SURE 2048u
/* Number of layers of an array texture that is supported by every OpenGL ES 3.0 driver. */
#define GL_LAYERS_SURE 256u
/* Line of a shader that defines the name `name` as the value of the macro `number`. */
#define GL_DEFINE(name, number) "#define " name " " GL_STRING(number) "\n"
#define GL_STRING(number) #number
/* Number of vertices of disc_and_handle() in common.glsl. */
#define DISC_AND_HANDLE_VERTICES 12

/* The first failure, as one line that names the object and the reason. The text is empty if nothing
 * has failed. */
struct gl_status {
    char text[HAL_TEXT_SIZE];
};

/* Stores the message if no earlier failure is stored. Later failures are ignored because they are
 * consequences of the first failure. */
void gl_fail(struct gl_status *status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
bool gl_is_well(const struct gl_status *status);

struct gl_texture_desc {
    GLenum internal_format; /* OpenGL format: GL_R8, GL_RG8 or GL_RGB8 if `pixels` is set. */
    uint32_t width, height;
    uint32_t layers;       /* Number of layers of an array texture. 0 means a plain 2D texture. */
    const uint8_t *pixels; /* Initial texels. Null leaves the content undefined. */
    bool mipmaps;
    bool nearest; /* True for nearest filtering, the only filter that 32-bit floats support. */
    GLenum wrap;  /* Wrap mode of the texture. 0 means GL_CLAMP_TO_EDGE. GL_MIRRORED_REPEAT applies
                     along x; along y the texture is clamped. */
};

/* Creates a texture. If the size is larger than the driver supports, the failure message contains
 * the requested and the supported size. */
GLuint gl_texture(struct gl_status *status, const char *name, const struct gl_texture_desc *desc);

/* Creates a buffer of `size` bytes. `data` may be null for a buffer that is filled every frame. */
GLuint gl_buffer(GLenum target, const void *data, size_t size);

/* Replaces the whole content of the buffer bound to `target` and allocates new storage for it. The
 * driver therefore does not wait for a frame that still reads the old content. */
void gl_buffer_refill(GLenum target, const void *data, size_t size);

/* Ring buffer of GL_RING textures of equal size without initial pixels. The next texture to fill is
 * never the texture that was drawn from last. */
struct gl_ring {
    GLuint textures[GL_RING];
    uint32_t now;
};

void gl_ring_open(struct gl_status *status, const char *name, struct gl_ring *ring,
                  const struct gl_texture_desc *desc);
void gl_ring_close(struct gl_ring *ring);

/* Advances to the next texture of the ring, which was filled the longest time ago, and returns its
 * OpenGL name. */
GLuint gl_ring_turn(struct gl_ring *ring);
/* Returns the result of the last call of gl_ring_turn(). */
GLuint gl_ring_texture(const struct gl_ring *ring);

/* Render target of a pass: a framebuffer and its size in pixels. */
struct gl_target {
    GLuint framebuffer;
    uint32_t width, height;
    /* Name of the object with the drawn colours: a texture, or a renderbuffer if `samples` > 1. */
    GLuint color;
    GLuint depth; /* Depth renderbuffer. 0 means that the target has no depth buffer. */
    /* Framebuffer whose colour buffer is `texture`. gl_target_resolve() copies the drawn picture to
     * this framebuffer. 0 means that the target has no multisampling. */
    GLuint resolve;
    GLuint texture; /* Texture with the finished picture, from which later passes read. */
};

struct gl_target_desc {
    GLenum internal_format; /* OpenGL format of the target, for example GL_RGBA8 or GL_R8. */
    uint32_t width, height;
    uint32_t samples; /* Samples per pixel. 0 and 1 mean no multisampling. */
    bool depth;
    GLenum wrap; /* Wrap mode of the render target's texture. 0 means GL_CLAMP_TO_EDGE. */
};

void gl_target_open(struct gl_status *status, const char *name, struct gl_target *target,
                    const struct gl_target_desc *desc);
void gl_target_close(struct gl_target *target);
void gl_target_bind(const struct gl_target *target);

/* Copies the drawn picture of a render target to its texture. Then invalidates the target's samples
 * and depth buffer, so that a tiled GPU does not write these data to memory. */
void gl_target_resolve(const struct gl_target *target);

void gl_bind_texture(uint32_t unit, GLenum kind, GLuint texture);

/* Describes a float attribute of the interleaved vertex buffer that is bound to GL_ARRAY_BUFFER.
 * `stride` and `offset` are in bytes. */
void gl_attribute_floats(GLuint location, GLint count, size_t stride, size_t offset);

/* Describes an attribute of unsigned bytes as gl_attribute_floats() does. If `is_fraction` is true,
 * the shader reads a byte as a fraction [0, 1], otherwise as a whole number. */
void gl_attribute_bytes(GLuint location, GLint count, bool is_fraction, size_t stride,
                        size_t offset);

/* Texture unit of the sampler `shades` of common.glsl, which light_pass.c binds once a frame. */
#define GL_UNIT_SHADES 5u
#define GL_UNIT_MAX 5u /* Maximum number of texture units that one program reads. */

/* Compiles one shader stage from `count` pieces of source code. The caller deletes the shader after
 * linking all programs that use the shader. Returns 0 on failure. */
GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count);
GLuint gl_link(struct gl_status *status, const char *name, GLuint vertex, GLuint fragment);

/* Compiles and links a program. `defines` (may be "") is inserted into both sources after the
 * version line and before the code that all shaders share. If `defines` defines KEYS, the vertex
 * shader can call the functions of assets/shaders/morph.glsl. `samplers` lists up to GL_UNIT_MAX
 * sampler names, separated by spaces. The samplers get the texture units 0, 1, 2, ... in this
 * order. Binds the uniform block `Frame` to binding point 0 and `Pose` to binding point 1. Returns
 * 0 on failure. */
GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers);

/* Binds the uniform blocks and samplers of a linked program as gl_program() does. */
void gl_program_bind(GLuint program, const char *samplers);

/* Converts a 32-bit float to a 16-bit float of a texture (IEEE 754 binary16). The driver would
 * convert each float of an upload with slower code.
 *
 * Returns the 16-bit float nearest to `value`. Returns 0 if the magnitude of `value` is below
 * 2^-14, the smallest normal 16-bit float. `value` must be below 65504 and finite. */
static inline uint16_t half_float(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    const uint32_t magnitude = bits & 0x7fffffffu;
    const uint32_t sign = bits >> 16u & 0x8000u;
    const uint32_t is_normal = magnitude >= 0x38800000u;
    /* The exponent of a 16-bit float has a bias of 15 in place of 127. */
    const uint32_t rounded = (magnitude - 0x38000000u + 0x1000u) >> 13u;
    return (uint16_t)(is_normal ? sign | rounded : 0u);
}
