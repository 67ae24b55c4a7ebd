/* contact_solver.c -- the contact solver: rounds of small pushes, followed by the penetration check
 * (penetration_check.c). */
#include "core/tank/collision/contact_solver.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/tank/collision/contact_solver_internal.h"

/* Thickness of the skin around a body: the gap that the contact solver leaves between two bodies
 * that it separates. */
#define SKIN_M 0.0001f
/* Largest number of rounds in a substep; each round pushes every overlapping pair apart. Most ticks
 * need two rounds. A dense group of fish that a poi pushes needs all rounds. */
#define PART_ROUNDS_MAX 12
/* First round of the contact solver in which nearly vertical pushes are tilted sideways. A pair
 * that still overlaps in this round can be part of a stack of fish between floor and surface.
 * Vertical pushes cannot separate such a stack, but tilted pushes topple the stack. */
#define TOPPLE_ROUND 5
#define PART_STEP_MAX_M 0.002f /* Largest push of a body in one round of the contact solver. */
#define CLEAR_ROUNDS 4u
/* Capacity of struct close: number of contacts whose gaps are measured together by SIMD code. */
#define CLOSE_MAX 64u

vec3 contact_kept_inside_m(const struct solver_step *all, uint32_t index, const struct body *body)
{
    CORE_ASSERT(index < all->broad_phase->count);
    const struct tank_bounds *bounds = &all->place->bounds;
    const float reach_m = body->half_x_m + body->half_y_m + body->half_z_m;
    const vec3 beyond_low = v3_sub(body->centre_m, bounds->low_m);
    const vec3 below_high = v3_sub(bounds->high_m, body->centre_m);
    /* A body that is farther than `reach_m` from all walls, the floor and the surface touches none
     * of them in any orientation. */
    if (beyond_low.x > reach_m && below_high.x > reach_m && beyond_low.y > reach_m &&
        below_high.y > reach_m && beyond_low.z > reach_m && below_high.z > reach_m) {
        return body->centre_m;
    }
    const vec3 extent = body_extent_m(body);
    const vec3 low = v3_add(bounds->low_m, extent), high = v3_sub(bounds->high_m, extent);
    const uint8_t flags = all->broad_phase->flags[index];
    vec3 p = body->centre_m;
    p.x = f_clamp(p.x, low.x, high.x);
    p.z = f_clamp(p.z, low.z, high.z);
    p.y = f_max(p.y, low.y);
    if (!(flags & BODY_AIRBORNE)) {
        const float out_m = flags & BODY_GULPING ? 2.0f * body->half_y_m : 0.0f;
        p.y = f_min(p.y, high.y + out_m);
    }
    return p;
}

static void keep_inside(const struct solver_step *all, uint32_t index)
{
    struct body *body = &all->broad_phase->body[index];
    body->centre_m = contact_kept_inside_m(all, index, body);
}

/* Moves a fish to the position of its body after a push of that body. Adds the distance to `way_m`,
 * the distance that the body moved since the last broad-phase query, so that contact_is_apart()
 * takes the push into account. */
static void note_moved_body(const struct solver_step *all, uint32_t index)
{
    CORE_ASSERT(all->broad_phase->flags[index] & BODY_SWIMMING);
    struct fish *fish = &all->place->fish[index];
    const vec3 centre_m = all->broad_phase->body[index].centre_m;
    all->broad_phase->way_m[index] += v3_length(v3_sub(centre_m, fish->position_m));
    fish->position_m = centre_m;
}

/* Moves a body by `move`. If the body would then be farther than `step_max_m` from its position at
 * the start of the substep, the function shortens the move. Returns the part of `move` by which the
 * body could not move. */
