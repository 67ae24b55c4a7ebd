/* accounts.h -- the state of the kiosk's accounts: the ledger, the credits, the audits and the
 * leaderboards.
 *
 * The ledger is the append-only list of money events. ledger_write() also adds each entry to the
 * audits, which are the operator's statistics, and to the leaderboards. A function that writes an
 * entry therefore takes `struct accounts`. A function that works on one account takes only that
 * account. The functions are in ledger_writer.h, credit.h, audits.h and ranking.h. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_ACCOUNTS_H
#define KINGYO_CORE_GAME_ACCOUNTING_ACCOUNTS_H

#include <stdint.h>

#include "core/game/accounting/audits.h"
#include "core/game/ranking/ranking.h"
#include "core/input.h"
#include "core/ledger.h"

/* Longest time for which the core waits for an entry to reach the disk. After this time the store
 * counts as not responding. A working SD card needs a tenth of this time; a broken card never
 * responds. */
#define LEDGER_WAIT_TICKS_MAX (2u * CORE_TICK_HZ)

struct ledger {
    uint32_t last_id;  /* Id of the newest entry. */
    uint32_t saved_id; /* Id of the newest entry on disk. */
    uint32_t boot;
    uint32_t uncommitted; /* Number of entries that were dropped because the ledger had no room.
                             Payments are never dropped. */
    uint32_t wait_ticks;  /* Number of ticks for which entries have waited for the disk since the
                             last entry was saved. */
    uint16_t day, minute;
    uint8_t is_healthy;                /* 1 if the store was healthy according to the last input,
                                          otherwise 0. */
    struct balance balance;            /* Current balance. */
    struct balance committed;          /* Balance after the newest entry on disk. */
    struct balance after[LEDGER_RING]; /* Balance after each entry that is not on disk. Entry n uses
                                          index n % LEDGER_RING. */
};

/* Highest price of a round in coin units. A more expensive round would be paid with banknotes. */
#define CREDIT_COINS_MAX 20u
/* Highest setting for the number of fish per prize ticket. Most players catch fewer fish. */
#define CREDIT_TICKET_FISH_MAX 20u
/* Time for which the coin slot stays closed after a tilt. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ)
/* Time for which a START press waits until the paid credit is on disk. */
#define CREDIT_AWAIT_TICKS (3u * CORE_TICK_HZ)

/* Bit flags of conditions that close the coin slot and are displayed as warnings. */
enum credit_warning {
    WARN_TILT = 1u << 0,   /* The cabinet was shaken or tilted. The balance does not change. Coins
                              are returned, because shaking can trigger the coin mechanism. */
    WARN_DOOR = 1u << 1,   /* The door is open. A running round continues. */
    WARN_NO_POI = 1u << 2, /* No slot has a controller, so a player who pays could not play. */
    WARN_STORE = 1u << 3,  /* The store is not safe, so a payment could be lost in a power cut. */
};

/* Coins that no ledger entry contains yet. */
struct pending_coins {
    uint32_t pulses;
    uint32_t units; /* Value of the pulses in units. */
    uint32_t owed;  /* Units of the pending coins that must be added to the balance. Coins inserted
                       during free play add nothing to `owed`. */
};

struct credit {
    uint8_t came_back; /* 1 if the credit of the last round was refunded, otherwise 0. */
    uint8_t warnings;  /* Current warnings (bit mask of enum credit_warning). */
    struct pending_coins pending_coins[COIN_LINE_COUNT];
    uint32_t metered;    /* Number of coins counted since the kiosk started. */
    uint32_t shakes;     /* Number of tilt events since the kiosk started. */
    uint32_t tickets;    /* Number of pulses requested from the ticket dispenser since the kiosk
                            started. */
    uint32_t coin_tick;  /* Tick of the last coin. */
    uint32_t tilt_tick;  /* Tick of the last tilt; 0 means never. */
    uint32_t asked_tick; /* Tick of the last start attempt without a credit; 0 means never. */
    uint32_t await_tick; /* Tick of the last start attempt whose credit was not on disk yet; 0 means
                            never. */
    uint32_t act_tick;   /* Tick of the last action of a person that changed the balance. */
    uint32_t stand_id;   /* Id of the newest LEDGER_STAND entry (state of an open round); 0 means
                            none. */
    struct ledger_stand stand; /* Fields of the newest LEDGER_STAND entry (state of an open
                                  round). */
    uint32_t ticket_id; /* Id of the LEDGER_TICKET that must reach the disk before its pulse starts;
                           0 means none. */
};

struct accounts {
    struct ledger ledger;
    struct credit credit;
    struct audits audits;
    struct ranking ranking;
};

#endif
