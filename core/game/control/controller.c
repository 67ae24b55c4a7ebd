/* controller.c -- selects the source of each poi, and blends the pose after a change of the
 * source. */
#include "core/game/control/controller.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/bot/bot.h"
#include "core/game/control/calibration.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/poi/pose.h"
#include "core/poi/world.h"

#define CLEAR_Y_M 0.035f /* Lowest height of a poi while its player may not dip it. */
/* Time for blending after a change of the source, 1.2 s. Across the tank the poi then moves at 1
 * m/s. */
#define GRIP_TICKS 144u
#define DOUBT_TICKS 8u /* Longest time for which an outlier is ignored, a fifteenth of a second. */
/* Distance to a new pose beyond which the poi moves slowly to the pose instead of immediately. */
#define FAR_M 0.30f
/* Rotation to a new pose beyond which the poi moves slowly to the pose instead of immediately. */
#define FAR_TURN 0.3f
/* Value that replaces FAR_TURN if the controller is a pointer. The value is larger, because a
 * pointer tilts its poi during fast motion. */
#define FAR_LEAN 0.8f
#define WET_BELOW_M 0.020f /* Height below which part of a tilted ring may be under water. */
/* Longest total damage immunity of several successive returns from an input loss. */
#define SPARE_TICKS_ALL (2u * FAILSAFE_IMMUNITY_TICKS_MAX)
/* Number of ticks of normal control after which one used tick of damage immunity is available
 * again. */
#define REFILL_TICKS 8u
#define REACH_SIDE_M 0.20f   /* Distance beyond the tank walls to which an arm reaches. */
#define REACH_HEIGHT_M 0.35f /* Height above the water to which an arm reaches. */

int controller_is_active(const struct world *world, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return world->bowl[index].present && world->poi[index].link != POI_SOURCE_ABSENT;
}

int controller_is_lost(const struct world *world, uint32_t index)
{
    return controller_is_active(world, index) && world->poi[index].link == POI_SOURCE_LOST;
}

struct input controller_calibrate(const struct settings *settings, const struct input *said)
{
    struct input own = *said;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        calibration_apply(settings, i, &own.poi[i]);
    }
    return own;
}

void controller_validate(struct game *game, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        input_validation_tick(&game->validation[i], &input->poi[i]);
    }
}

static int is_believed(const struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return game->validation[index].verdict == INPUT_VALID;
}

uint32_t controller_dipped_player(const struct game *game, const struct world *world,
                                  const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (world->bowl[i].present && is_believed(game, i) && game->live_y_m[i] >= GAME_DIP_Y_M &&
            input->poi[i].target.position_m.y < GAME_DIP_Y_M) {
            return i;
        }
    }
    return POI_MAX;
}

static float wrap_target_angle(float angle_rad)
{
    CORE_ASSERT(f_abs(angle_rad) <= INPUT_ANGLE_RAD_MAX);
    return f_wrap_angle(angle_rad);
}

/* Returns the lowest allowed height for a controlled poi: the tank's floor while the player may
 * dip, otherwise CLEAR_Y_M. */
static float lowest_m(const struct game *game, const struct world *world, uint32_t index)
{
    return game_may_scoop(game, index) ? -world->tank.size_m.y : CLEAR_Y_M;
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
    target.angles.yaw_rad = wrap_target_angle(target.angles.yaw_rad);
    target.angles.pitch_rad = wrap_target_angle(target.angles.pitch_rad);
    target.angles.roll_rad = wrap_target_angle(target.angles.roll_rad);
    return target;
}

void controller_forget_path(struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    game->return_ticks[index] = game->outlier_ticks[index] = 0;
    game->was_lost[index] = 0;
}

static void take_hold(struct game *game, const struct world *world,
                      const struct core_config *config, uint32_t index, uint8_t link)
{
    CORE_ASSERT(index < POI_MAX);
    if (game->holder[index] == link) {
        return;
    }
    if (link == POI_SOURCE_BOT) {
        bot_init(&game->bot[index], &technique_expert, config->seed + index);
        game->bot[index].hand.pose = game->hand_pose[index];
        controller_forget_path(game, index); /* The bot has no controller pose to which the poi
                                                would return. */
    }
    if (link == POI_SOURCE_LIVE && game->holder[index] == POI_SOURCE_LOST) {
        game->return_ticks[index] = game->was_lost[index] = 1;
    } else if (link == POI_SOURCE_LOST) {
        game->hand_pose[index] = failsafe_begin(&world->poi[index], game->hand_pose[index]);
    } else {
        game->grip_tick[index] = game->tick;
    }
    game->holder[index] = link;
}

