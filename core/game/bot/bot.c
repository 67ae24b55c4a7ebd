/* bot.c -- the bot's main loop. A snapshot becomes usable after the reaction time, and the function
 * of the current stage then acts on it. */
#include "core/game/bot/bot.h"

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/game/bot/bot_internal.h"

static uint32_t reaction_ticks(const struct bot *bot, uint32_t tick)
{
    const struct technique *t = &bot->technique;
    const struct rng_key key = { bot->seed, tick, 0, RNG_BOT_REACTION };
    const float wait_s = f_lerp(t->reaction_min_s, t->reaction_max_s, rng_unit(key));
    return (uint32_t)(int32_t)(wait_s * (float)CORE_TICK_HZ + 0.5f);
}

static vec3 attention_m(const struct bot *bot)
{
    const int hunts = bot->stage >= BOT_APPROACH && bot->stage <= BOT_LIFT;
    return hunts || bot->technique.hunt == HUNT_CHASE ? bot_hand_m(bot) : bot_ground_m(bot);
}

/* Makes the newest snapshot usable, and takes the next snapshot. */
static void perceive(struct bot *bot, const struct vision *vision, uint32_t tick)
{
    const struct snapshot_fish followed = bot->known.prey;
    bot->known = bot->seen;
    if (bot->known.prey.fish != bot->prey) {
        bot->known.prey = followed; /* The snapshot was taken before the present target was
                                       selected, so the earlier data of the target is copied. */
    }
    snapshot_take(&bot->seen, &bot->known, vision, bot->prey, attention_m(bot));
    bot->act_tick = tick + reaction_ticks(bot, tick);
}

static void decide(struct bot *bot, uint32_t tick)
{
    static void (*const stages[BOT_STAGE_COUNT])(struct bot *, uint32_t) = {
        [BOT_REST] = bot_rest,         [BOT_SOAK] = bot_soak,   [BOT_CHOOSE] = bot_choose,
        [BOT_APPROACH] = bot_approach, [BOT_WATCH] = bot_watch, [BOT_DIP] = bot_dip,
        [BOT_GLIDE] = bot_glide,       [BOT_LIFT] = bot_lift,   [BOT_CARRY] = bot_carry,
        [BOT_TIP] = bot_tip,
    };
    if (!bot_plays(bot) && bot->stage != BOT_REST) {
        bot_go(bot, BOT_REST, tick);
    }
    stages[bot->stage](bot, tick);
}

void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed)
{
    *bot = (struct bot){ .technique = *technique, .seed = seed, .prey = SNAPSHOT_NO_FISH };
    bot->hand.pose.position_m = v3(0.0f, BOT_HOVER_Y_M, 0.0f);
    bot->known.prey.fish = bot->seen.prey.fish = SNAPSHOT_NO_FISH;
}

struct poi_target bot_tick(struct bot *bot, const struct vision *vision)
{
    const uint32_t tick = vision_game(vision).tick;
    if (tick >= bot->act_tick) {
        perceive(bot, vision, tick);
    }
    decide(bot, tick);
    bot_hand_move(&bot->hand, &bot->goal, bot->speed_m_s, bot->ease_s);
    struct poi_target out = bot->hand.pose;
    const vec3 tremor = bot_hand_tremor(bot->technique.tremor_m, bot->seed, tick);
    out.position_m = v3_add(out.position_m, tremor);
    return out;
}

uint64_t bot_hash(uint64_t hash, const struct bot *bot)
{
    hash = technique_hash(hash, &bot->technique);
    hash = hash_u32(hash, bot->seed);
    hash = hash_u32(hash, bot->stage);
    hash = hash_u32(hash, bot->prey);
    hash = hash_u32(hash, bot->stage_tick);
    hash = hash_u32(hash, bot->act_tick);
    hash = hash_u32(hash, bot->tries);
    hash = hash_float(hash, bot->yaw_rad);
    hash = hash_vec3(hash, bot->miss_m);
    hash = hash_vec3(hash, bot->goal.position_m);
    hash = hash_float(hash, bot->goal.angles.yaw_rad);
    hash = hash_float(hash, bot->goal.angles.pitch_rad);
    hash = hash_float(hash, bot->goal.angles.roll_rad);
    hash = hash_float(hash, bot->speed_m_s);
    hash = hash_float(hash, bot->ease_s);
    hash = bot_hand_hash(hash, &bot->hand);
    hash = snapshot_hash(hash, &bot->known);
    return snapshot_hash(hash, &bot->seen);
}
