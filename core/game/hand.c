/* hand.c -- which hand has which poi, and how one takes it over from another. */
#include "core/game/hand.h"

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/drift.h"

#define CLEAR_Y_M 0.035f     /* Pois are held above this while nothing may be scooped. */
#define GRIP_TICKS 144u      /* 1.2 s from one hand to the next: 1 m/s across the tank. */
#define REACH_SIDE_M 0.20f   /* Beyond the walls ... */
#define REACH_HEIGHT_M 0.35f /* ... and above the water that an arm reaches. */

int hand_plays(const struct core *core, uint32_t index)
{
    return core->bowl[index].present && core->poi[index].link != POI_LINK_ABSENT;
}

int hand_is_lost(const struct core *core, uint32_t index)
{
    return hand_plays(core, index) && core->poi[index].link == POI_LINK_LOST;
}

void hand_read(struct core *core, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        trust_tick(&core->game.trust[i], &input->poi[i]);
    }
}

static int is_believed(const struct core *core, uint32_t index)
{
    return core->game.trust[index].verdict >= TRUST_CATCH_UP;
}

int hand_dips(const struct core *core, const struct input *input, uint32_t index)
{
    return is_believed(core, index) && core->game.live_y_m[index] >= GAME_DIP_Y_M &&
           input->poi[index].target.position_m.y < GAME_DIP_Y_M;
}

/* In attract nobody else's link counts. Who is not believed is as good as away. */
static uint8_t link_now(const struct core *core, const struct input *input, uint32_t index)
{
    if (core->game.phase == PHASE_ATTRACT) {
        return index == 0 ? POI_LINK_BOT : POI_LINK_ABSENT;
    }
    const int is_lost = core->game.trust[index].verdict == TRUST_LOST;
    return is_lost ? (uint8_t)POI_LINK_LOST : input->poi[index].link;
}

static float direction(float angle_rad)
{
    CORE_ASSERT(f_abs(angle_rad) <= TRUST_ANGLE_RAD);
    return f_wrap_angle(angle_rad);
}

/* No poi that is led goes below this. */
static float lowest_m(const struct core *core, uint32_t index)
{
    return game_may_scoop(core, index) ? -core->tank.size_m.y : CLEAR_Y_M;
}

static struct poi_target within_reach(const struct core *core, struct poi_target target,
                                      float low_m)
{
    const float side_m = 0.5f * core->tank.size_m.x + REACH_SIDE_M;
    const float depth_m = 0.5f * core->tank.size_m.z + REACH_SIDE_M;
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
        game->bot[index].hand.pose = game->hand[index];
        game->back_ticks[index] = 0; /* It is led to nobody any more. */
    }
    if (link == POI_LINK_LIVE && game->holder[index] == POI_LINK_LOST) {
        game->back_ticks[index] = 1;
    } else if (link == POI_LINK_LOST) {
        game->hand[index] = drift_begin(&core->poi[index], game->hand[index]);
    } else {
        game->grip_tick[index] = core->tick;
    }
    game->holder[index] = link;
}

static struct poi_target follow(struct core *core, uint32_t index, struct poi_target wanted)
{
    struct game *game = &core->game;
    const int begins = game->phase == PHASE_ROUND && core->tick == game->phase_tick;
    if (begins && wanted.position_m.y < CLEAR_Y_M) {
        game->grip_tick[index] = core->tick; /* Who waits with the button held enters gently. */
    }
    const float age = (float)(core->tick - game->grip_tick[index]) / (float)GRIP_TICKS;
    wanted = within_reach(core, wanted, lowest_m(core, index));
    return age < 1.0f ? blend(game->hand[index], wanted, age * age * age) : wanted;
}

/* A sensor that strays for a moment does not throw the poi about. */
static struct poi_target at_arms_pace(struct poi_target from, struct poi_target to)
{
    const vec3 way_m = v3_sub(to.position_m, from.position_m);
    to.position_m = v3_add(from.position_m, v3_limit(way_m, TRUST_ARM_M_S * CORE_TICK_S));
    return to;
}

/* Its paper is spared until it is back, but not for ever. */
static struct poi_target go_back(struct core *core, uint32_t index, struct poi_target wanted)
{
    struct game *game = &core->game;
    const uint32_t ticks = game->back_ticks[index];
    wanted = within_reach(core, wanted, lowest_m(core, index));
    const struct poi_target hand = drift_back(game->hand[index], wanted, ticks);
    const int is_back = drift_is_back(hand, wanted, ticks);
    core->poi[index].spared = ticks < DRIFT_SPARE_TICKS_MAX;
    game->back_ticks[index] = is_back ? 0u : ticks + 1u;
    return hand;
}

static struct poi_target led_by_a_person(struct core *core, const struct input *input,
                                         uint32_t index)
{
    struct game *game = &core->game;
    if (game->trust[index].verdict == TRUST_CATCH_UP && game->back_ticks[index] == 0) {
        game->back_ticks[index] = 1;
    }
    if (game->back_ticks[index] > 0) {
        return go_back(core, index, input->poi[index].target);
    }
    const struct poi_target next = follow(core, index, input->poi[index].target);
    return input->poi[index].has_wrist ? at_arms_pace(game->hand[index], next) : next;
}

/* Nobody leads it. Whoever is there again, or waits for somebody else, fetches it from there. */
static void drift(struct core *core, uint32_t index)
{
    struct game *game = &core->game;
    const struct poi_target out = drift_out(&core->poi[index], game->hand[index]);
    game->hand[index] = within_reach(core, out, -core->tank.size_m.y);
    if (core->poi[index].link == POI_LINK_BOT) {
        game->bot[index].hand.pose = game->hand[index];
    } else {
        game->back_ticks[index] = 1;
    }
}

/* While the round waits for a lost hand, all let go alike. */
static void tick_hand(struct core *core, const struct input *input, uint32_t index)
{
    struct game *game = &core->game;
    struct poi *poi = &core->poi[index];
    poi->spared = poi->link == POI_LINK_LOST || game->paused;
    if (poi->spared) {
        drift(core, index);
    } else if (poi->link == POI_LINK_BOT) {
        const struct sight sight = { core, index };
        game->hand[index] = follow(core, index, bot_tick(&game->bot[index], &sight));
    } else {
        game->hand[index] = led_by_a_person(core, input, index);
    }
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
            core->game.back_ticks[i] = 0;
        }
        targets[i] = core->game.hand[i];
        core->game.live_y_m[i] = is_believed(core, i)
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