/* Blends from the old target pose to the new pose after a change of the source. The weight of the
 * new pose grows from 0 to 1 during GRIP_TICKS. */
static struct poi_target blend_to_holder(struct game *game, const struct world *world,
                                         uint32_t index, struct poi_target wanted)
{
    CORE_ASSERT(game->holder[index] != POI_SOURCE_ABSENT);
    const int begins = game->phase == PHASE_ROUND && game->tick == game->phase_tick;
    if (begins && wanted.position_m.y < CLEAR_Y_M) {
        game->grip_tick[index] = game->tick; /* If the player already holds the button of the
                                                controller when the round begins, the poi dips
                                                slowly. */
    }
    const float age = (float)(game->tick - game->grip_tick[index]) / (float)GRIP_TICKS;
    wanted = within_reach(world, wanted, lowest_m(game, world, index));
    return age < 1.0f ? pose_between(game->hand_pose[index], wanted, age * age * age) : wanted;
}

/* Filters outliers. A pose that is farther away than an arm can move in one tick may be a sensor
 * error. The target then stays unchanged until the error ends or has lasted for DOUBT_TICKS. Above
 * the water a fast motion of a mouse is accepted. */
static struct poi_target steady(struct game *game, const struct world *world, uint32_t index,
                                struct poi_target next, int has_wrist)
{
    const struct poi *poi = &world->poi[index];
    const struct poi_target hand = game->hand_pose[index];
    const float low_m = f_min(f_min(hand.position_m.y, poi->position_m.y), next.position_m.y);
    /* 1 if an outlier could damage the paper or lose a fish, otherwise 0. */
    const int at_stake = low_m < WET_BELOW_M || poi->carried_count > 0;
    const int is_arm = has_wrist || at_stake;
    const float way_m = v3_length(v3_sub(next.position_m, hand.position_m));
    const float turn_rad = input_turn(hand.angles, next.angles);
    const float pace_m = (is_arm ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX) * CORE_TICK_S;
    const float pace_rad =
        (has_wrist ? INPUT_WRIST_RAD_S_MAX : INPUT_POINTER_RAD_S_MAX) * CORE_TICK_S;
    /* Share of the motion that the speed limits permit in one tick. */
    const float share = f_min(way_m > pace_m ? pace_m / way_m : 1.0f,
                              turn_rad > pace_rad ? pace_rad / turn_rad : 1.0f);
    const int is_doubted = share < 1.0f && is_arm && game_may_scoop(game, index);
    const int is_far = way_m > FAR_M || turn_rad > (has_wrist ? FAR_TURN : FAR_LEAN);
    CORE_ASSERT(share >= 0.0f && share <= 1.0f);
    game->outlier_ticks[index] = is_doubted ? game->outlier_ticks[index] + 1u : 0u;
    if (is_doubted && game->outlier_ticks[index] <= DOUBT_TICKS) {
        return hand;
    }
    if (is_doubted && at_stake && is_far) {
        game->return_ticks[index] = 1;
        return hand;
    }
    return share < 1.0f ? pose_between(hand, next, share) : next;
}

/* Advances the return to the controller's pose. The paper cannot be damaged until the return
 * completes or the immunity reaches its limit. One limit applies to a single return, and a second
 * limit to several returns. */
static struct poi_target return_to_hand(struct game *game, struct world *world, uint32_t index,
                                        struct poi_target wanted)
{
    CORE_ASSERT(game->return_ticks[index] > 0);
    const uint32_t ticks = game->return_ticks[index];
    wanted = within_reach(world, wanted, lowest_m(game, world, index));
    const struct poi_target hand = failsafe_return(game->hand_pose[index], wanted, ticks);
    const int is_back = failsafe_is_returned(hand, wanted, ticks);
    world->poi[index].damage_immune = game->was_lost[index] &&
                                      ticks < FAILSAFE_IMMUNITY_TICKS_MAX &&
                                      game->immunity_ticks[index] < SPARE_TICKS_ALL;
    game->immunity_ticks[index] += world->poi[index].damage_immune;
    game->return_ticks[index] = is_back ? 0u : ticks + 1u;
    game->was_lost[index] &= !is_back;
    game->outlier_ticks[index] = 0;
    return hand;
}

