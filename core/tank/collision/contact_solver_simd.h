/* contact_solver_simd.h -- contact_solver_project() for SIMD_LANES fish far from any obstacle; see
 * core/base/simd.h. */
#ifndef KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_SIMD_H
#define KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_SIMD_H

#include "core/base/simd.h"
#include "core/tank/collision/contact_solver.h"

/* Keeps the bodies of the block that begins at fish `first` within the tank, and sets their
 * `step_max_m` and `play_m`. The caller guarantees that all fish of the block swim and that none
 * gulps or is in the air. The substep must be the first of the tick. Returns one bit for each fish
 * that an obstacle could touch. The bodies of these fish are unchanged and need the full
 * contact_solver_project(). */
#define CONTACT_SOLVER_PROJECT(name)                                                               \
    uint32_t name(struct contact_solver *solver, struct broad_phase *broad_phase,                  \
                  const struct solver_context *place, uint32_t first)

SIMD_BEGIN
CONTACT_SOLVER_PROJECT(contact_solver_project_block_4);
CONTACT_SOLVER_PROJECT(contact_solver_project_block_8);
SIMD_END

#endif
