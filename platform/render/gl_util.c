/* gl_util.c -- implementation of gl_util.h: failure status, textures, buffers, render
 * targets and shader programs. */
#include "platform/render/gl_util.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "shaders.h"

void gl_fail(struct gl_status *status, const char *format, ...)
{
    CORE_ASSERT(status && format);
    if (!gl_is_well(status)) {
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(status->text, sizeof status->text, format, arguments);
    va_end(arguments);
    for (char *c = status->text; *c; c++) {
        if (*c == '\n') {
            /* Line breaks are replaced by spaces: a driver's message may have several lines, but
             * the status holds one line. */
            *c = ' ';
        }
    }
}

bool gl_is_well(const struct gl_status *status)
{
    return status->text[0] == '\0';
}

/* Stores a failure if the driver does not support the size of the texture. */
static bool is_size_supported(struct gl_status *status, const char *name,
                              const struct gl_texture_desc *desc)
{
    GLint side_max = 0, layers_max = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side_max);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers_max);
    if (desc->width > (uint32_t)side_max || desc->height > (uint32_t)side_max) {
        gl_fail(status, "texture %s is %ux%u texels, but this OpenGL driver supports at most %dx%d",
                name, desc->width, desc->height, side_max, side_max);
        return false;
    }
    if (desc->layers > (uint32_t)layers_max) {
        gl_fail(status, "texture %s has %u layers, but this OpenGL driver supports at most %d",
                name, desc->layers, layers_max);
        return false;
    }
    return true;
}

GLuint gl_texture(struct gl_status *status, const char *name, const struct gl_texture_desc *desc)
{
    const GLenum format = desc->internal_format == GL_R8    ? GL_RED
                          : desc->internal_format == GL_RG8 ? GL_RG
                                                            : GL_RGB;
    CORE_ASSERT(!desc->pixels || format != GL_RGB || desc->internal_format == GL_RGB8);
    CORE_ASSERT(desc->width > 0 && desc->height > 0);
    if (!is_size_supported(status, name, desc)) {
        return 0;
    }
    const GLenum kind = desc->layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    const GLsizei width = (GLsizei)desc->width, height = (GLsizei)desc->height;
    const GLsizei layers = (GLsizei)desc->layers;
    GLsizei levels = 1;
    for (uint32_t side = desc->width > desc->height ? desc->width : desc->height;
         desc->mipmaps && side > 1; side /= 2) {
        levels++;
    }
    GLuint texture = 0;
    glGenTextures(1, &texture);
    gl_bind_texture(0, kind, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (layers) {
        glTexStorage3D(kind, levels, desc->internal_format, width, height, layers);
    } else {
        glTexStorage2D(kind, levels, desc->internal_format, width, height);
    }
    if (desc->pixels && layers) {
        glTexSubImage3D(kind, 0, 0, 0, 0, width, height, layers, format, GL_UNSIGNED_BYTE,
                        desc->pixels);
    } else if (desc->pixels) {
        glTexSubImage2D(kind, 0, 0, 0, width, height, format, GL_UNSIGNED_BYTE, desc->pixels);
    }
    if (desc->mipmaps) {
        glGenerateMipmap(kind);
    }
    const GLint edge = (GLint)(desc->wrap ? desc->wrap : GL_CLAMP_TO_EDGE);
    const GLint magnify = desc->nearest ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER,
                    desc->mipmaps ? GL_LINEAR_MIPMAP_NEAREST : magnify);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(kind, GL_TEXTURE_WRAP_S, edge);
    glTexParameteri(kind, GL_TEXTURE_WRAP_T, edge == GL_MIRRORED_REPEAT ? GL_CLAMP_TO_EDGE : edge);
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) {
        gl_fail(status, "texture %s (%ux%u): OpenGL error 0x%x", name, desc->width, desc->height,
                error);
    }
    return texture;
}

GLuint gl_buffer(GLenum target, const void *data, size_t size)
{
    CORE_ASSERT(size > 0);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, (GLsizeiptr)size, data, data ? GL_STATIC_DRAW : GL_STREAM_DRAW);
    return buffer;
}

void gl_buffer_refill(GLenum target, const void *data, size_t size)
{
    glBufferData(target, (GLsizeiptr)size, data, GL_STREAM_DRAW);
}

void gl_ring_open(struct gl_status *status, const char *name, struct gl_ring *ring,
                  const struct gl_texture_desc *desc)
{
    for (uint32_t i = 0; i < GL_RING; i++) {
        ring->textures[i] = gl_texture(status, name, desc);
    }
    ring->now = 0;
}

void gl_ring_close(struct gl_ring *ring)
{
    glDeleteTextures(GL_RING, ring->textures);
    *ring = (struct gl_ring){ 0 };
}

GLuint gl_ring_turn(struct gl_ring *ring)
{
    ring->now = (ring->now + 1u) % GL_RING;
    return gl_ring_texture(ring);
}

GLuint gl_ring_texture(const struct gl_ring *ring)
{
    CORE_ASSERT(ring->now < GL_RING);
    return ring->textures[ring->now];
}

static GLuint renderbuffer(GLenum format, const struct gl_target_desc *desc)
{
    GLuint buffer = 0;
    const GLsizei samples = desc->samples > 1 ? (GLsizei)desc->samples : 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, (GLsizei)desc->width,
                                     (GLsizei)desc->height);
    return buffer;
}

static void check_complete(struct gl_status *status, const char *name,
                           const struct gl_target_desc *desc)
{
    const GLenum answer = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (answer != GL_FRAMEBUFFER_COMPLETE) {
        gl_fail(status, "target %s (%ux%u, %u samples) is incomplete: OpenGL status 0x%x", name,
                desc->width, desc->height, desc->samples, answer);
    }
}

