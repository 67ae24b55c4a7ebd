/* gl_program.h -- compiles and links shader programs. Failures are stored in struct gl_status, as
 * in gl_util.h. */
#ifndef KINGYO_PLATFORM_RENDER_GL_PROGRAM_H
#define KINGYO_PLATFORM_RENDER_GL_PROGRAM_H

#include "platform/render/gl_util.h"

#define GL_UNIT_MAX 5u /* Maximum number of texture units that one program reads. */

/* Compiles one shader stage from `count` pieces of source code. The caller deletes the shader after
 * linking all programs that use the shader. Returns 0 on failure. */
GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count);
GLuint gl_link(struct gl_status *status, const char *name, GLuint vertex, GLuint fragment);

/* Compiles and links a program. `defines` (may be "") is inserted into both sources after the
 * version line and before the code that all shaders share. `samplers` lists up to GL_UNIT_MAX
 * sampler names, separated by spaces. The samplers get the texture units 0, 1, 2, ... in this
 * order. Binds the uniform block `Frame` to binding point 0 and `Pose` to binding point 1. Returns
 * 0 on failure. */
GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers);

/* Same as gl_program(), but inserts assets/shaders/morph.glsl before the source of the vertex
 * shader. */
GLuint gl_morph_program(struct gl_status *status, const char *name, const char *defines,
                        const char *vertex, const char *fragment, const char *samplers);

/* Binds the uniform blocks and samplers of a linked program as gl_program() does. */
void gl_program_bind(GLuint program, const char *samplers);

#endif
