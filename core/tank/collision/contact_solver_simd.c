/* contact_solver_simd.c -- keeps a block of fish within walls, floor and surface. The file is the
 * SIMD form of a part of contact_solver.c. */
#include "core/tank/collision/contact_solver_internal.h"

#include "core/base/panic.h"
#include "core/base/simd_vec.h"
#include "core/tank/collision/narrow_phase_simd.h"

_Static_assert(sizeof(struct angles) == 12u && sizeof(vec3) == 12u, "three floats, side by side");

static inline flanes keep_between(const struct body_simd *all, int axis, float low_m, float high_m)
{
    /* For each lane, `extent` is half the size of the body's axis-aligned bounding box along the
     * world axis `axis`, as in body_extent_m(). */
    const flanes extent = simd_abs(all->right[axis]) * all->centre[3] +
                          simd_abs(all->up[axis]) * all->right[3] +
                          simd_abs(all->back[axis]) * all->up[3];
    return simd_clamp(all->centre[axis], low_m + extent, high_m - extent);
}

/* Returns, for each lane, the largest distance that any point of a body moved by rotation alone,
 * m. */
static inline flanes sweep_m(const struct body_simd *all, const struct fish *fish,
                             const struct angles *began)
{
    flanes now[4], was[4];
    simd_load_quads(now, &fish->angles, sizeof *fish);
    simd_load_quads(was, began, sizeof *began);
    const flanes yaw = simd_abs(now[0] - was[0]);
    const flanes turn =
        simd_min(yaw, F_TAU - yaw) + simd_abs(now[1] - was[1]) + simd_abs(now[2] - was[2]);
    return turn * (all->up[3] + all->right[3]);
}

CONTACT_SOLVER_PROJECT(SIMD_NAME(contact_solver_project_block))
{
    CORE_ASSERT(solver->substep == 0);
    CORE_ASSERT(first + SIMD_LANES <= broad_phase->count);
    const vec3 low = place->bounds.low_m, high = place->bounds.high_m;
    struct body_simd all;
    flanes began[4];
    body_simd_load_block(&all, &broad_phase->body[first]);
    simd_load_quads(began, &solver->began_m[first], sizeof solver->began_m[0]);
    ilanes beside = { 0 };
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        /* Does the test of obstacle_in_reach() for all lanes at once. `beside` is a mask of the
         * lanes that pass the test. */
        const struct simd_v3 half = { all.centre[3], all.right[3], all.up[3] };
        const struct simd_v3 d = { all.centre[0] - place->obstacles[o].centre_m.x,
                                   all.centre[1] - place->obstacles[o].centre_m.y,
                                   all.centre[2] - place->obstacles[o].centre_m.z };
        const flanes reach_m =
            place->obstacles[o].radius_m + simd_v3_length(half) + OBSTACLE_REACH_M;
        beside |= simd_v3_dot(d, d) < reach_m * reach_m;
    }
    const struct simd_v3 from = { began[0], began[1], began[2] };
    const struct simd_v3 at = { all.centre[0], all.centre[1], all.centre[2] };
    const struct simd_v3 kept = { keep_between(&all, 0, low.x, high.x),
                                  keep_between(&all, 1, low.y, high.y),
                                  keep_between(&all, 2, low.z, high.z) };
    const flanes step_max_m = simd_v3_length(simd_v3_sub(at, from)) + place->push_max_m;
    const flanes way_m = simd_v3_length(simd_v3_sub(kept, from));
    const flanes sweep = sweep_m(&all, &place->fish[first], &solver->began_angles[first]);
    simd_store(&solver->step_max_m[first], step_max_m);
    simd_store(&broad_phase->play_m[first], step_max_m + way_m + sweep);
    const flanes centre[4] = { simd_select(beside, at.x, kept.x), simd_select(beside, at.y, kept.y),
                               simd_select(beside, at.z, kept.z), all.centre[3] };
    simd_store_quads(&broad_phase->body[first], sizeof broad_phase->body[0], centre);
    return simd_bits(beside);
}
