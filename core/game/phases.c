/* phases.c -- changes the phase, and computes the time left in a phase and what a phase permits. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/game/rules.h"

void game_enter_phase(struct game *game, uint8_t phase)
{
    CORE_ASSERT(phase <= PHASE_LEADERBOARD);
    game->phase = phase;
    game->phase_tick = game->tick;
}

int game_may_scoop(const struct game *game, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const int in_time = game->phase == PHASE_ROUND && game_seconds_left(game, game->tick) > 0.0f;
    return game->phase == PHASE_ATTRACT || (in_time && !game->paused && !game->player[index].out);
}

int game_pumps(const struct game *game, uint32_t tick)
{
    const uint32_t elapsed = (tick - game->phase_tick) % (GAME_STALE_TICKS + GAME_AIR_TICKS);
    return game->phase == PHASE_ATTRACT ? elapsed >= GAME_STALE_TICKS : game->phase != PHASE_ROUND;
}

static uint32_t min_ticks(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

float game_seconds_left(const struct game *game, uint32_t tick)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    const struct name *name = &game->name;
    uint32_t start = game->phase_tick, total = 0;
    switch (game->phase) {
    case PHASE_MODE_SELECT:
        total = min_ticks(game->point_tick - start + GAME_MODE_SELECT_TICKS,
                          GAME_MODE_SELECT_TICKS_MAX);
        break;
    case PHASE_READY:
        total = rules_of(game->mode)->ready_s * CORE_TICK_HZ;
        break;
    case PHASE_ROUND:
        total = game->round_s * CORE_TICK_HZ;
        break;
    case PHASE_NAME:
        start = name->seat_tick;
        total = min_ticks(name->act_tick - start + NAME_IDLE_TICKS, NAME_TICKS_MAX);
        break;
    default:
        break;
    }
    const uint32_t elapsed = tick - start;
    return elapsed < total ? (float)(total - elapsed) * CORE_TICK_S : 0.0f;
}
