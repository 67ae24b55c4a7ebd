/* air_pass.h -- draws the air stone on the tank's floor, and its bubbles while the air pump
 * runs. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_AIR_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_AIR_PASS_H

#include "core/scene.h"
#include "platform/render/gl_util.h"

struct air_pass {
    GLuint program, no_attributes;
    GLint stone;
};

void air_pass_open(struct gl_status *status, struct air_pass *pass);
void air_pass_close(struct air_pass *pass);

/* Draws the air stone and its bubbles into a render target with depth. Call after all opaque
 * objects have been drawn. Draws nothing if the tank has no air stone. */
void air_pass_draw(const struct air_pass *pass, const struct scene *scene);

#endif
