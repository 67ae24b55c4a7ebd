/* bot_wait.c -- the bot's stages before a scoop: rest, wet the paper, and select a fish. */
#include "core/game/bot/bot_internal.h"

#include "core/base/rng.h"

/* Distance beyond the tank's wall at which the poi's shadow falls beside the tank. */
#define REST_BEYOND_M 0.12f
#define REST_Y_M 0.14f
#define SOAK_PITCH_RAD (-40.0f * F_DEG)
#define SOAK_MARGIN_M 0.006f
#define SOAKED 0.85f /* Share of the technique's wet area at which wetting the paper ends. */
#define SOAK_S_MAX 2.6f

static int paper_is_fresh(const struct bot *bot)
{
    return bot->known.paper.wet < 0.3f * bot->technique.wet;
}

void bot_rest(struct bot *bot, uint32_t tick)
{
    bot->yaw_rad = 0.3f;
    const vec3 ground_m = bot_ground_m(bot);
    const float front_m = 0.5f * bot->known.tank_m.z + REST_BEYOND_M;
    bot_want(bot, v3(ground_m.x, REST_Y_M, front_m), 0.0f, bot->technique.arm_m_s);
    if (bot_plays(bot)) {
        bot_go(bot, paper_is_fresh(bot) ? BOT_SOAK : BOT_CHOOSE, tick);
    }
}

/* Returns the ring's height at which the share `share` of its area is under water while the poi is
 * tilted. */
static float soak_y_m(float share)
{
    const float low = TARGETING_RING_M * f_sin(-SOAK_PITCH_RAD);
    return share >= 0.99f ? -low - SOAK_MARGIN_M : -(2.0f * share - 1.0f) * low;
}

void bot_soak(struct bot *bot, uint32_t tick)
{
    const float done_s = bot_stage_s(bot, tick);
    vec3 place_m = bot_ground_m(bot);
    place_m.y = soak_y_m(bot->technique.wet);
    const vec3 over_m = v3(place_m.x, BOT_HOVER_Y_M, place_m.z);
    const vec3 aside = v3_sub(bot_hand_m(bot), over_m);
    const int is_over = aside.x * aside.x + aside.z * aside.z < BOT_THERE_M * BOT_THERE_M;
    bot->yaw_rad = 0.3f;
    bot_want(bot, is_over ? place_m : over_m, SOAK_PITCH_RAD,
             is_over ? bot->technique.dip_m_s : bot->technique.arm_m_s);
    const int wet = bot->known.paper.wet >= SOAKED * bot->technique.wet;
    if (wet || done_s > SOAK_S_MAX + 1.0f) {
        bot_go(bot, BOT_CHOOSE, tick);
    }
}

static float luck(const struct bot *bot, uint32_t which)
{
    return rng_unit((struct rng_key){ bot->seed, bot->tries, which, RNG_BOT_CHOICE });
}

static void go_for(struct bot *bot, const struct snapshot_fish *fish, uint32_t tick)
{
    bot->prey = fish->fish;
    bot->known.prey = *fish;
    bot->tries++;
    const float angle = F_TAU * luck(bot, 0);
    const float far_m = bot->technique.aim_m * f_sqrt(luck(bot, 1));
    bot->miss_m = v3(far_m * f_cos(angle), 0.0f, far_m * f_sin(angle));
    bot_go(bot, BOT_APPROACH, tick);
}

void bot_choose(struct bot *bot, uint32_t tick)
{
    const vec3 hand_m = bot_hand_m(bot);
    bot_want(bot, v3(hand_m.x, BOT_HOVER_Y_M, hand_m.z), 0.0f, bot->technique.arm_m_s);
    if (paper_is_fresh(bot) && bot->known.paper.holds && bot_saw_since(bot, 0.0f)) {
        bot_go(bot, BOT_SOAK, tick);
        return;
    }
    if (!bot->known.paper.holds) {
        return;
    }
    const struct snapshot_fish *fish =
        targeting_choose(&bot->technique, &bot->known, hand_m, bot_age_s(bot, tick), &bot->yaw_rad);
    if (fish) {
        go_for(bot, fish, tick);
    }
}
