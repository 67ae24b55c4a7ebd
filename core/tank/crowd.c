/* crowd.c -- pair search over the grid, and position-based separation of what it finds. */
#include "core/tank/crowd.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/input.h"

#define ROOM_GAP_M 0.005f /* A tail sweeps so far in a few ticks of a hard turn. */
#define ROOM_MIN 0.2f
#define CONTACT_GAP_M 0.002f    /* Nearer pairs may come to touch while others are parted. */
#define SKIN_M 0.0001f          /* What parting leaves between two bodies. */
#define PART_ROUNDS_MAX 12      /* Most ticks need two; a shoved crowd uses them all. */
#define CLEAR_STEP_MIN_M 0.002f /* A tick: what even a resting obstacle gives way by. */
#define TOPPLE_ROUND 5          /* What four rounds could not part is jammed. */
#define PART_STEP_MAX_M 0.002f  /* A round. */
#define CLEAR_STEP_MAX_M 0.012f /* A tick; a poi at 1.4 m/s shoves no harder. */
#define SHOVE_MAX_M 0.003f      /* A tick, beyond its own motion: more would look like a jump. */
#define UNBOUND_M 1000.0f

float crowd_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                  const struct law *law)
{
    float volume_m3 = 0.0f;
    for (uint32_t i = 0; i < fish_count; i++) {
        const float both_m = 2.0f * law->space_per_length * fish[i].length_m;
        volume_m3 += (fish[i].length_m + both_m) * (fish[i].height_m + both_m) *
                     (fish[i].width_m + both_m);
    }
    const float fill = volume_m3 / (tank_size_m.x * tank_size_m.y * tank_size_m.z);
    if (fill <= law->space_fill_max) {
        return law->space_per_length;
    }
    const float share = f_clamp(f_exp(f_ln(law->space_fill_max / fill) / 3.0f), 0.2f, 1.0f);
    return share * law->space_per_length;
}

static struct crowd_body body_of(const struct fish *fish, uint16_t index, float space)
{
    struct crowd_body body = {
        .fish = index,
        .speed_m_s = fish->speed_m_s,
        .brake = 1.0f,
        .room = 1.0f,
        .avoiding = fish->avoiding,
        .avoid_with = fish->avoid_with,
        .avoid_since = fish->avoid_since,
        .before_m = fish->position_m,
        .step_max_m = UNBOUND_M,
    };
    body.box = fish_box(fish);
    body.centre_m = fish->position_m;
    body.margin_m = space * fish->length_m;
    body.extent_m = box_extent_m(&body.box);
    body.forward = v3_scale(body.box.axes.back, -1.0f);
    struct box room = body.box;
    room.half_m = v3_add(room.half_m, v3(body.margin_m, body.margin_m, body.margin_m));
    body.reach_m = v3_length(room.half_m);
    body.slab_m = f_abs(room.axes.right.y) * room.half_m.x + f_abs(room.axes.up.y) * room.half_m.y +
                  f_abs(room.axes.back.y) * room.half_m.z;
    body.airborne = fish->position_m.y + body.extent_m.y > FISH_AIRBORNE_M;
    return body;
}

void crowd_gather(struct crowd *crowd, const struct fish *fish, uint32_t fish_count, float space,
                  const vec3 *before_m)
{
    CORE_ASSERT(fish_count <= GRID_FISH_MAX);
    crowd->count = 0;
    for (uint32_t i = 0; i < fish_count; i++) {
        if (fish_swims(&fish[i])) {
            struct crowd_body *body = &crowd->body[crowd->count++];
            *body = body_of(&fish[i], (uint16_t)i, space);
            if (before_m) {
                body->before_m = before_m[i];
                body->step_max_m = v3_length(v3_sub(fish[i].position_m, before_m[i])) + SHOVE_MAX_M;
            }
        }
    }
}

static void take_advice(struct avoid_advice *kept, const struct avoid_advice *advice)
{
    if (advice->kind != MEET_NONE &&
        (kept->kind == MEET_NONE || advice->contact_s < kept->contact_s)) {
        *kept = *advice;
    }
}

static struct avoid_party party_of(const struct crowd_body *body)
{
    return (struct avoid_party){ body->box.centre_m,        body->forward,    body->speed_m_s,
                                 2.0f * body->box.half_m.z, 2.0f * body->box.half_m.y,
                                 body->fish,                body->avoiding,
                                 body->avoid_with,          body->avoid_since };
}

/* Full to the side, half along the body: a fish pushed from behind does not shoot ahead. */
static void push_apart(struct crowd_body *body, vec3 axis, float speed_m_s)
{
    const float along = v3_dot(axis, body->forward);
    const vec3 push = v3_mad(axis, body->forward, -0.5f * along);
    body->push_m_s = v3_mad(body->push_m_s, push, speed_m_s);
}

/* In a list that is full, each further pair takes a drawn place or none, so that every pair has the
 * same chance and none waits for long (a reservoir). */
