/* gl_program.c -- implementation of gl_program.h. */
#include "platform/render/gl_program.h"

#include <stdio.h>
#include <string.h>

#include "shaders.h"

#define LOG_SIZE 512
#define NAME_SIZE 32

GLuint gl_compile(struct gl_status *status, const char *name, GLenum stage,
                  const char *const *parts, GLsizei count)
{
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
        return 0; /* gl_compile() has already stored the name of the failed shader in the status. */
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

static void assign_samplers(GLuint program, const char *samplers)
{
    char name[NAME_SIZE];
    GLint unit = 0;
    glUseProgram(program);
    while (*samplers) {
        const size_t length = strcspn(samplers, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, samplers);
        glUniform1i(glGetUniformLocation(program, name), unit++);
        samplers += length + (samplers[length] == ' ');
    }
}

static void bind_block(GLuint program, const char *name, GLuint point)
{
    const GLuint block = glGetUniformBlockIndex(program, name);
    if (block != GL_INVALID_INDEX) {
        glUniformBlockBinding(program, block, point);
    }
}

void gl_program_bind(GLuint program, const char *samplers)
{
    bind_block(program, "Frame", 0);
    bind_block(program, "Pose", 1);
    assign_samplers(program, samplers);
}

static GLuint build(struct gl_status *status, const char *name, const char *defines,
                    const char *library, const char *vertex, const char *fragment,
                    const char *samplers)
{
    const char *const vertex_parts[] = { "#version 300 es\n", defines, shader_common, library,
                                         vertex };
    const char *const fragment_parts[] = { "#version 300 es\n", defines, shader_common, fragment };
    const GLuint stages[2] = {
        gl_compile(status, name, GL_VERTEX_SHADER, vertex_parts, 5),
        gl_compile(status, name, GL_FRAGMENT_SHADER, fragment_parts, 4),
    };
    const GLuint program = gl_link(status, name, stages[0], stages[1]);
    glDeleteShader(stages[0]); /* OpenGL keeps the shader until the program is deleted. The name 0
                                  of a failed shader is ignored. */
    glDeleteShader(stages[1]);
    if (program) {
        gl_program_bind(program, samplers);
    }
    return program;
}

GLuint gl_program(struct gl_status *status, const char *name, const char *defines,
                  const char *vertex, const char *fragment, const char *samplers)
{
    return build(status, name, defines, "", vertex, fragment, samplers);
}

GLuint gl_morph_program(struct gl_status *status, const char *name, const char *defines,
                        const char *vertex, const char *fragment, const char *samplers)
{
    return build(status, name, defines, shader_morph, vertex, fragment, samplers);
}
