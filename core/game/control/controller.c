/* controller.c -- selects the source of each poi, blends the pose after a change of the source, and
 * moves a poi without valid input out of the water and back. */
#include "core/game/control/controller.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/bot/bot.h"
#include "core/game/control/input_pose.h"
#include "core/game/phases.h"
#include "core/poi/pose.h"
#include "core/poi/world.h"

/* Lowest height to which a poi moves while its player may not dip it. Below this height part of a
 * tilted ring may be under water. */
#define CLEAR_Y_M 0.035f
/* Time for blending from the old pose to the new pose after a change of a poi's source, 1.2 s. A
 * poi that crosses the whole tank then moves at 1 m/s. */
#define GRIP_TICKS 144u
/* Longest time for which an implausibly fast pose (an outlier) is ignored, a fifteenth of a
 * second. */
#define OUTLIER_TICKS 8u
/* Distance to a new pose beyond which the poi moves slowly to the new pose instead of jumping. */
#define FAR_M 0.30f
/* Rotation to a new pose beyond which the poi moves slowly to the new pose instead of jumping. */
#define FAR_TURN 0.3f
/* Value that replaces FAR_TURN if the controller is a pointer, such as a mouse. The value is
 * larger, because a pointer tilts its poi during fast motion. */
#define FAR_LEAN 0.8f
/* Height of a poi below which part of its tilted ring may be under water. */
#define WET_BELOW_M 0.020f
/* Longest total time for which the paper cannot be damaged during several successive returns from
 * an input loss. */
#define IMMUNITY_TICKS_ALL (2u * FAILSAFE_IMMUNITY_TICKS_MAX)
/* Number of ticks of normal control that restore one used tick of damage immunity. */
#define REFILL_TICKS 8u
#define REACH_SIDE_M 0.20f   /* Distance beyond the tank walls to which a player's arm can reach. */
#define REACH_HEIGHT_M 0.35f /* Height above the water to which a player's arm can reach. */

/* ---- Failsafe motion after an input loss ----------------------------------------------------- */

/* Deceleration of a moving poi after an input loss. At this deceleration a fish on level paper does
 * not slide. */
#define COAST_M_S2 2.0f
#define COAST_LAG_S 0.025f /* Time by which a ring in air lags behind its target position. */
#define COAST_DONE_M_S 0.15f
/* Upward speed of a poi after an input loss. The value is the highest speed that half-wet paper of
 * grade 7 withstands broadside (test_failsafe). */
#define RISE_M_S 0.08f
#define TURN_RAD_S 1.5f
#define SLANT_RAD (45.0f * F_DEG)
/* Largest difference from the tilt SLANT_RAD at which the poi starts to move up. A poi whose pitch
 * is smaller than this angle counts as level. */
#define SLANT_NEAR_RAD (10.0f * F_DEG)
/* Speed of a returning poi above the water. At this speed the poi moves from the bowl to the far
 * corner within a second. */
#define BACK_DRY_M_S 1.0f
/* Downward speed of a returning poi in the water. The paper withstands this speed even
 * broadside. */
#define BACK_WET_M_S 0.10f
#define BACK_TURN_RAD_S 4.0f
/* Fraction of the remaining distance that a poi moves per tick while it returns to the controller's
 * pose. The poi therefore slows down near its goal. */
#define BACK_SHARE 0.08f
/* Growth per second of the speed limit of a returning poi after the damage immunity has ended, in
 * units of BACK_DRY_M_S or BACK_WET_M_S. The limit grows so that every return ends. */
#define BACK_HASTE_PER_S 5.0f
/* Growth per second of the fraction BACK_SHARE after the damage immunity has ended, so that every
 * return ends. */
#define BACK_SHARE_PER_S 0.5f
/* Distance from the controller's pose at which the return of a poi is complete. The spring between
 * pose and poi covers this distance without an impact. */
#define BACK_NEAR_M 0.006f
#define BACK_NEAR_RAD 0.02f
/* Horizontal distance to the controller's pose above which a returning poi leaves the water before
 * it moves sideways. */
#define BACK_FAR_M 0.15f
/* Horizontal distance to the controller's pose within which a returning poi may move down. */
#define BACK_ASIDE_M 0.03f

struct poi_target controller_failsafe_begin(const struct poi *poi, struct poi_target hand)
{
    CORE_ASSERT(v3_is_finite(poi->position_m));
    hand.position_m = poi->position_m;
    hand.angles = poi->tip > 0.0f ? hand.angles : poi->angles;
    return hand;
}

