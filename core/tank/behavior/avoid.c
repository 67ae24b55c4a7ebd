/* avoid.c -- classifies the encounters of two fish and computes how each fish avoids the other
 * fish. */
#include "core/tank/behavior/avoid.h"

#include "core/base/panic.h"
#include "core/base/rng.h"

#define COS_20_DEG 0.93969262f
#define COS_45_DEG 0.70710678f
/* Probability that a fish that would swim into the side of another fish turns to pass behind the
 * other fish. Otherwise the fish turns to pass in front of the other fish (2013 thesis on goldfish
 * behavior, section 3.4). */
#define STRAIGHT_CHANCE 0.9f
/* Longest time for which a fish avoids another fish by yaw, a turn to the left or right. Afterwards
 * the fish avoids by pitch, up or down (2013 thesis, section 3.4). */
#define YAW_TIME_S 0.5f
#define PITCH_TIME_S 0.5f
/* Time for which a fish keeps its depth after it avoided another fish by pitch. Without this time,
 * the fish would return to its preferred depth and meet the other fish again. */
#define HOLD_DEPTH_S 0.5f
/* Closing speed (decrease of the gap per second) below which two fish do not avoid each other. Two
 * resting fish of 5 cm drift at up to 0.5 cm/s each, so their closing speed is at most this limit,
 * and only repulsion separates them. */
#define CLOSING_MIN_M_S 0.010f
/* Smallest factor by which a braking fish multiplies its speed goal. With a smaller factor, a fish
 * in a burst (the fastest gait) would lose more than half of its speed in a dense tank, where fish
 * brake often. */
#define BRAKE_MIN 0.4f
/* While a fish avoids another fish by yaw, a turn to the left or right, its intended heading stays
 * this angle ahead of its present yaw. */
#define LEAD_RAD (75.0f * F_DEG)
/* Factor on LEAD_RAD for a struck fish, into whose side another fish swims. A struck fish turns
 * slowly, because a fast turn would swing its tail into the other fish. */
#define STRUCK_SHARE 0.15f
#define TURN_LAG_S 0.12f /* Time constant with which the yaw rate decays after a turn. */
/* Speed at which repulsion separates two fish that touch each other, in body lengths per second.
 * For a fish of 5 cm the value equals 2.25 cm/s, which is 7.5 minus 5.25 cm/s (2013 thesis, section
 * 3.3). */
#define REPULSION_LENGTHS_PER_S 0.45f
/* Largest gap at which two fish repel each other, in body lengths. For a fish of 5 cm the gap is 1
 * cm. */
#define REPULSION_RANGE 0.2f

static float flat_cos(vec3 a, vec3 b)
{
    const float aa = a.x * a.x + a.z * a.z, bb = b.x * b.x + b.z * b.z;
    return (a.x * b.x + a.z * b.z) / f_sqrt(f_max(aa * bb, 1e-12f));
}

/* Class and roles of an encounter between two fish a and b. The fish that runs into the other fish
 * is active. If both fish run into each other, the fish that faces the other fish more is active.
 * In a tie, the fish with the lower index is active. */
struct encounter {
    uint8_t kind; /* Kind of the encounter for the active fish (enum meeting_kind). */
    bool a_is_active;
    uint32_t since;
};

/* Returns the encounter of two fish, which the angle between their headings classifies as head-on,
 * rear-end or side. If one of the fish already avoids the other fish, returns the encounter that
 * this fish stored when it began to avoid, because its turn has changed the angle since then. */
static struct encounter encounter(const struct avoid_party *a, const struct avoid_party *b,
                                  float a_faces, float b_faces, uint32_t tick)
{
    const bool a_avoids = a->avoiding != AVOID_NONE && a->avoid_with == b->index;
    if (a_avoids || (b->avoiding != AVOID_NONE && b->avoid_with == a->index)) {
        const struct avoid_party *first = a_avoids ? a : b;
        const bool is_active = first->avoid_kind != MEET_STRUCK;
        return (struct encounter){
            .kind = is_active ? first->avoid_kind : MEET_SIDE,
            .a_is_active = is_active == a_avoids,
            .since = first->avoid_since,
        };
    }
    const float along = flat_cos(a->forward, b->forward);
    return (struct encounter){
        .kind = along > COS_20_DEG    ? MEET_REAR_END
                : along < -COS_20_DEG ? MEET_HEAD_ON
                                      : MEET_SIDE,
        .a_is_active = a_faces > b_faces || (a_faces == b_faces && a->index < b->index),
        .since = tick,
    };
}

/* Sets the advice for two fish of which the fish `hitter` would swim into the side of the fish
 * `struck`. The hitter turns to pass behind the struck fish, which turns away a little. In one of
 * ten encounters the hitter turns to pass in front instead. */
static void advise_side_encounter(struct avoid_advice *hitter, vec3 hitter_forward,
                                  struct avoid_advice *struck, vec3 struck_forward, vec3 to_struck,
                                  uint32_t draw)
{
    const float sense = (float)(draw >> 8) * (1.0f / 16777216.0f) < STRAIGHT_CHANCE ? 1.0f : -1.0f;
    /* `runs_left` is > 0 if the struck fish swims to the left, seen from the hitter. `hit_on_left`
     * is > 0 if the hitter comes from the left side of the struck fish. */
    const float runs_left =
        struck_forward.x * hitter_forward.z - struck_forward.z * hitter_forward.x;
    const float hit_on_left = -to_struck.x * struck_forward.z - -to_struck.z * struck_forward.x;
    struck->kind = MEET_STRUCK;
    hitter->turn = runs_left > 0.0f ? -sense : sense;
    struck->turn = STRUCK_SHARE * (hit_on_left > 0.0f ? -sense : sense);
}

