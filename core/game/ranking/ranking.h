/* ranking.h -- the leaderboards of each mode: today, this week, ever.
 *
 * Like the statistics, the leaderboards are computed from the ledger's entries alone. The core and
 * the store add entries with the same function.
 *
 * Dates are hints. A day lasts until an entry has a later date, and a date one day back is
 * ignored (the clock was set around midnight). Without a clock (entries with day 0) a day lasts
 * for one run of the kiosk. The first round of a new run begins a day, and the seventh such run
 * begins a week. */
#ifndef KINGYO_CORE_GAME_RANKING_RANKING_H
#define KINGYO_CORE_GAME_RANKING_RANKING_H

#include <stdint.h>

#include "core/ledger.h"
#include "core/scene.h"

#define RANK_ROWS 10u

enum rank_period { RANK_DAY = 0, RANK_WEEK, RANK_EVER, RANK_PERIOD_COUNT };

struct rank_row {
    uint32_t caught;   /* 0: empty row. If scores are equal, the earlier score ranks higher. */
    uint32_t round_id; /* Id of the round's entry, under which the store keeps its replay. */
    uint16_t day;      /* Day of the round; 0: unknown. */
    uint8_t seat;
    char name[LEDGER_NAME_SIZE]; /* Name; "" until one is entered. */
};

struct ranking {
    uint32_t boot;      /* Run in which the current day was last played or dated. */
    uint16_t day;       /* Current day; 0: the day began without a clock. */
    uint16_t week;      /* Weeks since 1999-12-27; 0: the week began without a clock. */
    uint32_t week_boot; /* Run in which the current week began. */
    struct rank_row row[MODE_COUNT][RANK_PERIOD_COUNT][RANK_ROWS];
};

/* Adds an entry: the players of a finished round without bots, or a name for an earlier round. */
void ranking_note(struct ranking *ranking, const struct ledger_entry *entry);

/* Returns the place of slot `seat` of round `round_id`, from 0; RANK_ROWS: not ranked. */
uint32_t ranking_place(const struct ranking *ranking, uint8_t mode, enum rank_period period,
                       uint32_t round_id, uint8_t seat);

uint64_t ranking_hash(uint64_t hash, const struct ranking *ranking);

#endif
