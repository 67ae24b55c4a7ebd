/* parting.h -- what part.c and judge.c share, and nobody else. */
#ifndef KINGYO_CORE_TANK_PARTING_H
#define KINGYO_CORE_TANK_PARTING_H

#include "core/tank/part.h"
#include "core/tank/rim.h"

#define PARTING_ROUNDING_M 1e-6f /* By which the same pose may seem deeper. */

/* One step of a tick. */
struct parting {
    struct part *part;
    struct crowd *crowd;
    const struct part_place *place;
};

/* Where it may go back to: where the step began. */
static inline vec3 parting_before_m(const struct parting *all, uint32_t index)
{
    const struct part *part = all->part;
    return part->station == 0 ? part->began_m[index] : part->step_began_m[index];
}

/* The body in the pose that it may go back to. Bodies turn in the first step only. */
static inline struct body parting_before(const struct parting *all, uint32_t index)
{
    const struct part *part = all->part;
    struct body body = all->crowd->body[index];
    body.centre_m = parting_before_m(all, index);
    if (part->station == 0) {
        const struct basis axes = basis_from_angles(part->began_angles[index]);
        body.right = axes.right;
        body.up = axes.up;
        body.back = axes.back;
    }
    return body;
}

/* Whether what two bodies have come since the look leaves more than `apart_m` of their gap: then it
 * need not be measured. */
static inline int parting_is_apart(const struct parting *all, const struct contact *contact,
                                   float apart_m)
{
    const float *way_m = all->crowd->way_m;
    return contact->gap_m - (way_m[contact->a] + way_m[contact->b]) > apart_m;
}

static inline int parting_is_clear(const struct obstacle *obstacle, const struct body *body,
                                   const struct body *before)
{
    vec3 unused;
    return rim_excess_m(obstacle, body, before, PART_FREE_M, &unused) <= PARTING_ROUNDING_M;
}

/* How far any point of a body goes by turning alone, at most. */
static inline float parting_sweep_m(const struct parting *all, uint32_t index)
{
    const struct angles now = all->place->fish[index].angles,
                        was = all->part->began_angles[index];
    const float yaw_rad = f_abs(now.yaw_rad - was.yaw_rad);
    const float turn_rad = f_min(yaw_rad, F_TAU - yaw_rad) +
                           f_abs(now.pitch_rad - was.pitch_rad) +
                           f_abs(now.roll_rad - was.roll_rad);
    const struct body *body = &all->crowd->body[index];
    return all->part->station == 0 ? turn_rad * (body->half_z_m + body->half_y_m) : 0.0f;
}

/* Where a body of this fish would be within walls, floor and surface; in part.c. */
vec3 parting_kept_inside_m(const struct parting *all, uint32_t index, const struct body *body);

/* After the pushes: who is too deep in another or in an obstacle goes back or along with it, or the
 * obstacle gives way, until nobody is. `is_parted`: the pushes left no two fish in each other. In
 * judge.c. */
void parting_judge(const struct parting *all, int is_parted);

#endif