void gl_target_open(struct gl_status *status, const char *name, struct gl_target *target,
                    const struct gl_target_desc *desc)
{
    CORE_ASSERT(desc->width > 0 && desc->height > 0);
    *target = (struct gl_target){ .width = desc->width, .height = desc->height };
    target->texture =
        gl_texture(status, name,
                   &(struct gl_texture_desc){ .internal_format = desc->internal_format,
                                              .width = desc->width,
                                              .height = desc->height,
                                              .wrap = desc->wrap });
    glGenFramebuffers(1, &target->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture, 0);
    if (desc->samples > 1) {
        check_complete(status, name, desc);
        target->resolve = target->framebuffer;
        glGenFramebuffers(1, &target->framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
        target->color = renderbuffer(desc->internal_format, desc);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  target->color);
    }
    if (desc->depth) {
        target->depth = renderbuffer(GL_DEPTH_COMPONENT24, desc);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  target->depth);
    }
    check_complete(status, name, desc);
}

void gl_target_close(struct gl_target *target)
{
    const GLuint framebuffers[2] = { target->framebuffer, target->resolve };
    const GLuint buffers[2] = { target->color, target->depth };
    glDeleteFramebuffers(2, framebuffers); /* OpenGL ignores an object with the name 0 in this call
                                              and in the following delete calls. */
    glDeleteRenderbuffers(2, buffers);
    glDeleteTextures(1, &target->texture);
    *target = (struct gl_target){ 0 };
}

void gl_target_bind(const struct gl_target *target)
{
    CORE_ASSERT(target->width > 0 && target->height > 0);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glViewport(0, 0, (GLsizei)target->width, (GLsizei)target->height);
}

void gl_target_resolve(const struct gl_target *target)
{
    static const GLenum spent[2] = { GL_DEPTH_ATTACHMENT, GL_COLOR_ATTACHMENT0 };
    const GLint width = (GLint)target->width;
    const GLint height = (GLint)target->height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    if (target->resolve) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target->resolve);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, target->resolve ? 2 : 1, spent);
}

void gl_bind_texture(uint32_t unit, GLenum kind, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(kind, texture);
}

void gl_attribute_floats(GLuint location, GLint count, size_t stride, size_t offset)
{
    CORE_ASSERT(count >= 1 && count <= 4);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, (GLsizei)stride,
                          (const void *)offset);
}

void gl_attribute_bytes(GLuint location, GLint count, bool is_fraction, size_t stride,
                        size_t offset)
{
    CORE_ASSERT(count >= 1 && count <= 4);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_UNSIGNED_BYTE, is_fraction ? GL_TRUE : GL_FALSE,
                          (GLsizei)stride, (const void *)offset);
}

#define LOG_SIZE 512
#define NAME_SIZE 32

GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count)
{
    CORE_ASSERT(count > 0);
    CORE_ASSERT(stage == GL_VERTEX_SHADER || stage == GL_FRAGMENT_SHADER);
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, count, parts, NULL);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[LOG_SIZE] = "no log";
        glGetShaderInfoLog(shader, LOG_SIZE, NULL, log);
        gl_fail(status, "shader %s (%s) does not compile: %s", name,
                stage == GL_VERTEX_SHADER ? "vertex" : "fragment", log);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

GLuint gl_link(struct gl_status *status, const char *name, GLuint vertex, GLuint fragment)
{
    if (!vertex || !fragment) {
        /* A shader with the name 0 failed to compile. gl_compile() has already stored its name in
         * the status. */
        return 0;
    }
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[LOG_SIZE] = "no log";
        glGetProgramInfoLog(program, LOG_SIZE, NULL, log);
        gl_fail(status, "shader %s does not link: %s", name, log);
        glDeleteProgram(program);
        return 0;
    }
    return program;
}

void gl_program_bind(GLuint program, const char *samplers)
{
    /* Names of the uniform blocks, indexed by binding point. */
    static const char *const blocks[] = { "Frame", "Pose" };
    CORE_ASSERT(program != 0 && samplers);
    for (GLuint point = 0; point < 2u; point++) {
        const GLuint block = glGetUniformBlockIndex(program, blocks[point]);
        if (block != GL_INVALID_INDEX) {
            glUniformBlockBinding(program, block, point);
        }
    }
    char name[NAME_SIZE];
    GLint unit = 0;
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "shades"), (GLint)GL_UNIT_SHADES);
    while (*samplers) {
        const size_t length = strcspn(samplers, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, samplers);
        glUniform1i(glGetUniformLocation(program, name), unit++);
        samplers += length + (samplers[length] == ' ');
    }
}

GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers)
{
    /* The second line of each shader is a comment with the name of the program. */
    const char *const vertex_parts[] = { "#version 300 es\n// ", name,         "\n",  defines,
                                         shader_common,          shader_morph, vertex };
    const char *const fragment_parts[] = { "#version 300 es\n// ", name,    "\n", defines,
                                           shader_common,          fragment };
    const GLuint stages[2] = {
        gl_compile(status, name, GL_VERTEX_SHADER, vertex_parts, 7),
        gl_compile(status, name, GL_FRAGMENT_SHADER, fragment_parts, 6),
    };
    const GLuint program = gl_link(status, name, stages[0], stages[1]);
    glDeleteShader(stages[0]); /* OpenGL keeps the shader until the program is deleted. If the
                                  compilation failed, the shader's name is 0, which OpenGL
                                  ignores. */
    glDeleteShader(stages[1]);
    if (program) {
        gl_program_bind(program, samplers);
    }
    return program;
}
