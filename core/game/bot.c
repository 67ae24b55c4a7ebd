/* bot.c -- the mind: stages of a scoop. What the hand feels it knows at once: that it has arrived,
 * and how long ago something began. All else it has seen, a moment ago. */
#include "core/game/bot.h"

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/game/aim.h"
#include "core/poi/pose.h"

#define HOVER_Y_M 0.062f          /* Over the water while it chooses. */
#define LIFTED_Y_M 0.058f         /* The ring is clear of the water, with a fish on it. */
#define REST_BEYOND_M 0.12f       /* Its shadow falls beside the tank. */
#define REST_Y_M 0.14f
#define THERE_M 0.012f            /* Near enough, for a hand on its way. */
#define WRIST_THERE_RAD (3.0f * F_DEG)
#define EASE_S 0.15f              /* A hand gets up its speed in this time. */
#define HASTY_EASE_S 0.06f
#define HASTY_SHARE 2.5f          /* Of the speed of a drained lift. */

#define BESIDE_BOWL_M 0.14f       /* Where it soaks its paper and looks for fish. */
#define SOAK_PITCH_RAD (-40.0f * F_DEG)
#define SOAK_MARGIN_M 0.006f
#define SOAKED 0.85f              /* Of the share that it means to wet. */
#define SOAK_S_MAX 2.6f

#define CALM_M_S 0.05f
#define CHASE_LOST_M 0.25f
#define LOST_M 0.075f             /* A fish that is farther from the ring is not followed. */
#define GLIDE_S_MAX 0.9f
#define DIP_S_MAX 1.2f
#define APPROACH_S_MAX 1.5f
#define CRADLE_RAD (0.0f * F_DEG) /* Far edge down: water runs off, and a fish lies at the rim. */

#define JAM_M 0.050f              /* A ring seen so far below the hand is held by fish: wait. */

#define STUCK_S 1.4f              /* No lift takes so long: */
#define STUCK_Y_M (-0.005f)       /* it is stuck, if it is still under water. */
#define STUCK_BACK_M 0.035f
#define STUCK_BACK_S 0.35f
#define STUCK_TURN_S 1.2f

#define TIP_RAD (58.0f * F_DEG)   /* Steep enough for a fish to roll over the ring. */
#define TIP_FALL_M 0.046f         /* It leaves the ring so far from its centre. */
#define TIP_EDGE_M 0.010f         /* The lower edge keeps so far over the mouth. */
#define TIP_HOLD_S 0.42f
#define TIP_LAST_S 1.5f

/* ---- What it has -------------------------------------------------------------------------- */

static float stage_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->stage_tick) * CORE_TICK_S;
}

static float age_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->known.tick) * CORE_TICK_S;
}

/* What it knows was seen in this stage. */
static int saw_since(const struct bot *bot, float after_s)
{
    const float seen_s = ((float)bot->known.tick - (float)bot->stage_tick) * CORE_TICK_S;
    return seen_s >= after_s;
}

static float luck(const struct bot *bot, uint32_t which)
{
    return rng_unit((struct rng_key){ bot->seed, bot->tries, which, RNG_BOT_CHOICE });
}

/* Who begins to lift looks at no one fish any more. */
static void go(struct bot *bot, uint8_t stage, uint32_t tick)
{
    if (stage < BOT_APPROACH || stage > BOT_GLIDE) {
        bot->prey = LOOK_NO_FISH;
    }
    bot->stage = stage;
    bot->stage_tick = tick;
}

static void want(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s)
{
    bot->goal.position_m = position_m;
    bot->goal.angles = (struct angles){ bot->yaw_rad, pitch_rad, 0.0f };
    bot->speed_m_s = speed_m_s;
    bot->ease_s = EASE_S;
}

static int wrist_is_there(const struct bot *bot)
{
    const struct angles *now = &bot->hand.pose.angles, *goal = &bot->goal.angles;
    return f_abs(f_wrap_angle(goal->pitch_rad - now->pitch_rad)) < WRIST_THERE_RAD &&
           f_abs(f_wrap_angle(goal->roll_rad - now->roll_rad)) < WRIST_THERE_RAD;
}

static float way_left_m(const struct bot *bot)
{
    return v3_length(v3_sub(bot->goal.position_m, bot->hand.pose.position_m));
}

static vec3 hand_m(const struct bot *bot)
{
    return bot->hand.pose.position_m;
}

/* ---- Fish ----------------------------------------------------------------------------------- */

static void go_for(struct bot *bot, const struct look_fish *fish, uint32_t tick)
{
    bot->prey = fish->fish;
    bot->known.prey = *fish;
    bot->tries++;
    const float angle = F_TAU * luck(bot, 0), far_m = bot->technique.aim_m * f_sqrt(luck(bot, 1));
    bot->miss_m = v3(far_m * f_cos(angle), 0.0f, far_m * f_sin(angle));
    go(bot, BOT_APPROACH, tick);
}

