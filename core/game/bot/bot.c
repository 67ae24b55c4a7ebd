/* bot.c -- the bot's main loop and its arm. A snapshot becomes usable after the reaction time, and
 * the function of the current stage then acts on it. The arm moves with a bell-shaped speed profile
 * and with tremor. */
#include "core/game/bot/bot.h"

#include "core/base/panic.h"
#include "core/base/rng.h"

/* Ratio of the arm's speed (m/s) to the remaining distance to its goal (m) on the last part of the
 * way. Before that part the arm moves at full speed and then brakes at half of its acceleration, as
 * people do. */
#define CREEP_PER_S 11.0f
#define WRIST_PULL_PER_S 12.0f
#define WRIST_EASE_S 0.06f

/* Period after which the arm's tremor repeats. The tremor is a sum of sine waves whose frequencies
 * are multiples of 0.1 Hz, so the sum repeats every ten seconds. */
#define TREMOR_TICKS (10u * CORE_TICK_HZ)
#define SWAY_HZ 1.3f
#define DRIFT_HZ 3.7f
#define BEAT_HZ 9.1f
#define NOISE_TICKS 6u

static float turn_wrist(float now_rad, float goal_rad, float *rate_rad_s)
{
    CORE_ASSERT(f_is_finite(goal_rad));
    const float wanted_rad_s = f_clamp(WRIST_PULL_PER_S * f_wrap_angle(goal_rad - now_rad),
                                       -BOT_WRIST_RAD_S_MAX, BOT_WRIST_RAD_S_MAX);
    *rate_rad_s += (wanted_rad_s - *rate_rad_s) * (CORE_TICK_S / (WRIST_EASE_S + CORE_TICK_S));
    return f_wrap_angle(now_rad + *rate_rad_s * CORE_TICK_S);
}

/* Advances the arm by one tick toward `goal` with a bell-shaped speed profile. `speed_m_s` is the
 * maximum speed, and `ease_s` is the time to reach that speed. The arm comes to rest at `goal`. */
static void bot_hand_move(struct bot_hand *hand, const struct poi_target *goal, float speed_m_s,
                          float ease_s)
{
    CORE_ASSERT(speed_m_s > 0.0f && ease_s > 0.0f);
    const float gain_m_s2 = f_min(speed_m_s / ease_s, BOT_HAND_M_S2_MAX);
    const vec3 way = v3_sub(goal->position_m, hand->pose.position_m);
    const float way_m = v3_length(way), braking_m_s = f_sqrt(gain_m_s2 * way_m);
    const float reach_m_s = f_min(speed_m_s, f_min(braking_m_s, CREEP_PER_S * way_m));
    const vec3 toward = v3_normalize_or(way, v3(0.0f, 0.0f, 0.0f));
    const vec3 change = v3_sub(v3_scale(toward, reach_m_s), hand->velocity_m_s);
    const vec3 eased = v3_scale(change, CORE_TICK_S / (0.03f + CORE_TICK_S));
    hand->velocity_m_s = v3_add(hand->velocity_m_s, v3_limit(eased, gain_m_s2 * CORE_TICK_S));
    hand->pose.position_m = v3_muladd(hand->pose.position_m, hand->velocity_m_s, CORE_TICK_S);
    struct angles *now = &hand->pose.angles;
    now->yaw_rad = turn_wrist(now->yaw_rad, goal->angles.yaw_rad, &hand->turning.yaw_rad);
    now->pitch_rad = turn_wrist(now->pitch_rad, goal->angles.pitch_rad, &hand->turning.pitch_rad);
    now->roll_rad = turn_wrist(now->roll_rad, goal->angles.roll_rad, &hand->turning.roll_rad);
}

/* Returns the tremor of the arm along one axis, [-1, 1]. The tremor is the sum of three sine waves
 * (slow sway, drift and the 9 Hz muscle tremor) and of noise. The noise is piecewise linear with a
 * new random value every NOISE_TICKS. `seed` determines the phases of the waves. */
static float axis_tremor(uint32_t seed, uint32_t tick, uint32_t axis)
{
    CORE_ASSERT(axis < 3u);
    const float t = F_TAU * (float)(tick % TREMOR_TICKS) * CORE_TICK_S;
    const float phase = 2.1f * (float)axis + (float)(seed & 63u) * 0.1f;
    const struct rng_key now = { seed, tick / NOISE_TICKS, axis, RNG_BOT_TREMOR };
    const struct rng_key next = { seed, tick / NOISE_TICKS + 1u, axis, RNG_BOT_TREMOR };
    const float share = (float)(tick % NOISE_TICKS) / (float)NOISE_TICKS;
    const float noise = 2.0f * f_lerp(rng_unit(now), rng_unit(next), share) - 1.0f;
    return 0.4f * f_sin(SWAY_HZ * t + phase) + 0.2f * f_sin(DRIFT_HZ * t + 2.0f * phase) +
           0.2f * f_sin(BEAT_HZ * t + 3.0f * phase) + 0.2f * noise;
}

void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed)
{
    CORE_ASSERT(technique->reaction_min_s <= technique->reaction_max_s);
    *bot = (struct bot){ .technique = *technique, .seed = seed, .prey = SNAPSHOT_NO_FISH };
    bot->hand.pose.position_m = v3(0.0f, BOT_HOVER_Y_M, 0.0f);
    bot->known.prey.fish = bot->seen.prey.fish = SNAPSHOT_NO_FISH;
}

struct poi_target bot_tick(struct bot *bot, const struct vision *vision)
{
    CORE_ASSERT(vision->player < POI_MAX);
    const struct technique *technique = &bot->technique;
    const uint32_t tick = vision_game(vision).tick;
    /* The reaction time is over: the newest snapshot becomes usable, and the bot takes the next
     * snapshot. */
    if (tick >= bot->act_tick) {
        const struct rng_key key = { bot->seed, tick, 0, RNG_BOT_REACTION };
        const float wait_s =
            f_lerp(technique->reaction_min_s, technique->reaction_max_s, rng_unit(key));
        const struct snapshot_fish followed = bot->known.prey;
        bot->known = bot->seen;
        if (bot->known.prey.fish != bot->prey) {
            /* If the snapshot was taken before the present target fish was selected, the snapshot
             * lacks this fish. The earlier data of the target fish is then copied. */
            bot->known.prey = followed;
        }
        snapshot_take(&bot->seen, &bot->known, vision, bot->prey, bot_attention_m(bot));
        bot->act_tick = tick + (uint32_t)(int32_t)(wait_s * (float)CORE_TICK_HZ + 0.5f);
    }
    bot_decide(bot, tick);
    bot_hand_move(&bot->hand, &bot->goal, bot->speed_m_s, bot->ease_s);
    struct poi_target out = bot->hand.pose;
    const vec3 tremor = v3(axis_tremor(bot->seed, tick, 0), axis_tremor(bot->seed, tick, 1),
                           axis_tremor(bot->seed, tick, 2));
    out.position_m = v3_add(out.position_m, v3_scale(tremor, technique->tremor_m));
    return out;
}
