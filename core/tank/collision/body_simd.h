/* body_simd.h -- the bodies of SIMD_LANES fish as columns, for SIMD kernels (core/base/simd.h).
 * Each lane of a column belongs to one fish. */
#ifndef KINGYO_CORE_TANK_COLLISION_BODY_SIMD_H
#define KINGYO_CORE_TANK_COLLISION_BODY_SIMD_H

#include "core/base/simd.h"
#include "core/tank/collision/body.h"

/* Columns of SIMD_LANES bodies. The members have the names of the members of struct body. */
struct body_simd {
    flanes centre[4], right[4], up[4], back[4]; /* Columns 0 to 2 are x, y and z of the vector.
                                                   Column 3 is the float that follows the vector in
                                                   struct body: half_x_m, half_y_m, half_z_m or
                                                   margin_m. */
};

/* Loads SIMD_LANES bodies that are consecutive in memory. */
static inline void body_simd_load_block(struct body_simd *all, const struct body *first)
{
    const char *from = (const char *)first;
    simd_load_quads(all->centre, from, sizeof *first);
    simd_load_quads(all->right, from + 16u, sizeof *first);
    simd_load_quads(all->up, from + 32u, sizeof *first);
    simd_load_quads(all->back, from + 48u, sizeof *first);
}

/* Loads quad number `quad` of body fish[0]. With eight lanes, the upper four lanes are loaded from
 * body fish[4]. */
static inline flanes body_simd_row(const struct body *body, const uint32_t *fish, uint32_t quad)
{
    const size_t at = quad * sizeof(fquad);
    return simd_load_pair((const char *)&body[fish[0]] + at,
                          (const char *)&body[fish[SIMD_LANES - 4]] + at);
}

static inline void body_simd_quads(flanes column[4], const struct body *body, const uint32_t *fish,
                                   uint32_t quad)
{
    simd_turn(column, body_simd_row(body, fish, quad), body_simd_row(body, fish + 1, quad),
              body_simd_row(body, fish + 2, quad), body_simd_row(body, fish + 3, quad));
}

/* Loads the bodies of the SIMD_LANES fish in the list `fish`. The bodies need not be consecutive in
 * memory. */
static inline void body_simd_load(struct body_simd *all, const struct body *body,
                                  const uint32_t *fish)
{
    body_simd_quads(all->centre, body, fish, 0);
    body_simd_quads(all->right, body, fish, 1);
    body_simd_quads(all->up, body, fish, 2);
    body_simd_quads(all->back, body, fish, 3);
}

#endif
