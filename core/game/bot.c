/* bot.c -- the art of the stall as rules: wet the paper at a slant, glide under a calm fish with the
 * paper along its way, lift slowly with the far edge up, empty over the bowl. */
#include "core/game/bot.h"

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/core.h"
#include "core/game/paper.h"

/* An arm that is not in a hurry. */
#define ARM_M_S 0.45f
#define ARM_M_S2 3.0f
#define ARM_PULL_PER_S 7.0f      /* How eagerly the remaining way becomes speed. */
#define WRIST_RAD_S 2.6f
#define DIP_M_S 0.20f
#define GLIDE_M_S 0.14f
#define LIFT_M_S 0.19f
#define TREMOR_M 0.0006f

#define HOVER_M 0.060f           /* Over the water while it looks. */
#define UNDER_M 0.028f           /* The ring's depth below the fish. */
#define BACK_M 0.060f            /* It enters so far on the player's side of the fish. */
#define FLOOR_GAP_M 0.012f
#define WALL_GAP_M 0.070f
#define SLANT_RAD (-35.0f * F_DEG) /* Far edge down: the ring cuts the water edgewise. */
#define CRADLE_RAD (6.0f * F_DEG)  /* Far edge up: the fish slides toward the hand. */
#define TIP_RAD (-75.0f * F_DEG)

#define THINK_TICKS_MIN 18u      /* 150 ms ... */
#define THINK_TICKS_MAX 30u      /* ... to 250 ms between two looks. */
#define FORESIGHT_S 0.20f        /* How far ahead of a look it leads a moving fish. */

static float stage_s(const struct bot *bot, const struct core *core)
{
    return (float)(core->tick - bot->stage_tick) * CORE_TICK_S;
}

static void go(struct bot *bot, const struct core *core, uint8_t stage)
{
    bot->stage = stage;
    bot->stage_tick = core->tick;
    bot->think_tick = core->tick;
}

/* ---- Choosing ------------------------------------------------------------------------------- */

static float crowding(const struct tank *tank, uint32_t index)
{
    float crowd = 0.0f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const vec3 d = v3_sub(tank->fish[i].position_m, tank->fish[index].position_m);
        if (i != index && v3_dot(d, d) < 0.06f * 0.06f) {
            crowd += 1.0f;
        }
    }
    return crowd;
}

static int reachable(const struct core *core, uint32_t poi_index, const struct fish *fish)
{
    const vec3 p = fish->position_m;
    const struct bowl *bowl = &core->bowl[poi_index];
    const float dx = p.x - bowl->position_m.x;
    const float dz = p.z - bowl->position_m.z;
    const float clear_m = BOWL_RADIUS_M + POI_OUTER_RADIUS_M + 0.03f;
    return fish->gait < GAIT_HELD && fish->gait != GAIT_ESCAPE &&
           f_abs(p.x) < 0.5f * core->tank.size_m.x - WALL_GAP_M &&
           f_abs(p.z) < 0.5f * core->tank.size_m.z - WALL_GAP_M &&
           p.y > -core->tank.size_m.y + UNDER_M + FLOOR_GAP_M &&
           (!bowl->present || dx * dx + dz * dz > clear_m * clear_m);
}

/* What a look costs: depth, speed, way and weight all speak against a fish. */
static float cost_of(const struct bot *bot, const struct fish *fish)
{
    const vec3 way = v3_sub(fish->position_m, bot->hand.position_m);
    return -6.0f * fish->position_m.y + 4.0f * v3_length(fish->velocity_m_s) +
           1.2f * f_sqrt(way.x * way.x + way.z * way.z) + 6.0f * fish->length_m + fish->alarm;
}

static uint16_t choose(const struct bot *bot, const struct core *core, uint32_t poi_index)
{
    uint16_t best = BOT_NO_PREY;
    float best_cost = 1e9f;
    for (uint32_t i = 0; i < core->tank.fish_count; i++) {
        const struct fish *fish = &core->tank.fish[i];
        if (!reachable(core, poi_index, fish)) {
            continue;
        }
        const float cost = cost_of(bot, fish);
        if (cost < best_cost && cost + 0.1f * crowding(&core->tank, i) < best_cost) {
            best = (uint16_t)i;
            best_cost = cost + 0.1f * crowding(&core->tank, i);
        }
    }
    return best;
}

/* ---- Stages --------------------------------------------------------------------------------- */

static vec3 foresee(const struct core *core, uint16_t prey, float ahead_s)
{
    const struct fish *fish = &core->tank.fish[prey];
    return v3_mad(fish->position_m, fish->velocity_m_s, ahead_s);
}

static float glide_y_m(const struct core *core, vec3 fish_m)
{
    return f_max(fish_m.y - UNDER_M, -core->tank.size_m.y + FLOOR_GAP_M);
}

static int has_fish(const struct core *core, uint32_t index)
{
    for (uint32_t i = 0; i < core->tank.fish_count; i++) {
        if (core->tank.fish[i].gait == GAIT_HELD && core->tank.fish[i].holder == index) {
            return 1;
        }
    }
    return 0;
}

