/* avoid.c -- classifies the encounters of two fish and computes how each fish avoids the other
 * fish. */
#include "core/tank/behavior/avoid.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/input.h"

#define COS_20_DEG 0.93969262f
#define COS_45_DEG 0.70710678f
/* Probability that the hitting fish passes behind the struck fish (section 3.4 of the 2013
 * thesis). */
#define STRAIGHT_CHANCE 0.9f
/* Longest duration of avoidance by yaw. Afterwards the fish avoids by pitch (2013 thesis, section
 * 3.4). */
#define YAW_TIME_S 0.5f
#define PITCH_TIME_S 0.5f
/* Time for which a fish keeps its depth after it avoided another fish by pitch. Without this time,
 * the fish would return to its preferred depth and meet the other fish again. */
#define HOLD_DEPTH_S 0.5f
/* Closing speed below which fish do not avoid each other. Two resting fish can drift toward each
 * other at this speed, and repulsion then separates them. */
#define CLOSING_MIN_M_S 0.010f
/* Smallest factor on the speed of a braking fish. With a smaller factor, a burst in a dense tank
 * would lose more than half its speed. */
#define BRAKE_MIN 0.4f
/* Angle from the fish's yaw to its new heading while the fish avoids by yaw. */
#define LEAD_RAD (75.0f * F_DEG)
/* Fraction of LEAD_RAD for the struck fish, which then turns at 67 deg/s and hardly swings its
 * tail. */
#define STRUCK_SHARE 0.15f
#define TURN_LAG_S 0.12f /* Time constant with which the yaw rate decays after a turn. */
/* Repulsion speed at contact in body lengths per second: (7.5 - 5.25) cm/s for a fish of 5 cm (2013
 * thesis, section 3.3). */
#define REPULSION_LENGTHS_PER_S 0.45f
#define REPULSION_RANGE 0.2f /* Range of the repulsion in body lengths: 1 cm for a fish of 5 cm. */

static float flat_cos(vec3 a, vec3 b)
{
    const float aa = a.x * a.x + a.z * a.z, bb = b.x * b.x + b.z * b.z;
    return (a.x * b.x + a.z * b.z) / f_sqrt(f_max(aa * bb, 1e-12f));
}

/* Returns a value > 0 if `to` points to the left of `forward`, seen from above. */
static float leftness(vec3 forward, vec3 to)
{
    return to.x * forward.z - to.z * forward.x;
}

static int gives_way_to(const struct avoid_party *a, const struct avoid_party *b)
{
    return a->avoiding != AVOID_NONE && a->avoid_with == b->index;
}

/* An encounter of two fish a and b. The fish that runs into the other fish is active. If each runs
 * into the other, the fish that faces the other fish more is active; in a tie, the fish with the
 * lower index. */
struct encounter {
    uint8_t kind; /* Kind of the encounter for the active fish (enum meeting_kind). */
    uint8_t a_is_active;
    uint32_t since;
};

/* Returns the encounter that the fish `first` recorded when it began to avoid. A turn during the
 * avoidance changes the angle between the fish, but not the class of the encounter. */
static struct encounter encounter_of(const struct avoid_party *first, int first_is_a)
{
    CORE_ASSERT(first->avoiding != AVOID_NONE);
    const int is_active = first->avoid_kind != MEET_STRUCK;
    return (struct encounter){
        .kind = is_active ? first->avoid_kind : MEET_SIDE,
        .a_is_active = is_active == first_is_a,
        .since = first->avoid_since,
    };
}

static struct encounter new_encounter(const struct avoid_party *a, const struct avoid_party *b,
                                      float a_faces, float b_faces, uint32_t tick)
{
    const float along = flat_cos(a->forward, b->forward);
    const uint8_t kind = along > COS_20_DEG    ? MEET_REAR_END
                         : along < -COS_20_DEG ? MEET_HEAD_ON
                                               : MEET_SIDE;
    const int a_is_active = a_faces > b_faces || (a_faces == b_faces && a->index < b->index);
    return (struct encounter){ kind, a_is_active != 0, tick };
}

static struct encounter encounter(const struct avoid_party *a, const struct avoid_party *b,
                                  float a_faces, float b_faces, uint32_t tick)
{
    return gives_way_to(a, b)   ? encounter_of(a, 1)
           : gives_way_to(b, a) ? encounter_of(b, 0)
                                : new_encounter(a, b, a_faces, b_faces, tick);
}

/* Sets the advice for an encounter from the side. The fish `hitter` passes behind the struck fish,
 * which turns away a little. In one of ten encounters the hitter passes in front of the struck
 * fish. */
