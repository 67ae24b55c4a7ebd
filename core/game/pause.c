/* pause.c -- who is waited for, and for how long. */
#include "core/game/pause.h"

#include "core/core.h"
#include "core/game/hand.h"

int pause_holds(const struct core *core, uint32_t index)
{
    return hand_plays(core, index) && !hand_is_lost(core, index);
}

struct hands {
    uint32_t any;  /* In hand, by whoever takes part. */
    uint32_t busy; /* Of those, whose round goes on. */
    uint32_t lost; /* Whose round would go on, but their hand is away. */
};

static struct hands count_hands(struct core *core)
{
    struct hands hands = { 0 };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct player *player = &core->game.player[i];
        const int holds = pause_holds(core, i);
        player->plays |= (uint8_t)holds;
        hands.any += holds ? 1u : 0u;
        hands.busy += holds && !player->out;
        hands.lost += !holds && player->plays && !player->out;
    }
    return hands;
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
    const struct hands hands = count_hands(core);
    lose_patience(core, hands.busy > 0);
    game->paused = hands.lost > 0 || hands.any == 0;
    game->lost_ticks = game->paused && hands.busy == 0 ? game->lost_ticks + 1u : 0;
    if (game->paused) {
        game->phase_tick++;
        game->gone_tick += game->gone_tick != 0 ? 1u : 0u;
    }
}

int pause_is_over(const struct core *core)
{
    return core->game.lost_ticks > GAME_LOST_TICKS_MAX;
}
