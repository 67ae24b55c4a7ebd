/* contact_solver_internal.h -- declarations that contact_solver.c, contact_solver_simd.c and
 * penetration_check.c share. */
#pragma once

#include "core/base/simd.h"
#include "core/tank/collision/contact_solver.h"
#include "core/tank/collision/obstacle.h"

/* Tolerance for rounding errors. A measured penetration can grow by up to this depth although no
 * body moved. */
#define SOLVER_ROUNDING_M 1e-6f

/* Data that the functions of the contact solver share in one substep of a tick. */
struct solver_step {
    struct contact_solver *solver;
    struct broad_phase *broad_phase;
    const struct solver_context *place;
};

/* Returns the position of a fish at the start of the substep. The solver may move the fish back to
 * this position. */
static inline vec3 contact_before_m(const struct solver_step *all, uint32_t index)
{
    const struct contact_solver *solver = all->solver;
    return solver->substep == 0 ? solver->began_m[index] : solver->step_began_m[index];
}

/* Returns the body of a fish in its pose at the start of the substep. The solver may move the fish
 * back to this pose. Bodies rotate only in the first substep (number 0). */
static inline struct body contact_body_before(const struct solver_step *all, uint32_t index)
{
    const struct contact_solver *solver = all->solver;
    struct body body = all->broad_phase->body[index];
    body.centre_m = contact_before_m(all, index);
    if (solver->substep == 0) {
        const struct basis axes = vec_basis_from_angles(solver->began_angles[index]);
        body.right = axes.right;
        body.up = axes.up;
        body.back = axes.back;
    }
    return body;
}

/* Returns true if the gap between the two bodies of a contact is certainly larger than `apart_m`.
 * Measuring the gap would take long, so the function uses a lower bound: the gap at the last
 * broad-phase query minus the distances that the two bodies moved since then. */
static inline bool contact_is_apart(const struct solver_step *all, const struct contact *contact,
                                    float apart_m)
{
    const float *way_m = all->broad_phase->way_m;
    return contact->gap_m - (way_m[contact->a] + way_m[contact->b]) > apart_m;
}

static inline bool contact_is_clear(const struct obstacle *obstacle, const struct body *body,
                                    const struct body *before)
{
    vec3 unused;
    return obstacle_excess_m(obstacle, body, before, SOLVER_FREE_M, &unused) <= SOLVER_ROUNDING_M;
}

/* Returns the largest distance that any point of a body moved in this substep by rotation alone,
 * m. */
static inline float contact_sweep_m(const struct solver_step *all, uint32_t index)
{
    const struct angles now = all->place->fish[index].angles;
    const struct angles was = all->solver->began_angles[index];
    const float yaw_rad = f_abs(now.yaw_rad - was.yaw_rad);
    const float turn_rad = f_min(yaw_rad, F_TAU - yaw_rad) + f_abs(now.pitch_rad - was.pitch_rad) +
                           f_abs(now.roll_rad - was.roll_rad);
    const struct body *body = &all->broad_phase->body[index];
    return all->solver->substep == 0 ? turn_rad * (body->half_z_m + body->half_y_m) : 0.0f;
}

/* Returns the nearest centre at which the body of fish `index` is within walls, floor and surface.
 * Defined in contact_solver.c. */
vec3 contact_kept_inside_m(const struct solver_step *all, uint32_t index, const struct body *body);

/* Runs the penetration check after the pushes, until no fish is too deep in another fish or in an
 * obstacle. If a fish is too deep, the fish returns to its previous pose or moves along with the
 * obstacle, or the check undoes a part of the obstacle's motion. `is_parted` is true if no two fish
 * overlap after the pushes. Defined in penetration_check.c. */
void penetration_check(const struct solver_step *all, bool is_parted);

/* SIMD form of a part of contact_solver_project(), for a block of consecutive fish that begins with
 * fish `first`. Moves the bodies into the tank, and sets their `step_max_m` and `play_m`.
 *
 * The caller guarantees that all fish of the block swim and that none gulps or is in the air, and
 * that the substep is the first of the tick. Returns one bit for each fish that an obstacle could
 * touch. The function does not move the bodies of these fish, for which the caller must run the
 * complete contact_solver_project(). */
#define CONTACT_SOLVER_PROJECT(name)                                                               \
    uint32_t name(struct contact_solver *solver, struct broad_phase *broad_phase,                  \
                  const struct solver_context *place, uint32_t first)

SIMD_BEGIN
CONTACT_SOLVER_PROJECT(contact_solver_project_block_4);
CONTACT_SOLVER_PROJECT(contact_solver_project_block_8);
SIMD_END
