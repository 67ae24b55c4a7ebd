/* edge_pass.h -- the last of a frame: what lies beside the picture is black, and the picture as
 * dark as is asked. Costs nothing where it fills the screen in full light. */
#ifndef KINGYO_PLATFORM_RENDER_EDGE_PASS_H
#define KINGYO_PLATFORM_RENDER_EDGE_PASS_H

#include "platform/render/gl_util.h"

struct edge_pass {
    GLuint program, no_attributes;
    GLint dark;
};

void edge_pass_open(struct gl_status *status, struct edge_pass *pass);
void edge_pass_close(struct edge_pass *pass);

/* Over what is in the bound framebuffer, the screen of `placing`. Leaves blending on, scissor off.
 */
void edge_pass_draw(const struct edge_pass *pass, const struct placing *placing);

/* In its place where there is no light at all: a black screen. */
void edge_pass_night(void);

#endif
