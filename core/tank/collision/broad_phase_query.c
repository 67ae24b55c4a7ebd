/* broad_phase_query.c -- one broad-phase query: finds the pairs of nearby fish, computes how the
 * two fish of each pair avoid each other, and makes the contact list. */
#include "core/tank/collision/broad_phase.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/tank/behavior/swim.h"

/* Gap to another fish below which a fish turns more slowly. In a fast turn, the tail of the fish
 * would sweep through this gap in a few ticks. */
#define ROOM_GAP_M 0.005f
#define ROOM_MIN 0.2f
/* Number of pairs by which a prefetch precedes the use of the prefetched data. Testing this number
 * of pairs takes as long as one memory access. */
#define FETCH_AHEAD 8u

static void take_advice(struct avoid_advice *kept, const struct avoid_advice *advice)
{
    if (advice->kind != MEET_NONE &&
        (kept->kind == MEET_NONE || advice->contact_s < kept->contact_s)) {
        *kept = *advice;
    }
}

static struct avoid_party party_of(const struct body *body, const struct fish *fish, uint32_t index)
{
    return (struct avoid_party){
        .position_m = body->centre_m,
        .forward = v3_scale(body->back, -1.0f),
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

/* Adds the push by a nearby fish to the sum of the pushes on a fish. The component of the push
 * along the fish's body is halved, so that a push from behind does not make the fish too fast. */
static void push_apart(struct neighbours *neighbours, vec3 forward, vec3 axis, float speed_m_s)
{
    const float along = v3_dot(axis, forward);
    const vec3 push = v3_muladd(axis, forward, -0.5f * along);
    neighbours->push_m_s = v3_muladd(neighbours->push_m_s, push, speed_m_s);
}

/* Adds a contact to the list. If the list is full, the new contact replaces a random contact or is
 * not listed (reservoir sampling). Every pair has the same probability to be listed, and no pair
 * stays unlisted for long. */
static void list_contact(struct broad_phase *broad_phase, struct contact contact, uint32_t seed,
                         uint32_t tick)
{
    const uint32_t most = broad_phase_contact_max(broad_phase);
    uint32_t place = broad_phase->touch_count++;
    if (place >= most) {
        place = rng_u32((struct rng_key){ seed, tick, place, RNG_CONTACT_LOT }) % (place + 1u);
        const struct contact *unlisted = place < most ? &broad_phase->contact[place] : &contact;
        broad_phase->flags[unlisted->a] |= BODY_UNLISTED;
        broad_phase->flags[unlisted->b] |= BODY_UNLISTED;
    }
    if (place < most) {
        broad_phase->contact[place] = contact;
        broad_phase->near_count = broad_phase->touch_count < most ? broad_phase->touch_count : most;
    }
}

/* Data that the functions of one broad-phase query share. */
struct query {
    struct broad_phase *broad_phase;
    const struct fish *fish;
    const struct perception *around;
    bool contacts_only;
};

static void advise_pair(const struct query *query, const struct narrow_phase_pair *found)
{
    struct broad_phase *broad_phase = query->broad_phase;
    const struct perception *around = query->around;
    const struct body *a = &broad_phase->body[found->a], *b = &broad_phase->body[found->b];
    struct neighbours *ca = &broad_phase->neighbours[found->a];
    struct neighbours *cb = &broad_phase->neighbours[found->b];
    const struct avoid_party pa = party_of(a, &query->fish[found->a], found->a);
    const struct avoid_party pb = party_of(b, &query->fish[found->b], found->b);
    const struct avoid_pair advice =
        avoid_meet(&pa, &pb, found->gap_m, around->params, around->seed, around->tick);
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
        const vec3 axis = narrow_phase_axis(a, b, found->axis);
        push_apart(ca, pa.forward, axis, -apart_m_s);
        push_apart(cb, pb.forward, axis, apart_m_s);
    }
}

static void take_found(const struct query *query, const struct narrow_phase_pair *found)
{
    struct broad_phase *broad_phase = query->broad_phase;
    if (found->spaces && !query->contacts_only && !query->around->ball_spaces) {
        advise_pair(query, found);
    }
    broad_phase->overlap_count += found->gap_m < 0.0f;
    if (found->gap_m < broad_phase->reach_m[found->a] + broad_phase->reach_m[found->b]) {
        const struct contact contact = { (fish_index)found->a, (fish_index)found->b, found->gap_m };
        list_contact(broad_phase, contact, query->around->seed, query->around->tick);
    }
}

/* Prefetches the data of a fish. In a large tank, neighbours are far apart in memory and outside
 * every cache. */
static void fetch_fish(const struct query *query, uint32_t index)
{
    __builtin_prefetch(&query->fish[index].speed_m_s);
    __builtin_prefetch(&query->fish[index].avoid_since);
    __builtin_prefetch(&query->broad_phase->body[index]);
    __builtin_prefetch(&query->broad_phase->neighbours[index], 1);
}

static void run_query(const struct query *query, const struct narrow_phase_query *of, bool ahead)
{
    CORE_ASSERT(query->broad_phase->count <= TANK_FISH_MAX);
    struct broad_phase *broad_phase = query->broad_phase;
    broad_phase->touch_count = 0;
    broad_phase->near_count = 0;
    broad_phase->overlap_count = 0;
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        broad_phase->flags[i] &= (uint8_t)~BODY_UNLISTED;
        if (!query->contacts_only) {
            broad_phase->neighbours[i] = (struct neighbours){ .brake = 1.0f, .room = 1.0f };
        }
        broad_phase->reach_m[i] =
            broad_phase->play_m[i] + (ahead ? broad_phase_reach_m(&query->fish[i]) : 0.0f);
        broad_phase->way_m[i] = broad_phase->flags[i] & BODY_SWIMMING ? 0.0f : SWIM_FAR_M;
    }
    narrow_phase_begin(&broad_phase->narrow_phase, of);
    for (uint32_t count;
         narrow_phase_next(&broad_phase->narrow_phase, of, broad_phase->found, &count);) {
        for (uint32_t f = 0; f < count; f++) {
            if (f + FETCH_AHEAD < count) {
                fetch_fish(query, broad_phase->found[f + FETCH_AHEAD].a);
                fetch_fish(query, broad_phase->found[f + FETCH_AHEAD].b);
            }
            take_found(query, &broad_phase->found[f]);
        }
    }
}

