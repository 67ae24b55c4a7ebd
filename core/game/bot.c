/* bot.c -- the art of the stall as rules: wait for a calm fish, wet the paper at a slant, glide
 * under with the paper along its way, lift slowly with the far edge up, empty over the bowl. */
#include "core/game/bot.h"

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/aim.h"
#include "core/game/paper.h"

/* An arm that is not in a hurry. */
#define ARM_M_S 0.36f
#define ARM_M_S2 2.5f
#define ARM_PULL_PER_S 6.0f     /* How eagerly the remaining way becomes speed. */
#define WRIST_RAD_S 2.6f
#define WRIST_PULL_PER_S 9.0f
#define DIP_M_S 0.17f
#define GLIDE_M_S 0.10f
#define LIFT_M_S 0.22f
#define CARRY_M_S 0.30f
#define TREMOR_M 0.0006f

#define HOVER_Y_M 0.065f        /* Over the water while it looks and carries. */
#define CRADLE_RAD (7.0f * F_DEG) /* Far edge up: water runs off, the fish lies against the rim. */
#define THERE_M 0.012f          /* Near enough, for a hand. */
#define ERROR_M 0.014f          /* How well it aims. */

#define THINK_TICKS_MIN 18u     /* 150 ms ... */
#define THINK_TICKS_MAX 30u     /* ... to 250 ms between two looks. */
#define LOOK_S 0.5f             /* Nobody chooses faster. */
#define ADMIRE_TICKS (3u * CORE_TICK_HZ) /* After a catch it looks at its bowl first. */
#define WATCH_S_MIN 0.4f
#define WATCH_S_MAX 1.8f
#define PATIENCE_S 2.2f         /* With a fish that does not come to rest. */
#define CALM_M_S 0.06f
#define LOST_M 0.09f            /* A fish that is farther from the ring is not followed. */
#define DRIP_S 0.60f            /* It lets the water run off before it carries. */

static float stage_s(const struct bot *bot, const struct core *core)
{
    return (float)(core->tick - bot->stage_tick) * CORE_TICK_S;
}

static void go(struct bot *bot, const struct core *core, uint8_t stage)
{
    bot->stage = stage;
    bot->stage_tick = core->tick;
    bot->think_tick = core->tick + 1u;
}

static float distance_to_aim(const struct bot *bot)
{
    return v3_length(v3_sub(bot->aim_m, bot->hand.position_m));
}

/* One draw in [0, 1) for each dip of each poi. */
static float luck(const struct core *core, uint32_t index, uint32_t which)
{
    const struct poi *poi = &core->poi[index];
    return rng_unit((struct rng_key){ poi->seed, poi->dips, which, RNG_BOT_CHOICE });
}

/* How far this try will miss what it aims at. */
static vec3 miss(const struct core *core, uint32_t index)
{
    return v3(ERROR_M * (2.0f * luck(core, index, 0) - 1.0f), 0.0f,
              ERROR_M * (2.0f * luck(core, index, 1) - 1.0f));
}

/* [0, 1]: it takes its time, but not when the round is nearly over. */
static float leisure(const struct core *core)
{
    const int counts = core->game.phase == PHASE_ROUND;
    return counts ? f_smoothstep(10.0f, 30.0f, game_seconds_left(&core->game, core->tick)) : 1.0f;
}

/* ---- Stages --------------------------------------------------------------------------------- */

static void go_for_another(struct bot *bot, const struct core *core, uint32_t index)
{
    bot->prey = aim_choose(core, index, bot->hand.position_m, &bot->yaw_rad);
    go(bot, core, bot->prey != AIM_NO_FISH ? BOT_APPROACH : BOT_LOOK);
}

static void look(struct bot *bot, const struct core *core, uint32_t index)
{
    bot->aim_m.y = HOVER_Y_M;
    bot->aim_angles = (struct angles){ bot->yaw_rad, 0.3f * AIM_SLANT_RAD, 0.0f };
    if (stage_s(bot, core) < LOOK_S || !paper_can_hold(&core->poi[index].sheet)) {
        return;
    }
    go_for_another(bot, core, index);
}

/* Both before the dip: the hand keeps over the entry as the fish moves on. */
static int keep_over_entry(struct bot *bot, const struct core *core, uint32_t index)
{
    struct way_in way;
    const uint8_t gait = core->tank.fish[bot->prey].gait;
    if (gait >= GAIT_HELD || gait == GAIT_ESCAPE ||
        !aim_way_in(core, index, bot->prey, bot->yaw_rad, &way)) {
        go_for_another(bot, core, index);
        return 0;
    }
    bot->aim_m = v3_add(way.entry_m, miss(core, index));
    bot->aim_angles = (struct angles){ bot->yaw_rad, AIM_SLANT_RAD, 0.0f };
    return 1;
}

static void approach(struct bot *bot, const struct core *core, uint32_t index)
{
    if (keep_over_entry(bot, core, index) && distance_to_aim(bot) < 2.0f * THERE_M) {
        go(bot, core, BOT_WATCH);
    }
}