/* The way to where the prey will be `ahead_s` from now. */
static int way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s, struct aim_way *way)
{
    const struct look_fish *prey = &bot->known.prey;
    const vec3 fish_m = v3_add(look_foresee(prey, age_s(bot, tick) + ahead_s), bot->miss_m);
    return aim_way_to(&bot->technique, &bot->known, fish_m, prey->length_m, bot->yaw_rad, way);
}

static int prey_swims(const struct bot *bot)
{
    return bot->prey != LOOK_NO_FISH && bot->known.prey.place == SCENE_IN_TANK;
}

/* Where it looks for fish: beside its bowl, toward the middle of the tank. */
static vec3 hunting_ground_m(const struct bot *bot)
{
    const vec3 bowl_m = bot->known.bowl.position_m;
    const vec3 inward = v3_normalize_or(v3(-bowl_m.x, 0.0f, -bowl_m.z), v3(0.0f, 0.0f, -1.0f));
    return v3_mad(v3(bowl_m.x, 0.0f, bowl_m.z), inward, BESIDE_BOWL_M);
}

/* ---- Stages --------------------------------------------------------------------------------- */

static int plays(const struct bot *bot)
{
    return (bot->known.phase == PHASE_ROUND || bot->known.phase == PHASE_ATTRACT) &&
           bot->known.poi.present;
}

static int paper_is_fresh(const struct bot *bot)
{
    return bot->known.paper.wet < 0.3f * bot->technique.wet;
}

static void rest(struct bot *bot, uint32_t tick)
{
    bot->yaw_rad = 0.3f;
    const vec3 ground_m = hunting_ground_m(bot);
    const float front_m = 0.5f * bot->known.tank_m.z + REST_BEYOND_M;
    want(bot, v3(ground_m.x, REST_Y_M, front_m), 0.0f, bot->technique.arm_m_s);
    if (plays(bot)) {
        go(bot, paper_is_fresh(bot) ? BOT_SOAK : BOT_CHOOSE, tick);
    }
}

/* The ring's height at which so much of its area is under water, held at a slant. */
static float soak_y_m(float share)
{
    const float low = AIM_RING_M * f_sin(-SOAK_PITCH_RAD);
    return share >= 0.99f ? -low - SOAK_MARGIN_M : -(2.0f * share - 1.0f) * low;
}

static void soak(struct bot *bot, uint32_t tick)
{
    const float done_s = stage_s(bot, tick);
    vec3 place_m = hunting_ground_m(bot);
    place_m.y = soak_y_m(bot->technique.wet);
    const vec3 over_m = v3(place_m.x, HOVER_Y_M, place_m.z);
    const vec3 aside = v3_sub(hand_m(bot), over_m);
    const int is_over = aside.x * aside.x + aside.z * aside.z < THERE_M * THERE_M;
    bot->yaw_rad = 0.3f;
    want(bot, is_over ? place_m : over_m, SOAK_PITCH_RAD,
         is_over ? bot->technique.dip_m_s : bot->technique.arm_m_s);
    const int wet = bot->known.paper.wet >= SOAKED * bot->technique.wet;
    if (wet || done_s > SOAK_S_MAX + 1.0f) {
        go(bot, BOT_CHOOSE, tick);
    }
}

static void choose(struct bot *bot, uint32_t tick)
{
    want(bot, v3(hand_m(bot).x, HOVER_Y_M, hand_m(bot).z), 0.0f, bot->technique.arm_m_s);
    if (paper_is_fresh(bot) && bot->known.paper.holds && saw_since(bot, 0.0f)) {
        go(bot, BOT_SOAK, tick);
        return;
    }
    if (!bot->known.paper.holds) {
        return;
    }
    const struct look_fish *fish = aim_choose(&bot->technique, &bot->known, hand_m(bot),
                                              age_s(bot, tick), &bot->yaw_rad);
    if (fish) {
        go_for(bot, fish, tick);
    }
}

static float entry_pitch_rad(const struct bot *bot)
{
    return -bot->technique.entry_deg * F_DEG;
}

/* Seconds that the way takes from the surface until the fish is over the paper. */
static float stroke_s(const struct bot *bot)
{
    return 0.06f / bot->technique.dip_m_s + 0.03f / bot->technique.glide_m_s;
}

/* Before the dip the hand keeps over the entry as the fish moves on. Returns whether it is there.
 */
