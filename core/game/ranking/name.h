/* name.h -- the name entry after a round: each ranked player enters a name for the leaderboard. The
 * players take turns, beginning with the player with the best place.
 *
 * The player's own poi points at a key of the on-screen keyboard, and a dip presses the key. LEFT
 * and RIGHT move from key to key, and repeat while they are held. OK and START press the
 * highlighted key.
 *
 * After a timeout the letters entered so far become the name. The name is written to the ledger.
 *
 * An offensive name (name_filter.h) is rejected once and must be replaced. After a second rejection
 * the score has no name.
 *
 * Names are requested only if the operator enabled them (SET_NAMES) and a store exists. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/game.h"

/* Stores which players of a finished round are ranked and therefore may enter a name. `board` is
 * the board of the round (ranking_board()). `round_id` is the ledger id of the round, or 0 if the
 * round has no ledger entry. */
void name_note_round(struct name *name, const struct accounts *accounts,
                     const struct settings *settings, uint32_t board, uint32_t round_id);

/* Starts the name entry of the next ranked player. Returns true, or false if no player still needs
 * a name. */
bool name_begin(struct game *game, struct output *output);
game_phase_tick name_tick;

/* Ends the name entry early and logs the letters entered so far as the name. */
void name_keep(struct accounts *accounts, const struct name *name, uint32_t tick,
               struct output *output);

/* Fills `out` with the visible state of the name entry. */
void name_show(const struct game *game, struct scene_name *out);

/* ---- Leaderboard screen after a round and in attract mode ------------------------------------ */

/* The leaderboard screen, which is shown after a round with a ranked player, and at intervals in
 * attract mode. */

/* Duration of the leaderboard screen, long enough to read ten rows. */
#define LEADERBOARD_TICKS (9u * CORE_TICK_HZ)
/* Time in attract mode between the starts of two leaderboard screens. The tank is shown between the
 * screens. */
#define LEADERBOARD_EVERY_TICKS (30u * CORE_TICK_HZ)

/* A player's best place on the leaderboards of the day, the week and all time. If the places in two
 * periods are equal, the longer period counts. */
struct leaderboard_place {
    uint8_t period; /* Period of the leaderboard with the best place (enum rank_period). */
    uint8_t place;  /* Best place on that leaderboard, counted from 1; 0 means not ranked. */
};

/* Returns the board of the mode and level of the current or last round (ranking_board()). */
uint32_t leaderboard_board(const struct game *game);

/* Returns the best place of slot `slot` in the last ranked round, on the leaderboards of the
 * round's mode and level. The place is 0 if the slot is not ranked. */
struct leaderboard_place leaderboard_best_place(const struct game *game, uint8_t slot);

/* Runs one tick of the leaderboard phase, which follows the name entry. START or a dip starts a
 * game; OK turns the page. */
game_phase_tick leaderboard_tick;

/* Fills `out` with the visible leaderboard. The function also works in attract mode and in the
 * operator's menu. */
void leaderboard_show(const struct game *game, const struct core_config *config,
                      struct scene_leaderboard *out);
