/* crowd.c -- the bodies of all fish, and how long the pairs found by a broad-phase query stay
 * valid. */
#include "core/tank/crowd.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/swim.h"

#define REACH_SPARE_M 0.0035f /* Margin beyond 1.2 times the present motion; covers most starts and
                                 turns. */
#define REACH_SPARE 1.2f
#define AGAIN_MAX 8u /* Fish queried one by one; for more fish a full query is as cheap. */
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

/* Returns 1 if the body stands out of the water. The cheap sphere test rejects most bodies
 * first. */
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
            crowd->way_m[i] = SWIM_FAR_M; /* Invalid until a query has seen this fish swim. */
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

float crowd_reach_m(const struct fish *fish)
{
    const float pace_m_s = fish->speed_m_s + f_abs(fish->climb_m_s) + v3_length(fish->push_m_s) +
                           f_abs(fish->yaw_rate_rad_s) * RADIUS_PER_LENGTH * fish->length_m;
    return REACH_SPARE * (float)CROWD_LOOK_TICKS * CORE_TICK_S * pace_m_s + REACH_SPARE_M;
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
    int farther = crowd->touch_count > crowd_contact_max(crowd);
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

/* Lists the pair if it could touch before the next query of either fish. The gap is computed from
 * the position that the other fish had at its last query. */
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
        CORE_ASSERT(crowd->near_count < crowd_contact_max(crowd));
        crowd->contact[crowd->near_count++] =
            (struct contact){ (fish_index)fish, (fish_index)other, gap.body_m + way_m };
        crowd->touch_count = crowd->near_count;
    }
}

static void see_again(struct crowd *crowd, const struct fish *fish, uint32_t index)
{
    forget(crowd, index);
    crowd->way_m[index] = 0.0f;
    crowd->reach_m[index] = crowd->play_m[index] + crowd_reach_m(&fish[index]);
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
    if (crowd->touch_count + count * crowd->count > crowd_contact_max(crowd)) {
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
