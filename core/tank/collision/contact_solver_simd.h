/* contact_solver_simd.h -- contact_solver_project() for LANES fish far from any obstacle; see
 * core/base/simd.h. */
#ifndef KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_SIMD_H
#define KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_SIMD_H

#include "core/base/simd.h"
#include "core/tank/collision/contact_solver.h"

/* Keeps the block that begins at `first` within bounds and sets the allowance of each body. All
 * fish of the block swim, and none gulps or is in the air. The substep is the first of the tick.
 * Returns one bit for each fish that an obstacle could touch. The flagged fish are unchanged and
 * need the full contact_solver_project(). */
#define CONTACT_SOLVER_PROJECT(name)                                                               \
    uint32_t name(struct contact_solver *solver, struct broad_phase *broad_phase,                  \
                  const struct solver_context *place, uint32_t first)

SIMD_BEGIN
CONTACT_SOLVER_PROJECT(contact_solver_project_block_4);
CONTACT_SOLVER_PROJECT(contact_solver_project_block_8);
SIMD_END

#endif