static int keep_over_entry(struct bot *bot, uint32_t tick)
{
    struct aim_way way;
    const float reach_s = way_left_m(bot) / bot->technique.arm_m_s;
    bot->yaw_rad = aim_yaw(&bot->technique, &bot->known.prey, bot->yaw_rad);
    if (!prey_swims(bot) || stage_s(bot, tick) > APPROACH_S_MAX + bot->technique.patience_s ||
        !way_to_prey(bot, tick, f_min(reach_s, 0.3f) + stroke_s(bot), &way)) {
        go(bot, BOT_CHOOSE, tick);
        return 0;
    }
    want(bot, way.entry_m, entry_pitch_rad(bot), bot->technique.arm_m_s);
    return way_left_m(bot) < THERE_M && wrist_is_there(bot);
}

static void approach(struct bot *bot, uint32_t tick)
{
    if (bot->known.riders > 0 && saw_since(bot, 0.0f)) {
        go(bot, BOT_CARRY, tick); /* Something stuck to the paper. */
    } else if (keep_over_entry(bot, tick)) {
        go(bot, bot->technique.hunt == HUNT_SHADE ? BOT_WATCH : BOT_DIP, tick);
    }
}

static void watch(struct bot *bot, uint32_t tick)
{
    if (stage_s(bot, tick) > bot->technique.patience_s) {
        go(bot, BOT_CHOOSE, tick);
    } else if (keep_over_entry(bot, tick) &&
               v3_length(bot->known.prey.velocity_m_s) < CALM_M_S) {
        go(bot, BOT_DIP, tick);
    }
}

static void dip(struct bot *bot, uint32_t tick)
{
    struct aim_way way;
    (void)way_to_prey(bot, tick, 0.03f / bot->technique.glide_m_s, &way);
    want(bot, way.stop_m, entry_pitch_rad(bot), bot->technique.dip_m_s);
    if (way_left_m(bot) < THERE_M || stage_s(bot, tick) > DIP_S_MAX) {
        go(bot, BOT_GLIDE, tick);
    }
}

/* What fled is let go; another that is near may do. Returns whether there is a fish to go under. */
static int keep_prey(struct bot *bot, uint32_t tick)
{
    const float reach_m = bot->technique.hunt == HUNT_CHASE ? CHASE_LOST_M : LOST_M;
    const vec3 fish_m = look_foresee(&bot->known.prey, age_s(bot, tick));
    const vec3 d = v3_sub(fish_m, hand_m(bot));
    if (prey_swims(bot) && d.x * d.x + d.z * d.z < reach_m * reach_m) {
        return 1;
    }
    const struct look_fish *other = aim_nearest(&bot->known, hand_m(bot), reach_m);
    if (!other) {
        return 0;
    }
    bot->prey = other->fish;
    bot->known.prey = *other;
    return 1;
}

static void glide(struct bot *bot, uint32_t tick)
{
    const int chases = bot->technique.hunt == HUNT_CHASE;
    const float longest_s = chases ? bot->technique.patience_s : GLIDE_S_MAX;
    struct aim_way way;
    if (!keep_prey(bot, tick) || stage_s(bot, tick) > longest_s) {
        go(bot, BOT_LIFT, tick);
        return;
    }
    (void)way_to_prey(bot, tick, 0.1f, &way);
    const float speed_m_s = chases ? bot->technique.arm_m_s : bot->technique.glide_m_s;
    want(bot, way.under_m, -bot->technique.glide_deg * F_DEG, speed_m_s);
    if (way_left_m(bot) < THERE_M) {
        go(bot, BOT_LIFT, tick);
    }
}

/* Fish that lie between ring and surface hold it down: it gives way, draws back, tries again. */
static int frees_ring(struct bot *bot, uint32_t tick)
{
    const float turn_s = stage_s(bot, tick) - STUCK_S;
    const float rounds = f_floor(turn_s / STUCK_TURN_S);
    const int stuck = turn_s > 0.0f && bot->known.poi.position_m.y < STUCK_Y_M;
    if (!stuck || turn_s - rounds * STUCK_TURN_S > STUCK_BACK_S) {
        return 0;
    }
    const vec3 ring_m = bot->known.poi.position_m;
    vec3 back_m = v3_mad(ring_m, aim_forward(bot->yaw_rad), -STUCK_BACK_M);
    back_m.y = f_max(ring_m.y - STUCK_BACK_M, 0.02f - bot->known.tank_m.y);
    want(bot, back_m, 0.0f, bot->technique.lift_m_s);
    return 1;
}

static void lift(struct bot *bot, uint32_t tick)
{
    const int drains = bot->technique.lift == LIFT_DRAINED;
    vec3 up_m = hand_m(bot);
    if (frees_ring(bot, tick)) {
        return;
    }
    up_m.y = drains ? f_min(LIFTED_Y_M, bot->known.poi.position_m.y + JAM_M) : LIFTED_Y_M;
    const float haste = drains ? 1.0f : HASTY_SHARE;
    want(bot, up_m, drains ? CRADLE_RAD : 0.0f, haste * bot->technique.lift_m_s);
    bot->ease_s = drains ? EASE_S : HASTY_EASE_S;
    if (hand_m(bot).y < LIFTED_Y_M - THERE_M) {
        return;
    }
    const float drain_s = drains ? bot->technique.drain_s : 0.0f;
    if (stage_s(bot, tick) > drain_s) {
        go(bot, BOT_CARRY, tick);
    }
}

