/* bowl_pass.h -- draws the floating bowls and their water. fish_pass.h draws the fish in the
 * bowls. */
#pragma once

#include "core/scene.h"
#include "platform/render/shape.h"

struct bowl_part {
    GLuint program;
    GLint mouth, form, paint, heel;
};

struct bowl_pass {
    struct bowl_part inside_part, hull_part, cap_part, water_part;
    struct shape_buffers shell, disc;
    /* Position of the hull's first entry in the index buffer. The entries before it are the inside
     * of the bowl. The hull is the outside and the lip of the bowl's shell. */
    uint32_t hull_first;
    /* True if the bowls are classic white, and false if they have bands in the colours of the
     * players. True also for a white bowl without a line, which is the bowl of a player who plays
     * alone. */
    bool is_white, is_plain;
};

void bowl_pass_open(struct gl_status *status, struct bowl_pass *pass);
void bowl_pass_close(struct bowl_pass *pass);

/* Chooses the look of the bowls of the frame. White bowls of several players have a thin line in
 * the colour of the player. */
void bowl_pass_prepare(struct bowl_pass *pass, const struct scene *scene, bool is_white);

/* Draws the inside of the bowl's enamelled shell. */
void bowl_pass_inside(const struct bowl_pass *pass, const struct scene_bowl *bowl, GLuint caustics);
/* Draws the outside and the lip of the bowl's enamelled shell. */
void bowl_pass_hull(const struct bowl_pass *pass, const struct scene_bowl *bowl);
/* Draws the surface of the water in the bowl. */
void bowl_pass_water(const struct bowl_pass *pass, const struct scene_bowl *bowl);
/* Writes a depth just above the tank's water surface where the viewer looks into the bowl's mouth.
 * Must be called after the contents of the bowl and before the tank's water surface are drawn. The
 * tank's water then does not cover the contents, although the contents are lower than this
 * water. */
void bowl_pass_cap(const struct bowl_pass *pass, const struct scene_bowl *bowl);