static void list_contact(struct crowd *crowd, uint32_t first, uint32_t second, uint32_t seed,
                         uint32_t tick)
{
    uint32_t place = crowd->touch_count++;
    if (place >= CROWD_CONTACT_MAX) {
        const uint32_t lot = place | 1u << 31; /* No pair of fish has that key. */
        place = rng_u32((struct rng_key){ seed, tick, lot, RNG_FISH_AVOID_SIDE }) % (place + 1u);
    }
    if (place < CROWD_CONTACT_MAX) {
        crowd->contact[place][0] = (uint16_t)first;
        crowd->contact[place][1] = (uint16_t)second;
        crowd->contact_count =
            crowd->touch_count < CROWD_CONTACT_MAX ? crowd->touch_count : CROWD_CONTACT_MAX;
    }
}

static void meet_pair(struct crowd *crowd, uint32_t first, uint32_t second, const struct law *law,
                      uint32_t seed, uint32_t tick)
{
    struct crowd_body *a = &crowd->body[first], *b = &crowd->body[second];
    const struct box_gap gap = box_gap(&a->box, a->margin_m, &b->box, b->margin_m);
    if (gap.space_m > 0.0f) {
        return;
    }
    const struct avoid_party pa = party_of(a), pb = party_of(b);
    const struct avoid_pair advice = avoid_meet(&pa, &pb, gap.body_m, law, seed, tick);
    take_advice(&a->advice, &advice.a);
    take_advice(&b->advice, &advice.b);
    a->brake = f_min(a->brake, advice.brake_a);
    b->brake = f_min(b->brake, advice.brake_b);
    const float room = f_clamp(gap.body_m / ROOM_GAP_M, ROOM_MIN, 1.0f);
    a->room = f_min(a->room, room);
    b->room = f_min(b->room, room);
    const float length_m = 2.0f * f_min(a->box.half_m.z, b->box.half_m.z);
    const float apart_m_s = avoid_repulsion_m_s(gap.body_m, length_m);
    push_apart(a, gap.axis, -apart_m_s);
    push_apart(b, gap.axis, apart_m_s);
    crowd->overlap_count += gap.body_m < 0.0f;
    if (gap.body_m < CONTACT_GAP_M) {
        list_contact(crowd, first, second, seed, tick);
    }
}

static int may_meet(const struct crowd_near *a, const struct crowd_near *b)
{
    const vec3 d = v3_sub(b->centre_m, a->centre_m);
    const float reach_m = a->reach_m + b->reach_m;
    return v3_dot(d, d) < reach_m * reach_m && f_abs(d.y) < a->slab_m + b->slab_m;
}

/* Item `k` against the items [from, to) of the cells' order. */
static void meet_range(struct crowd *crowd, uint32_t k, uint32_t from, uint32_t to,
                       const struct law *law, uint32_t seed, uint32_t tick)
{
    const struct crowd_near me = crowd->near[k];
    for (uint32_t other = from; other < to; other++) {
        if (may_meet(&me, &crowd->near[other])) {
            meet_pair(crowd, crowd->grid.item[k], crowd->grid.item[other], law, seed, tick);
        }
    }
}

/* Half of the 3 x 3 cells: the rest of its own, the one to the right, the three of the next row. */
static void meet_item(struct crowd *crowd, uint32_t k, const struct law *law, uint32_t seed,
                      uint32_t tick)
{
    const struct grid *grid = &crowd->grid;
    const uint32_t cell = grid->cell_of[grid->item[k]];
    const uint32_t column = cell % grid->columns;
    const uint32_t right = column + 1u < grid->columns ? cell + 1u : cell;
    const uint32_t left = column > 0 ? cell - 1u : cell;
    /* A row's cells follow each other, so a range of cells is a range of items. */
    meet_range(crowd, k, k + 1u, grid->start[right + 1u], law, seed, tick);
    if (cell + grid->columns < grid->columns * grid->rows) {
        meet_range(crowd, k, grid->start[left + grid->columns],
                   grid->start[right + grid->columns + 1u], law, seed, tick);
    }
}

void crowd_meet(struct crowd *crowd, vec3 tank_size_m, const struct law *law, uint32_t seed,
                uint32_t tick)
{
    float reach_m = 0.01f;
    for (uint32_t i = 0; i < crowd->count; i++) {
        reach_m = f_max(reach_m, crowd->body[i].reach_m);
    }
    grid_layout(&crowd->grid, tank_size_m.x, tank_size_m.z, 2.0f * reach_m);
    grid_fill(&crowd->grid, &crowd->body[0].centre_m, sizeof crowd->body[0], crowd->count);
    for (uint32_t k = 0; k < crowd->count; k++) {
        const struct crowd_body *body = &crowd->body[crowd->grid.item[k]];
        crowd->near[k] = (struct crowd_near){ body->centre_m, body->reach_m, body->slab_m };
    }
    crowd->touch_count = 0;
    crowd->contact_count = 0;
    crowd->overlap_count = 0;
    for (uint32_t k = 0; k < crowd->count; k++) {
        meet_item(crowd, k, law, seed, tick);
    }
}