static void watch(struct bot *bot, const struct core *core, uint32_t index)
{
    if (!keep_over_entry(bot, core, index)) {
        return;
    }
    const float longest_s = f_lerp(WATCH_S_MIN, WATCH_S_MAX, leisure(core));
    const float wait_s = f_lerp(WATCH_S_MIN, longest_s, luck(core, index, 2));
    const int calm = v3_length(core->tank.fish[bot->prey].velocity_m_s) < CALM_M_S;
    if (stage_s(bot, core) > PATIENCE_S) {
        go_for_another(bot, core, index);
    } else if (stage_s(bot, core) > wait_s && calm && distance_to_aim(bot) < THERE_M) {
        go(bot, core, BOT_DIP);
    }
}

/* From here on no way back but up: what fled is let go, what swims over the ring is taken. */
static int keep_prey(struct bot *bot, const struct core *core, uint32_t index)
{
    const struct fish *fish = &core->tank.fish[bot->prey];
    const vec3 d = v3_sub(fish->position_m, core->poi[index].position_m);
    const int near = d.x * d.x + d.z * d.z < LOST_M * LOST_M;
    if (near && fish->gait < GAIT_HELD && fish->gait != GAIT_ESCAPE) {
        return 1;
    }
    bot->prey = aim_over_ring(core, index, 0.5f * LOST_M);
    return bot->prey != AIM_NO_FISH;
}

static void dip(struct bot *bot, const struct core *core, uint32_t index)
{
    struct way_in way;
    (void)aim_way_in(core, index, bot->prey, bot->yaw_rad, &way);
    bot->aim_m = v3_add(way.stop_m, miss(core, index));
    bot->aim_angles = (struct angles){ bot->yaw_rad, AIM_SLANT_RAD, 0.0f };
    if (core->tank.fish[bot->prey].gait == GAIT_ESCAPE) {
        go(bot, core, keep_prey(bot, core, index) ? BOT_GLIDE : BOT_LIFT);
    } else if (distance_to_aim(bot) < THERE_M || stage_s(bot, core) > 1.8f) {
        go(bot, core, BOT_GLIDE);
    }
}

static void glide(struct bot *bot, const struct core *core, uint32_t index)
{
    struct way_in way;
    if (!keep_prey(bot, core, index)) {
        go(bot, core, BOT_LIFT);
        return;
    }
    (void)aim_way_in(core, index, bot->prey, bot->yaw_rad, &way);
    bot->aim_m = v3_add(way.under_m, miss(core, index));
    bot->aim_angles = (struct angles){ bot->yaw_rad, 0.0f, 0.0f };
    if (distance_to_aim(bot) < THERE_M || stage_s(bot, core) > 1.6f) {
        go(bot, core, BOT_LIFT);
    }
}

static void lift(struct bot *bot, const struct core *core, uint32_t index)
{
    const struct poi *poi = &core->poi[index];
    bot->aim_m.y = HOVER_Y_M;
    bot->aim_angles = (struct angles){ bot->yaw_rad, CRADLE_RAD, 0.0f };
    if (poi->immersed <= 0.0f && bot->hand.position_m.y > HOVER_Y_M - THERE_M) {
        go(bot, core, poi->rider_count > 0 ? BOT_CARRY : BOT_LOOK);
    }
}

/* The handle comes back toward the player on the way. The stall's rule for wristless hands tips the
 * poi over the bowl; the bot has none. */
static void carry(struct bot *bot, const struct core *core, uint32_t index)
{
    const struct bowl *bowl = &core->bowl[index];
    if (stage_s(bot, core) > DRIP_S) {
        bot->yaw_rad = 0.3f;
        bot->aim_m = v3(bowl->position_m.x, bowl->position_m.y + 0.05f, bowl->position_m.z);
        bot->aim_angles = (struct angles){ bot->yaw_rad, CRADLE_RAD, 0.0f };
    }
    if (core->poi[index].rider_count == 0 && core->poi[index].tip < 0.1f) {
        go(bot, core, BOT_LOOK); /* It jumped off on the way. */
    } else if (stage_s(bot, core) > DRIP_S && distance_to_aim(bot) < 2.0f * THERE_M) {
        go(bot, core, BOT_TIP);
    }
}

static void tip(struct bot *bot, const struct core *core, uint32_t index)
{
    if (core->poi[index].rider_count == 0 || stage_s(bot, core) > 2.0f) {
        go(bot, core, BOT_LOOK);
        bot->think_tick += (uint32_t)(int32_t)(leisure(core) * (float)ADMIRE_TICKS);
    }
}

