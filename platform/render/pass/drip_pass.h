/* drip_pass.h -- draws the drops that fall from a wet poi (the paper scoop) held over the water. */
#ifndef KINGYO_PLATFORM_RENDER_PASS_DRIP_PASS_H
#define KINGYO_PLATFORM_RENDER_PASS_DRIP_PASS_H

#include "core/scene.h"
#include "platform/render/gl_util.h"

struct drip_pass {
    GLuint program, no_attributes;
    GLint lip;
};

void drip_pass_open(struct gl_status *status, struct drip_pass *pass);
void drip_pass_close(struct drip_pass *pass);

/* Draws the drops into a render target with depth. Call after the bowls and before the pois. Draws
 * nothing if every poi is dry or in the water. */
void drip_pass_draw(const struct drip_pass *pass, const struct scene *scene);

#endif