/* Parks a poi that is not in use. A bot continues to take snapshots. When a person uses the poi
 * again, its pose is blended gently. */
static void tick_parked(struct game *game, struct world *world, uint32_t index)
{
    struct bot *bot = &game->bot[index];
    world->poi[index].damage_immune = 1;
    game->hand_pose[index] = parking_path(game, world, index, game->hand_pose[index]);
    if (world->poi[index].link == POI_SOURCE_BOT) {
        const struct vision vision = { game, world, index };
        (void)bot_tick(bot, &vision);
        bot->hand = (struct bot_hand){ .pose = game->hand_pose[index] };
    } else {
        game->grip_tick[index] = game->tick;
        controller_forget_path(game, index);
    }
}

/* Moves a poi without input out of the water. When the input is restored or the pause ends, the
 * return starts from the position that the poi has reached. */
static void tick_failsafe(struct game *game, const struct world *world, uint32_t index)
{
    CORE_ASSERT(world->poi[index].damage_immune);
    const struct poi_target out = failsafe_withdraw(&world->poi[index], game->hand_pose[index]);
    game->hand_pose[index] = within_reach(world, out, -world->tank.size_m.y);
    if (world->poi[index].link == POI_SOURCE_BOT) {
        game->bot[index].hand.pose = game->hand_pose[index];
    } else {
        game->return_ticks[index] = game->was_lost[index] = 1;
    }
}

/* Updates one poi. During a pause for a lost controller, every poi of the tank is in failsafe. */
static void tick_hand(struct game *game, struct world *world, const struct input *input,
                      uint32_t index)
{
    const struct poi_input *says = &input->poi[index];
    struct poi_target *hand = &game->hand_pose[index];
    struct poi *poi = &world->poi[index];
    CORE_ASSERT(poi->link != POI_SOURCE_ABSENT);
    if (parking_tick(game, world, index)) {
        tick_parked(game, world, index);
        return;
    }
    poi->damage_immune = poi->link == POI_SOURCE_LOST || game->paused;
    if (poi->damage_immune) {
        tick_failsafe(game, world, index);
    } else if (poi->link == POI_SOURCE_BOT) {
        const struct vision vision = { game, world, index };
        *hand = blend_to_holder(game, world, index, bot_tick(&game->bot[index], &vision));
    } else if (game->return_ticks[index] > 0) {
        *hand = return_to_hand(game, world, index, says->target);
    } else {
        if (game->tick % REFILL_TICKS == 0 && game->immunity_ticks[index] > 0) {
            game->immunity_ticks[index]--;
        }
        const float share = input_validation_blend(&game->validation[index]);
        struct poi_target next = blend_to_holder(game, world, index, says->target);
        next = share < 1.0f ? pose_between(*hand, next, share) : next;
        *hand = steady(game, world, index, next, says->has_wrist);
    }
}

void controller_tick_all(struct game *game, struct world *world, const struct core_config *config,
                         const struct input *input, struct poi_target targets[POI_MAX],
                         uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        live[i] = (uint8_t)controller_is_active(world, i);
        if (live[i]) {
            take_hold(game, world, config, i, world->poi[i].link);
            tick_hand(game, world, input, i);
        } else {
            game->holder[i] = POI_SOURCE_ABSENT;
            game->rest_ticks[i] = 0;
            controller_forget_path(game, i);
        }
        targets[i] = game->hand_pose[i];
        game->live_y_m[i] = is_believed(game, i)
                                ? input->poi[i].target.position_m.y
                                : -1.0f; /* The value -1 marks invalid input, so that the next valid
                                            pose does not count as a dip (downward crossing). */
    }
}

/* A controller with invalid input counts as a lost controller. */
void controller_assign(const struct game *game, struct world *world, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int is_lost = game->validation[i].verdict == INPUT_LOST;
        uint8_t link = is_lost ? (uint8_t)POI_SOURCE_LOST : input->poi[i].link;
        if (game->phase == PHASE_ATTRACT) {
            link = i == 0 ? POI_SOURCE_BOT : POI_SOURCE_ABSENT;
        }
        world->poi[i].link = link;
    }
}