static vec3 move_body_limited(const struct solver_step *all, uint32_t index, vec3 move)
{
    struct body *body = &all->broad_phase->body[index];
    const vec3 wanted = v3_add(body->centre_m, move);
    const vec3 before = contact_before_m(all, index);
    const vec3 step = v3_limit(v3_sub(wanted, before), all->solver->step_max_m[index]);
    body->centre_m = v3_add(before, step);
    const vec3 left = v3_sub(wanted, body->centre_m);
    keep_inside(all, index);
    note_moved_body(all, index);
    return left;
}

static float mass_of(const struct body *body)
{
    return body->half_z_m * body->half_z_m * body->half_z_m;
}

/* Stores the measured gap `apart_m` of a contact. The gap need not be measured again until the two
 * bodies have moved so far that they could touch. */
static void contact_store_gap(const struct solver_step *all, struct contact *contact, float apart_m)
{
    const float *way_m = all->broad_phase->way_m;
    const float gap_m = apart_m - SOLVER_ROUNDING_M + (way_m[contact->a] + way_m[contact->b]);
    contact->gap_m = f_max(contact->gap_m, gap_m);
}

/* Moves the two bodies of a contact apart if the bodies overlap. Returns true if the bodies
 * overlapped. */
static bool part_pair(const struct solver_step *all, struct contact *contact, int round)
{
    CORE_ASSERT(contact->a != contact->b);
    const struct body *a = &all->broad_phase->body[contact->a],
                      *b = &all->broad_phase->body[contact->b];
    struct box_gap gap = body_gap(a, 0.0f, b, 0.0f);
    if (gap.body_m >= 0.0f) {
        contact_store_gap(all, contact, gap.body_m);
        return false;
    }
    if (round >= TOPPLE_ROUND && f_abs(gap.axis.y) > 0.7f) {
        /* One body of the pair lies on top of the other body. A stack of fish from floor to surface
         * cannot be separated vertically, so the separation axis is tilted and the stack
         * topples. */
        const vec3 aside = v3_flat(v3_sub(b->centre_m, a->centre_m));
        const vec3 tilted =
            v3_muladd(v3_scale(gap.axis, 0.5f), v3_normalize_or(aside, a->right), 1.0f);
        gap.axis = v3_normalize_or(tilted, gap.axis);
    }
    const float depth_m = f_min(SKIN_M - gap.body_m, PART_STEP_MAX_M);
    const float share_a = mass_of(b) / (mass_of(a) + mass_of(b));
    const vec3 solver = v3_scale(gap.axis, depth_m);
    const vec3 left_a = move_body_limited(all, contact->a, v3_scale(solver, -share_a));
    const vec3 left_b =
        move_body_limited(all, contact->b, v3_sub(v3_scale(solver, 1.0f - share_a), left_a));
    /* If the second fish could not move as far as intended, the first fish also moves by the
     * distance that is missing. */
    move_body_limited(all, contact->a, v3_scale(left_b, -1.0f));
    return true;
}

/* Moves a fish that touches an obstacle off the obstacle by at most CLEAR_ROUNDS pushes. One push
 * is not always enough: in the corner between the paper and the ring of a poi (paper scoop), a push
 * off the paper can move the fish into the ring. If the fish still touches the obstacle after the
 * pushes, moves the fish along with the obstacle. */
static void clear_obstacle(const struct solver_step *all, uint32_t index, uint32_t o)
{
    CORE_ASSERT(o < all->place->obstacle_count);
    const struct obstacle *obstacle = &all->place->obstacles[o];
    struct body *body = &all->broad_phase->body[index];
    const struct body before = contact_body_before(all, index);
    for (uint32_t k = 0; k < CLEAR_ROUNDS; k++) {
        const vec3 hard = obstacle_hard_push(obstacle, body);
        const vec3 paper = obstacle_paper_push(obstacle, body, contact_before_m(all, index));
        const vec3 move = v3_dot(hard, hard) > 0.0f ? hard : paper;
        if (v3_dot(move, move) == 0.0f) {
            return;
        }
        all->solver->result[index] = (uint8_t)(SOLVER_PRESSED + o);
        move_body_limited(all, index, move);
        if (contact_is_clear(obstacle, body, &before)) {
            return;
        }
    }
    struct body carried = *body;
    carried.centre_m = obstacle_carry_m(obstacle, before.centre_m);
    if (contact_is_clear(obstacle, &carried, &before)) {
        body->centre_m = carried.centre_m;
        keep_inside(all, index);
    }
}

