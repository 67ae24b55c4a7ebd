/* ranking.h -- the best of each mode: today, this week, ever.
 *
 * Like the audits it is nothing but what the ledger's entries make of it, added one by one by the
 * same function in the core and in the store.
 *
 * Dates are a hint. A day lasts until an entry's clock says another one, and a day back is none
 * (it was set about midnight). Without a clock (entries whose day is 0) a day lasts as long as the
 * kiosk runs: the first round of another start begins one, and the seventh such start a week. */
#ifndef KINGYO_CORE_GAME_RANKING_H
#define KINGYO_CORE_GAME_RANKING_H

#include <stdint.h>

#include "core/ledger.h"
#include "core/scene.h"

#define RANK_ROWS 10u

enum rank_period { RANK_DAY = 0, RANK_WEEK, RANK_EVER, RANK_PERIOD_COUNT };

struct rank_row {
    uint32_t caught;   /* 0: nobody yet. Who caught as many earlier stands higher. */
    uint32_t round_id; /* The entry of its round, under which the store keeps its replay. */
    uint16_t day;      /* 0: unknown. */
    uint8_t seat;
    char name[LEDGER_NAME_SIZE]; /* "" until, and unless, one was given. */
};

struct ranking {
    uint32_t boot;      /* In which its day was last played, or told by the clock. */
    uint16_t day;       /* 0: it began without a clock. */
    uint16_t week;      /* Since 1999-12-27; 0: likewise. */
    uint32_t week_boot; /* In which its week began. */
    struct rank_row row[MODE_COUNT][RANK_PERIOD_COUNT][RANK_ROWS];
};

/* A finished round's players, none of them a bot's, and names that are given later. */
void ranking_note(struct ranking *ranking, const struct ledger_entry *entry);

/* Where seat `seat` of the round `round_id` stands, from 0; RANK_ROWS: it does not. */
uint32_t ranking_place(const struct ranking *ranking, uint8_t mode, enum rank_period period,
                       uint32_t round_id, uint8_t seat);

uint64_t ranking_hash(uint64_t hash, const struct ranking *ranking);

#endif
