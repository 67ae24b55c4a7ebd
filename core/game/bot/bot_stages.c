/* bot_stages.c -- the bot's stages: rest, wet the paper, select a fish, approach the fish, scoop
 * the fish, and carry the fish to the bowl.
 *
 * The bot has immediate access to its own arm position and to the time since an event, such as the
 * start of its stage. All other data comes from the last usable snapshot. The current stage's
 * function is called once per tick, sets the arm's goal and decides when to change the stage. */
#include "core/game/bot/bot.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/poi/pose.h"

#define WRIST_THERE_RAD (3.0f * F_DEG)
/* Default time in seconds in which the arm accelerates to its maximum speed. */
#define EASE_S 0.15f
#define BESIDE_BOWL_M 0.14f
#define BOT_THERE_M 0.012f /* Distance from the goal within which the arm counts as arrived. */

/* Returns the seconds since the stage began. */
static float bot_stage_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->stage_tick) * CORE_TICK_S;
}

/* Returns the seconds since the snapshot `known` was captured. */
static float bot_age_s(const struct bot *bot, uint32_t tick)
{
    return (float)(tick - bot->known.tick) * CORE_TICK_S;
}

/* Returns true if the bot has seen the game since the stage began: the snapshot `known` was taken
 * at least `after_s` seconds after the start of the stage. With a negative `after_s`, a snapshot
 * from shortly before the start also counts. */
static bool bot_saw_since(const struct bot *bot, float after_s)
{
    const float seen_s = ((float)bot->known.tick - (float)bot->stage_tick) * CORE_TICK_S;
    return seen_s >= after_s;
}

/* Starts the stage `stage`. The start of a stage before BOT_APPROACH or after BOT_GLIDE clears the
 * target fish, because these stages have none. */
static void bot_set_stage(struct bot *bot, uint8_t stage, uint32_t tick)
{
    CORE_ASSERT(stage < BOT_STAGE_COUNT);
    if (stage < BOT_APPROACH || stage > BOT_GLIDE) {
        bot->prey = SNAPSHOT_NO_FISH;
    }
    bot->stage = stage;
    bot->stage_tick = tick;
}

/* Sets the goal of the arm, with the current handle yaw and the default acceleration time. */
static void bot_set_goal(struct bot *bot, vec3 position_m, float pitch_rad, float speed_m_s)
{
    CORE_ASSERT(v3_is_finite(position_m) && f_is_finite(pitch_rad) && speed_m_s > 0.0f);
    bot->goal.position_m = position_m;
    bot->goal.angles = (struct angles){ bot->yaw_rad, pitch_rad, 0.0f };
    bot->speed_m_s = speed_m_s;
    bot->ease_s = EASE_S;
}

/* Returns the distance of the arm to its goal. */
static float bot_way_left_m(const struct bot *bot)
{
    return v3_length(v3_sub(bot->goal.position_m, bot->hand.pose.position_m));
}

/* Computes the path to the position that the target fish is predicted to have in `ahead_s` seconds.
 * Returns true if the path has enough room, as targeting_approach() does. */
static bool bot_way_to_prey(const struct bot *bot, uint32_t tick, float ahead_s,
                            struct approach_path *way)
{
    CORE_ASSERT(bot->known.prey.fish == bot->prey);
    const struct snapshot_fish *prey = &bot->known.prey;
    const vec3 fish_m = v3_add(snapshot_predict(prey, bot_age_s(bot, tick) + ahead_s), bot->miss_m);
    return targeting_approach(&bot->technique, &bot->known, fish_m, prey->length_m, bot->yaw_rad,
                              way);
}

/* Returns true if the target fish still swims in the tank. */
static bool bot_prey_swims(const struct bot *bot)
{
    return bot->prey != SNAPSHOT_NO_FISH && bot->known.prey.place == SCENE_IN_TANK;
}

/* Returns the place where the bot wets the paper and from which it searches for fish: a point
 * beside the bowl, toward the middle of the tank. */
static vec3 bot_ground_m(const struct bot *bot)
{
    CORE_ASSERT(f_is_finite(bot->known.bowl.position_m.x));
    const vec3 bowl_m = bot->known.bowl.position_m;
    const vec3 inward = v3_normalize_or(v3(-bowl_m.x, 0.0f, -bowl_m.z), v3(0.0f, 0.0f, -1.0f));
    return v3_muladd(v3(bowl_m.x, 0.0f, bowl_m.z), inward, BESIDE_BOWL_M);
}

