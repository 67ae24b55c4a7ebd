/* contact_solver_steps.c -- divides a tick of the contact solver into substeps, and ends the
 * tick. */
#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/collision/contact_solver.h"

/* Largest motion of an obstacle in a substep. The ring of a poi (the paper scoop) and a fish
 * together are four times as thick as this distance. Therefore the ring cannot jump over the fish
 * within one substep. */
#define SUBSTEP_M 0.003f
/* Largest number of substeps in a tick of 1/120 s. A poi (paper scoop) that moves at 2.1 m/s needs
 * this number of substeps. In the substeps of a faster poi, the poi moves farther than
 * SUBSTEP_M. */
#define SUBSTEPS_MAX 6u

void contact_solver_begin(struct contact_solver *solver, const struct fish *fish,
                          uint32_t fish_count)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < fish_count; i++) {
        solver->began_m[i] = fish[i].position_m;
        solver->began_angles[i] = fish[i].angles;
    }
}

uint32_t contact_solver_substep_count(struct contact_solver *solver,
                                      const struct solver_context *place)
{
    CORE_ASSERT(place->obstacle_count <= TANK_OBSTACLE_MAX);
    CORE_ASSERT(place->obstacles || place->obstacle_count == 0);
    float longest_m = 0.0f;
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        struct obstacle *obstacle = &place->obstacles[o];
        const vec3 from_m = v3_sub(obstacle->centre_m, obstacle->step_m);
        solver->course[o] = (struct course){ from_m, obstacle->step_m, obstacle->turned };
        longest_m = f_max(longest_m, v3_length(obstacle->step_m));
    }
    solver->reverted_count = 0;
    solver->reverts_angles = false;
    solver->substep_count = 1u + (uint32_t)f_min(longest_m / SUBSTEP_M, (float)(SUBSTEPS_MAX - 1u));
    return solver->substep_count;
}

/* Begins a substep. Each obstacle moves by its part of the tick's motion, but rotates only in the
 * first substep (number 0). */
void contact_solver_substep(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place, uint32_t substep)
{
    CORE_ASSERT(substep < solver->substep_count);
    solver->substep = substep;
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        struct obstacle *obstacle = &place->obstacles[o];
        if (substep == 0) {
            obstacle->centre_m = solver->course[o].from_m;
        } else {
            obstacle->turned = false;
        }
        obstacle->step_m = v3_scale(solver->course[o].step_m, 1.0f / (float)solver->substep_count);
        obstacle->centre_m = v3_add(obstacle->centre_m, obstacle->step_m);
        obstacle->reaction_count = 0;
    }
    if (substep > 0) {
        broad_phase_sync(broad_phase, place->fish);
        for (uint32_t i = 0; i < broad_phase->count; i++) {
            solver->step_began_m[i] = place->fish[i].position_m;
        }
    }
}

void contact_solver_write_back(const struct broad_phase *broad_phase, struct fish *fish)
{
    CORE_ASSERT(broad_phase->count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        if (broad_phase->flags[i] & BODY_SWIMMING) {
            fish[i].position_m = broad_phase->body[i].centre_m;
        }
    }
}

void contact_solver_end(struct contact_solver *solver, const struct broad_phase *broad_phase,
                        const struct solver_context *place)
{
    CORE_ASSERT(place->obstacle_count <= TANK_OBSTACLE_MAX);
    for (uint32_t i = 0; i < broad_phase->count && solver->reverts_angles; i++) {
        if (broad_phase->flags[i] & BODY_REVERTED) {
            CORE_ASSERT(broad_phase->flags[i] & BODY_SWIMMING);
            place->fish[i].angles = solver->began_angles[i];
            place->fish[i].yaw_rate_rad_s = 0.0f;
        }
    }
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        struct obstacle *obstacle = &place->obstacles[o];
        const struct course *course = &solver->course[o];
        /* reentry.c computes the previous position of the obstacle from `step_m`. Therefore
         * `step_m` becomes the motion of the whole tick. An obstacle whose motion the solver undid
         * loses velocity. */
        obstacle->step_m = v3_sub(obstacle->centre_m, course->from_m);
        obstacle->turned = course->turned && !(obstacle->reaction & REACTION_ROTATION);
        if (obstacle->reaction & REACTION_POSITION) {
            const vec3 lost_m = v3_sub(course->step_m, obstacle->step_m);
            obstacle->velocity_m_s =
                v3_muladd(obstacle->velocity_m_s, lost_m, -(float)CORE_TICK_HZ);
        }
    }
}