/* Moves a poi without fish out of the water along its own plane. For a tilted ring the higher edge
 * leaves the water first. For a level ring, the edge nearer to the middle of the tank leaves the
 * water first. */
static struct poi_target slip_out(struct poi_target hand)
{
    const float pitch_rad = hand.angles.pitch_rad;
    const bool is_tilted = f_abs(pitch_rad) > SLANT_NEAR_RAD;
    const float middle = hand.position_m.z * f_cos(hand.angles.yaw_rad);
    /* `edge` is 1 if the far edge of the ring leaves the water first, or -1 if the near
     * edge does. */
    const float edge = (is_tilted ? pitch_rad > 0.0f : middle >= 0.0f) ? 1.0f : -1.0f;
    const struct angles goal = { hand.angles.yaw_rad, edge * SLANT_RAD, 0.0f };
    hand.angles = pose_toward(hand.angles, goal, 1.0f, TURN_RAD_S * CORE_TICK_S);
    if (f_abs(hand.angles.pitch_rad - goal.pitch_rad) < SLANT_NEAR_RAD) {
        const vec3 back = vec_basis_from_angles(hand.angles).back;
        hand.position_m = v3_muladd(hand.position_m, back, -edge * RISE_M_S * CORE_TICK_S);
    }
    return hand;
}

struct poi_target controller_failsafe_withdraw(const struct poi *poi, struct poi_target hand)
{
    const float speed_m_s = v3_length(poi->velocity_m_s);
    CORE_ASSERT(v3_is_finite(hand.position_m) && f_is_finite(speed_m_s));
    if (speed_m_s > COAST_DONE_M_S) {
        const vec3 next = v3_limit(poi->velocity_m_s, speed_m_s - COAST_M_S2 * CORE_TICK_S);
        hand.position_m = v3_muladd(poi->position_m, next, COAST_LAG_S + CORE_TICK_S);
        return hand;
    }
    if (poi->immersed > 0.0f && hand.position_m.y < FAILSAFE_HOVER_M && poi->carried_count == 0) {
        return slip_out(hand);
    }
    const struct angles level = { hand.angles.yaw_rad, 0.0f, 0.0f };
    const float high_m = f_max(hand.position_m.y, FAILSAFE_HOVER_M);
    const float step_m = RISE_M_S * CORE_TICK_S;
    hand.angles = pose_toward(hand.angles, level, 1.0f, TURN_RAD_S * CORE_TICK_S);
    hand.position_m.y += f_clamp(high_m - hand.position_m.y, -step_m, step_m);
    return hand;
}

/* Returns the next target pose of a poi that returns to the controller's pose `wanted`. If that
 * pose is far away, the poi first moves up out of the water, then sideways, and then down. After
 * the damage immunity has ended, the speed limit of the poi grows with time, so that every return
 * ends. */
struct poi_target controller_failsafe_return(struct poi_target hand, struct poi_target wanted,
                                             uint32_t ticks)
{
    const float age = f_min((float)ticks / (float)FAILSAFE_RETURN_TICKS_MIN, 1.0f);
    const float late_s = ticks > FAILSAFE_IMMUNITY_TICKS_MAX
                             ? (float)(ticks - FAILSAFE_IMMUNITY_TICKS_MAX) * CORE_TICK_S
                             : 0.0f;
    const float share = age * age * f_min(BACK_SHARE + BACK_SHARE_PER_S * late_s, 1.0f);
    /* Direction of the next motion. The initial value leads straight to the controller's pose. */
    vec3 way_m = v3_sub(wanted.position_m, hand.position_m);
    const float aside_m = f_sqrt(way_m.x * way_m.x + way_m.z * way_m.z);
    const bool is_low = hand.position_m.y < CLEAR_Y_M;
    CORE_ASSERT(v3_is_finite(way_m));
    if (is_low && aside_m > BACK_FAR_M) {
        way_m = v3(0.0f, FAILSAFE_HOVER_M - hand.position_m.y, 0.0f);
    } else if (!is_low && aside_m > BACK_ASIDE_M && way_m.y < 0.0f) {
        way_m.y = 0.0f;
    }
    const bool is_wet = is_low || way_m.y < 0.0f;
    const float pace_m_s =
        (1.0f + BACK_HASTE_PER_S * late_s) * (is_wet ? BACK_WET_M_S : BACK_DRY_M_S);
    const vec3 step_m = v3_limit(v3_scale(way_m, share), pace_m_s * CORE_TICK_S);
    return (struct poi_target){
        .position_m = v3_add(hand.position_m, step_m),
        .angles = pose_toward(hand.angles, wanted.angles, share, BACK_TURN_RAD_S * CORE_TICK_S),
    };
}

