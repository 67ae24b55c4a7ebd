/* part.c -- position-based separation of what the look found near. */
#include "core/tank/part.h"

#include "core/input.h"

#define SKIN_M 0.0001f          /* What parting leaves between two bodies. */
#define PART_ROUNDS_MAX 12      /* Most ticks need two; a shoved crowd uses them all. */
#define CLEAR_STEP_MIN_M 0.002f /* A tick: what even a resting obstacle gives way by. */
#define TOPPLE_ROUND 5          /* What four rounds could not part is jammed. */
#define PART_STEP_MAX_M 0.002f  /* A round. */
#define CLEAR_STEP_MAX_M 0.012f /* A tick; a poi at 1.4 m/s shoves no harder. */
#define SHOVE_MAX_M 0.003f      /* A tick, beyond its own motion: more would look like a jump. */

struct parting {
    struct part *part;
    struct crowd *crowd;
    const struct part_place *place;
};

static void keep_inside(const struct parting *all, uint32_t index)
{
    struct body *body = &all->crowd->body[index];
    const vec3 extent = body_extent_m(body);
    const vec3 low = v3_add(all->place->bounds.low_m, extent),
               high = v3_sub(all->place->bounds.high_m, extent);
    vec3 *p = &body->centre_m;
    p->x = f_clamp(p->x, low.x, high.x);
    p->z = f_clamp(p->z, low.z, high.z);
    p->y = f_max(p->y, low.y);
    if (!(all->crowd->flags[index] & CROWD_AIRBORNE)) {
        const float out_m = all->crowd->flags[index] & CROWD_GULPS ? 2.0f * body->half_y_m : 0.0f;
        p->y = f_min(p->y, high.y + out_m);
    }
}

/* Moves it as far as its step allows, and returns what is left. Back to where it came from it may
 * go, however hard it ran into others. */
static vec3 shove(const struct parting *all, uint32_t index, vec3 move)
{
    struct body *body = &all->crowd->body[index];
    const vec3 wanted = v3_add(body->centre_m, move);
    body->centre_m = wanted;
    if (all->place->before_m) {
        const vec3 before = all->place->before_m[index];
        const vec3 step = v3_limit(v3_sub(wanted, before), all->part->step_max_m[index]);
        body->centre_m = v3_add(before, step);
    }
    const vec3 left = v3_sub(wanted, body->centre_m);
    keep_inside(all, index);
    return left;
}

/* A stack of fish that fills the water from floor to surface cannot be parted upward: it topples.
 */
static vec3 topple(const struct body *a, const struct body *b, vec3 axis)
{
    vec3 aside = v3_sub(b->centre_m, a->centre_m);
    aside.y = 0.0f;
    return v3_normalize_or(v3_mad(v3_scale(axis, 0.5f), v3_normalize_or(aside, a->right), 1.0f),
                           axis);
}

static float mass_of(const struct body *body)
{
    return body->half_z_m * body->half_z_m * body->half_z_m;
}

/* Whether the pair had to be parted. */
static int part_pair(const struct parting *all, const struct contact *contact, int round)
{
    const struct body *a = &all->crowd->body[contact->a], *b = &all->crowd->body[contact->b];
    const struct box box_a = body_box(a), box_b = body_box(b);
    struct box_gap gap = box_gap(&box_a, SKIN_M, &box_b, SKIN_M);
    if (gap.space_m > 0.0f || gap.body_m >= 0.0f) {
        return 0;
    }
    if (round >= TOPPLE_ROUND && f_abs(gap.axis.y) > 0.7f) {
        gap.axis = topple(a, b, gap.axis);
    }
    const float depth_m = f_min(SKIN_M - gap.body_m, PART_STEP_MAX_M);
    const float share_a = mass_of(b) / (mass_of(a) + mass_of(b));
    const vec3 part = v3_scale(gap.axis, depth_m);
    const vec3 left_a = shove(all, contact->a, v3_scale(part, -share_a));
    const vec3 left_b = shove(all, contact->b, v3_sub(v3_scale(part, 1.0f - share_a), left_a));
    /* Who cannot give way leaves it to the other. */
    shove(all, contact->a, v3_scale(left_b, -1.0f));
    return 1;
}

static void clear_obstacles(const struct parting *all, uint32_t index)
{
    struct body *body = &all->crowd->body[index];
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        const struct obstacle *obstacle = &all->place->obstacles[o];
        const struct box box = body_box(body);
        const vec3 move = obstacle_clear(obstacle, &box);
        if (v3_dot(move, move) > 0.0f) {
            const float rush_m = 2.0f * CORE_TICK_S * v3_length(obstacle->velocity_m_s);
            const float step_m = f_clamp(rush_m, CLEAR_STEP_MIN_M, CLEAR_STEP_MAX_M);
            float *step_max_m = &all->part->step_max_m[index];
            *step_max_m = f_max(*step_max_m, step_m);
            body->centre_m = v3_add(body->centre_m, v3_limit(move, step_m));
        }
    }
    keep_inside(all, index);
}

/* A body beside an obstacle must not be shoved into it. */
static void clear_if_beside(const struct parting *all, uint32_t index)
{
    if (all->crowd->flags[index] & CROWD_BESIDE) {
        clear_obstacles(all, index);
    }
}

static void look_beside(const struct parting *all, uint32_t index)
{
    const struct box box = body_box(&all->crowd->body[index]);
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        if (obstacle_in_reach(&all->place->obstacles[o], &box)) {
            all->crowd->flags[index] |= CROWD_BESIDE;
        }
    }
}

void part_clear(struct part *part, struct crowd *crowd, const struct part_place *place)
{
    const struct parting all = { part, crowd, place };
    for (uint32_t i = 0; i < crowd->count; i++) {
        if (crowd->flags[i] & CROWD_SWIMS) {
            const vec3 moved = place->before_m
                                   ? v3_sub(crowd->body[i].centre_m, place->before_m[i])
                                   : v3(0.0f, 0.0f, 0.0f);
            part->step_max_m[i] = v3_length(moved) + SHOVE_MAX_M;
            look_beside(&all, i);
            clear_if_beside(&all, i);
            keep_inside(&all, i);
        }
    }
}

void part_bodies(struct part *part, struct crowd *crowd, const struct part_place *place)
{
    const struct parting all = { part, crowd, place };
    uint32_t parted = 1;
    for (int round = 0; round < PART_ROUNDS_MAX && parted > 0; round++) {
        parted = 0;
        for (uint32_t c = 0; c < crowd->contact_count; c++) {
            if (part_pair(&all, &crowd->contact[c], round)) {
                clear_if_beside(&all, crowd->contact[c].a);
                clear_if_beside(&all, crowd->contact[c].b);
                parted++;
            }
        }
    }
}