/* Over the bowl's near side, from where it comes. */
static vec3 over_bowl_m(const struct bot *bot, vec3 *toward)
{
    const vec3 bowl_m = bot->known.bowl.position_m;
    const vec3 way = v3(bowl_m.x - hand_m(bot).x, 0.0f, bowl_m.z - hand_m(bot).z);
    *toward = v3_normalize_or(way, v3(1.0f, 0.0f, 0.0f));
    vec3 place_m = v3_mad(bowl_m, *toward, -TIP_FALL_M);
    place_m.y = bowl_m.y + TIP_EDGE_M + AIM_RING_M * f_sin(TIP_RAD);
    return place_m;
}

static void carry(struct bot *bot, uint32_t tick)
{
    vec3 toward;
    if (bot->known.riders + bot->known.over == 0 && saw_since(bot, -0.15f)) {
        go(bot, BOT_CHOOSE, tick);
        return;
    }
    want(bot, over_bowl_m(bot, &toward), CRADLE_RAD, bot->technique.carry_m_s);
    if (way_left_m(bot) < 2.0f * THERE_M) {
        bot->miss_m = toward; /* No try goes on: it keeps which way it tips. */
        go(bot, BOT_TIP, tick);
    }
}

static void tip(struct bot *bot, uint32_t tick)
{
    const vec3 toward = bot->miss_m;
    const struct angles held = { bot->yaw_rad, CRADLE_RAD, 0.0f };
    const struct basis axes = basis_from_angles(held);
    const vec3 axis = v3_cross(v3(0.0f, 1.0f, 0.0f), toward);
    const struct basis turned = pose_turn(&axes, axis, TIP_RAD);
    vec3 place_m = v3_mad(bot->known.bowl.position_m, toward, -TIP_FALL_M);
    place_m.y = bot->known.bowl.position_m.y + TIP_EDGE_M + AIM_RING_M * f_sin(TIP_RAD);
    want(bot, place_m, 0.0f, bot->technique.carry_m_s);
    bot->goal.angles = pose_angles(&turned);
    const int empty = bot->known.riders == 0 && saw_since(bot, 0.0f);
    if (stage_s(bot, tick) > (empty ? TIP_HOLD_S : TIP_LAST_S)) {
        go(bot, BOT_CHOOSE, tick);
    }
}

/* ---- A tick --------------------------------------------------------------------------------- */

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
    return hunts || bot->technique.hunt == HUNT_CHASE ? hand_m(bot) : hunting_ground_m(bot);
}

/* What was seen becomes known, and the next look is taken. */
static void perceive(struct bot *bot, const struct sight *sight, uint32_t tick)
{
    const struct look_fish followed = bot->known.prey;
    bot->known = bot->seen;
    if (bot->known.prey.fish != bot->prey) {
        bot->known.prey = followed; /* It has only just turned its eyes. */
    }
    look_take(&bot->seen, &bot->known, sight, bot->prey, attention_m(bot));
    bot->act_tick = tick + reaction_ticks(bot, tick);
}

static void decide(struct bot *bot, uint32_t tick)
{
    static void (*const stages[BOT_STAGE_COUNT])(struct bot *, uint32_t) = {
        [BOT_REST] = rest,         [BOT_SOAK] = soak,   [BOT_CHOOSE] = choose,
        [BOT_APPROACH] = approach, [BOT_WATCH] = watch, [BOT_DIP] = dip,
        [BOT_GLIDE] = glide,       [BOT_LIFT] = lift,   [BOT_CARRY] = carry,
        [BOT_TIP] = tip,
    };
    if (!plays(bot) && bot->stage != BOT_REST) {
        go(bot, BOT_REST, tick);
    }
    stages[bot->stage](bot, tick);
}

void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed)
{
    *bot = (struct bot){ .technique = *technique, .seed = seed, .prey = LOOK_NO_FISH };
    bot->hand.pose.position_m = v3(0.0f, HOVER_Y_M, 0.0f);
    bot->known.prey.fish = bot->seen.prey.fish = LOOK_NO_FISH;
}

struct poi_target bot_tick(struct bot *bot, const struct sight *sight)
{
    const uint32_t tick = sight_game(sight).tick;
    if (tick >= bot->act_tick) {
        perceive(bot, sight, tick);
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
    hash = look_hash(hash, &bot->known);
    return look_hash(hash, &bot->seen);
}
