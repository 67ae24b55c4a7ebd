/* crowd.c -- bodies from fish, and what each fish is told of those about it. */
#include "core/tank/crowd.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"

#define ROOM_GAP_M 0.005f /* A tail sweeps so far in a few ticks of a hard turn. */
#define ROOM_MIN 0.2f
#define CONTACT_GAP_M 0.002f /* Nearer pairs may come to touch while others are parted. */

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

/* Few bodies are so near the surface that their pose counts. */
static int is_airborne(const struct body *body, float emerges_m)
{
    const float y = body->centre_m.y;
    return y + body->half_x_m + body->half_y_m + body->half_z_m > emerges_m &&
           y + body_extent_m(body).y > emerges_m;
}

void crowd_mark(struct crowd *crowd, const struct fish *fish, uint32_t fish_count)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    crowd->count = fish_count;
    for (uint32_t i = 0; i < fish_count; i++) {
        crowd->flags[i] = 0;
        if (fish_swims(&fish[i])) {
            crowd->flags[i] = CROWD_SWIMS;
            crowd->flags[i] |= is_airborne(&crowd->body[i], fish_emerges_m(&fish[i]))
                                   ? CROWD_AIRBORNE
                                   : 0u;
            crowd->flags[i] |= fish[i].gait == GAIT_SURFACE ? CROWD_GULPS : 0u;
        }
    }
}

void crowd_gather(struct crowd *crowd, const struct fish *fish, uint32_t fish_count, float space)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < fish_count; i++) {
        if (fish_swims(&fish[i])) {
            const struct box box = fish_box(&fish[i]);
            crowd->body[i] = body_of(&box, space * fish[i].length_m);
        }
    }
    crowd_mark(crowd, fish, fish_count);
}

static void take_advice(struct avoid_advice *kept, const struct avoid_advice *advice)
{
    if (advice->kind != MEET_NONE &&
        (kept->kind == MEET_NONE || advice->contact_s < kept->contact_s)) {
        *kept = *advice;
    }
}

static vec3 forward_of(const struct body *body)
{
    return v3_scale(body->back, -1.0f);
}

static struct avoid_party party_of(const struct body *body, const struct fish *fish,
                                   uint32_t index)
{
    return (struct avoid_party){
        .position_m = body->centre_m,
        .forward = forward_of(body),
        .speed_m_s = fish->speed_m_s,
        .length_m = 2.0f * body->half_z_m,
        .height_m = 2.0f * body->half_y_m,
        .index = (fish_index)index,
        .avoiding = fish->avoiding,
        .avoid_with = fish->avoid_with,
        .avoid_since = fish->avoid_since,
    };
}

/* Full to the side, half along the body: a fish pushed from behind does not shoot ahead. */
static void push_apart(struct company *company, vec3 forward, vec3 axis, float speed_m_s)
{
    const float along = v3_dot(axis, forward);
    const vec3 push = v3_mad(axis, forward, -0.5f * along);
    company->push_m_s = v3_mad(company->push_m_s, push, speed_m_s);
}

/* In a list that is full, each further pair takes a drawn place or none, so that every pair has the
 * same chance and none waits for long (a reservoir). */
static void list_contact(struct crowd *crowd, struct contact contact, uint32_t seed, uint32_t tick)
{
    uint32_t place = crowd->touch_count++;
    if (place >= CROWD_CONTACT_MAX) {
        const uint32_t lot = place | 1u << 31; /* No pair of fish has that key. */
        place = rng_u32((struct rng_key){ seed, tick, lot, RNG_FISH_AVOID_SIDE }) % (place + 1u);
    }
    if (place < CROWD_CONTACT_MAX) {
        crowd->contact[place] = contact;
        crowd->contact_count =
            crowd->touch_count < CROWD_CONTACT_MAX ? crowd->touch_count : CROWD_CONTACT_MAX;
    }
}

/* One look at a tank. */
struct look {
    struct crowd *crowd;
    const struct fish *fish;
    const struct surroundings *around;
};