static void meet_side(struct avoid_advice *hitter, vec3 hitter_forward, struct avoid_advice *struck,
                      vec3 struck_forward, vec3 to_struck, uint32_t draw)
{
    const float sense = (float)(draw >> 8) * (1.0f / 16777216.0f) < STRAIGHT_CHANCE ? 1.0f : -1.0f;
    const float runs_left = leftness(hitter_forward, struck_forward);
    const float hit_on_left = leftness(struck_forward, v3_scale(to_struck, -1.0f));
    struck->kind = MEET_STRUCK;
    hitter->turn = runs_left > 0.0f ? -sense : sense;
    struck->turn = STRUCK_SHARE * (hit_on_left > 0.0f ? -sense : sense);
}

/* Returns 1 if the courses of the fish cross, so that the fish must avoid each other. Only
 * living fish use the test; the 2013 thesis has no such test. Always returns 1 if
 * params->meet_miss is 0. */
static int courses_cross(const struct avoid_party *a, const struct avoid_party *b, vec3 apart,
                         const struct behavior_params *params)
{
    if (params->meet_miss == 0.0f) {
        return 1;
    }
    const vec3 v = v3_sub(v3_scale(b->forward, b->speed_m_s), v3_scale(a->forward, a->speed_m_s));
    const float when_s = -v3_dot(apart, v) / f_max(v3_dot(v, v), 1e-6f);
    const vec3 miss = v3_muladd(apart, v, when_s);
    const float lengths_m = a->length_m + b->length_m;
    const float wide_m = params->meet_miss * lengths_m;
    return f_abs(miss.y) < 0.6f * (a->height_m + b->height_m) &&
           miss.x * miss.x + miss.z * miss.z < wide_m * wide_m;
}

/* Returns the factor on the speed of a fish. The factor is below 1 if the fish swims toward the gap
 * and the gap would close within `brake_s`. */
static float brake_for(float faces, float gap_m, float closing_m_s, float brake_s)
{
    const float stop_m = brake_s * closing_m_s;
    if (faces < 0.3f || stop_m <= 0.0f) {
        return 1.0f;
    }
    return f_clamp(gap_m / stop_m, BRAKE_MIN, 1.0f);
}

static void advise(struct avoid_pair *pair, const struct avoid_party *a,
                   const struct avoid_party *b, const struct encounter *now, float contact_s,
                   uint32_t seed)
{
    CORE_ASSERT(contact_s >= 0.0f);
    const vec3 apart = v3_sub(b->position_m, a->position_m);
    const uint32_t low = a->index < b->index ? a->index : b->index;
    const uint32_t high = a->index < b->index ? b->index : a->index;
    const uint32_t key = rng_u32((struct rng_key){ seed, now->since, low, RNG_FISH_AVOID_SIDE });
    const uint32_t draw = rng_u32((struct rng_key){ key, now->since, high, RNG_FISH_AVOID_SIDE });
    const int8_t a_rise = apart.y < 0.0f || (apart.y == 0.0f && a->index < b->index) ? 1 : -1;
    pair->a = (struct avoid_advice){ now->kind, a_rise, b->index, now->since, contact_s, 0.0f };
    pair->b =
        (struct avoid_advice){ now->kind, (int8_t)-a_rise, a->index, now->since, contact_s, 0.0f };
    struct avoid_advice *active = now->a_is_active ? &pair->a : &pair->b;
    struct avoid_advice *other = now->a_is_active ? &pair->b : &pair->a;
    if (now->kind == MEET_REAR_END) {
        /* Only the follower, which is the active fish, avoids. */
        active->turn = draw & 1u ? 1.0f : -1.0f;
        other->kind = MEET_NONE;
    } else if (now->kind == MEET_HEAD_ON) {
        /* Both fish turn to their own left, or both turn to their own right. */
        const float side = draw & 1u ? 1.0f : -1.0f;
        pair->a.turn = side;
        pair->b.turn = side;
    } else if (now->a_is_active) {
        meet_side(active, a->forward, other, b->forward, apart, draw);
    } else {
        meet_side(active, b->forward, other, a->forward, v3_scale(apart, -1.0f), draw);
    }
}