static float bounding_radius_m(const struct body *body)
{
    const float m = body->margin_m;
    return v3_length(v3(body->half_x_m + m, body->half_y_m + m, body->half_z_m + m));
}

/* Finds the pairs whose personal spaces overlap if each space is a ball. Section 3.4 of the 2013
 * thesis on goldfish behavior rejected such balls, so the function serves only for comparison and
 * is not used in a kiosk. The function tests each fish against each other fish. */
static void advise_all_balls(const struct query *query)
{
    const struct broad_phase *broad_phase = query->broad_phase;
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const struct body *a = &broad_phase->body[j], *b = &broad_phase->body[i];
            const vec3 way = v3_sub(b->centre_m, a->centre_m);
            const float both_m = bounding_radius_m(a) + bounding_radius_m(b);
            if ((broad_phase->flags[i] & broad_phase->flags[j] & BODY_SWIMMING) &&
                v3_dot(way, way) < both_m * both_m) {
                const struct box_gap gap = body_gap(a, 1.0f, b, 1.0f);
                const struct narrow_phase_pair found = {
                    .a = j,
                    .b = i,
                    .gap_m = gap.body_m,
                    .axis = gap.which,
                };
                advise_pair(query, &found);
            }
        }
    }
}

void broad_phase_update(struct broad_phase *broad_phase, const struct fish *fish,
                        struct broad_phase_search how, const struct perception *around)
{
    CORE_ASSERT(around->size_m.x > 0.0f && around->size_m.z > 0.0f);
    CORE_ASSERT(simd_is_built(how.lanes));
    const struct query query = { broad_phase, fish, around, how.contacts_only };
    const struct narrow_phase_query of = {
        .body = broad_phase->body,
        .flags = broad_phase->flags,
        .reach_m = broad_phase->reach_m,
        .count = broad_phase->count,
        .which = BODY_SWIMMING,
        .search = how.search,
        .lanes = how.lanes,
        .bodies_only = how.contacts_only,
        .width_m = around->size_m.x,
        .breadth_m = around->size_m.z,
    };
    run_query(&query, &of, true);
    /* If the contact list overflowed, a second search lists only the pairs that could touch in this
     * tick. The next query is then due soon. */
    if (broad_phase->touch_count > broad_phase_contact_max(broad_phase)) {
        run_query(&query, &of, false);
    }
    if (around->ball_spaces && !how.contacts_only) {
        advise_all_balls(&query);
    }
    broad_phase_select_contacts(broad_phase);
}
