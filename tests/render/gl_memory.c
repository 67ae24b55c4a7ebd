/* gl_memory.c -- a library for LD_PRELOAD that counts the memory of the GPU objects of a program.
 * When the program ends, the library prints one line for each kind of object on standard output:
 * the greatest number of bytes that existed at the same time, and the number of objects then.
 *
 * The bytes are those that the formats need. A driver may need more, for example for alignment. The
 * buffers of the window, which belong to the display server, are not counted. */
#define _GNU_SOURCE /* NOLINT(bugprone-reserved-identifier,cert-*): RTLD_NEXT */
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef unsigned int GLuint;
typedef unsigned int GLenum;
typedef int GLsizei;
typedef intptr_t GLsizeiptr;

#define ID_MAX 4096u /* Maximum id of an object. */
#define TARGET_COUNT 4u

enum kind { TEXTURE, RENDERBUFFER, BUFFER, KIND_COUNT };

static const char *const names[KIND_COUNT] = { "textures", "render buffers",
                                               "vertex and uniform buffers" };
static uint64_t bytes_of[KIND_COUNT][ID_MAX], now[KIND_COUNT], peak[KIND_COUNT];
static uint32_t count_now[KIND_COUNT], count_at_peak[KIND_COUNT];
static uint64_t peak_of_all;
/* Id of the bound object for each target: 2D textures and arrays of them, render buffers, and
 * vertex, index and uniform buffers. */
static GLuint bound_texture[2], bound_renderbuffer;
static struct {
    GLenum target;
    GLuint id;
} bound_buffer[TARGET_COUNT];

/* Defines `next`, the function of the OpenGL library with the name of the enclosing function. */
#define NEXT(name)                                                                                 \
    static __typeof__(name) *next;                                                                 \
    if (!next) {                                                                                   \
        *(void **)&next = dlsym(RTLD_NEXT, #name);                                                 \
    }

static void set_bytes(enum kind kind, GLuint id, uint64_t bytes)
{
    if (id >= ID_MAX) {
        fprintf(stderr, "gl_memory: object %u is above the maximum of %u\n", id, ID_MAX - 1u);
        abort();
    }
    uint64_t *const entry = &bytes_of[kind][id];
    count_now[kind] += (uint32_t)(bytes > 0) - (uint32_t)(*entry > 0);
    now[kind] += bytes - *entry;
    *entry = bytes;
    const uint64_t all = now[TEXTURE] + now[RENDERBUFFER] + now[BUFFER];
    if (all > peak_of_all) {
        peak_of_all = all;
        for (uint32_t i = 0; i < KIND_COUNT; i++) {
            peak[i] = now[i];
            count_at_peak[i] = count_now[i];
        }
    }
}

/* Returns the bytes of a pixel. Drivers store three bytes as four. */
static uint32_t pixel_bytes(GLenum format)
{
    switch (format) {
    case 0x8229: /* GL_R8 */
        return 1;
    case 0x822B: /* GL_RG8 */
        return 2;
    case 0x8051: /* GL_RGB8 */
    case 0x8058: /* GL_RGBA8 */
    case 0x81A6: /* GL_DEPTH_COMPONENT24 */
        return 4;
    case 0x881A: /* GL_RGBA16F */
        return 8;
    default:
        fprintf(stderr, "gl_memory: the format 0x%x is unknown\n", format);
        abort();
    }
}

static uint64_t texture_bytes(GLsizei levels, GLenum format, GLsizei width, GLsizei height)
{
    uint64_t sum = 0;
    for (GLsizei i = 0; i < levels; i++) {
        const uint64_t w = (uint64_t)(width >> i ? width >> i : 1);
        const uint64_t h = (uint64_t)(height >> i ? height >> i : 1);
        sum += w * h * pixel_bytes(format);
    }
    return sum;
}

void glBindTexture(GLenum target, GLuint id);
void glBindTexture(GLenum target, GLuint id)
{
    NEXT(glBindTexture);
    bound_texture[target == 0x8C1A] = id; /* GL_TEXTURE_2D_ARRAY */
    next(target, id);
}

void glTexStorage2D(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height);
void glTexStorage2D(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height)
{
    NEXT(glTexStorage2D);
    set_bytes(TEXTURE, bound_texture[0], texture_bytes(levels, format, width, height));
    next(target, levels, format, width, height);
}

void glTexStorage3D(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                    GLsizei layers);
void glTexStorage3D(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                    GLsizei layers)
{
    NEXT(glTexStorage3D);
    set_bytes(TEXTURE, bound_texture[1],
              (uint64_t)layers * texture_bytes(levels, format, width, height));
    next(target, levels, format, width, height, layers);
}

void glBindRenderbuffer(GLenum target, GLuint id);
void glBindRenderbuffer(GLenum target, GLuint id)
{
    NEXT(glBindRenderbuffer);
    bound_renderbuffer = id;
    next(target, id);
}

void glRenderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                                      GLsizei height);
void glRenderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                                      GLsizei height)
{
    NEXT(glRenderbufferStorageMultisample);
    const uint64_t each = texture_bytes(1, format, width, height);
    set_bytes(RENDERBUFFER, bound_renderbuffer, each * (uint64_t)(samples > 1 ? samples : 1));
    next(target, samples, format, width, height);
}

void glBindBuffer(GLenum target, GLuint id);
void glBindBuffer(GLenum target, GLuint id)
{
    NEXT(glBindBuffer);
    uint32_t i = 0;
    while (i < TARGET_COUNT - 1u && bound_buffer[i].target != 0 &&
           bound_buffer[i].target != target) {
        i++;
    }
    bound_buffer[i].target = target;
    bound_buffer[i].id = id;
    next(target, id);
}

void glBufferData(GLenum target, GLsizeiptr size, const void *data, GLenum usage);
void glBufferData(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    NEXT(glBufferData);
    for (uint32_t i = 0; i < TARGET_COUNT; i++) {
        if (bound_buffer[i].target == target) {
            set_bytes(BUFFER, bound_buffer[i].id, (uint64_t)size);
        }
    }
    next(target, size, data, usage);
}

static void forget(enum kind kind, GLsizei count, const GLuint *ids)
{
    for (GLsizei i = 0; i < count; i++) {
        set_bytes(kind, ids[i], 0);
    }
}

void glDeleteTextures(GLsizei count, const GLuint *ids);
void glDeleteTextures(GLsizei count, const GLuint *ids)
{
    NEXT(glDeleteTextures);
    forget(TEXTURE, count, ids);
    next(count, ids);
}

void glDeleteRenderbuffers(GLsizei count, const GLuint *ids);
void glDeleteRenderbuffers(GLsizei count, const GLuint *ids)
{
    NEXT(glDeleteRenderbuffers);
    forget(RENDERBUFFER, count, ids);
    next(count, ids);
}

void glDeleteBuffers(GLsizei count, const GLuint *ids);
void glDeleteBuffers(GLsizei count, const GLuint *ids)
{
    NEXT(glDeleteBuffers);
    forget(BUFFER, count, ids);
    next(count, ids);
}

__attribute__((destructor)) static void print_sums(void)
{
    for (uint32_t i = 0; i < KIND_COUNT; i++) {
        printf("%-28s %6.1f MiB in %3u\n", names[i], (double)peak[i] / 1048576.0, count_at_peak[i]);
    }
    printf("%-28s %6.1f MiB\n", "greatest sum", (double)peak_of_all / 1048576.0);
}
