/* edge_pass.h -- the last pass of a frame. The pass fills the area beside the picture with black,
 * and dims the picture to the configured brightness. Draws nothing if the picture fills the screen
 * at full brightness. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_EDGE_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_EDGE_PASS_H

#include "platform/render/gl_util.h"

struct edge_pass {
    GLuint program, no_attributes;
    GLint dark;
};

void edge_pass_open(struct gl_status *status, struct edge_pass *pass);
void edge_pass_close(struct edge_pass *pass);

/* Draws over the bound framebuffer, whose size must be the screen size of `transform`. Afterwards
 * blending is on and the scissor test is off. */
void edge_pass_draw(const struct edge_pass *pass, const struct display_transform *transform);

/* Draws a black screen. Used instead of edge_pass_draw() while the brightness is 0. */
void edge_pass_night(void);

#endif