bool controller_failsafe_is_returned(struct poi_target hand, struct poi_target wanted,
                                     uint32_t ticks)
{
    CORE_ASSERT(v3_is_finite(hand.position_m) && v3_is_finite(wanted.position_m));
    const vec3 way_m = v3_sub(wanted.position_m, hand.position_m);
    const float turn_rad =
        f_max(f_abs(f_wrap_angle(wanted.angles.yaw_rad - hand.angles.yaw_rad)),
              f_max(f_abs(f_wrap_angle(wanted.angles.pitch_rad - hand.angles.pitch_rad)),
                    f_abs(f_wrap_angle(wanted.angles.roll_rad - hand.angles.roll_rad))));
    const bool is_near = v3_length(way_m) < BACK_NEAR_M && turn_rad < BACK_NEAR_RAD;
    return ticks >= FAILSAFE_RETURN_TICKS_MIN && is_near;
}

/* ---- Selection of the source of each poi ----------------------------------------------------- */

bool controller_is_active(const struct world *world, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return world->bowl[index].present && world->poi[index].link != POI_SOURCE_ABSENT;
}

bool controller_is_lost(const struct world *world, uint32_t index)
{
    return controller_is_active(world, index) && world->poi[index].link == POI_SOURCE_LOST;
}

uint32_t controller_dipped_player(const struct game *game, const struct world *world,
                                  const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (world->bowl[i].present && game->control[i].validation.verdict == INPUT_VALID &&
            game->control[i].live_y_m >= RULES_DIP_Y_M &&
            input->poi[i].target.position_m.y < RULES_DIP_Y_M) {
            return i;
        }
    }
    return POI_MAX;
}

static struct poi_target within_reach(const struct world *world, struct poi_target target,
                                      float low_m)
{
    CORE_ASSERT(low_m < REACH_HEIGHT_M);
    const float side_m = 0.5f * world->tank.size_m.x + REACH_SIDE_M;
    const float depth_m = 0.5f * world->tank.size_m.z + REACH_SIDE_M;
    CORE_ASSERT(v3_is_finite(target.position_m));
    target.position_m.x = f_clamp(target.position_m.x, -side_m, side_m);
    target.position_m.y = f_clamp(target.position_m.y, low_m, REACH_HEIGHT_M);
    target.position_m.z = f_clamp(target.position_m.z, -depth_m, depth_m);
    target.angles.yaw_rad = f_wrap_angle(target.angles.yaw_rad);
    target.angles.pitch_rad = f_wrap_angle(target.angles.pitch_rad);
    target.angles.roll_rad = f_wrap_angle(target.angles.roll_rad);
    return target;
}

void controller_forget_path(struct control *control)
{
    control->return_ticks = control->outlier_ticks = 0;
    control->was_lost = 0;
}

/* Begins the control of `poi` by its source if the source has changed since the last tick. `seed`
 * is the seed of the slot's bot. */
static void change_holder(struct control *control, struct bot *bot, const struct poi *poi,
                          uint32_t tick, uint32_t seed)
{
    CORE_ASSERT(poi->link != POI_SOURCE_ABSENT);
    if (control->holder == poi->link) {
        return;
    }
    if (poi->link == POI_SOURCE_BOT) {
        bot_init(bot, &technique_expert, seed);
        bot->hand.pose = control->target_pose;
        /* Cancel a return to the pose of the previous controller, because the bot controls the poi
         * now. */
        controller_forget_path(control);
    }
    if (poi->link == POI_SOURCE_LIVE && control->holder == POI_SOURCE_LOST) {
        control->return_ticks = control->was_lost = 1;
    } else if (poi->link == POI_SOURCE_LOST) {
        control->target_pose = controller_failsafe_begin(poi, control->target_pose);
    } else {
        control->grip_tick = tick;
    }
    control->holder = poi->link;
}

/* Blends from the old target pose to the new pose after a change of the source. The weight of the
 * new pose grows from 0 to 1 during GRIP_TICKS. */
