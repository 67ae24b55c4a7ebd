/* contact_solver.c -- the contact solver: rounds of small pushes, followed by the penetration check
 * (penetration_check.c). */
#include "core/tank/collision/contact_solver.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/collision/contact_solver_internal.h"

/* Gap that the contact solver leaves between two bodies that it separates. */
#define SKIN_M 0.0001f
/* Largest number of rounds in a substep; each round pushes every overlapping pair apart. Most ticks
 * need two rounds. A dense group of fish that a poi pushes needs all rounds. */
#define PART_ROUNDS_MAX 12
/* First round of the solver in which vertical pushes are tilted. Pairs that earlier rounds could
 * not separate are jammed. */
#define TOPPLE_ROUND 5
#define PART_STEP_MAX_M 0.002f /* Largest push of a body in one round of the contact solver. */
#define CLEAR_ROUNDS 4u
#define CLOSE_MAX 64u /* Number of contacts whose gaps are measured together by SIMD code. */

vec3 contact_kept_inside_m(const struct solver_step *all, uint32_t index, const struct body *body)
{
    CORE_ASSERT(index < all->broad_phase->count);
    const struct tank_bounds *bounds = &all->place->bounds;
    const float reach_m = body->half_x_m + body->half_y_m + body->half_z_m;
    const vec3 beyond_low = v3_sub(body->centre_m, bounds->low_m);
    const vec3 below_high = v3_sub(bounds->high_m, body->centre_m);
    /* The body is so far inside the tank that it reaches no wall, floor or surface in any
     * orientation. */
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

/* Moves a fish to the position of its body and adds the distance to `way_m`, as broad_phase_sync()
 * does. Therefore contact_is_apart() includes the push. */
static void note_moved_body(const struct solver_step *all, uint32_t index)
{
    CORE_ASSERT(all->broad_phase->flags[index] & BODY_SWIMMING);
    struct fish *fish = &all->place->fish[index];
    const vec3 centre_m = all->broad_phase->body[index].centre_m;
    all->broad_phase->way_m[index] += v3_length(v3_sub(centre_m, fish->position_m));
    fish->position_m = centre_m;
}

/* Moves a body as far as its limit for the substep allows, and returns the rest of the move. A body
 * may always move back toward its previous position. */
static vec3 shove(const struct solver_step *all, uint32_t index, vec3 move)
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

/* Returns a tilted separation axis for a pair that lies on top of each other. A stack of fish from
 * floor to surface cannot be separated vertically, so the stack must topple. */
static vec3 topple(const struct body *a, const struct body *b, vec3 axis)
{
    vec3 aside = v3_sub(b->centre_m, a->centre_m);
    aside.y = 0.0f;
    return v3_normalize_or(v3_muladd(v3_scale(axis, 0.5f), v3_normalize_or(aside, a->right), 1.0f),
                           axis);
}

static float mass_of(const struct body *body)
{
    return body->half_z_m * body->half_z_m * body->half_z_m;
}

/* Stores the measured gap of a contact, so that the gap is not measured again until the bodies come
 * nearer. */
static void know_apart(const struct solver_step *all, struct contact *contact, float apart_m)
{
    const float *way_m = all->broad_phase->way_m;
    const float gap_m = apart_m - SOLVER_ROUNDING_M + (way_m[contact->a] + way_m[contact->b]);
    contact->gap_m = f_max(contact->gap_m, gap_m);
}

/* Separates the two bodies of a contact. Returns 1 if the bodies had to be moved, otherwise 0. */
static int part_pair(const struct solver_step *all, struct contact *contact, int round)
{
    CORE_ASSERT(contact->a != contact->b);
    const struct body *a = &all->broad_phase->body[contact->a],
                      *b = &all->broad_phase->body[contact->b];
    struct box_gap gap = body_gap(a, 0.0f, b, 0.0f);
    if (gap.body_m >= 0.0f) {
        know_apart(all, contact, gap.body_m);
        return 0;
    }
    if (round >= TOPPLE_ROUND && f_abs(gap.axis.y) > 0.7f) {
        gap.axis = topple(a, b, gap.axis);
    }
    const float depth_m = f_min(SKIN_M - gap.body_m, PART_STEP_MAX_M);
    const float share_a = mass_of(b) / (mass_of(a) + mass_of(b));
    const vec3 solver = v3_scale(gap.axis, depth_m);
    const vec3 left_a = shove(all, contact->a, v3_scale(solver, -share_a));
    const vec3 left_b = shove(all, contact->b, v3_sub(v3_scale(solver, 1.0f - share_a), left_a));
    /* If a fish cannot move by its full part of the separation, the other fish moves by the
     * remaining part. */
    shove(all, contact->a, v3_scale(left_b, -1.0f));
    return 1;
}

/* Moves a body off an obstacle. Pushes nearly always suffice. In the corner between paper and ring,
 * the push by the ring undoes the push by the paper. A fish in that corner moves along with the
 * poi. */
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
        shove(all, index, move);
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

/* Moves a body off the obstacles near it, so that no push of the solver drives the body into an
 * obstacle. */
static void clear_if_beside(const struct solver_step *all, uint32_t index)
{
    if (all->broad_phase->flags[index] & BODY_NEAR_OBSTACLE) {
        for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
            clear_obstacle(all, index, o);
        }
    }
}