/* Moves a body off the obstacles near it. Called after a push by another fish, which may have
 * driven the body into an obstacle. */
static void clear_if_beside(const struct solver_step *all, uint32_t index)
{
    if (all->broad_phase->flags[index] & BODY_NEAR_OBSTACLE) {
        for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
            clear_obstacle(all, index, o);
        }
    }
}

/* List of contacts whose gaps must be measured again, because the two bodies may have approached
 * each other since the last measurement. SIMD code measures several gaps of the list at a time. */
struct close {
    uint32_t count;
    uint32_t contact[CLOSE_MAX];
    fish_index a[CLOSE_MAX + SIMD_LANES_MAX], b[CLOSE_MAX + SIMD_LANES_MAX];
    float gap_m[CLOSE_MAX + SIMD_LANES_MAX];
};

/* Measures the gaps of all contacts in the list `close` and empties the list. */
static void measure_close_pairs(const struct solver_step *all, struct close *close)
{
    CORE_ASSERT(close->count <= CLOSE_MAX);
    const uint32_t count = close->count;
    for (uint32_t lane = 0; lane < SIMD_LANES_MAX; lane++) {
        close->a[count + lane] = 0;
        close->b[count + lane] = 0;
    }
    narrow_phase_gaps(all->broad_phase->body, close->a, close->b, count, all->place->lanes,
                      close->gap_m);
    for (uint32_t k = 0; k < count; k++) {
        contact_store_gap(all, &all->broad_phase->contact[close->contact[k]], close->gap_m[k]);
    }
    close->count = 0;
}

/* Pushes overlapping fish apart in several rounds. Returns true if the last round found no
 * overlapping pair. */
static bool relax(const struct solver_step *all)
{
    CORE_ASSERT(all->broad_phase->contact_count <= all->broad_phase->near_count);
    uint32_t parted = 1;
    /* Measures the gap of each contact whose bodies may have approached each other so far that they
     * touch. Most of these bodies prove to be apart. */
    struct broad_phase *broad_phase = all->broad_phase;
    struct close close;
    close.count = 0;
    for (uint32_t c = 0; c < broad_phase->contact_count; c++) {
        if (!contact_is_apart(all, &broad_phase->contact[c], 0.0f)) {
            close.contact[close.count] = c;
            close.a[close.count] = broad_phase->contact[c].a;
            close.b[close.count++] = broad_phase->contact[c].b;
        }
        if (close.count == CLOSE_MAX) {
            measure_close_pairs(all, &close);
        }
    }
    measure_close_pairs(all, &close);
    for (int round = 0; round < PART_ROUNDS_MAX && parted > 0; round++) {
        /* A round handles all contacts in order, so that a push propagates to later contacts in the
         * same round. */
        parted = 0;
        for (uint32_t c = 0; c < broad_phase->contact_count; c++) {
            struct contact *contact = &broad_phase->contact[c];
            if (!contact_is_apart(all, contact, 0.0f) && part_pair(all, contact, round)) {
                /* The push may have moved the two fish into an obstacle, so they are moved off the
                 * obstacle. */
                clear_if_beside(all, contact->a);
                note_moved_body(all, contact->a);
                clear_if_beside(all, contact->b);
                note_moved_body(all, contact->b);
                parted++;
            }
        }
    }
    return parted == 0;
}

/* ---- Moving a fish out of walls and obstacles ------------------------------------------------ */

