/* gl_trace.c -- a library for LD_PRELOAD that writes one line on standard error for each OpenGL
 * call that matters for the cost of a frame. The lines are:
 *
 *     PROGRAM id hash name
 *     DRAW program framebuffer indices instances vertices
 *
 * `hash` is the FNV-1a hash of the texts of both shaders without comments and without repeated
 * white space. `name` is the comment in the second line of the fragment shader.
 * `vertices` is the number of vertices that the vertex shader computes for one instance: a GPU
 * computes a vertex again if it is not among the last CACHE_SIZE vertices.
 * If the environment variable GL_TRACE_RENDERER is set, the program reads its value as the name of
 * the graphics hardware, and therefore draws with the quality for that hardware. */
#define _GNU_SOURCE /* NOLINT(bugprone-reserved-identifier,cert-*): RTLD_NEXT */
#include <ctype.h>
#include <dlfcn.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef unsigned int GLuint;
typedef unsigned int GLenum;
typedef int GLsizei;
typedef int GLint;
typedef intptr_t GLintptr;

#define GL_RENDERER 0x1F01
#define GL_FRAGMENT_SHADER 0x8B30
#define GL_ELEMENT_ARRAY_BUFFER 0x8893
#define GL_UNSIGNED_SHORT 0x1403
#define GL_MAP_READ_BIT 0x0001
#define OBJECT_MAX 512u /* Maximum number of shaders and programs. */
#define NAME_SIZE 48u
/* Number of vertices that the vertex cache of V3D holds. */
#define CACHE_SIZE 64u

/* Defines `next`, the function of the OpenGL library with the name of the enclosing function. */
#define NEXT(name)                                                                                 \
    static __typeof__(name) *next;                                                                 \
    if (!next) {                                                                                   \
        *(void **)&next = dlsym(RTLD_NEXT, #name);                                                 \
    }

static GLuint program_now, framebuffer_now;

#define HASH_START 0xcbf29ce484222325u
#define HASH_PRIME 0x100000001b3u

/* Properties of each shader. In `programs`, the combined properties of a program's shaders. */
static struct object {
    uint64_t hash;
    char name[NAME_SIZE];
    bool is_fragment;
} shaders[OBJECT_MAX], programs[OBJECT_MAX];

static uint64_t add_to_hash(uint64_t hash, char c)
{
    return (hash ^ (uint8_t)c) * HASH_PRIME;
}

/* Returns the hash of `text`. Skips comments that begin with two slashes, and counts each run of
 * white space as one space. */
static uint64_t hash_code(const char *text)
{
    uint64_t hash = HASH_START;
    bool is_after_space = true;
    for (const char *c = text; *c; c++) {
        if (c[0] == '/' && c[1] == '/') {
            c += strcspn(c, "\n") - 1u;
        } else if (!isspace((unsigned char)*c)) {
            hash = add_to_hash(hash, *c);
            is_after_space = false;
        } else if (!is_after_space) {
            hash = add_to_hash(hash, ' ');
            is_after_space = true;
        }
    }
    return hash;
}

GLuint glCreateShader(GLenum stage)
{
    NEXT(glCreateShader)
    const GLuint shader = next(stage);
    shaders[shader % OBJECT_MAX].is_fragment = stage == GL_FRAGMENT_SHADER;
    return shader;
}

void glShaderSource(GLuint shader, GLsizei count, const char *const *parts, const GLint *lengths)
{
    NEXT(glShaderSource)
    struct object *const object = &shaders[shader % OBJECT_MAX];
    static char text[1u << 16];
    text[0] = '\0';
    for (GLsizei i = 0; i < count; i++) {
        strncat(text, parts[i], sizeof text - strlen(text) - 1u);
    }
    sscanf(text, "%*[^\n]\n// %47[^\n]", object->name);
    object->hash = hash_code(text);
    next(shader, count, parts, lengths);
}

void glAttachShader(GLuint program, GLuint shader)
{
    NEXT(glAttachShader)
    const struct object *const from = &shaders[shader % OBJECT_MAX];
    struct object *const to = &programs[program % OBJECT_MAX];
    to->hash = (from->is_fragment ? to->hash * HASH_PRIME : to->hash) ^ from->hash;
    if (from->is_fragment) {
        memcpy(to->name, from->name, sizeof to->name);
        fprintf(stderr, "PROGRAM %u %016" PRIx64 " %s\n", program, to->hash, to->name);
    }
    next(program, shader);
}

const unsigned char *glGetString(GLenum name)
{
    NEXT(glGetString)
    const char *const renderer = getenv("GL_TRACE_RENDERER");
    return name == GL_RENDERER && renderer ? (const unsigned char *)renderer : next(name);
}

void glUseProgram(GLuint program)
{
    NEXT(glUseProgram)
    program_now = program;
    next(program);
}

void glBindFramebuffer(GLenum target, GLuint framebuffer)
{
    NEXT(glBindFramebuffer)
    framebuffer_now = framebuffer;
    next(target, framebuffer);
}

static void note_draw(GLsizei count, GLsizei instances, GLsizei vertices)
{
    fprintf(stderr, "DRAW %u %u %d %d %d\n", program_now, framebuffer_now, count, instances,
            vertices);
}

/* Returns the number of vertices that are computed for `count` indices of the bound index buffer.
 * Returns `count` if the indices cannot be read. */
static GLsizei count_vertices(GLsizei count, GLenum type, const void *first)
{
    void *(*map)(GLenum, GLintptr, GLintptr, unsigned) = NULL;
    unsigned char (*unmap)(GLenum) = NULL;
    *(void **)&map = dlsym(RTLD_NEXT, "glMapBufferRange");
    *(void **)&unmap = dlsym(RTLD_NEXT, "glUnmapBuffer");
    const uint16_t *const index =
        type != GL_UNSIGNED_SHORT || !map || !unmap
            ? NULL
            : map(GL_ELEMENT_ARRAY_BUFFER, (GLintptr)first, 2 * count, GL_MAP_READ_BIT);
    if (!index) {
        return count;
    }
    uint16_t cache[CACHE_SIZE];
    uint32_t used = 0;
    for (GLsizei i = 0; i < count; i++) {
        bool is_cached = false;
        for (uint32_t k = used > CACHE_SIZE ? used - CACHE_SIZE : 0; k < used && !is_cached; k++) {
            is_cached = cache[k % CACHE_SIZE] == index[i];
        }
        if (!is_cached) {
            cache[used++ % CACHE_SIZE] = index[i];
        }
    }
    unmap(GL_ELEMENT_ARRAY_BUFFER);
    return (GLsizei)used;
}

void glDrawArrays(GLenum mode, GLint first, GLsizei count)
{
    NEXT(glDrawArrays)
    note_draw(count, 1, count);
    next(mode, first, count);
}

void glDrawArraysInstanced(GLenum mode, GLint first, GLsizei count, GLsizei instances)
{
    NEXT(glDrawArraysInstanced)
    note_draw(count, instances, count);
    next(mode, first, count, instances);
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void *indices)
{
    NEXT(glDrawElements)
    note_draw(count, 1, count_vertices(count, type, indices));
    next(mode, count, type, indices);
}

void glDrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void *indices,
                             GLsizei instances)
{
    NEXT(glDrawElementsInstanced)
    note_draw(count, instances, count_vertices(count, type, indices));
    next(mode, count, type, indices, instances);
}
