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
    struct bowl_part shell_part, hole_part, water_part;
    struct shape_buffers shell, disc;
    /* Position of the hull's first entry in the index buffer. The hull is the outside and the lip
     * of the bowl's shell. The hull's entries are the last ones of the buffer. */
    uint32_t hull_first;
};

void bowl_pass_open(struct gl_status *status, struct bowl_pass *pass);
void bowl_pass_close(struct bowl_pass *pass);

/* Removes the tank's water surface from the depth buffer inside the bowl's mouth. */
void bowl_pass_hole(const struct bowl_pass *pass, const struct scene_bowl *bowl);
/* Draws the bowl's enamelled shell. If `is_hull` is true, draws only the outside and the lip,
 * because the picture of the objects below the water surface needs no more. Otherwise also draws
 * the inside, which the picture of the objects above the surface needs. */
void bowl_pass_shell(const struct bowl_pass *pass, const struct scene_bowl *bowl, GLuint caustics,
                     bool is_hull);
/* Draws the surface of the water in the bowl. */
void bowl_pass_water(const struct bowl_pass *pass, const struct scene_bowl *bowl);