/* Returns true if a game runs and the bot has a poi. */
static bool bot_plays(const struct bot *bot)
{
    return (bot->known.phase == PHASE_ROUND || bot->known.phase == PHASE_ATTRACT) &&
           bot->known.poi.present;
}

/* Distance beyond the tank's wall at which the resting bot holds its poi. The poi's shadow then
 * falls beside the tank and not on the fish. */
#define REST_BEYOND_M 0.12f
#define REST_Y_M 0.14f
#define SOAK_PITCH_RAD (-40.0f * F_DEG)
#define SOAK_MARGIN_M 0.006f
/* The bot stops wetting the paper when the wet share of the paper reaches this fraction of the
 * share that the technique requires. */
#define SOAKED 0.85f
#define SOAK_S_MAX 2.6f

static bool paper_is_fresh(const struct bot *bot)
{
    return bot->known.paper.wet < 0.3f * bot->technique.wet;
}

static void bot_rest(struct bot *bot, uint32_t tick)
{
    bot->yaw_rad = 0.3f;
    const vec3 ground_m = bot_ground_m(bot);
    const float front_m = 0.5f * bot->known.tank_m.z + REST_BEYOND_M;
    bot_set_goal(bot, v3(ground_m.x, REST_Y_M, front_m), 0.0f, bot->technique.arm_m_s);
    if (bot_plays(bot)) {
        bot_set_stage(bot, paper_is_fresh(bot) ? BOT_SOAK : BOT_CHOOSE, tick);
    }
}

static void bot_soak(struct bot *bot, uint32_t tick)
{
    CORE_ASSERT(bot->technique.wet >= 0.0f && bot->technique.wet <= 1.0f);
    const float done_s = bot_stage_s(bot, tick), share = bot->technique.wet;
    const float low_m = TARGETING_RING_M * f_sin(-SOAK_PITCH_RAD);
    vec3 place_m = bot_ground_m(bot);
    /* Choose the ring's height so that `share` of the area of the tilted ring is under water. */
    place_m.y = share >= 0.99f ? -low_m - SOAK_MARGIN_M : -(2.0f * share - 1.0f) * low_m;
    const vec3 over_m = v3(place_m.x, BOT_HOVER_Y_M, place_m.z);
    const vec3 aside = v3_sub(bot->hand.pose.position_m, over_m);
    const bool is_over = aside.x * aside.x + aside.z * aside.z < BOT_THERE_M * BOT_THERE_M;
    bot->yaw_rad = 0.3f;
    bot_set_goal(bot, is_over ? place_m : over_m, SOAK_PITCH_RAD,
                 is_over ? bot->technique.dip_m_s : bot->technique.arm_m_s);
    const bool wet = bot->known.paper.wet >= SOAKED * share;
    if (wet || done_s > SOAK_S_MAX + 1.0f) {
        bot_set_stage(bot, BOT_CHOOSE, tick);
    }
}

static float random_choice(const struct bot *bot, uint32_t which)
{
    CORE_ASSERT(bot->tries > 0);
    return rng_unit((struct rng_key){ bot->seed, bot->tries, which, RNG_BOT_CHOICE });
}

static void bot_choose(struct bot *bot, uint32_t tick)
{
    const vec3 hand_m = bot->hand.pose.position_m;
    bot_set_goal(bot, v3(hand_m.x, BOT_HOVER_Y_M, hand_m.z), 0.0f, bot->technique.arm_m_s);
    if (paper_is_fresh(bot) && bot->known.paper.holds && bot_saw_since(bot, 0.0f)) {
        bot_set_stage(bot, BOT_SOAK, tick);
        return;
    }
    if (!bot->known.paper.holds) {
        return;
    }
    const struct snapshot_fish *fish =
        targeting_choose(&bot->technique, &bot->known, hand_m, bot_age_s(bot, tick), &bot->yaw_rad);
    if (!fish) {
        return;
    }
    bot->prey = fish->fish;
    bot->known.prey = *fish;
    bot->tries++;
    const float angle = F_TAU * random_choice(bot, 0);
    const float far_m = bot->technique.aim_m * f_sqrt(random_choice(bot, 1));
    bot->miss_m = v3(far_m * f_cos(angle), 0.0f, far_m * f_sin(angle));
    bot_set_stage(bot, BOT_APPROACH, tick);
}

