/* pause.c -- who is waited for, and for how long. */
#include "core/game/pause.h"

#include "core/core.h"
#include "core/game/hand.h"

int pause_holds(const struct core *core, uint32_t index)
{
    return hand_plays(core, index) && !hand_is_lost(core, index);
}

static uint32_t note_who_holds(struct core *core)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const int holds = pause_holds(core, i);
        core->game.player[i].plays |= (uint8_t)holds;
        count += holds ? 1u : 0u;
    }
    return count;
}

/* Whose round goes on: with their poi in hand (1), or with that hand away (0). */
static uint32_t count_in(const struct core *core, int holds)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &core->game.player[i];
        count += player->plays && !player->out && pause_holds(core, i) == holds;
    }
    return count;
}

/* Waiting counts only while somebody waits. */
static void lose_patience(struct core *core, int others_wait)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &core->game.player[i];
        if (pause_holds(core, i)) {
            player->lost_ticks = 0;
        } else if (player->plays && others_wait && !player->out) {
            player->lost_ticks++;
            player->out |= player->lost_ticks > GAME_LOST_TICKS_OTHERS;
        }
    }
}

void pause_tick(struct core *core)
{
    struct game *game = &core->game;
    const uint32_t holding = note_who_holds(core), busy = count_in(core, 1);
    lose_patience(core, busy > 0);
    game->paused = holding == 0 || count_in(core, 0) > 0;
    game->lost_ticks = game->paused && busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->phase_tick++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}

int pause_is_over(const struct core *core)
{
    return core->game.lost_ticks > GAME_LOST_TICKS_MAX;
}
