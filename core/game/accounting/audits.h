/* audits.h -- the audits, which are the operator's statistics: money, games, catches and faults.
 *
 * The audits are counters, each with a fixed name. Each counter is computed from ledger entries.
 * The core and the store add entries with the same function, so the menu and the database always
 * agree. Hours and weekdays come from the clock, if the clock was set. */
#pragma once

#include <stdint.h>

#include "core/ledger.h"
#include "core/poi/paper/sheet.h"
#include "core/scene.h"

#define AUDIT_GRADES (SHEET_GRADE_MAX - SHEET_GRADE_MIN + 1u)

enum audit_id {
    /* Group 0: counters of coins, credits and tickets. */
    AUDIT_COINS_1 = 0, /* Number of pulses of the first coin line. */
    AUDIT_COINS_2,
    AUDIT_COINS_3,
    AUDIT_UNITS, /* Total value of all coin pulses, in coin units. */
    AUDIT_TEST_COINS,
    AUDIT_CREDITS_PAID,
    AUDIT_CREDITS_BONUS, /* Bonus credits, included in AUDIT_CREDITS_PAID. */
    AUDIT_CREDITS_SERVICE,
    AUDIT_REFUNDS,
    AUDIT_EXPIRED,
    AUDIT_TICKETS,
    AUDIT_TILTS,
    /* Group 1: counters of games, players, catches and paper. */
    AUDIT_PLAYS_PAID,
    AUDIT_PLAYS_SERVICE,
    AUDIT_PLAYS_FREE,
    /* Visits to the growth lab. These visits are also included in the counters of started games. */
    AUDIT_PLAYS_LAB,
    /* Scored rounds that people played to the end. The counters from AUDIT_PLAYERS to AUDIT_FOULS
     * cover only these rounds. */
    AUDIT_ROUNDS,
    AUDIT_PLAYERS,
    AUDIT_CAUGHT,
    AUDIT_PLAY_S,       /* Total time of the rounds in seconds. */
    AUDIT_PAPERS,       /* Sheets of paper that players received. */
    AUDIT_PAPERS_TORN,  /* Sheets of paper that tore through. */
    AUDIT_PAPER_LIFE_S, /* Total lifetime in seconds of the sheets of paper that tore. */
    AUDIT_FOULS,
    /* First of the counters of started rounds, one for each mode and grade. The index is
     * AUDIT_PLAYS + mode * AUDIT_GRADES + grade - SHEET_GRADE_MIN. */
    AUDIT_PLAYS,
    /* First of 24 counters of started games, one for each hour of the day. */
    AUDIT_HOUR = AUDIT_PLAYS + MODE_COUNT * AUDIT_GRADES,
    /* First of 7 counters of started games, one for each weekday, beginning with Monday. */
    AUDIT_WEEKDAY = AUDIT_HOUR + 24,
    /* Group 2: counters of starts, faults and uptime of the machine. */
    AUDIT_BOOTS = AUDIT_WEEKDAY + 7,
    /* Rounds that were still open at startup, because a crash or a power cut interrupted them. */
    AUDIT_CRASHED_ROUNDS,
    AUDIT_DROPPED_TICKS,
    AUDIT_DEVICE_FAULTS,
    AUDIT_UP_S,     /* Total uptime in seconds. */
    AUDIT_UP_S_MAX, /* Longest uptime between two starts, in seconds. */
    AUDIT_RESETS,   /* Number of resets of counter groups. This counter is never reset. */
    /* Number of wrong PINs since the last correct PIN. No page shows the counter, because a page
     * opens only after a correct PIN, which sets the counter to 0. */
    AUDIT_WRONG_PINS,
    AUDIT_FORMAT_7_COUNT, /* Number of counters in recordings of the older format 7. */
    /* First of the counters of LEDGER_LOSS entries (repeated losses of a slot's controller during
     * rounds), one for each slot. */
    AUDIT_LOST_AGAIN = AUDIT_FORMAT_7_COUNT,
    /* Number of tickets sent to the ticket dispenser. AUDIT_TICKETS includes these tickets. The
     * counter belongs to group 0. */
    AUDIT_TICKETS_OUT = AUDIT_LOST_AGAIN + (int)POI_MAX,
    AUDIT_FORMAT_8_COUNT, /* Number of counters in recordings of the older format 8. */
    /* First of the counters of rounds at easier levels, one for each level from LEVEL_NORMAL on.
     * AUDIT_ROUNDS includes these rounds. The counters belong to group 1. */
    AUDIT_ROUNDS_EASIER = AUDIT_FORMAT_8_COUNT,
    AUDIT_COUNT = AUDIT_ROUNDS_EASIER + (int)LEVEL_COUNT - 1,
};

enum audit_group {
    AUDIT_GROUP_MONEY = 0,
    AUDIT_GROUP_PLAY,
    AUDIT_GROUP_MACHINE,
    AUDIT_GROUP_COUNT
};

struct audits {
    uint32_t count[AUDIT_COUNT]; /* Counters, each saturated at UINT32_MAX. */
};

#define AUDIT_NAME_SIZE 32u

/* Writes the key of counter `id` < AUDIT_COUNT, such as "coins-1", "plays-festival-6" or "hour-13".
 * The store and kingyoctl use this key. */
void audits_name(uint32_t id, char out[AUDIT_NAME_SIZE]);

/* Returns the group of counter `id`. Asserts that `id` < AUDIT_COUNT. */
enum audit_group audits_group_of(uint32_t id);

/* Returns the number of rounds in AUDIT_ROUNDS that were played at `level`. Rounds of an earlier
 * version count as LEVEL_MASTER. `count` holds the values of all counters. */
uint32_t audits_rounds_at(const uint32_t count[AUDIT_COUNT], uint8_t level);

/* Increases the counters to which the ledger entry `entry` belongs. */
void audits_note(struct audits *audits, const struct ledger_entry *entry);