#define CALM_M_S 0.05f
#define CHASE_LOST_M 0.25f
/* Horizontal distance between the ring and the target fish beyond which the bot gives up this
 * fish. */
#define LOST_M 0.075f
#define GLIDE_S_MAX 0.9f
#define DIP_S_MAX 1.2f
#define APPROACH_S_MAX 1.5f

/* Keeps the poi over the start of the path to the target fish. The path moves with the fish.
 * Returns true when the poi has arrived over the start. */
static bool keep_over_entry(struct bot *bot, uint32_t tick)
{
    const struct technique *technique = &bot->technique;
    struct approach_path way;
    const float reach_s = bot_way_left_m(bot) / technique->arm_m_s;
    /* Time that the poi needs to move from the water surface until the fish is over the paper. */
    const float stroke_s = 0.06f / technique->dip_m_s + 0.03f / technique->glide_m_s;
    bot->yaw_rad = targeting_yaw(technique, &bot->known.prey, bot->yaw_rad);
    const float longest_s = APPROACH_S_MAX + technique->patience_s;
    if (!bot_prey_swims(bot) || bot_stage_s(bot, tick) > longest_s ||
        !bot_way_to_prey(bot, tick, f_min(reach_s, 0.3f) + stroke_s, &way)) {
        bot_set_stage(bot, BOT_CHOOSE, tick);
        return false;
    }
    bot_set_goal(bot, way.entry_m, -bot->technique.entry_deg * F_DEG, technique->arm_m_s);
    const struct angles *now = &bot->hand.pose.angles, *goal = &bot->goal.angles;
    return bot_way_left_m(bot) < BOT_THERE_M &&
           f_abs(f_wrap_angle(goal->pitch_rad - now->pitch_rad)) < WRIST_THERE_RAD &&
           f_abs(f_wrap_angle(goal->roll_rad - now->roll_rad)) < WRIST_THERE_RAD;
}

static void bot_approach(struct bot *bot, uint32_t tick)
{
    if (bot->known.carried_count > 0 && bot_saw_since(bot, 0.0f)) {
        /* A fish already lies on the paper, so the bot carries this fish to the bowl. */
        bot_set_stage(bot, BOT_CARRY, tick);
    } else if (keep_over_entry(bot, tick)) {
        bot_set_stage(bot, bot->technique.hunt == HUNT_SHADE ? BOT_WATCH : BOT_DIP, tick);
    }
}

static void bot_watch(struct bot *bot, uint32_t tick)
{
    if (bot_stage_s(bot, tick) > bot->technique.patience_s) {
        bot_set_stage(bot, BOT_CHOOSE, tick);
    } else if (keep_over_entry(bot, tick) && v3_length(bot->known.prey.velocity_m_s) < CALM_M_S) {
        bot_set_stage(bot, BOT_DIP, tick);
    }
}

static void bot_dip(struct bot *bot, uint32_t tick)
{
    struct approach_path way;
    (void)bot_way_to_prey(bot, tick, 0.03f / bot->technique.glide_m_s, &way);
    bot_set_goal(bot, way.stop_m, -bot->technique.entry_deg * F_DEG, bot->technique.dip_m_s);
    if (bot_way_left_m(bot) < BOT_THERE_M || bot_stage_s(bot, tick) > DIP_S_MAX) {
        bot_set_stage(bot, BOT_GLIDE, tick);
    }
}

/* Keeps the target fish, or selects a nearby fish if the target escaped. Returns true if a fish is
 * in reach. */
static bool keep_prey(struct bot *bot, uint32_t tick)
{
    CORE_ASSERT(bot->known.near_count <= SNAPSHOT_NEAR_MAX);
    const float reach_m = bot->technique.hunt == HUNT_CHASE ? CHASE_LOST_M : LOST_M;
    const vec3 fish_m = snapshot_predict(&bot->known.prey, bot_age_s(bot, tick));
    const vec3 d = v3_sub(fish_m, bot->hand.pose.position_m);
    if (bot_prey_swims(bot) && d.x * d.x + d.z * d.z < reach_m * reach_m) {
        return true;
    }
    const struct snapshot_fish *other =
        targeting_nearest(&bot->known, bot->hand.pose.position_m, reach_m);
    if (!other) {
        return false;
    }
    bot->prey = other->fish;
    bot->known.prey = *other;
    return true;
}