static struct poi_target blend_to_holder(struct control *control, const struct game *game,
                                         const struct world *world, uint32_t index,
                                         struct poi_target wanted)
{
    CORE_ASSERT(control->holder != POI_SOURCE_ABSENT);
    const bool begins = game->phase == PHASE_ROUND && game->tick == game->phase_tick;
    if (begins && wanted.position_m.y < CLEAR_Y_M) {
        /* Restarts the blending if the pose is already at the water when the round begins, for
         * example because the player holds the button of the controller. The poi then dips
         * slowly. */
        control->grip_tick = game->tick;
    }
    const float age = (float)(game->tick - control->grip_tick) / (float)GRIP_TICKS;
    wanted = within_reach(world, wanted,
                          game_may_scoop(game, index) ? -world->tank.size_m.y : CLEAR_Y_M);
    return age < 1.0f ? pose_between(control->target_pose, wanted, age * age * age) : wanted;
}

/* Filters outliers. A pose that is farther away than an arm can move in one tick may be a sensor
 * error. The target then stays unchanged until the error ends or has lasted for OUTLIER_TICKS.
 * Above the water a fast motion of a mouse is accepted. `may_scoop` is true while the player may
 * dip the poi. */
static struct poi_target steady(struct control *control, const struct poi *poi,
                                struct poi_target next, bool has_wrist, bool may_scoop)
{
    const struct poi_target hand = control->target_pose;
    const float low_m = f_min(f_min(hand.position_m.y, poi->position_m.y), next.position_m.y);
    /* True if a wrong pose could damage the paper or lose a fish. */
    const bool at_stake = low_m < WET_BELOW_M || poi->carried_count > 0;
    const bool is_arm = has_wrist || at_stake;
    const float way_m = v3_length(v3_sub(next.position_m, hand.position_m));
    const float turn_rad = input_turn(hand.angles, next.angles);
    const float pace_m = (is_arm ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX) * CORE_TICK_S;
    const float pace_rad =
        (has_wrist ? INPUT_WRIST_RAD_S_MAX : INPUT_POINTER_RAD_S_MAX) * CORE_TICK_S;
    /* Share of the motion to the new pose that the speed limits permit in one tick. */
    const float share = f_min(way_m > pace_m ? pace_m / way_m : 1.0f,
                              turn_rad > pace_rad ? pace_rad / turn_rad : 1.0f);
    const bool is_outlier = share < 1.0f && is_arm && may_scoop;
    const bool is_far = way_m > FAR_M || turn_rad > (has_wrist ? FAR_TURN : FAR_LEAN);
    CORE_ASSERT(share >= 0.0f && share <= 1.0f);
    control->outlier_ticks = is_outlier ? control->outlier_ticks + 1u : 0u;
    if (is_outlier && control->outlier_ticks <= OUTLIER_TICKS) {
        return hand;
    }
    if (is_outlier && at_stake && is_far) {
        control->return_ticks = 1;
        return hand;
    }
    return share < 1.0f ? pose_between(hand, next, share) : next;
}

/* Moves the poi by one tick toward the controller's pose after an input loss. The paper cannot be
 * damaged until the poi arrives or the damage immunity is used up. The immunity is limited for a
 * single return and for several returns together. */
static struct poi_target return_to_controller(struct control *control, const struct game *game,
                                              struct world *world, uint32_t index,
                                              struct poi_target wanted)
{
    CORE_ASSERT(control->return_ticks > 0);
    const uint32_t ticks = control->return_ticks;
    wanted = within_reach(world, wanted,
                          game_may_scoop(game, index) ? -world->tank.size_m.y : CLEAR_Y_M);
    const struct poi_target hand = controller_failsafe_return(control->target_pose, wanted, ticks);
    const bool is_back = controller_failsafe_is_returned(hand, wanted, ticks);
    world->poi[index].damage_immune = control->was_lost && ticks < FAILSAFE_IMMUNITY_TICKS_MAX &&
                                      control->immunity_ticks < IMMUNITY_TICKS_ALL;
    control->immunity_ticks += world->poi[index].damage_immune;
    control->return_ticks = is_back ? 0u : ticks + 1u;
    control->was_lost &= !is_back;
    control->outlier_ticks = 0;
    return hand;
}

/* Smooths and limits the motion of a poi in the water, as the player's level requires. Above the
 * water the poi follows the controller. */
static struct poi_target soften(const struct player *player, struct poi_target from,
                                struct poi_target to)
{
    const struct level_rules *level = rules_of_level(player->level);
    if (level->stroke_s <= 0.0f || f_min(from.position_m.y, to.position_m.y) > WET_BELOW_M) {
        return to;
    }
    const float share = CORE_TICK_S / (level->stroke_s + CORE_TICK_S);
    const float way_m = share * v3_length(v3_sub(to.position_m, from.position_m));
    const float most_m = level->stroke_m_s * CORE_TICK_S;
    return pose_between(from, to, way_m > most_m ? share * most_m / way_m : share);
}

