/* bot_internal.c -- helpers shared by all stages of the bot. */
#include "core/game/bot/bot_internal.h"

#define WRIST_THERE_RAD (3.0f * F_DEG)
#define EASE_S 0.15f /* Time in which the arm accelerates to its maximum speed. */
#define BESIDE_BOWL_M 0.14f

float bot_stage_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->stage_tick) * CORE_TICK_S;
}

float bot_age_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->known.tick) * CORE_TICK_S;
}

int bot_saw_since(const struct bot *bot, float after_s)
{
    const float seen_s = ((float)bot->known.tick - (float)bot->stage_tick) * CORE_TICK_S;
    return seen_s >= after_s;
}

void bot_go(struct bot *bot, uint8_t stage, uint32_t tick)
{
    if (stage < BOT_APPROACH || stage > BOT_GLIDE) {
        bot->prey = SNAPSHOT_NO_FISH;
    }
    bot->stage = stage;
    bot->stage_tick = tick;
}

void bot_want(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s)
{
    bot->goal.position_m = position_m;
    bot->goal.angles = (struct angles){ bot->yaw_rad, pitch_rad, 0.0f };
    bot->speed_m_s = speed_m_s;
    bot->ease_s = EASE_S;
}

int bot_wrist_is_there(const struct bot *bot)
{
    const struct angles *now = &bot->hand.pose.angles, *goal = &bot->goal.angles;
    return f_abs(f_wrap_angle(goal->pitch_rad - now->pitch_rad)) < WRIST_THERE_RAD &&
           f_abs(f_wrap_angle(goal->roll_rad - now->roll_rad)) < WRIST_THERE_RAD;
}

float bot_way_left_m(const struct bot *bot)
{
    return v3_length(v3_sub(bot->goal.position_m, bot->hand.pose.position_m));
}

vec3 bot_hand_m(const struct bot *bot)
{
    return bot->hand.pose.position_m;
}

int bot_way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s, struct approach_path *way)
{
    const struct snapshot_fish *prey = &bot->known.prey;
    const vec3 fish_m = v3_add(snapshot_predict(prey, bot_age_s(bot, tick) + ahead_s), bot->miss_m);
    return targeting_approach(&bot->technique, &bot->known, fish_m, prey->length_m, bot->yaw_rad,
                              way);
}

int bot_prey_swims(const struct bot *bot)
{
    return bot->prey != SNAPSHOT_NO_FISH && bot->known.prey.place == SCENE_IN_TANK;
}

/* Returns a point beside the bowl, toward the middle of the tank. */
vec3 bot_ground_m(const struct bot *bot)
{
    const vec3 bowl_m = bot->known.bowl.position_m;
    const vec3 inward = v3_normalize_or(v3(-bowl_m.x, 0.0f, -bowl_m.z), v3(0.0f, 0.0f, -1.0f));
    return v3_muladd(v3(bowl_m.x, 0.0f, bowl_m.z), inward, BESIDE_BOWL_M);
}

int bot_plays(const struct bot *bot)
{
    return (bot->known.phase == PHASE_ROUND || bot->known.phase == PHASE_ATTRACT) &&
           bot->known.poi.present;
}
