/* ranking.h -- the leaderboards of each mode and level: today, this week, all time.
 *
 * Like the audits, the leaderboards are computed only from the ledger's entries. The core and the
 * store add entries with the same function.
 *
 * Dates in entries may be wrong. A day lasts until an entry has a later date. A date one day back
 * is ignored, because the clock was probably set around midnight. Without a clock, entries have day
 * 0, and a day lasts from one start of the kiosk to the next. The first round after a start then
 * begins a new day, and the seventh such start begins a new week. */
#pragma once

#include <stdint.h>

#include "core/ledger.h"
#include "core/scene.h"

#define RANK_ROWS 10u

/* Number of boards: each mode has a board for LEVEL_MASTER, and the festival also has one for each
 * easier level. Each board has a leaderboard for each period. */
#define RANK_BOARD_COUNT (MODE_COUNT + LEVEL_COUNT - 1u)

struct rank_board {
    uint8_t mode;  /* enum game_mode */
    uint8_t level; /* enum level */
};

enum rank_period { RANK_DAY = 0, RANK_WEEK, RANK_EVER, RANK_PERIOD_COUNT };

struct rank_row {
    /* Number of fish caught; 0 means that the row is empty. If two scores are equal, the earlier
     * score ranks higher. */
    uint32_t caught;
    /* Id of the round's ledger entry. The store keeps the round's replay under this id. */
    uint32_t round_id;
    uint16_t day; /* Date of the round as a day number; 0 means unknown. */
    uint8_t slot;
    char name[LEDGER_NAME_SIZE]; /* Name of the player; "" until a name is entered. */
};

struct ranking {
    /* Boot counter (number of kiosk starts so far) of the newest entry of the current day. */
    uint32_t boot;
    uint16_t day; /* Current day; 0 means that the day began without a clock. */
    /* Current week, counted from 1999-12-27; 0 means that the week began without a clock. */
    uint16_t week;
    /* Boot counter (number of kiosk starts so far) when the current week began. */
    uint32_t week_boot;
    struct rank_row row[RANK_BOARD_COUNT][RANK_PERIOD_COUNT][RANK_ROWS];
};

/* Returns mode and level of board `board`. Asserts that `board` < RANK_BOARD_COUNT. The number of a
 * board at LEVEL_MASTER is the number of its mode. */
struct rank_board ranking_board_at(uint32_t board);

/* Returns the number of the board of `mode` and `level`. A mode without a board at `level` has only
 * the board at LEVEL_MASTER, whose number is then returned. */
uint32_t ranking_board(uint8_t mode, uint8_t level);

/* Updates the leaderboards from a ledger entry. The entry of a finished round without bots adds the
 * players of the round, and a LEDGER_NAME adds a name to an earlier round. */
void ranking_note(struct ranking *ranking, const struct ledger_entry *entry);

/* Returns the place of slot `slot` of round `round_id` on board `board`, from 0. RANK_ROWS means
 * that the slot is not ranked. */
uint32_t ranking_place(const struct ranking *ranking, uint32_t board, enum rank_period period,
                       uint32_t round_id, uint8_t slot);