/* Parks a poi that is not in use. A bot continues to take snapshots. When a person uses the poi
 * again, the poi moves gradually from the rest position to the person's pose. */
static void tick_parked(struct control *control, struct bot *bot, const struct game *game,
                        struct world *world, uint32_t index)
{
    world->poi[index].damage_immune = 1;
    control->target_pose = parking_path(game, world, index, control->target_pose);
    if (world->poi[index].link == POI_SOURCE_BOT) {
        const struct vision vision = { game, world, index };
        (void)bot_tick(bot, &vision);
        bot->hand = (struct bot_hand){ .pose = control->target_pose };
    } else {
        control->grip_tick = game->tick;
        controller_forget_path(control);
    }
}

/* Updates the target pose of one poi. While the round is paused because of a lost controller, the
 * failsafe moves every poi of the tank out of the water. */
static void update_target(struct control *control, struct bot *bot, const struct game *game,
                          struct world *world, const struct input *input, uint32_t index)
{
    const struct poi_input *reported = &input->poi[index];
    struct poi_target *hand = &control->target_pose;
    struct poi *poi = &world->poi[index];
    CORE_ASSERT(poi->link != POI_SOURCE_ABSENT);
    if (parking_tick(control, game, world, index)) {
        tick_parked(control, bot, game, world, index);
        return;
    }
    poi->damage_immune = poi->link == POI_SOURCE_LOST || game->paused;
    if (poi->damage_immune) {
        /* A poi without valid input leaves the water. When the input is restored or the pause ends,
         * the poi returns from the position that it has reached. */
        const struct poi_target out = controller_failsafe_withdraw(poi, *hand);
        *hand = within_reach(world, out, -world->tank.size_m.y);
        if (poi->link == POI_SOURCE_BOT) {
            bot->hand.pose = *hand;
        } else {
            control->return_ticks = control->was_lost = 1;
        }
    } else if (poi->link == POI_SOURCE_BOT) {
        const struct vision vision = { game, world, index };
        *hand = blend_to_holder(control, game, world, index, bot_tick(bot, &vision));
    } else if (control->return_ticks > 0) {
        *hand = return_to_controller(control, game, world, index, reported->target);
    } else {
        if (game->tick % REFILL_TICKS == 0 && control->immunity_ticks > 0) {
            control->immunity_ticks--;
        }
        const float share = input_validation_blend(&control->validation);
        struct poi_target next = blend_to_holder(control, game, world, index, reported->target);
        next = share < 1.0f ? pose_between(*hand, next, share) : next;
        next = steady(control, poi, next, reported->has_wrist, game_may_scoop(game, index));
        *hand = soften(&game->player[index], *hand, next);
    }
}

void controller_tick_all(struct control control[POI_MAX], struct bot bot[POI_MAX],
                         const struct game *game, struct world *world,
                         const struct core_config *config, const struct input *input,
                         struct poi_target targets[POI_MAX], uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        live[i] = (uint8_t)controller_is_active(world, i);
        if (live[i]) {
            change_holder(&control[i], &bot[i], &world->poi[i], game->tick, config->seed + i);
            update_target(&control[i], &bot[i], game, world, input, i);
        } else {
            control[i].holder = POI_SOURCE_ABSENT;
            control[i].rest_ticks = 0;
            controller_forget_path(&control[i]);
        }
        targets[i] = control[i].target_pose;
        /* The height -1 marks invalid input, so that the next valid pose does not count as a dip
         * (downward crossing). */
        control[i].live_y_m = control[i].validation.verdict == INPUT_VALID
                                  ? input->poi[i].target.position_m.y
                                  : -1.0f;
    }
}

/* Sets the source of each poi. A controller with invalid input counts as a lost controller. */
void controller_assign(const struct game *game, struct world *world, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const bool is_lost = game->control[i].validation.verdict == INPUT_LOST;
        uint8_t link = is_lost ? (uint8_t)POI_SOURCE_LOST : input->poi[i].link;
        if (game->phase == PHASE_ATTRACT) {
            link = i == 0 ? POI_SOURCE_BOT : POI_SOURCE_ABSENT;
        }
        world->poi[i].link = link;
    }
}
