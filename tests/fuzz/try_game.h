/* try_game.h -- starts a game with the data of an untrusted file. */
#ifndef KINGYO_TESTS_FUZZ_TRY_GAME_H
#define KINGYO_TESTS_FUZZ_TRY_GAME_H

#include <stdint.h>

#include "core/core.h"

/* Starts a game with `config` and runs `ticks` ticks without controller input. Returns 1 if the
 * game started. Returns 0 if core_init() rejected `config`, which is not a fault. A failed
 * assertion of the core ends the process. */
int try_game(const struct core_config *config, uint32_t ticks);

/* Starts a game with persistent state that a store has loaded, as the kiosk does. Resets settings
 * that are out of range to their defaults first. */
void try_game_persistent(const struct persistent_state *memory, uint32_t ticks);

/* Core of the last game that try_game() started. Valid until the next call. */
extern struct core try_game_core;

#endif
