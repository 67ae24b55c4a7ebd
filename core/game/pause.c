/* pause.c -- decides for which player the round pauses, and for how long. */
#include "core/game/pause.h"

#include "core/core.h"
#include "core/game/control/controller.h"

int pause_holds(const struct core *core, uint32_t index)
{
    return controller_is_active(core, index) && !controller_is_lost(core, index);
}

/* Marks the players who have a poi in use. Returns 1 if any player has had one in this round. */
static int note_who_plays(struct core *core)
{
    int any = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &core->game.player[i];
        player->plays |= (uint8_t)pause_holds(core, i);
        any |= player->plays;
    }
    return any;
}

/* Returns the number of players still in the round: those with a working controller (`holds` 1), or
 * those without (0). */
static uint32_t count_in(const struct core *core, int holds)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &core->game.player[i];
        count += player->plays && !player->out && pause_holds(core, i) == holds;
    }
    return count;
}

/* Counts the waiting time for each lost player while other players wait, and puts players beyond
 * the limits out of the round. */
static void lose_patience(struct core *core, int others_wait)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &core->game.player[i];
        if (pause_holds(core, i)) {
            player->lost_ticks = 0;
        } else if (player->plays && others_wait && !player->out) {
            player->lost_ticks++;
            player->waited_ticks++;
            player->out |= player->lost_ticks > GAME_LOST_TICKS_OTHERS ||
                           player->waited_ticks > GAME_WAIT_TICKS_OTHERS;
        }
    }
}

void pause_tick(struct core *core)
{
    struct game *game = &core->game;
    const int anybody_played = note_who_plays(core);
    const int in_time =
        game_seconds_left(game, core->game.tick) > 0.0f; /* After time is up the round
                                                                       does not pause. */
    const uint32_t busy = count_in(core, 1);
    lose_patience(core, in_time && busy > 0);
    game->paused = in_time && (!anybody_played || count_in(core, 0) > 0);
    game->lost_ticks = game->paused && busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->waited_ticks += busy == 0 ? 1u : 0u;
        game->phase_tick++;
        game->paused_ticks++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}

int pause_is_over(const struct core *core)
{
    return core->game.lost_ticks > GAME_LOST_TICKS_MAX ||
           core->game.waited_ticks > GAME_WAIT_TICKS_MAX;
}
