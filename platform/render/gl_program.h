/* gl_program.h -- from the sources of shaders to a program that is ready to draw. Failures as in
 * gl_util.h. */
#ifndef KINGYO_PLATFORM_RENDER_GL_PROGRAM_H
#define KINGYO_PLATFORM_RENDER_GL_PROGRAM_H

#include "platform/render/gl_util.h"

#define GL_UNIT_MAX 5u /* Texture units that any one program reads. */

/* One stage, of `count` pieces of source in a row. Delete it when its programs are linked. */
GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count);
GLuint gl_link(struct gl_status *status, const char *name, GLuint vertex, GLuint fragment);

/* Compiles and links. `defines` (may be "") is put in front of both sources, after the version line
 * and before the common block. `samplers` names up to GL_UNIT_MAX samplers, separated by spaces,
 * that get units 0, 1, .. in that order. Binds the block `Frame` to point 0 and `Pose` to 1. */
GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers);

/* The same with assets/shaders/morph.glsl in front of the vertex shader. */
GLuint gl_morph_program(struct gl_status *status, const char *name, const char *defines,
                        const char *vertex, const char *fragment, const char *samplers);

/* What a linked program needs besides: blocks and samplers bound as above. */
void gl_program_bind(GLuint program, const char *samplers);

#endif