struct avoid_pair avoid_meet(const struct avoid_party *a, const struct avoid_party *b, float gap_m,
                             const struct behavior_params *params, uint32_t seed, uint32_t tick)
{
    struct avoid_pair pair = { .brake_a = 1.0f, .brake_b = 1.0f };
    const vec3 apart = v3_sub(b->position_m, a->position_m);
    const vec3 to_b = v3_normalize_or(apart, v3(1.0f, 0.0f, 0.0f));
    const float a_faces = v3_dot(a->forward, to_b), b_faces = -v3_dot(b->forward, to_b);
    const float closing_m_s = a_faces * a->speed_m_s + b_faces * b->speed_m_s;
    pair.brake_a = brake_for(a_faces, gap_m, closing_m_s, params->brake_s);
    pair.brake_b = brake_for(b_faces, gap_m, closing_m_s, params->brake_s);
    if (closing_m_s < CLOSING_MIN_M_S ||
        (params->meet_within_s > 0.0f && gap_m > params->meet_within_s * closing_m_s) ||
        !courses_cross(a, b, apart, params)) {
        return pair;
    }
    if (flat_cos(a->forward, b->forward) > COS_20_DEG && f_max(a_faces, b_faces) < COS_45_DEG) {
        return pair; /* The fish swim side by side and need no avoidance. */
    }
    const struct encounter now = encounter(a, b, a_faces, b_faces, tick);
    advise(&pair, a, b, &now, f_max(gap_m, 0.0f) / closing_m_s, seed);
    return pair;
}

/* Returns `rise` or its opposite: -1 means down, +1 means up. The result is the opposite if the
 * surface or the floor is too near in the direction `rise`. */
static float possible_rise(const struct fish *fish, float rise, float water_depth_m)
{
    CORE_ASSERT(water_depth_m > 0.0f);
    const float room_m = 1.0f * fish->height_m;
    const float above_floor_m = fish->position_m.y + water_depth_m;
    if (rise > 0.0f) {
        return -fish->position_m.y < room_m ? -1.0f : 1.0f;
    }
    return above_floor_m < room_m ? 1.0f : -1.0f;
}

static void go_on_or_end(struct fish *fish, const struct avoid_advice *advice, float water_depth_m)
{
    CORE_ASSERT(fish->avoid_left_s <= 0.0f);
    CORE_ASSERT(fish->avoiding != AVOID_NONE);
    if (fish->avoiding == AVOID_YAW && advice->kind != MEET_NONE) {
        fish->avoiding = AVOID_PITCH;
        fish->avoid_left_s = PITCH_TIME_S;
        fish->avoid_turn = possible_rise(fish, advice->rise, water_depth_m);
    } else {
        fish->avoid_left_s = fish->avoiding == AVOID_PITCH ? HOLD_DEPTH_S : 0.0f;
        fish->avoiding = AVOID_NONE;
        /* The fish ends its avoiding turn. Its new heading includes the angle by which the fish
         * continues to turn because its yaw rate decays slowly. */
        const float carries_rad = TURN_LAG_S * fish->yaw_rate_rad_s;
        const float ahead_rad = f_wrap_angle(fish->heading_rad - fish->angles.yaw_rad);
        if (f_abs(ahead_rad) > f_abs(carries_rad)) {
            fish->heading_rad = f_wrap_angle(fish->angles.yaw_rad + carries_rad);
        }
    }
}

int avoid_holds_depth(const struct fish *fish)
{
    return fish->avoiding == AVOID_NONE && fish->avoid_left_s > 0.0f;
}

void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct perception *around)
{
    CORE_ASSERT(brake >= 0.0f && brake <= 1.0f);
    CORE_ASSERT(around->dt_s > 0.0f);
    const int meets = advice->kind != MEET_NONE;
    /* The factor `brake` rises from 0 to 1 in a third of a second at the earliest. */
    fish->brake = f_min(brake, fish->brake + 3.0f * around->dt_s);
    /* The remaining avoidance time runs three times as fast if the fish meets no other fish any
     * more. */
    const float pace = fish->avoiding != AVOID_NONE && !meets ? 3.0f : 1.0f;
    fish->avoid_left_s = f_max(0.0f, fish->avoid_left_s - pace * around->dt_s);
    if (fish->avoiding == AVOID_NONE) {
        if (meets) {
            fish->avoiding = AVOID_YAW;
            fish->avoid_left_s = YAW_TIME_S;
            fish->avoid_turn = advice->turn;
            fish->avoid_since = advice->since;
            fish->avoid_with = advice->with;
            fish->avoid_kind = advice->kind;
        }
    } else if (fish->avoid_left_s <= 0.0f) {
        go_on_or_end(fish, advice, around->size_m.y);
    }
    if (fish->avoiding == AVOID_YAW && meets) {
        /* The fish turns as fast as its gait allows (180 deg/s in GAIT_SWIM). */
        fish->heading_rad = f_wrap_angle(fish->angles.yaw_rad + fish->avoid_turn * LEAD_RAD);
    }
}

float avoid_repulsion_m_s(float gap_m, float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float near = 1.0f - f_clamp(gap_m / (REPULSION_RANGE * length_m), 0.0f, 1.0f);
    return REPULSION_LENGTHS_PER_S * length_m * near * near;
}
