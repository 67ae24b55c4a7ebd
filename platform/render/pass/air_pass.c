/* air_pass.c -- implementation of air_pass.h. */
#include "platform/render/pass/air_pass.h"

#include "platform/render/gl_program.h"
#include "shaders.h"

#define STONE_COUNT 1
/* Maximum number of bubbles. At any time about a third of the bubbles have risen and float on the
 * surface. */
#define BUBBLE_COUNT 72

void air_pass_open(struct gl_status *status, struct air_pass *pass)
{
    pass->program = gl_program(status, "air stone", "", shader_bubble_vert, shader_bubble_frag, "");
    pass->stone = glGetUniformLocation(pass->program, "stone");
    glGenVertexArrays(1, &pass->no_attributes);
}

void air_pass_close(struct air_pass *pass)
{
    glDeleteProgram(pass->program);
    glDeleteVertexArrays(1, &pass->no_attributes);
}

void air_pass_draw(const struct air_pass *pass, const struct scene *scene)
{
    const struct scene_pump *const pump = &scene->pump;
    if (!pump->present) {
        return;
    }
    const GLsizei count = STONE_COUNT + (pump->runs ? BUBBLE_COUNT : 0);
    glUseProgram(pass->program);
    glUniform3f(pass->stone, pump->stone_m.x, pump->stone_m.y, pump->stone_m.z);
    glBindVertexArray(pass->no_attributes);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
