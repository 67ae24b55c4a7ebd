/* crowd.c -- bodies from fish, and what each fish is told of those about it. */
#include "core/tank/crowd.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/swim.h"

#define ROOM_GAP_M 0.005f /* A tail sweeps so far in a few ticks of a hard turn. */
#define ROOM_MIN 0.2f
#define REACH_SPARE_M 0.0035f /* Beyond 1.2 times what it does now: most starts and turns. */
#define REACH_SPARE 1.2f
#define AGAIN_MAX 8u /* Fish looked at alone; for more, a search of all is as cheap. */
#define FETCH_AHEAD 8u /* Pairs: what a few of them take to judge is what memory takes to answer. */
#define RADIUS_PER_LENGTH 0.55f /* Half the diagonal of a body of 5 x 2 x 1. */

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
        crowd->play_m[i] = 0.5f * CROWD_TOUCH_M;
        if (!fish_swims(&fish[i])) {
            crowd->way_m[i] = SWIM_FAR_M; /* Until a look has seen it swim. */
        } else {
            crowd->flags[i] = CROWD_SWIMS;
            crowd->flags[i] |=
                fish[i].falls || is_airborne(&crowd->body[i], fish_emerges_m(&fish[i]))
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
        .avoid_kind = fish->avoid_kind,
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

static void leave_out(struct crowd *crowd, const struct contact *contact)
{
    crowd->flags[contact->a] |= CROWD_UNLISTED;
    crowd->flags[contact->b] |= CROWD_UNLISTED;
}

/* In a list that is full, each further pair takes a drawn place or none, so that every pair has the
 * same chance and none waits for long (a reservoir). */
static void list_contact(struct crowd *crowd, struct contact contact, uint32_t seed, uint32_t tick)
{
    uint32_t place = crowd->touch_count++;
    if (place >= CROWD_CONTACT_MAX) {
        place = rng_u32((struct rng_key){ seed, tick, place, RNG_CONTACT_LOT }) % (place + 1u);
        leave_out(crowd, place < CROWD_CONTACT_MAX ? &crowd->contact[place] : &contact);
    }
    if (place < CROWD_CONTACT_MAX) {
        crowd->contact[place] = contact;
        crowd->near_count =
            crowd->touch_count < CROWD_CONTACT_MAX ? crowd->touch_count : CROWD_CONTACT_MAX;
    }
}

/* One look at a tank. */
struct look {
    struct crowd *crowd;
    const struct fish *fish;
    const struct surroundings *around;
    int contacts_only;
};

static void meet_pair(const struct look *look, const struct found *found)
{
    struct crowd *crowd = look->crowd;
    const struct surroundings *around = look->around;
    const struct body *a = &crowd->body[found->a], *b = &crowd->body[found->b];
    struct company *ca = &crowd->company[found->a], *cb = &crowd->company[found->b];
    const struct avoid_party pa = party_of(a, &look->fish[found->a], found->a),
                             pb = party_of(b, &look->fish[found->b], found->b);
    const struct avoid_pair advice = avoid_meet(&pa, &pb, found->gap_m, around->law, around->seed,
                                                around->tick);
    take_advice(&ca->advice, &advice.a);
    take_advice(&cb->advice, &advice.b);
    ca->brake = f_min(ca->brake, advice.brake_a);
    cb->brake = f_min(cb->brake, advice.brake_b);
    const float room = f_clamp(found->gap_m / ROOM_GAP_M, ROOM_MIN, 1.0f);
    ca->room = f_min(ca->room, room);
    cb->room = f_min(cb->room, room);
    const float length_m = 2.0f * f_min(a->half_z_m, b->half_z_m);
    const float apart_m_s = avoid_repulsion_m_s(found->gap_m, length_m);
    if (apart_m_s > 0.0f) {
        const vec3 axis = pairs_axis(a, b, found->axis);
        push_apart(ca, pa.forward, axis, -apart_m_s);
        push_apart(cb, pb.forward, axis, apart_m_s);
    }
}

static void take_found(const struct look *look, const struct found *found)
{
    struct crowd *crowd = look->crowd;
    if (found->spaces && !look->contacts_only && !look->around->ball_spaces) {
        meet_pair(look, found);
    }
    crowd->overlap_count += found->gap_m < 0.0f;
    if (found->gap_m < crowd->reach_m[found->a] + crowd->reach_m[found->b]) {
        const struct contact contact = { (fish_index)found->a, (fish_index)found->b,
                                         found->gap_m };
        list_contact(crowd, contact, look->around->seed, look->around->tick);
    }
}

/* How far it will come before the next look, by what it does now. */
static float reach_m(const struct fish *fish)
{
    const float pace_m_s = fish->speed_m_s + f_abs(fish->climb_m_s) + v3_length(fish->push_m_s) +
                           f_abs(fish->yaw_rate_rad_s) * RADIUS_PER_LENGTH * fish->length_m;
    return REACH_SPARE * (float)CROWD_LOOK_TICKS * CORE_TICK_S * pace_m_s + REACH_SPARE_M;
}

/* Fish that are near each other lie anywhere in memory: in a big tank, far from every cache. */
static void fetch_fish(const struct look *look, uint32_t index)
{
    __builtin_prefetch(&look->fish[index].speed_m_s);
    __builtin_prefetch(&look->fish[index].avoid_since);
    __builtin_prefetch(&look->crowd->body[index]);
    __builtin_prefetch(&look->crowd->company[index], 1);
}

static void fetch(const struct look *look, const struct found *found)
{
    fetch_fish(look, found->a);
    fetch_fish(look, found->b);
}

static void seek(const struct look *look, const struct pairs_of *of, int ahead)
{
    struct crowd *crowd = look->crowd;
    crowd->touch_count = 0;
    crowd->near_count = 0;
    crowd->overlap_count = 0;
    for (uint32_t i = 0; i < crowd->count; i++) {
        crowd->flags[i] &= (uint8_t)~CROWD_UNLISTED;
        if (!look->contacts_only) {
            crowd->company[i] = (struct company){ .brake = 1.0f, .room = 1.0f };
        }
        crowd->reach_m[i] = crowd->play_m[i] + (ahead ? reach_m(&look->fish[i]) : 0.0f);
        crowd->way_m[i] = crowd->flags[i] & CROWD_SWIMS ? 0.0f : SWIM_FAR_M;
    }
    pairs_begin(&crowd->pairs, of);
    for (uint32_t count; pairs_next(&crowd->pairs, of, crowd->found, &count);) {
        for (uint32_t f = 0; f < count; f++) {
            if (f + FETCH_AHEAD < count) {
                fetch(look, &crowd->found[f + FETCH_AHEAD]);
            }
            take_found(look, &crowd->found[f]);
        }
    }
}

static float ball_m(const struct body *body)
{
    const float m = body->margin_m;
    return v3_length(v3(body->half_x_m + m, body->half_y_m + m, body->half_z_m + m));
}

/* What the thesis decided against in section 3.4: balls that hold the boxes of the spaces. Each
 * against each, for it is there to be compared, not to run a stall. */
static void meet_balls(const struct look *look)
{
    const struct crowd *crowd = look->crowd;
    for (uint32_t i = 0; i < crowd->count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const struct body *a = &crowd->body[j], *b = &crowd->body[i];
            const vec3 way = v3_sub(b->centre_m, a->centre_m);
            const float both_m = ball_m(a) + ball_m(b);
            if ((crowd->flags[i] & crowd->flags[j] & CROWD_SWIMS) &&
                v3_dot(way, way) < both_m * both_m) {
                const struct box box_a = body_box(a), box_b = body_box(b);
                const struct box_gap gap = box_gap(&box_a, 1.0f, &box_b, 1.0f);
                const struct found found = {
                    .a = j,
                    .b = i,
                    .gap_m = gap.body_m,
                    .axis = gap.which,
                };
                meet_pair(look, &found);
            }
        }
    }
}

