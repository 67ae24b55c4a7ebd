/* pause.c -- decides for which player the round pauses, and how long. */
#include "core/game/pause.h"

#include "core/game/game.h"
#include "core/poi/world.h"
#include "core/game/control/controller.h"

int pause_holds(const struct world *world, uint32_t index)
{
    return controller_is_active(world, index) && !controller_is_lost(world, index);
}

/* Marks the players who have a poi in use. Returns 1 if any player has had one in this round. */
static int note_who_plays(struct game *game, const struct world *world)
{
    int any = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &game->player[i];
        player->plays |= (uint8_t)pause_holds(world, i);
        any |= player->plays;
    }
    return any;
}

/* Returns the number of players who are still in the round. If `holds` is 1, counts players with a
 * working controller. If `holds` is 0, counts players without one. */
static uint32_t count_in(const struct game *game, const struct world *world, int holds)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        count += player->plays && !player->out && pause_holds(world, i) == holds;
    }
    return count;
}

/* Counts the waiting time for each player without a controller while other players wait. A player
 * whose waiting time exceeds a limit is out of the round. */
static void lose_patience(struct game *game, const struct world *world, int others_wait)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &game->player[i];
        if (pause_holds(world, i)) {
            player->lost_ticks = 0;
        } else if (player->plays && others_wait && !player->out) {
            player->lost_ticks++;
            player->waited_ticks++;
            player->out |= player->lost_ticks > GAME_LOST_TICKS_OTHERS ||
                           player->waited_ticks > GAME_WAIT_TICKS_OTHERS;
        }
    }
}

void pause_tick(struct game *game, const struct world *world)
{
    const int anybody_played = note_who_plays(game, world);
    const int in_time = game_seconds_left(game, game->tick) > 0.0f; /* After time is up the round
                                                                       does not pause. */
    const uint32_t busy = count_in(game, world, 1);
    lose_patience(game, world, in_time && busy > 0);
    game->paused = in_time && (!anybody_played || count_in(game, world, 0) > 0);
    game->lost_ticks = game->paused && busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->waited_ticks += busy == 0 ? 1u : 0u;
        game->phase_tick++;
        game->paused_ticks++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}

int pause_is_over(const struct game *game)
{
    return game->lost_ticks > GAME_LOST_TICKS_MAX || game->waited_ticks > GAME_WAIT_TICKS_MAX;
}
