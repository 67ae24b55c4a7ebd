/* audits.h -- the operator's books: what was earned, played, caught and broken.
 *
 * Numbers that only grow, each with a name that never changes. They are nothing but the sum of the
 * ledger's entries: the core and the store add the same entries by the same function, so the menu
 * and the file can never disagree. Hours and weekdays are what the clock said, if it said any. */
#ifndef KINGYO_CORE_GAME_AUDITS_H
#define KINGYO_CORE_GAME_AUDITS_H

#include <stdint.h>

#include "core/ledger.h"
#include "core/poi/sheet.h"
#include "core/scene.h"

#define AUDIT_GRADES (SHEET_GRADE_MAX - SHEET_GRADE_MIN + 1u)

enum audit_id {
    /* Money: group 0. */
    AUDIT_COINS_1 = 0, /* Pulses of each line; */
    AUDIT_COINS_2,
    AUDIT_COINS_3,
    AUDIT_UNITS,       /* what they were worth. */
    AUDIT_TEST_COINS,
    AUDIT_CREDITS_PAID,
    AUDIT_CREDITS_BONUS, /* Among those that were paid. */
    AUDIT_CREDITS_SERVICE,
    AUDIT_REFUNDS,
    AUDIT_EXPIRED,
    AUDIT_TICKETS,
    AUDIT_TILTS,
    /* Play: group 1. */
    AUDIT_PLAYS_PAID,
    AUDIT_PLAYS_SERVICE,
    AUDIT_PLAYS_FREE,
    AUDIT_PLAYS_LAB,   /* The growth lab, among these. */
    AUDIT_ROUNDS,      /* Played to their end by people, and scored: what follows is of them. */
    AUDIT_PLAYERS,
    AUDIT_CAUGHT,
    AUDIT_PLAY_S,      /* Seconds. */
    AUDIT_PAPERS,      /* Sheets that were handed out, ... */
    AUDIT_PAPERS_TORN, /* ... those that tore through, ... */
    AUDIT_PAPER_LIFE_S, /* ... and how long those lasted together. */
    AUDIT_FOULS,
    AUDIT_PLAYS, /* Begun, by mode and grade: mode * AUDIT_GRADES + grade - SHEET_GRADE_MIN. */
    AUDIT_HOUR = AUDIT_PLAYS + MODE_COUNT * AUDIT_GRADES, /* All that began, by hour, 24; */
    AUDIT_WEEKDAY = AUDIT_HOUR + 24,                      /* by weekday, Monday first, 7. */
    /* The machine: group 2. */
    AUDIT_BOOTS = AUDIT_WEEKDAY + 7,
    AUDIT_CRASHED_ROUNDS, /* That were open at the start. */
    AUDIT_DROPPED_TICKS,
    AUDIT_DEVICE_FAULTS,
    AUDIT_UP_S,        /* In all; */
    AUDIT_UP_S_MAX,    /* the longest without a restart. */
    AUDIT_RESETS,      /* Of any group; never reset. */
    AUDIT_WRONG_PINS,  /* In a row, up to now: the right one makes it 0, so no page shows it. */
    AUDIT_FORMAT_7_COUNT, /* Recordings of format 7 have the counters above, and no others. */
    AUDIT_LOST_AGAIN = AUDIT_FORMAT_7_COUNT, /* Repeated losses of each seat's controller. */
    AUDIT_TICKETS_OUT = AUDIT_LOST_AGAIN + (int)POI_MAX, /* Money: begun by the dispenser, of
                                                            AUDIT_TICKETS. */
    AUDIT_COUNT,
};

enum audit_group { AUDIT_GROUP_MONEY = 0, AUDIT_GROUP_PLAY, AUDIT_GROUP_MACHINE,
                   AUDIT_GROUP_COUNT };

struct audits {
    uint32_t count[AUDIT_COUNT]; /* Each stops at UINT32_MAX. */
};

#define AUDIT_NAME_SIZE 32u

/* "coins-1", "plays-festival-6", "hour-13": the key of `id` < AUDIT_COUNT in the store and in what
 * kingyoctl prints. */
void audit_name(uint32_t id, char out[AUDIT_NAME_SIZE]);

/* `id` < AUDIT_COUNT, else it asserts. */
enum audit_group audit_group_of(uint32_t id);

/* Adds what one entry tells. */
void audits_note(struct audits *audits, const struct ledger_entry *entry);

uint64_t audits_hash(uint64_t hash, const struct audits *audits);

#endif