void crowd_look(struct crowd *crowd, const struct fish *fish, struct crowd_search how,
                const struct surroundings *around)
{
    const struct look look = { crowd, fish, around, how.contacts_only };
    const struct pairs_of of = {
        .body = crowd->body,
        .flags = crowd->flags,
        .reach_m = crowd->reach_m,
        .count = crowd->count,
        .which = CROWD_SWIMS,
        .search = how.search,
        .lanes = how.lanes,
        .bodies_only = how.contacts_only,
        .width_m = around->size_m.x,
        .breadth_m = around->size_m.z,
    };
    seek(&look, &of, 1);
    if (crowd->touch_count > CROWD_CONTACT_MAX) { /* Rather the nearest of them, and look soon. */
        seek(&look, &of, 0);
    }
    if (around->ball_spaces && !how.contacts_only) {
        meet_balls(&look);
    }
    crowd_touch(crowd);
}

void crowd_follow(struct crowd *crowd, struct fish *fish)
{
    for (uint32_t i = 0; i < crowd->count; i++) {
        const vec3 moved = v3_sub(crowd->body[i].centre_m, fish[i].position_m);
        if (crowd->flags[i] & CROWD_SWIMS && v3_dot(moved, moved) > 0.0f) {
            crowd->way_m[i] += v3_length(moved);
            fish[i].position_m = crowd->body[i].centre_m;
        }
    }
}