static void think(struct bot *bot, const struct core *core, uint32_t index)
{
    static void (*const stages[BOT_STAGE_COUNT])(struct bot *, const struct core *, uint32_t) = {
        [BOT_LOOK] = look,   [BOT_APPROACH] = approach, [BOT_WATCH] = watch, [BOT_DIP] = dip,
        [BOT_GLIDE] = glide, [BOT_LIFT] = lift,         [BOT_CARRY] = carry, [BOT_TIP] = tip,
    };
    const struct rng_key key = { core->config.seed, core->tick, index, RNG_BOT_REACTION };
    bot->think_tick =
        core->tick + THINK_TICKS_MIN + rng_u32(key) % (THINK_TICKS_MAX - THINK_TICKS_MIN + 1u);
    stages[bot->stage](bot, core, index);
}

/* ---- Arm ------------------------------------------------------------------------------------ */

static float speed_max_m_s(uint8_t stage)
{
    switch (stage) {
    case BOT_DIP:
        return DIP_M_S;
    case BOT_GLIDE:
        return GLIDE_M_S;
    case BOT_LIFT:
        return LIFT_M_S;
    case BOT_CARRY:
    case BOT_TIP:
        return CARRY_M_S;
    default:
        return ARM_M_S;
    }
}

static float turn(float now_rad, float aim_rad)
{
    const float step = WRIST_RAD_S * CORE_TICK_S;
    return now_rad + f_clamp(WRIST_PULL_PER_S * CORE_TICK_S * (aim_rad - now_rad), -step, step);
}

static void move(struct bot *bot)
{
    const vec3 way = v3_sub(bot->aim_m, bot->hand.position_m);
    const vec3 wish = v3_limit(v3_scale(way, ARM_PULL_PER_S), speed_max_m_s(bot->stage));
    const vec3 change = v3_limit(v3_sub(wish, bot->velocity_m_s), ARM_M_S2 * CORE_TICK_S);
    bot->velocity_m_s = v3_add(bot->velocity_m_s, change);
    bot->hand.position_m = v3_mad(bot->hand.position_m, bot->velocity_m_s, CORE_TICK_S);
    bot->hand.angles.yaw_rad = turn(bot->hand.angles.yaw_rad, bot->aim_angles.yaw_rad);
    bot->hand.angles.pitch_rad = turn(bot->hand.angles.pitch_rad, bot->aim_angles.pitch_rad);
    bot->hand.angles.roll_rad = turn(bot->hand.angles.roll_rad, bot->aim_angles.roll_rad);
}

/* A few hertz, half a millimetre, each axis at its own pace. */
static vec3 tremor(uint32_t tick, uint32_t index)
{
    const float t = (float)(tick % (CORE_TICK_HZ * 60u)) * CORE_TICK_S + 7.0f * (float)index;
    return v3(TREMOR_M * f_sin(29.0f * t), 0.5f * TREMOR_M * f_sin(37.0f * t + 1.0f),
              TREMOR_M * f_sin(23.0f * t + 2.0f));
}

/* Between rounds it rests over the middle of the tank. */
static void rest(struct bot *bot, const struct core *core)
{
    go(bot, core, BOT_LOOK);
    bot->aim_m = v3(0.0f, 0.09f, 0.15f * core->tank.size_m.z);
    bot->aim_angles = (struct angles){ bot->yaw_rad, 0.3f * AIM_SLANT_RAD, 0.0f };
}

/* ---- Public --------------------------------------------------------------------------------- */

void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed)
{
    *bot = (struct bot){ .technique = *technique, .seed = seed, .prey = AIM_NO_FISH };
    bot->hand.position_m = v3(0.0f, HOVER_Y_M, 0.0f);
    bot->aim_m = bot->hand.position_m;
}

struct poi_target bot_tick(struct bot *bot, const struct sight *sight)
{
    const struct core *core = sight->core;
    const uint32_t index = sight->player;
    const uint8_t phase = core->game.phase;
    if (phase == PHASE_READY || phase == PHASE_RESULT) {
        rest(bot, core);
    } else if (core->tick >= bot->think_tick) {
        think(bot, core, index);
    }
    move(bot);
    struct poi_target out = bot->hand;
    out.position_m = v3_add(out.position_m, tremor(core->tick, index));
    return out;
}

uint64_t bot_hash(uint64_t hash, const struct bot *bot)
{
    hash = technique_hash(hash, &bot->technique);
    hash = hash_u32(hash, bot->seed);
    hash = hash_u32(hash, bot->stage);
    hash = hash_u32(hash, bot->prey);
    hash = hash_u32(hash, bot->stage_tick);
    hash = hash_u32(hash, bot->think_tick);
    hash = hash_float(hash, bot->yaw_rad);
    hash = hash_vec3(hash, bot->hand.position_m);
    hash = hash_float(hash, bot->hand.angles.yaw_rad);
    hash = hash_float(hash, bot->hand.angles.pitch_rad);
    hash = hash_float(hash, bot->hand.angles.roll_rad);
    hash = hash_vec3(hash, bot->velocity_m_s);
    hash = hash_vec3(hash, bot->aim_m);
    hash = hash_float(hash, bot->aim_angles.yaw_rad);
    hash = hash_float(hash, bot->aim_angles.pitch_rad);
    return hash_float(hash, bot->aim_angles.roll_rad);
}
