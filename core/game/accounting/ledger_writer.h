/* ledger_writer.h -- the core's side of the ledger: writes entries, and tracks which of them are on
 * disk.
 *
 * The core keeps the balance of each entry until the store reports the entry as saved. The core can
 * therefore compute the balance that would remain after a power cut in this tick: the field
 * `committed`. Credits gained since then are not playable yet; credits spent since then are spent.
 */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H
#define KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

/* A working card syncs in a tenth of this time; a card that hangs never reports. */
#define LEDGER_WAIT_TICKS_MAX (2u * CORE_TICK_HZ)

struct ledger {
    uint32_t last_id;  /* Id of the newest entry. */
    uint32_t saved_id; /* Id of the newest entry on disk. */
    uint32_t boot;
    uint32_t uncommitted; /* Entries dropped for lack of room; never payments. */
    uint32_t wait_ticks;  /* Ticks for which entries have waited without any of them being saved. */
    uint16_t day, minute;
    uint8_t is_healthy;                /* 1: the store is healthy, from the last input. */
    struct balance balance;            /* Current balance. */
    struct balance committed;          /* Balance on disk. */
    struct balance after[LEDGER_RING]; /* Balance after each unsaved entry; entry n uses index n
                                          % LEDGER_RING. */
};

struct accounts;

/* Initializes `ledger` from the state that the store loaded at startup. */
void ledger_init(struct ledger *ledger, const struct ledger_start *start);

/* Reads the store's state from `input`, before any entry of the tick is written. */
void ledger_tick(struct ledger *ledger, const struct input *input);

/* Returns 1 if the ring has room for an entry of this kind (enum ledger_kind). */
int ledger_has_room(const struct ledger *ledger, uint8_t kind);

/* Returns 1 if an entry of this kind would be written: the ring has room, or the kiosk has no store
 * and overwrites the oldest entry. */
int ledger_may_write(const struct ledger *ledger, uint8_t kind);

/* Writes an entry. Id, boot, tick, day, minute and balance are filled in; the caller supplies the
 * other fields. Statistics and leaderboard are updated at once. Returns the id of the entry, or 0
 * if the ring had no room; such drops are counted. */
uint32_t ledger_write(struct accounts *accounts, uint32_t tick, const struct ledger_entry *what,
                      struct output *output);

/* Returns 1 if the entry is on disk. */
int ledger_is_saved(const struct ledger *ledger, uint32_t id);

/* Returns 1 if every entry is on disk, or if the kiosk has no store. */
int ledger_is_flushed(const struct ledger *ledger);

/* Returns 1 if a payment now will soon be on disk: the store is healthy, responds, and has room. */
int ledger_is_safe(const struct ledger *ledger);

/* Returns 1 if the balance differs from the one on disk and no pending entry contains it. The
 * difference arises when a store appears later, or had no room when the balance changed. */
int ledger_needs_sync(const struct ledger *ledger);

/* Credits that are on disk and not spent; only these can be played. */
struct ledger_credits {
    uint32_t paid, service;
};
struct ledger_credits ledger_committed_credits(const struct ledger *ledger);

uint64_t ledger_balance_hash(uint64_t hash, const struct balance *balance);
uint64_t ledger_start_hash(uint64_t hash, const struct ledger_start *start);
uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger);

#endif
