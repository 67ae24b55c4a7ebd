/* gl_program.h -- compiles and links shader programs. Failures are stored in struct gl_status, as
 * in gl_util.h. */
#ifndef KINGYO_PLATFORM_RENDER_GL_PROGRAM_H
#define KINGYO_PLATFORM_RENDER_GL_PROGRAM_H

#include "platform/render/gl_util.h"

#define GL_UNIT_MAX 5u /* Maximum number of texture units that one program reads. */

/* Compiles one shader stage from `count` pieces of source. The caller deletes the shader after its
 * programs are linked. Returns 0 on failure. */
GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count);
GLuint gl_link(struct gl_status *status, const char *name, GLuint vertex, GLuint fragment);

/* Compiles and links a program. `defines` (may be "") is inserted into both sources after the
 * version line and before the common block. `samplers` names up to GL_UNIT_MAX samplers, separated
 * by spaces, which get the texture units 0, 1 and so on in that order. Binds the uniform block
 * `Frame` to point 0 and `Pose` to point 1. Returns 0 on failure. */
GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers);

/* Does the same as gl_program(), with assets/shaders/morph.glsl inserted before the vertex
 * shader. */
GLuint gl_morph_program(struct gl_status *status, const char *name, const char *defines,
                        const char *vertex, const char *fragment, const char *samplers);

/* Binds the uniform blocks and samplers of a linked program as gl_program() does. */
void gl_program_bind(GLuint program, const char *samplers);

#endif
