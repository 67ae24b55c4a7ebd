/* edge_pass.c -- implementation of edge_pass.h. */
#include "platform/render/pass/edge_pass.h"

#include "platform/render/gl_program.h"
#include "shaders.h"

void edge_pass_open(struct gl_status *status, struct edge_pass *pass)
{
    pass->program = gl_program(status, "dark", "", shader_fill_vert, shader_dark_frag, "");
    pass->dark = glGetUniformLocation(pass->program, "dark");
    glGenVertexArrays(1, &pass->no_attributes);
}

void edge_pass_close(struct edge_pass *pass)
{
    glDeleteProgram(pass->program);
    glDeleteVertexArrays(1, &pass->no_attributes);
}

/* Fills the rectangle from (left, bottom) to (right, top) with black, in OpenGL's window
 * coordinates with the origin at the lower left. */
static void blacken(GLint left, GLint bottom, GLint right, GLint top)
{
    if (right > left && top > bottom) {
        glScissor(left, bottom, right - left, top - bottom);
        glClear(GL_COLOR_BUFFER_BIT);
    }
}

/* Draws the four black strips beside the picture. An empty strip costs nothing. */
static void margins(const struct display_transform *transform)
{
    const struct display_rect part = display_picture_rect(transform);
    const GLint width = (GLint)transform->screen_width, height = (GLint)transform->screen_height;
    const GLint left = (GLint)part.left, right = (GLint)part.right;
    const GLint top = height - (GLint)part.top, bottom = height - (GLint)part.bottom;
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    blacken(0, top, width, height);
    blacken(0, 0, width, bottom);
    blacken(0, 0, left, height);
    blacken(right, 0, width, height);
    glDisable(GL_SCISSOR_TEST);
}

void edge_pass_draw(const struct edge_pass *pass, const struct display_transform *transform)
{
    if (transform->light < 1.0f) {
        glViewport(0, 0, (GLsizei)transform->screen_width, (GLsizei)transform->screen_height);
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glUseProgram(pass->program);
        glUniform1f(pass->dark, 1.0f - transform->light);
        glBindVertexArray(pass->no_attributes);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindVertexArray(0);
    }
    margins(transform);
}

void edge_pass_night(void)
{
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}