/* Returns true if two fish must avoid each other, because they would pass each other too closely on
 * their present courses. The smallest allowed distance is params->meet_miss times the sum of the
 * two body lengths. Always returns true if params->meet_miss is 0, because the 2013 thesis has no
 * such test. */
static bool courses_cross(const struct avoid_party *a, const struct avoid_party *b, vec3 apart,
                          const struct behavior_params *params)
{
    if (params->meet_miss == 0.0f) {
        return true;
    }
    const vec3 v = v3_sub(v3_scale(b->forward, b->speed_m_s), v3_scale(a->forward, a->speed_m_s));
    const float when_s = -v3_dot(apart, v) / f_max(v3_dot(v, v), 1e-6f);
    const vec3 miss = v3_muladd(apart, v, when_s);
    const float lengths_m = a->length_m + b->length_m;
    const float wide_m = params->meet_miss * lengths_m;
    return f_abs(miss.y) < 0.6f * (a->height_m + b->height_m) &&
           miss.x * miss.x + miss.z * miss.z < wide_m * wide_m;
}

/* Returns the factor by which a fish multiplies its speed goal. The result is below 1 if the fish
 * swims toward the other fish and would touch it within `brake_s` seconds. Otherwise the result is
 * 1, and the fish does not brake. */
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
        /* In a rear-end encounter only the fish behind (the active fish) turns, to a random
         * side. */
        active->turn = draw & 1u ? 1.0f : -1.0f;
        other->kind = MEET_NONE;
    } else if (now->kind == MEET_HEAD_ON) {
        /* Two fish that meet head-on both turn to their own left, or both turn to their own right,
         * and so pass each other. */
        const float side = draw & 1u ? 1.0f : -1.0f;
        pair->a.turn = side;
        pair->b.turn = side;
    } else if (now->a_is_active) {
        advise_side_encounter(active, a->forward, other, b->forward, apart, draw);
    } else {
        advise_side_encounter(active, b->forward, other, a->forward, v3_scale(apart, -1.0f), draw);
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

static void avoid_continue_or_end(struct fish *fish, const struct avoid_advice *advice,
                                  float water_depth_m)
{
    CORE_ASSERT(fish->avoid_left_s <= 0.0f);
    CORE_ASSERT(fish->avoiding != AVOID_NONE);
    if (fish->avoiding == AVOID_YAW && advice->kind != MEET_NONE) {
        fish->avoiding = AVOID_PITCH;
        fish->avoid_left_s = PITCH_TIME_S;
        /* The fish swims up or down as the advice says, but in the opposite direction if the
         * surface or the floor is too near. */
        const float room_m =
            advice->rise > 0 ? -fish->position_m.y : fish->position_m.y + water_depth_m;
        fish->avoid_turn = room_m < fish->height_m ? -(float)advice->rise : (float)advice->rise;
    } else {
        fish->avoid_left_s = fish->avoiding == AVOID_PITCH ? HOLD_DEPTH_S : 0.0f;
        fish->avoiding = AVOID_NONE;
        /* The fish ends its avoiding turn. The new heading includes the angle by which the fish
         * continues to turn while its yaw rate decays. */
        const float carries_rad = TURN_LAG_S * fish->yaw_rate_rad_s;
        const float ahead_rad = f_wrap_angle(fish->heading_rad - fish->angles.yaw_rad);
        if (f_abs(ahead_rad) > f_abs(carries_rad)) {
            fish->heading_rad = f_wrap_angle(fish->angles.yaw_rad + carries_rad);
        }
    }
}

bool avoid_holds_depth(const struct fish *fish)
{
    return fish->avoiding == AVOID_NONE && fish->avoid_left_s > 0.0f;
}

void avoid_tick(struct fish *fish, const struct avoid_advice *advice, float brake,
                const struct perception *around)
{
    CORE_ASSERT(brake >= 0.0f && brake <= 1.0f);
    CORE_ASSERT(around->dt_s > 0.0f);
    const bool meets = advice->kind != MEET_NONE;
    /* `brake` is the factor [0, 1] on the speed goal. The factor falls immediately, but rises by at
     * most 3 per second. */
    fish->brake = f_min(brake, fish->brake + 3.0f * around->dt_s);
    /* The remaining avoidance time decreases three times as fast if the fish meets no other fish
     * any more. */
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
        avoid_continue_or_end(fish, advice, around->size_m.y);
    }
    if (fish->avoiding == AVOID_YAW && meets) {
        /* The intended heading stays ahead of the present yaw by a fixed angle, so that the fish
         * keeps its turning rate until the turn ends. */
        fish->heading_rad = f_wrap_angle(fish->angles.yaw_rad + fish->avoid_turn * LEAD_RAD);
    }
}

float avoid_repulsion_m_s(float gap_m, float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float near = 1.0f - f_clamp(gap_m / (REPULSION_RANGE * length_m), 0.0f, 1.0f);
    return REPULSION_LENGTHS_PER_S * length_m * near * near;
}