static void meet_pair(const struct look *look, uint32_t first, uint32_t second)
{
    struct crowd *crowd = look->crowd;
    const struct surroundings *around = look->around;
    const struct body *a = &crowd->body[first], *b = &crowd->body[second];
    struct company *ca = &crowd->company[first], *cb = &crowd->company[second];
    const struct box box_a = body_box(a), box_b = body_box(b);
    const struct box_gap gap = box_gap(&box_a, a->margin_m, &box_b, b->margin_m);
    if (gap.space_m > 0.0f) {
        return;
    }
    const struct avoid_party pa = party_of(a, &look->fish[first], first),
                             pb = party_of(b, &look->fish[second], second);
    const struct avoid_pair advice = avoid_meet(&pa, &pb, gap.body_m, around->law, around->seed,
                                                around->tick);
    take_advice(&ca->advice, &advice.a);
    take_advice(&cb->advice, &advice.b);
    ca->brake = f_min(ca->brake, advice.brake_a);
    cb->brake = f_min(cb->brake, advice.brake_b);
    const float room = f_clamp(gap.body_m / ROOM_GAP_M, ROOM_MIN, 1.0f);
    ca->room = f_min(ca->room, room);
    cb->room = f_min(cb->room, room);
    const float length_m = 2.0f * f_min(a->half_z_m, b->half_z_m);
    const float apart_m_s = avoid_repulsion_m_s(gap.body_m, length_m);
    push_apart(ca, pa.forward, gap.axis, -apart_m_s);
    push_apart(cb, pb.forward, gap.axis, apart_m_s);
    crowd->overlap_count += gap.body_m < 0.0f;
    if (gap.body_m < CONTACT_GAP_M) {
        const struct contact contact = { (fish_index)first, (fish_index)second, gap.body_m };
        list_contact(crowd, contact, around->seed, around->tick);
    }
}

static int may_meet(const struct crowd *crowd, uint32_t a, uint32_t b)
{
    const vec3 d = v3_sub(crowd->body[b].centre_m, crowd->body[a].centre_m);
    const float reach_m = crowd->reach_m[a] + crowd->reach_m[b];
    return v3_dot(d, d) < reach_m * reach_m && f_abs(d.y) < crowd->slab_m[a] + crowd->slab_m[b];
}

/* Item `k` against the items [from, to) of the cells' order. */
static void meet_range(const struct look *look, uint32_t k, uint32_t from, uint32_t to)
{
    const struct crowd *crowd = look->crowd;
    const uint32_t me = crowd->grid.item[k];
    for (uint32_t other = from; other < to; other++) {
        if (may_meet(crowd, me, crowd->grid.item[other])) {
            meet_pair(look, me, crowd->grid.item[other]);
        }
    }
}

/* Half of the 3 x 3 cells: the rest of its own, the one to the right, the three of the next row. */
static void meet_item(const struct look *look, uint32_t k)
{
    const struct grid *grid = &look->crowd->grid;
    const uint32_t cell = grid->cell_of[grid->item[k]];
    const uint32_t column = cell % grid->columns;
    const uint32_t right = column + 1u < grid->columns ? cell + 1u : cell;
    const uint32_t left = column > 0 ? cell - 1u : cell;
    /* A row's cells follow each other, so a range of cells is a range of items. */
    meet_range(look, k, k + 1u, grid->start[right + 1u]);
    if (cell + grid->columns < grid->columns * grid->rows) {
        meet_range(look, k, grid->start[left + grid->columns],
                   grid->start[right + grid->columns + 1u]);
    }
}

/* How far each may be felt; returns the farthest. */
static float measure(struct crowd *crowd)
{
    float farthest_m = 0.01f;
    for (uint32_t i = 0; i < crowd->count; i++) {
        if (crowd->flags[i] & CROWD_SWIMS) {
            struct body space = crowd->body[i];
            space.half_x_m += space.margin_m;
            space.half_y_m += space.margin_m;
            space.half_z_m += space.margin_m;
            crowd->reach_m[i] = v3_length(v3(space.half_x_m, space.half_y_m, space.half_z_m));
            crowd->slab_m[i] = body_extent_m(&space).y;
            farthest_m = f_max(farthest_m, crowd->reach_m[i]);
        }
    }
    return farthest_m;
}

void crowd_look(struct crowd *crowd, const struct fish *fish, const struct surroundings *around)
{
    const struct look look = { crowd, fish, around };
    grid_layout(&crowd->grid, around->size_m.x, around->size_m.z, 2.0f * measure(crowd));
    grid_fill(&crowd->grid, crowd->body, crowd->flags, CROWD_SWIMS, crowd->count);
    crowd->touch_count = 0;
    crowd->contact_count = 0;
    crowd->overlap_count = 0;
    for (uint32_t i = 0; i < crowd->count; i++) {
        crowd->company[i] = (struct company){ .brake = 1.0f, .room = 1.0f };
    }
    for (uint32_t k = 0; k < crowd->grid.count; k++) {
        meet_item(&look, k);
    }
}