static int is_beyond(const struct crowd *crowd, uint32_t i)
{
    const int swims = crowd->flags[i] & CROWD_SWIMS;
    return swims && crowd->way_m[i] > crowd->reach_m[i] - crowd->play_m[i];
}

int crowd_is_stale(const struct crowd *crowd)
{
    int farther = crowd->touch_count > CROWD_CONTACT_MAX;
    for (uint32_t i = 0; i < crowd->count; i++) {
        farther |= is_beyond(crowd, i);
    }
    return farther;
}

static void forget(struct crowd *crowd, uint32_t fish)
{
    uint32_t kept = 0;
    for (uint32_t c = 0; c < crowd->near_count; c++) {
        const struct contact contact = crowd->contact[c];
        crowd->contact[kept] = contact;
        kept += contact.a != fish && contact.b != fish;
    }
    crowd->near_count = kept;
    crowd->touch_count = kept;
}

/* Lists the pair if it could touch before either is looked at again. The gap is reckoned from where
 * the other was when it was looked at last. */
static void meet_again(struct crowd *crowd, uint32_t fish, uint32_t other)
{
    const struct body *a = &crowd->body[fish], *b = &crowd->body[other];
    const float way_m = crowd->way_m[other];
    const float left_m = f_max(crowd->reach_m[other] - way_m, 0.0f);
    const vec3 d = v3_sub(b->centre_m, a->centre_m);
    const float near_m = crowd->reach_m[fish] + left_m + a->half_x_m + a->half_y_m + a->half_z_m +
                         b->half_x_m + b->half_y_m + b->half_z_m;
    if (v3_dot(d, d) > near_m * near_m) {
        return;
    }
    const struct box box_a = body_box(a), box_b = body_box(b);
    const struct box_gap gap = box_gap(&box_a, crowd->reach_m[fish], &box_b, left_m);
    if (gap.space_m <= 0.0f && gap.body_m < crowd->reach_m[fish] + left_m) {
        CORE_ASSERT(crowd->near_count < CROWD_CONTACT_MAX);
        crowd->contact[crowd->near_count++] =
            (struct contact){ (fish_index)fish, (fish_index)other, gap.body_m + way_m };
        crowd->touch_count = crowd->near_count;
    }
}

static void see_again(struct crowd *crowd, const struct fish *fish, uint32_t index)
{
    forget(crowd, index);
    crowd->way_m[index] = 0.0f;
    crowd->reach_m[index] = crowd->play_m[index] + reach_m(&fish[index]);
    for (uint32_t other = 0; other < crowd->count; other++) {
        if (other != index && (crowd->flags[other] & CROWD_SWIMS)) {
            meet_again(crowd, index, other);
        }
    }
}

int crowd_look_again(struct crowd *crowd, const struct fish *fish)
{
    fish_index beyond[AGAIN_MAX];
    uint32_t count = 0;
    for (uint32_t i = 0; i < crowd->count; i++) {
        if (is_beyond(crowd, i)) {
            if (count == AGAIN_MAX) {
                return 0;
            }
            beyond[count++] = (fish_index)i;
        }
    }
    if (crowd->touch_count + count * crowd->count > CROWD_CONTACT_MAX) {
        return 0;
    }
    for (uint32_t k = 0; k < count; k++) {
        see_again(crowd, fish, beyond[k]);
    }
    crowd_touch(crowd);
    return 1;
}

void crowd_touch(struct crowd *crowd)
{
    uint32_t count = 0;
    for (uint32_t c = 0; c < crowd->near_count; c++) {
        const struct contact contact = crowd->contact[c];
        const float ways_m = crowd->way_m[contact.a] + crowd->way_m[contact.b];
        const float plays_m = crowd->play_m[contact.a] + crowd->play_m[contact.b];
        const int swim = crowd->flags[contact.a] & crowd->flags[contact.b] & CROWD_SWIMS;
        if (swim && contact.gap_m - ways_m < plays_m) {
            crowd->contact[c] = crowd->contact[count];
            crowd->contact[count++] = contact;
        }
    }
    crowd->contact_count = count;
}

uint64_t crowd_hash(uint64_t hash, const struct crowd *crowd)
{
    hash = hash_u32(hash, crowd->near_count);
    hash = hash_u32(hash, crowd->touch_count);
    for (uint32_t c = 0; c < crowd->near_count; c++) {
        hash = hash_u32(hash, crowd->contact[c].a);
        hash = hash_u32(hash, crowd->contact[c].b);
        hash = hash_float(hash, crowd->contact[c].gap_m);
    }
    hash = hash_floats(hash, crowd->way_m, crowd->count);
    return hash_floats(hash, crowd->reach_m, crowd->count);
}
