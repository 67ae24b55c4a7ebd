/* bot_hand.c -- computes the bell-shaped speed profile and the tremor of the bot's arm. */
#include "core/game/bot/bot_hand.h"

#include "core/base/hash.h"
#include "core/base/rng.h"

/* Ratio of the arm's speed to its remaining distance near the goal. Far from the goal the arm moves
 * at full speed, and it brakes at half of its acceleration, as people do. Near the goal the arm
 * moves slowly. */
#define CREEP_PER_S 11.0f
#define WRIST_PULL_PER_S 12.0f
#define WRIST_EASE_S 0.06f

/* Period of the tremor. All frequencies are multiples of 0.1 Hz, so the sum of the sine waves
 * repeats every ten seconds. */
#define TREMOR_TICKS (10u * CORE_TICK_HZ)
#define SWAY_HZ 1.3f
#define DRIFT_HZ 3.7f
#define BEAT_HZ 9.1f
#define NOISE_TICKS 6u

static float reach_m_s(float way_m, float speed_m_s, float gain_m_s2)
{
    const float braking = f_sqrt(gain_m_s2 * way_m);
    return f_min(speed_m_s, f_min(braking, CREEP_PER_S * way_m));
}

static float turn_wrist(float now_rad, float goal_rad, float *rate_rad_s)
{
    const float wish = f_clamp(WRIST_PULL_PER_S * f_wrap_angle(goal_rad - now_rad),
                               -BOT_WRIST_RAD_S_MAX, BOT_WRIST_RAD_S_MAX);
    *rate_rad_s += (wish - *rate_rad_s) * (CORE_TICK_S / (WRIST_EASE_S + CORE_TICK_S));
    return f_wrap_angle(now_rad + *rate_rad_s * CORE_TICK_S);
}

void bot_hand_move(struct bot_hand *hand, const struct poi_target *goal, float speed_m_s,
                   float ease_s)
{
    const float gain_m_s2 = f_min(speed_m_s / ease_s, BOT_HAND_M_S2_MAX);
    const vec3 way = v3_sub(goal->position_m, hand->pose.position_m);
    const float way_m = v3_length(way);
    const vec3 toward = v3_normalize_or(way, v3(0.0f, 0.0f, 0.0f));
    const vec3 wish = v3_scale(toward, reach_m_s(way_m, speed_m_s, gain_m_s2));
    const vec3 change = v3_sub(wish, hand->velocity_m_s);
    const vec3 eased = v3_scale(change, CORE_TICK_S / (0.03f + CORE_TICK_S));
    hand->velocity_m_s = v3_add(hand->velocity_m_s, v3_limit(eased, gain_m_s2 * CORE_TICK_S));
    hand->pose.position_m = v3_muladd(hand->pose.position_m, hand->velocity_m_s, CORE_TICK_S);
    struct angles *now = &hand->pose.angles;
    now->yaw_rad = turn_wrist(now->yaw_rad, goal->angles.yaw_rad, &hand->turning.yaw_rad);
    now->pitch_rad = turn_wrist(now->pitch_rad, goal->angles.pitch_rad, &hand->turning.pitch_rad);
    now->roll_rad = turn_wrist(now->roll_rad, goal->angles.roll_rad, &hand->turning.roll_rad);
}

/* Returns piecewise linear noise in [-1, 1], with a new random value every NOISE_TICKS. */
static float noise(uint32_t seed, uint32_t tick, uint32_t axis)
{
    const struct rng_key now = { seed, tick / NOISE_TICKS, axis, RNG_BOT_TREMOR };
    const struct rng_key next = { seed, tick / NOISE_TICKS + 1u, axis, RNG_BOT_TREMOR };
    const float share = (float)(tick % NOISE_TICKS) / (float)NOISE_TICKS;
    return 2.0f * f_lerp(rng_unit(now), rng_unit(next), share) - 1.0f;
}

static float axis_tremor(uint32_t seed, uint32_t tick, uint32_t axis)
{
    const float t = F_TAU * (float)(tick % TREMOR_TICKS) * CORE_TICK_S;
    const float phase = 2.1f * (float)axis + (float)(seed & 63u) * 0.1f;
    return 0.4f * f_sin(SWAY_HZ * t + phase) + 0.2f * f_sin(DRIFT_HZ * t + 2.0f * phase) +
           0.2f * f_sin(BEAT_HZ * t + 3.0f * phase) + 0.2f * noise(seed, tick, axis);
}

vec3 bot_hand_tremor(float tremor_m, uint32_t seed, uint32_t tick)
{
    return v3_scale(
        v3(axis_tremor(seed, tick, 0), axis_tremor(seed, tick, 1), axis_tremor(seed, tick, 2)),
        tremor_m);
}

uint64_t bot_hand_hash(uint64_t hash, const struct bot_hand *hand)
{
    const struct angles *at = &hand->pose.angles;
    hash = hash_vec3(hash, hand->pose.position_m);
    hash = hash_vec3(hash, v3(at->yaw_rad, at->pitch_rad, at->roll_rad));
    hash = hash_vec3(hash, hand->velocity_m_s);
    const struct angles *turning = &hand->turning;
    return hash_vec3(hash, v3(turning->yaw_rad, turning->pitch_rad, turning->roll_rad));
}
