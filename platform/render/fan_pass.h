/* fan_pass.h -- the fans that hands hold over the water.
 *
 * The shadows that they cast are in the frame block (frame_block.h), for every shader that draws
 * what lies below. */
#ifndef KINGYO_PLATFORM_RENDER_FAN_PASS_H
#define KINGYO_PLATFORM_RENDER_FAN_PASS_H

#include "core/scene.h"
#include "platform/render/frame_block.h"
#include "platform/render/textures.h"

struct fan_pass {
    GLuint program, no_attributes;
    GLint pose, trim;
};

void fan_pass_open(struct gl_status *status, struct fan_pass *pass);
void fan_pass_close(struct fan_pass *pass);

/* Over everything else of the stall; blends, and wants no depth. */
void fan_pass_draw(const struct fan_pass *pass, const struct scene *scene,
                   const struct textures *textures);

#endif