/* Sets BODY_NEAR_OBSTACLE of a fish that could touch an obstacle in this substep. Returns the
 * largest distance by which an obstacle near the fish may carry the fish in this substep, m. */
static float look_beside(const struct solver_step *all, uint32_t index)
{
    CORE_ASSERT(all->solver->beside_count < TANK_FISH_MAX);
    const struct box box = body_box(&all->broad_phase->body[index]);
    float excess_m = 0.0f;
    int beside = 0;
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        const struct obstacle *obstacle = &all->place->obstacles[o];
        if (obstacle_in_reach(obstacle, &box)) {
            const vec3 from_m = contact_before_m(all, index);
            beside = 1;
            excess_m =
                f_max(excess_m, v3_length(v3_sub(obstacle_carry_m(obstacle, from_m), from_m)));
        }
    }
    if (beside) {
        all->broad_phase->flags[index] |= BODY_NEAR_OBSTACLE;
        all->solver->beside[all->solver->beside_count++] = (fish_index)index;
    }
    return excess_m;
}

/* Moves a fish that other fish pushed into an obstacle out of the obstacle. */
static void clear_shoved(const struct solver_step *all, uint32_t index)
{
    clear_if_beside(all, index);
    note_moved_body(all, index);
}

/* Contacts whose stored gap no longer proves that the bodies are apart. The contacts are collected
 * so that SIMD code measures several gaps at a time. */
struct close {
    uint32_t count;
    uint32_t contact[CLOSE_MAX];
    fish_index a[CLOSE_MAX + SIMD_LANES_MAX], b[CLOSE_MAX + SIMD_LANES_MAX];
    float gap_m[CLOSE_MAX + SIMD_LANES_MAX];
};

/* Measures the gaps of the collected contacts and empties the collection. */
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
        know_apart(all, &all->broad_phase->contact[close->contact[k]], close->gap_m[k]);
    }
    close->count = 0;
}

/* Runs the rounds of pushes. Returns 1 if the last round separated no pair, otherwise 0. The result
 * 1 means that no two fish overlap. */
static int relax(const struct solver_step *all)
{
    CORE_ASSERT(all->broad_phase->contact_count <= all->broad_phase->near_count);
    uint32_t parted = 1;
    /* Measures all contacts whose stored gap no longer proves that the bodies are apart. Most of
     * these contacts were only predicted to come near. */
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
                clear_shoved(all, contact->a);
                clear_shoved(all, contact->b);
                parted++;
            }
        }
    }
    return parted == 0;
}

/* ---- Walls and obstacles --------------------------------------------------------------------- */

static void clear_one(const struct solver_step *all, uint32_t index)
{
    struct broad_phase *broad_phase = all->broad_phase;
    struct contact_solver *solver = all->solver;
    broad_phase->flags[index] &= (uint8_t)~BODY_NEAR_OBSTACLE;
    const vec3 moved_m = v3_sub(broad_phase->body[index].centre_m, contact_before_m(all, index));
    const float excess_m = look_beside(all, index);
    solver->step_max_m[index] = v3_length(moved_m) + all->place->push_max_m + excess_m;
    clear_if_beside(all, index);
    keep_inside(all, index);
    const vec3 led_m = v3_sub(broad_phase->body[index].centre_m, contact_before_m(all, index));
    broad_phase->play_m[index] =
        solver->step_max_m[index] + v3_length(led_m) + contact_sweep_m(all, index);
}

/* Returns 1 if contact_solver_project_block() may process `width` fish from `first` on, otherwise
 * 0. The result is 1 if `width` fish exist, and each of them swims, does not gulp and is not in the
 * air. */
static int can_project_block(const struct broad_phase *broad_phase, uint32_t first, uint32_t width)
{
    CORE_ASSERT(width <= SIMD_LANES_MAX);
    uint32_t all_same = broad_phase->count - first >= width;
    for (uint32_t i = first; i < first + width && all_same; i++) {
        all_same = broad_phase->flags[i] == BODY_SWIMMING;
    }
    return (int)all_same;
}

/* ---- Public functions ------------------------------------------------------------------------ */

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
        if (solver->station == 0 && can_project_block(broad_phase, i, width)) {
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
    const int is_parted = relax(&all);
    penetration_check(&all, is_parted);
}
