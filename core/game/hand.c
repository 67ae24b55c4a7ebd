/* hand.c -- which hand has which poi, and how one takes it over from another. */
#include "core/game/hand.h"

#include "core/base/panic.h"
#include "core/core.h"

#define CLEAR_Y_M 0.035f     /* Pois are held above this while nothing may be scooped. */
#define GRIP_TICKS 144u      /* 1.2 s from one hand to the next: 1 m/s across the tank. */
#define REACH_SIDE_M 0.20f   /* Beyond the walls ... */
#define REACH_HEIGHT_M 0.35f /* ... and above the water that an arm reaches. */
#define ANGLE_RAD_MAX 1000.0f

int hand_plays(const struct core *core, uint32_t index)
{
    return core->bowl[index].present && core->poi[index].link != POI_LINK_ABSENT;
}

/* In attract nobody else's link counts. */
static uint8_t link_now(const struct core *core, const struct input *input, uint32_t index)
{
    if (core->game.phase == PHASE_ATTRACT) {
        return index == 0 ? POI_LINK_BOT : POI_LINK_ABSENT;
    }
    return input->poi[index].link;
}

/* No wrist has turned so far: such an angle is a broken report, and too coarse for a direction. */
static float direction(float angle_rad)
{
    CORE_ASSERT(f_is_finite(angle_rad));
    return f_abs(angle_rad) <= ANGLE_RAD_MAX ? f_wrap_angle(angle_rad) : 0.0f;
}

static struct poi_target within_reach(const struct core *core, struct poi_target target)
{
    const float side_m = 0.5f * core->tank.size_m.x + REACH_SIDE_M;
    const float depth_m = 0.5f * core->tank.size_m.z + REACH_SIDE_M;
    const int in_time = core->game.phase == PHASE_ROUND &&
                        game_seconds_left(&core->game, core->tick) > 0.0f;
    const int scooping = in_time || core->game.phase == PHASE_ATTRACT;
    const float low_m = scooping ? -core->tank.size_m.y : CLEAR_Y_M;
    CORE_ASSERT(v3_is_finite(target.position_m));
    target.position_m.x = f_clamp(target.position_m.x, -side_m, side_m);
    target.position_m.y = f_clamp(target.position_m.y, low_m, REACH_HEIGHT_M);
    target.position_m.z = f_clamp(target.position_m.z, -depth_m, depth_m);
    target.angles.yaw_rad = direction(target.angles.yaw_rad);
    target.angles.pitch_rad = direction(target.angles.pitch_rad);
    target.angles.roll_rad = direction(target.angles.roll_rad);
    return target;
}

/* The short way round. */
static float blend_angle(float from_rad, float to_rad, float share)
{
    return f_wrap_angle(from_rad + f_wrap_angle(to_rad - from_rad) * share);
}

/* From the old hand to the new one: the share that is taken over each tick grows from 0 to 1. */
static struct poi_target blend(struct poi_target from, struct poi_target to, float share)
{
    return (struct poi_target){
        .position_m = v3_lerp(from.position_m, to.position_m, share),
        .angles = { blend_angle(from.angles.yaw_rad, to.angles.yaw_rad, share),
                    blend_angle(from.angles.pitch_rad, to.angles.pitch_rad, share),
                    blend_angle(from.angles.roll_rad, to.angles.roll_rad, share) },
    };
}

static void take_hold(struct core *core, uint32_t index, uint8_t link)
{
    struct game *game = &core->game;
    if (game->holder[index] == link) {
        return;
    }
    if (link == POI_LINK_BOT) {
        bot_init(&game->bot[index], &technique_expert, core->config.seed + index);
        game->bot[index].hand = game->hand[index];
    }
    game->holder[index] = link;
    game->grip_tick[index] = core->tick;
}

static void tick_hand(struct core *core, const struct input *input, uint32_t index)
{
    struct game *game = &core->game;
    struct poi_target wanted = game->hand[index]; /* A lost poi stays where it is. */
    if (core->poi[index].link == POI_LINK_BOT) {
        wanted = bot_tick(&game->bot[index], &(struct sight){ core, index });
    } else if (core->poi[index].link == POI_LINK_LIVE) {
        wanted = input->poi[index].target;
    }
    const int begins = game->phase == PHASE_ROUND && core->tick == game->phase_tick;
    if (begins && wanted.position_m.y < CLEAR_Y_M) {
        game->grip_tick[index] = core->tick; /* Who waits with the button held enters gently. */
    }
    const float age = (float)(core->tick - game->grip_tick[index]) / (float)GRIP_TICKS;
    wanted = within_reach(core, wanted);
    game->hand[index] =
        age < 1.0f ? blend(game->hand[index], wanted, age * age * age) : wanted;
}

void hand_tick_all(struct core *core, const struct input *input,
                   struct poi_target targets[POI_MAX], uint8_t live[POI_MAX])
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        live[i] = (uint8_t)hand_plays(core, i);
        if (live[i]) {
            take_hold(core, i, core->poi[i].link);
            tick_hand(core, input, i);
        } else {
            core->game.holder[i] = POI_LINK_ABSENT;
        }
        targets[i] = core->game.hand[i];
        core->game.live_y_m[i] = input->poi[i].link == POI_LINK_LIVE
                                     ? input->poi[i].target.position_m.y
                                     : -1.0f; /* No way down from a hand that was not there. */
    }
}

void hand_links(struct core *core, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        core->poi[i].link = link_now(core, input, i);
    }
}
