/* fouls.c -- detection of fouls from shadows and catches. */
#include "core/game/fouls.h"

#include "core/game/game.h"
#include "core/poi/world.h"

void fouls_commit(struct game *game, uint32_t index, enum foul kind, struct output *output)
{
    struct player *player = &game->player[index];
    const uint32_t last_tick = player->offence_tick[kind];
    player->offence_tick[kind] = game->tick;
    if (!rules_of(game->mode)->judges || player->fouls >= FOUL_MAX ||
        (last_tick != 0 && game->tick - last_tick < FOUL_APART_TICKS)) {
        return;
    }
    player->fouls++;
    player->foul = (uint8_t)kind;
    player->foul_tick = game->tick;
    player->out |= player->fouls == FOUL_MAX;
    output_sound(output, SOUND_FOUL, 1.0f, 0.0f);
}

/* ---- Before the start ----------------------------------------------------------------------- */

/* Returns 1 if the shadow has rested over fish long enough for a foul, otherwise 0. The time of a
 * shadow that was already present when READY began counts only from the start of READY. */
static int is_held_over_fish(const struct game *game, const struct world *world,
                             const struct shade *shade)
{
    const float ready_s = (float)(game->tick - game->phase_tick) * CORE_TICK_S;
    return shade->cast.present && f_min(shade->still_s, ready_s) >= FOUL_SHADE_S &&
           tank_shade_count(&world->tank, &shade->cast) > 0;
}

/* Tracks whether the player moved the controller. The function uses the controller's pose and not
 * the poi's pose, because a new tank or a new source moves the poi without the player. After the
 * view changes, a pointer refers to a different point of the water, and its pose jumps in the next
 * frames. The rest position is therefore updated until FOUL_SETTLE_TICKS. */
static void watch_stance(struct player *player, vec3 hand_m, uint32_t ready_ticks)
{
    if (player->stance == STANCE_UNSEEN || ready_ticks < FOUL_SETTLE_TICKS) {
        player->stance = STANCE_RESTS;
        player_rests(player, hand_m);
    } else if (player_stirs(player, hand_m)) {
        player->stance = STANCE_MOVED;
    }
}

static int has_moved(struct game *game, const struct world *world, uint32_t index)
{
    struct player *player = &game->player[index];
    const uint32_t ready_ticks = game->tick - game->phase_tick;
    if (!pause_holds(world, index)) {
        player->stance = STANCE_UNSEEN; /* A controller that was disconnected by a broken cable is
                                           no foul. */
    } else if (world->poi[index].link == POI_SOURCE_LIVE) {
        watch_stance(player, game->validation[index].newest.position_m, ready_ticks);
    } else if (world->poi[index].link == POI_SOURCE_BOT) {
        watch_stance(player, game->hand_pose[index].position_m, ready_ticks);
    }
    return player->stance == STANCE_MOVED;
}

void fouls_before_start(struct game *game, const struct world *world, struct output *output)
{
    const struct tank *tank = &world->tank;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int moved = has_moved(game, world, i);
        const int by_fan = is_held_over_fish(game, world, &tank->shade[i]);
        const int by_poi = moved && is_held_over_fish(game, world, &tank->shade[SHADE_MAX + i]);
        if (world->bowl[i].present && (by_fan || by_poi)) {
            fouls_commit(game, i, FOUL_SHADE, output);
        }
    }
}

/* ---- In the round --------------------------------------------------------------------------- */

void fouls_of_catch(struct game *game, const struct world *world,
                    const struct catch_result caught[POI_MAX], struct output *output)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (!pause_holds(world, i) || game->paused) {
            continue; /* Fish that fall off a poi without valid input count for no player. */
        }
        if (caught[i].poured > 0) {
            fouls_commit(game, i, FOUL_POURED, output);
        }
        if (caught[i].walled > 0) {
            fouls_commit(game, i, FOUL_WALL, output);
        }
    }
}