static void look(struct bot *bot, const struct core *core, uint32_t index)
{
    bot->aim_m.y = HOVER_M;
    bot->aim_angles = (struct angles){ 0.0f, 0.5f * SLANT_RAD, 0.0f };
    bot->prey = choose(bot, core, index);
    if (bot->prey != BOT_NO_PREY && paper_can_hold(&core->poi[index].sheet)) {
        go(bot, core, BOT_APPROACH);
    }
}

static void approach(struct bot *bot, const struct core *core, uint32_t index)
{
    const struct fish *fish = &core->tank.fish[bot->prey];
    if (!reachable(core, index, fish) || stage_s(bot, core) > 3.0f) {
        go(bot, core, BOT_LOOK);
        return;
    }
    const vec3 there = foresee(core, bot->prey, FORESIGHT_S);
    bot->aim_m = v3(there.x, 0.045f, there.z + BACK_M);
    bot->aim_angles = (struct angles){ 0.0f, SLANT_RAD, 0.0f };
    const vec3 way = v3_sub(bot->aim_m, bot->hand.position_m);
    if (v3_length(way) < 0.015f) {
        go(bot, core, BOT_DIP);
    }
}

static void dip(struct bot *bot, const struct core *core, uint32_t index)
{
    (void)index;
    const vec3 there = foresee(core, bot->prey, FORESIGHT_S);
    bot->aim_m = v3(there.x, glide_y_m(core, there), there.z + 0.5f * BACK_M);
    bot->aim_angles = (struct angles){ 0.0f, SLANT_RAD, 0.0f };
    if (bot->hand.position_m.y < bot->aim_m.y + 0.01f || stage_s(bot, core) > 1.5f) {
        go(bot, core, BOT_GLIDE);
    }
}

static void glide(struct bot *bot, const struct core *core, uint32_t index)
{
    (void)index;
    const vec3 there = foresee(core, bot->prey, FORESIGHT_S);
    bot->aim_m = v3(there.x, glide_y_m(core, there), there.z);
    bot->aim_angles = (struct angles){ 0.0f, 0.0f, 0.0f };
    const vec3 way = v3_sub(core->tank.fish[bot->prey].position_m, bot->hand.position_m);
    if (way.x * way.x + way.z * way.z < 0.014f * 0.014f || stage_s(bot, core) > 2.5f) {
        go(bot, core, BOT_LIFT);
    }
}

static void lift(struct bot *bot, const struct core *core, uint32_t index)
{
    bot->aim_m.y = HOVER_M;
    bot->aim_angles = (struct angles){ 0.0f, CRADLE_RAD, 0.0f };
    if (bot->hand.position_m.y > HOVER_M - 0.01f && core->poi[index].immersed <= 0.0f) {
        go(bot, core, has_fish(core, index) ? BOT_CARRY : BOT_LOOK);
    }
}

static void carry(struct bot *bot, const struct core *core, uint32_t index)
{
    const struct bowl *bowl = &core->bowl[index];
    bot->aim_m = v3(bowl->position_m.x, bowl->position_m.y + 0.05f, bowl->position_m.z);
    const vec3 way = v3_sub(bot->aim_m, bot->hand.position_m);
    if (!has_fish(core, index)) {
        go(bot, core, BOT_LOOK);
    } else if (v3_length(way) < 0.02f) {
        go(bot, core, BOT_TIP);
    }
}

static void tip(struct bot *bot, const struct core *core, uint32_t index)
{
    bot->aim_angles = (struct angles){ 0.0f, TIP_RAD, 0.0f };
    if (!has_fish(core, index) || stage_s(bot, core) > 2.0f) {
        go(bot, core, BOT_LOOK);
    }
}

static void think(struct bot *bot, const struct core *core, uint32_t index)
{
    static void (*const stages[])(struct bot *, const struct core *, uint32_t) = {
        [BOT_LOOK] = look, [BOT_APPROACH] = approach, [BOT_DIP] = dip, [BOT_GLIDE] = glide,
        [BOT_LIFT] = lift, [BOT_CARRY] = carry,       [BOT_TIP] = tip,
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
    default:
        return ARM_M_S;
    }
}

static float turn(float now_rad, float aim_rad)
{
    const float step = WRIST_RAD_S * CORE_TICK_S;
    return now_rad + f_clamp(0.08f * (aim_rad - now_rad), -step, step);
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
    bot->aim_angles = (struct angles){ 0.0f, 0.5f * SLANT_RAD, 0.0f };
}

void bot_init(struct bot *bot)
{
    *bot = (struct bot){ .prey = BOT_NO_PREY };
    bot->hand.position_m = v3(0.0f, HOVER_M, 0.0f);
    bot->aim_m = bot->hand.position_m;
}

struct poi_target bot_tick(struct bot *bot, const struct core *core, uint32_t index)
{
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
    hash = hash_u32(hash, bot->stage);
    hash = hash_u32(hash, bot->prey);
    hash = hash_u32(hash, bot->stage_tick);
    hash = hash_u32(hash, bot->think_tick);
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
