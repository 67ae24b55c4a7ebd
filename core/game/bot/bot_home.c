/* bot_home.c -- the bot's stages with a fish on the paper: lift the poi, carry it to the bowl, and
 * tip the fish into the bowl. */
#include "core/game/bot/bot_internal.h"

#include "core/poi/pose.h"

#define LIFTED_Y_M 0.058f /* Height at which a ring with a fish is out of the water. */
#define HASTY_EASE_S 0.06f
#define HASTY_SHARE 2.5f /* Ratio of the speed of a fast lift to the speed of a draining lift. */
/* Pitch of the poi while lifting; 0 is level. A negative pitch lowers the far edge, so that water
 * runs off and the fish moves to the rim. */
#define CRADLE_RAD (0.0f * F_DEG)
/* Largest distance of the ring below the arm's position. If fish push the ring further down, the
 * arm waits. */
#define JAM_M 0.050f

#define STUCK_S 1.4f        /* Time after which a lift counts as stuck. */
#define STUCK_Y_M (-0.005f) /* Height below which the ring counts as still under water. */
#define STUCK_BACK_M 0.035f
#define STUCK_BACK_S 0.35f
#define STUCK_TURN_S 1.2f

/* Pitch at which a fish slides over the ring. */
#define TIP_RAD (58.0f * F_DEG)
/* Distance from the ring's centre to the point where the fish leaves the ring. */
#define TIP_FALL_M 0.046f
#define TIP_EDGE_M 0.010f /* Height of the ring's lower edge above the bowl's mouth. */
#define TIP_HOLD_S 0.42f
#define TIP_LAST_S 1.5f

/* Frees a ring that fish above it keep under water. The ring moves down and back, and then the bot
 * lifts the poi again. Returns 1 while the ring moves back, otherwise 0. */
static int frees_ring(struct bot *bot, uint32_t tick)
{
    const float turn_s = bot_stage_s(bot, tick) - STUCK_S;
    const float rounds = f_floor(turn_s / STUCK_TURN_S);
    const int stuck = turn_s > 0.0f && bot->known.poi.position_m.y < STUCK_Y_M;
    if (!stuck || turn_s - rounds * STUCK_TURN_S > STUCK_BACK_S) {
        return 0;
    }
    const vec3 ring_m = bot->known.poi.position_m;
    vec3 back_m = v3_muladd(ring_m, targeting_forward(bot->yaw_rad), -STUCK_BACK_M);
    back_m.y = f_max(ring_m.y - STUCK_BACK_M, 0.02f - bot->known.tank_m.y);
    bot_want(bot, back_m, 0.0f, bot->technique.lift_m_s);
    return 1;
}

void bot_lift(struct bot *bot, uint32_t tick)
{
    const int drains = bot->technique.lift == LIFT_DRAINED;
    vec3 up_m = bot_hand_m(bot);
    if (frees_ring(bot, tick)) {
        return;
    }
    up_m.y = drains ? f_min(LIFTED_Y_M, bot->known.poi.position_m.y + JAM_M) : LIFTED_Y_M;
    const float haste = drains ? 1.0f : HASTY_SHARE;
    bot_want(bot, up_m, drains ? CRADLE_RAD : 0.0f, haste * bot->technique.lift_m_s);
    bot->ease_s = drains ? bot->ease_s : HASTY_EASE_S;
    if (bot_hand_m(bot).y < LIFTED_Y_M - BOT_THERE_M) {
        return;
    }
    const float drain_s = drains ? bot->technique.drain_s : 0.0f;
    if (bot_stage_s(bot, tick) > drain_s) {
        bot_go(bot, BOT_CARRY, tick);
    }
}

/* Returns the position above the near side of the bowl at which the poi is tipped. `toward` is the
 * horizontal unit vector in which the ring approaches the bowl. */
static vec3 over_bowl_m(const struct bot *bot, vec3 toward)
{
    const vec3 bowl_m = bot->known.bowl.position_m;
    vec3 place_m = v3_muladd(bowl_m, toward, -TIP_FALL_M);
    place_m.y = bowl_m.y + TIP_EDGE_M + TARGETING_RING_M * f_sin(TIP_RAD);
    return place_m;
}

static vec3 toward_bowl(const struct bot *bot)
{
    const vec3 way_m = v3_sub(bot->known.bowl.position_m, bot_hand_m(bot));
    return v3_normalize_or(v3(way_m.x, 0.0f, way_m.z), v3(1.0f, 0.0f, 0.0f));
}

void bot_carry(struct bot *bot, uint32_t tick)
{
    const vec3 toward = toward_bowl(bot);
    if (bot->known.carried_count + bot->known.over == 0 && bot_saw_since(bot, -0.15f)) {
        bot_go(bot, BOT_CHOOSE, tick);
        return;
    }
    bot_want(bot, over_bowl_m(bot, toward), CRADLE_RAD, bot->technique.carry_m_s);
    if (bot_way_left_m(bot) < 2.0f * BOT_THERE_M) {
        bot->miss_m = toward; /* During this stage `miss_m` holds no aiming error, so it stores the
                                 direction for tipping the poi. */
        bot_go(bot, BOT_TIP, tick);
    }
}

void bot_tip(struct bot *bot, uint32_t tick)
{
    const vec3 toward = bot->miss_m;
    const struct angles held = { bot->yaw_rad, CRADLE_RAD, 0.0f };
    const struct basis axes = vec_basis_from_angles(held);
    const vec3 axis = v3_cross(v3(0.0f, 1.0f, 0.0f), toward);
    const struct basis turned = pose_turn(&axes, axis, TIP_RAD);
    bot_want(bot, over_bowl_m(bot, toward), 0.0f, bot->technique.carry_m_s);
    bot->goal.angles = pose_angles(&turned);
    const int empty = bot->known.carried_count == 0 && bot_saw_since(bot, 0.0f);
    if (bot_stage_s(bot, tick) > (empty ? TIP_HOLD_S : TIP_LAST_S)) {
        bot_go(bot, BOT_CHOOSE, tick);
    }
}