static void bot_glide(struct bot *bot, uint32_t tick)
{
    const bool chases = bot->technique.hunt == HUNT_CHASE;
    const float longest_s = chases ? bot->technique.patience_s : GLIDE_S_MAX;
    struct approach_path way;
    if (!keep_prey(bot, tick) || bot_stage_s(bot, tick) > longest_s) {
        bot_set_stage(bot, BOT_LIFT, tick);
        return;
    }
    (void)bot_way_to_prey(bot, tick, 0.1f, &way);
    const float speed_m_s = chases ? bot->technique.arm_m_s : bot->technique.glide_m_s;
    bot_set_goal(bot, way.under_m, -bot->technique.glide_deg * F_DEG, speed_m_s);
    if (bot_way_left_m(bot) < BOT_THERE_M) {
        bot_set_stage(bot, BOT_LIFT, tick);
    }
}

/* Height to which the bot lifts the poi. At this height a ring with a fish is out of the water. */
#define LIFTED_Y_M 0.058f
#define HASTY_EASE_S 0.06f
#define HASTY_SHARE 2.5f /* Ratio of the speed of a fast lift to the speed of a draining lift. */
/* Pitch of the poi during a lift that drains the paper; 0 is level. At a negative pitch the far
 * edge of the ring would be lower, so that water runs off and the fish moves to the rim. */
#define CRADLE_RAD (0.0f * F_DEG)
/* Largest height of the arm's goal above the ring during a lift that drains the paper. If fish push
 * the ring down, the arm therefore waits for the ring. */
#define JAM_M 0.050f

/* Time in seconds after which a lift counts as stuck if the ring is still under water. */
#define STUCK_S 1.4f
/* Height of the ring below which a lift that takes longer than STUCK_S (1.4 s) counts as stuck. */
#define STUCK_Y_M (-0.005f)
#define STUCK_BACK_M 0.035f
#define STUCK_BACK_S 0.35f
#define STUCK_TURN_S 1.2f

/* Pitch of the poi over the bowl. At this pitch a fish slides off the ring into the bowl. */
#define TIP_RAD (58.0f * F_DEG)
/* Horizontal distance from the ring's centre to the point at which a fish slides off the tipped
 * ring. */
#define TIP_FALL_M 0.046f
#define TIP_EDGE_M 0.010f /* Height of the tipped ring's lower edge above the bowl's mouth. */
#define TIP_HOLD_S 0.42f
#define TIP_LAST_S 1.5f

/* Frees the ring if fish above the ring keep it under water. The ring moves down and back, and then
 * the bot lifts the poi again. Returns true while the ring moves back. */
static bool frees_ring(struct bot *bot, uint32_t tick)
{
    const float turn_s = bot_stage_s(bot, tick) - STUCK_S;
    const float rounds = f_floor(turn_s / STUCK_TURN_S);
    const bool stuck = turn_s > 0.0f && bot->known.poi.position_m.y < STUCK_Y_M;
    if (!stuck || turn_s - rounds * STUCK_TURN_S > STUCK_BACK_S) {
        return false;
    }
    const vec3 ring_m = bot->known.poi.position_m;
    vec3 back_m = v3_muladd(ring_m, targeting_forward(bot->yaw_rad), -STUCK_BACK_M);
    back_m.y = f_max(ring_m.y - STUCK_BACK_M, 0.02f - bot->known.tank_m.y);
    bot_set_goal(bot, back_m, 0.0f, bot->technique.lift_m_s);
    return true;
}

