/* bot_hunt.c -- the bot's stages from the approach of a fish to the position under the fish. */
#include "core/game/bot/bot_internal.h"

#define CALM_M_S 0.05f
#define CHASE_LOST_M 0.25f
#define LOST_M 0.075f /* Distance from the ring beyond which the bot stops following a fish. */
#define GLIDE_S_MAX 0.9f
#define DIP_S_MAX 1.2f
#define APPROACH_S_MAX 1.5f

static float entry_pitch_rad(const struct bot *bot)
{
    return -bot->technique.entry_deg * F_DEG;
}

/* Returns the time in seconds from the water surface until the fish is over the paper. */
static float stroke_s(const struct bot *bot)
{
    return 0.06f / bot->technique.dip_m_s + 0.03f / bot->technique.glide_m_s;
}

/* Keeps the poi over the start of the path while the fish moves. Returns 1 when the poi has
 * arrived, otherwise 0. */
static int keep_over_entry(struct bot *bot, uint32_t tick)
{
    struct approach_path way;
    const float reach_s = bot_way_left_m(bot) / bot->technique.arm_m_s;
    bot->yaw_rad = targeting_yaw(&bot->technique, &bot->known.prey, bot->yaw_rad);
    const float longest_s = APPROACH_S_MAX + bot->technique.patience_s;
    if (!bot_prey_swims(bot) || bot_stage_s(bot, tick) > longest_s ||
        !bot_way_to_prey(bot, tick, f_min(reach_s, 0.3f) + stroke_s(bot), &way)) {
        bot_go(bot, BOT_CHOOSE, tick);
        return 0;
    }
    bot_want(bot, way.entry_m, entry_pitch_rad(bot), bot->technique.arm_m_s);
    return bot_way_left_m(bot) < BOT_THERE_M && bot_wrist_is_there(bot);
}

void bot_approach(struct bot *bot, uint32_t tick)
{
    if (bot->known.carried_count > 0 && bot_saw_since(bot, 0.0f)) {
        bot_go(bot, BOT_CARRY, tick); /* A fish already lies on the paper. */
    } else if (keep_over_entry(bot, tick)) {
        bot_go(bot, bot->technique.hunt == HUNT_SHADE ? BOT_WATCH : BOT_DIP, tick);
    }
}

void bot_watch(struct bot *bot, uint32_t tick)
{
    if (bot_stage_s(bot, tick) > bot->technique.patience_s) {
        bot_go(bot, BOT_CHOOSE, tick);
    } else if (keep_over_entry(bot, tick) && v3_length(bot->known.prey.velocity_m_s) < CALM_M_S) {
        bot_go(bot, BOT_DIP, tick);
    }
}

void bot_dip(struct bot *bot, uint32_t tick)
{
    struct approach_path way;
    (void)bot_way_to_prey(bot, tick, 0.03f / bot->technique.glide_m_s, &way);
    bot_want(bot, way.stop_m, entry_pitch_rad(bot), bot->technique.dip_m_s);
    if (bot_way_left_m(bot) < BOT_THERE_M || bot_stage_s(bot, tick) > DIP_S_MAX) {
        bot_go(bot, BOT_GLIDE, tick);
    }
}

/* Keeps the target fish, or selects a nearby fish if the target escaped. Returns 1 if a fish is in
 * reach, otherwise 0. */
static int keep_prey(struct bot *bot, uint32_t tick)
{
    const float reach_m = bot->technique.hunt == HUNT_CHASE ? CHASE_LOST_M : LOST_M;
    const vec3 fish_m = snapshot_predict(&bot->known.prey, bot_age_s(bot, tick));
    const vec3 d = v3_sub(fish_m, bot_hand_m(bot));
    if (bot_prey_swims(bot) && d.x * d.x + d.z * d.z < reach_m * reach_m) {
        return 1;
    }
    const struct snapshot_fish *other = targeting_nearest(&bot->known, bot_hand_m(bot), reach_m);
    if (!other) {
        return 0;
    }
    bot->prey = other->fish;
    bot->known.prey = *other;
    return 1;
}

void bot_glide(struct bot *bot, uint32_t tick)
{
    const int chases = bot->technique.hunt == HUNT_CHASE;
    const float longest_s = chases ? bot->technique.patience_s : GLIDE_S_MAX;
    struct approach_path way;
    if (!keep_prey(bot, tick) || bot_stage_s(bot, tick) > longest_s) {
        bot_go(bot, BOT_LIFT, tick);
        return;
    }
    (void)bot_way_to_prey(bot, tick, 0.1f, &way);
    const float speed_m_s = chases ? bot->technique.arm_m_s : bot->technique.glide_m_s;
    bot_want(bot, way.under_m, -bot->technique.glide_deg * F_DEG, speed_m_s);
    if (bot_way_left_m(bot) < BOT_THERE_M) {
        bot_go(bot, BOT_LIFT, tick);
    }
}