static void keep_inside(struct crowd_body *body, const struct tank_bounds *bounds)
{
    const vec3 low = v3_add(bounds->low_m, body->extent_m),
               high = v3_sub(bounds->high_m, body->extent_m);
    vec3 *p = &body->box.centre_m;
    p->x = f_clamp(p->x, low.x, high.x);
    p->z = f_clamp(p->z, low.z, high.z);
    p->y = f_max(p->y, low.y);
    if (!body->airborne) {
        p->y = f_min(p->y, high.y);
    }
}

/* Moves it as far as its step allows, and returns what is left. Back to where it came from it may
 * go, however hard it ran into others. */
static vec3 shove(struct crowd_body *body, vec3 move, const struct tank_bounds *bounds)
{
    const vec3 wanted = v3_add(body->box.centre_m, move);
    const vec3 step = v3_limit(v3_sub(wanted, body->before_m), body->step_max_m);
    body->box.centre_m = v3_add(body->before_m, step);
    const vec3 left = v3_sub(wanted, body->box.centre_m);
    keep_inside(body, bounds);
    return left;
}

/* A stack of fish that fills the water from floor to surface cannot be parted upward: it topples.
 */
static vec3 topple(const struct crowd_body *a, const struct crowd_body *b, vec3 axis)
{
    vec3 aside = v3_sub(b->box.centre_m, a->box.centre_m);
    aside.y = 0.0f;
    return v3_normalize_or(
        v3_mad(v3_scale(axis, 0.5f), v3_normalize_or(aside, a->box.axes.right), 1.0f), axis);
}

/* Whether the pair had to be parted. */
static int part_pair(struct crowd_body *a, struct crowd_body *b, const struct tank_bounds *bounds,
                     int round)
{
    struct box_gap gap = box_gap(&a->box, SKIN_M, &b->box, SKIN_M);
    if (gap.space_m > 0.0f || gap.body_m >= 0.0f) {
        return 0;
    }
    if (round >= TOPPLE_ROUND && f_abs(gap.axis.y) > 0.7f) {
        gap.axis = topple(a, b, gap.axis);
    }
    const float depth_m = f_min(SKIN_M - gap.body_m, PART_STEP_MAX_M);
    const float mass_a = a->box.half_m.z * a->box.half_m.z * a->box.half_m.z;
    const float mass_b = b->box.half_m.z * b->box.half_m.z * b->box.half_m.z;
    const float share_a = mass_b / (mass_a + mass_b);
    const vec3 part = v3_scale(gap.axis, depth_m);
    const vec3 left_a = shove(a, v3_scale(part, -share_a), bounds);
    const vec3 left_b = shove(b, v3_sub(v3_scale(part, 1.0f - share_a), left_a), bounds);
    shove(a, v3_scale(left_b, -1.0f), bounds); /* Who cannot give way leaves it to the other. */
    return 1;
}

static void clear_obstacles(struct crowd_body *body, const struct tank_bounds *bounds,
                            const struct obstacle *obstacles, uint32_t obstacle_count)
{
    for (uint32_t o = 0; o < obstacle_count; o++) {
        const vec3 move = obstacle_clear(&obstacles[o], &body->box);
        if (v3_dot(move, move) > 0.0f) {
            const float rush_m = 2.0f * CORE_TICK_S * v3_length(obstacles[o].velocity_m_s);
            const float step_m = f_clamp(rush_m, CLEAR_STEP_MIN_M, CLEAR_STEP_MAX_M);
            body->step_max_m = f_max(body->step_max_m, step_m);
            body->box.centre_m = v3_add(body->box.centre_m, v3_limit(move, step_m));
        }
    }
    keep_inside(body, bounds);
}

/* A body beside an obstacle must not be shoved into it. */
static void clear_if_beside(struct crowd_body *body, const struct tank_bounds *bounds,
                            const struct obstacle *obstacles, uint32_t obstacle_count)
{
    if (body->beside) {
        clear_obstacles(body, bounds, obstacles, obstacle_count);
    }
}

void crowd_clear(struct crowd *crowd, const struct tank_bounds *bounds,
                 const struct obstacle *obstacles, uint32_t obstacle_count)
{
    for (uint32_t i = 0; i < crowd->count; i++) {
        struct crowd_body *body = &crowd->body[i];
        for (uint32_t o = 0; o < obstacle_count; o++) {
            body->beside |= (uint8_t)obstacle_in_reach(&obstacles[o], &body->box);
        }
        clear_if_beside(body, bounds, obstacles, obstacle_count);
        keep_inside(body, bounds);
        body->centre_m = body->box.centre_m;
    }
}

void crowd_part(struct crowd *crowd, const struct tank_bounds *bounds,
                const struct obstacle *obstacles, uint32_t obstacle_count)
{
    uint32_t parted = 1;
    for (int round = 0; round < PART_ROUNDS_MAX && parted > 0; round++) {
        parted = 0;
        for (uint32_t c = 0; c < crowd->contact_count; c++) {
            struct crowd_body *a = &crowd->body[crowd->contact[c][0]];
            struct crowd_body *b = &crowd->body[crowd->contact[c][1]];
            if (part_pair(a, b, bounds, round)) {
                clear_if_beside(a, bounds, obstacles, obstacle_count);
                clear_if_beside(b, bounds, obstacles, obstacle_count);
                parted++;
            }
        }
    }
}