static void bot_lift(struct bot *bot, uint32_t tick)
{
    const bool drains = bot->technique.lift == LIFT_DRAINED;
    vec3 up_m = bot->hand.pose.position_m;
    if (frees_ring(bot, tick)) {
        return;
    }
    up_m.y = drains ? f_min(LIFTED_Y_M, bot->known.poi.position_m.y + JAM_M) : LIFTED_Y_M;
    const float haste = drains ? 1.0f : HASTY_SHARE;
    bot_set_goal(bot, up_m, drains ? CRADLE_RAD : 0.0f, haste * bot->technique.lift_m_s);
    bot->ease_s = drains ? bot->ease_s : HASTY_EASE_S;
    if (bot->hand.pose.position_m.y < LIFTED_Y_M - BOT_THERE_M) {
        return;
    }
    const float drain_s = drains ? bot->technique.drain_s : 0.0f;
    if (bot_stage_s(bot, tick) > drain_s) {
        bot_set_stage(bot, BOT_CARRY, tick);
    }
}

/* Returns the position above the near side of the bowl at which the poi is tipped. `toward` is the
 * horizontal unit vector of the direction in which the ring approaches the bowl. */
static vec3 over_bowl_m(const struct bot *bot, vec3 toward)
{
    CORE_ASSERT(bot->known.bowl.present);
    const vec3 bowl_m = bot->known.bowl.position_m;
    vec3 place_m = v3_muladd(bowl_m, toward, -TIP_FALL_M);
    place_m.y = bowl_m.y + TIP_EDGE_M + TARGETING_RING_M * f_sin(TIP_RAD);
    return place_m;
}

static void bot_carry(struct bot *bot, uint32_t tick)
{
    const vec3 way_m = v3_sub(bot->known.bowl.position_m, bot->hand.pose.position_m);
    const vec3 toward = v3_normalize_or(v3(way_m.x, 0.0f, way_m.z), v3(1.0f, 0.0f, 0.0f));
    if (bot->known.carried_count + bot->known.over == 0 && bot_saw_since(bot, -0.15f)) {
        bot_set_stage(bot, BOT_CHOOSE, tick);
        return;
    }
    bot_set_goal(bot, over_bowl_m(bot, toward), CRADLE_RAD, bot->technique.carry_m_s);
    if (bot_way_left_m(bot) < 2.0f * BOT_THERE_M) {
        /* The stage BOT_TIP needs no aiming error, so `miss_m` stores the direction in which the
         * poi is tipped. */
        bot->miss_m = toward;
        bot_set_stage(bot, BOT_TIP, tick);
    }
}

static void bot_tip(struct bot *bot, uint32_t tick)
{
    const vec3 toward = bot->miss_m;
    const struct angles held = { bot->yaw_rad, CRADLE_RAD, 0.0f };
    const struct basis axes = vec_basis_from_angles(held);
    const vec3 axis = v3_cross(v3(0.0f, 1.0f, 0.0f), toward);
    const struct basis turned = pose_turn(&axes, axis, TIP_RAD);
    bot_set_goal(bot, over_bowl_m(bot, toward), 0.0f, bot->technique.carry_m_s);
    bot->goal.angles = pose_angles(&turned);
    const bool empty = bot->known.carried_count == 0 && bot_saw_since(bot, 0.0f);
    if (bot_stage_s(bot, tick) > (empty ? TIP_HOLD_S : TIP_LAST_S)) {
        bot_set_stage(bot, BOT_CHOOSE, tick);
    }
}

/* ---- Choice of the current stage's function -------------------------------------------------- */

void bot_decide(struct bot *bot, uint32_t tick)
{
    static void (*const stages[BOT_STAGE_COUNT])(struct bot *, uint32_t) = {
        [BOT_REST] = bot_rest,         [BOT_SOAK] = bot_soak,   [BOT_CHOOSE] = bot_choose,
        [BOT_APPROACH] = bot_approach, [BOT_WATCH] = bot_watch, [BOT_DIP] = bot_dip,
        [BOT_GLIDE] = bot_glide,       [BOT_LIFT] = bot_lift,   [BOT_CARRY] = bot_carry,
        [BOT_TIP] = bot_tip,
    };
    CORE_ASSERT(bot->stage < BOT_STAGE_COUNT);
    if (!bot_plays(bot) && bot->stage != BOT_REST) {
        bot_set_stage(bot, BOT_REST, tick);
    }
    stages[bot->stage](bot, tick);
}

vec3 bot_attention_m(const struct bot *bot)
{
    const bool hunts = bot->stage >= BOT_APPROACH && bot->stage <= BOT_LIFT;
    return hunts || bot->technique.hunt == HUNT_CHASE ? bot->hand.pose.position_m
                                                      : bot_ground_m(bot);
}
