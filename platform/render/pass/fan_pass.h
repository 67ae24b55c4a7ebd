/* fan_pass.h -- draws the hand-held fans that the players hold over the water.
 *
 * The frame block (frame_block.h) contains the fans' shadows, so that every shader that draws
 * objects below the fans can apply them. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_FAN_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_FAN_PASS_H

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/textures.h"

struct fan_pass {
    GLuint program, no_attributes;
    GLint pose, trim;
};

void fan_pass_open(struct gl_status *status, struct fan_pass *pass);
void fan_pass_close(struct fan_pass *pass);

/* Draws the hand-held fans over all other objects of the scene, with blending. The render target
 * needs no depth buffer. */
void fan_pass_draw(const struct fan_pass *pass, const struct scene *scene,
                   const struct textures *textures);

#endif
