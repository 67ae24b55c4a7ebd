/* body_lanes.h -- LANES bodies as columns, for SIMD kernels (core/base/lanes.h). */
#ifndef KINGYO_CORE_TANK_BODY_LANES_H
#define KINGYO_CORE_TANK_BODY_LANES_H

#include "core/base/lanes.h"
#include "core/tank/body.h"

/* The columns of LANES bodies; the names are those of struct body. */
struct bodies {
    flanes centre[4], right[4], up[4], back[4]; /* x, y, z of the vector; [3] is a half size or the
                                                   margin. */
};

/* Loads LANES bodies that are consecutive in memory. */
static inline void bodies_load_block(struct bodies *all, const struct body *first)
{
    const char *from = (const char *)first;
    lanes_load_quads(all->centre, from, sizeof *first);
    lanes_load_quads(all->right, from + 16u, sizeof *first);
    lanes_load_quads(all->up, from + 32u, sizeof *first);
    lanes_load_quads(all->back, from + 48u, sizeof *first);
}

/* Loads quad `quad` of fish[0]. With eight lanes the second half is the quad of fish[4]. */
static inline flanes bodies_row(const struct body *body, const uint32_t *fish, uint32_t quad)
{
    const size_t at = quad * sizeof(fquad);
    return lanes_load_beside((const char *)&body[fish[0]] + at,
                             (const char *)&body[fish[LANES - 4]] + at);
}

static inline void bodies_quads(flanes column[4], const struct body *body, const uint32_t *fish,
                                uint32_t quad)
{
    lanes_turn(column, bodies_row(body, fish, quad), bodies_row(body, fish + 1, quad),
               bodies_row(body, fish + 2, quad), bodies_row(body, fish + 3, quad));
}

/* Loads the bodies of LANES fish in a list, at any place in memory. */
static inline void bodies_load(struct bodies *all, const struct body *body, const uint32_t *fish)
{
    bodies_quads(all->centre, body, fish, 0);
    bodies_quads(all->right, body, fish, 1);
    bodies_quads(all->up, body, fish, 2);
    bodies_quads(all->back, body, fish, 3);
}

#endif