static void clear_one(const struct solver_step *all, uint32_t index)
{
    struct broad_phase *broad_phase = all->broad_phase;
    struct contact_solver *solver = all->solver;
    broad_phase->flags[index] &= (uint8_t)~BODY_NEAR_OBSTACLE;
    const vec3 from_m = contact_before_m(all, index);
    const vec3 moved_m = v3_sub(broad_phase->body[index].centre_m, from_m);
    /* Sets BODY_NEAR_OBSTACLE if the fish could touch an obstacle in this substep. `excess_m` is
     * the largest distance by which an obstacle near the fish may carry the fish in this
     * substep. */
    const struct box box = body_box(&broad_phase->body[index]);
    float excess_m = 0.0f;
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        const struct obstacle *obstacle = &all->place->obstacles[o];
        if (obstacle_in_reach(obstacle, &box)) {
            broad_phase->flags[index] |= BODY_NEAR_OBSTACLE;
            excess_m =
                f_max(excess_m, v3_length(v3_sub(obstacle_carry_m(obstacle, from_m), from_m)));
        }
    }
    if (broad_phase->flags[index] & BODY_NEAR_OBSTACLE) {
        CORE_ASSERT(solver->beside_count < TANK_FISH_MAX);
        solver->beside[solver->beside_count++] = (fish_index)index;
    }
    solver->step_max_m[index] = v3_length(moved_m) + all->place->push_max_m + excess_m;
    clear_if_beside(all, index);
    keep_inside(all, index);
    const vec3 led_m = v3_sub(broad_phase->body[index].centre_m, from_m);
    broad_phase->play_m[index] =
        solver->step_max_m[index] + v3_length(led_m) + contact_sweep_m(all, index);
}

/* ---- Steps of the contact solver (contact_solver.h) ------------------------------------------ */

void contact_solver_project(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place)
{
    CORE_ASSERT(broad_phase->count <= TANK_FISH_MAX);
    CORE_ASSERT(place->obstacle_count <= TANK_OBSTACLE_MAX);
    CORE_ASSERT(simd_is_built(place->lanes));
    const struct solver_step all = { solver, broad_phase, place };
    const uint32_t width = place->lanes == SIMD_LANES_MAX ? SIMD_LANES_MAX : 4u;
    solver->beside_count = 0;
    memset(solver->reaction_round, 0, sizeof solver->reaction_round);
    memset(solver->result, SOLVER_MOVED, broad_phase->count * sizeof solver->result[0]);
    memset(solver->fresh_round, 0, broad_phase->count * sizeof solver->fresh_round[0]);
    for (uint32_t i = 0; i < broad_phase->count;) {
        const uint32_t count = broad_phase->count - i < width ? broad_phase->count - i : width;
        uint32_t left = (1u << count) - 1u; /* One bit for each fish of the block that is not yet
                                               processed. */
        /* SIMD code processes a block of fish if all of them swim, none gulps and none is in the
         * air. */
        bool is_block = solver->substep == 0 && count == width;
        for (uint32_t k = i; k < i + width && is_block; k++) {
            is_block = broad_phase->flags[k] == BODY_SWIMMING;
        }
        if (is_block) {
            left = SIMD_PICK(place->lanes, contact_solver_project_block)(solver, broad_phase, place,
                                                                         i);
        }
        for (uint32_t k = 0; left != 0; k++, left >>= 1u) {
            if (left & 1u && broad_phase->flags[i + k] & BODY_SWIMMING) {
                clear_one(&all, i + k);
            }
        }
        i += count;
    }
}

void contact_solver_relax(struct contact_solver *solver, struct broad_phase *broad_phase,
                          const struct solver_context *place)
{
    CORE_ASSERT(place->obstacle_count <= TANK_OBSTACLE_MAX);
    const struct solver_step all = { solver, broad_phase, place };
    relax(&all);
}

void contact_solver_finish(struct contact_solver *solver, struct broad_phase *broad_phase,
                           const struct solver_context *place)
{
    CORE_ASSERT(place->obstacle_count <= TANK_OBSTACLE_MAX);
    const struct solver_step all = { solver, broad_phase, place };
    penetration_check(&all, relax(&all));
}
