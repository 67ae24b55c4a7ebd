/* ledger_writer.h -- the core's part of the ledger: writes entries, and tracks which entries are on
 * disk.
 *
 * The core keeps the balance after each entry until the store reports the entry as saved. The core
 * can therefore compute the balance that would remain after a power cut in this tick: the field
 * `committed`. Credits that were added after `committed` cannot be played yet. Credits that were
 * spent after `committed` cannot be played again. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H
#define KINGYO_CORE_GAME_ACCOUNTING_LEDGER_WRITER_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

/* Longest wait for a saved entry while the store counts as responding. A working SD card syncs in a
 * tenth of this time; a card that hangs never reports. */
#define LEDGER_WAIT_TICKS_MAX (2u * CORE_TICK_HZ)

struct ledger {
    uint32_t last_id;  /* Id of the newest entry. */
    uint32_t saved_id; /* Id of the newest entry on disk. */
    uint32_t boot;
    uint32_t uncommitted; /* Number of entries that were dropped because the ledger had no room.
                             Payments are never dropped. */
    uint32_t wait_ticks;  /* Number of ticks for which entries have waited without any of them being
                             saved. */
    uint16_t day, minute;
    uint8_t is_healthy;                /* 1 if the store was healthy according to the last input,
                                          otherwise 0. */
    struct balance balance;            /* Current balance. */
    struct balance committed;          /* Balance after the newest entry on disk. */
    struct balance after[LEDGER_RING]; /* Balance after each entry that is not on disk. Entry n uses
                                          index n % LEDGER_RING. */
};

struct accounts;

/* Initializes `ledger` from the state that the store loaded at startup. */
void ledger_init(struct ledger *ledger, const struct ledger_start *start);

/* Reads the store's state from `input`. Call before any entry of the tick is written. */
void ledger_tick(struct ledger *ledger, const struct input *input);

/* Returns 1 if the ledger's ring buffer has room for an entry of kind `kind` (enum ledger_kind),
 * otherwise 0. */
int ledger_has_room(const struct ledger *ledger, uint8_t kind);

/* Returns 1 if ledger_write() would write an entry of kind `kind`, otherwise 0. An entry is written
 * if the ledger's ring buffer has room. A kiosk without a store overwrites the oldest entry. */
int ledger_may_write(const struct ledger *ledger, uint8_t kind);

/* Writes an entry. The function sets id, boot, tick, day, minute and balance; the caller supplies
 * the other fields in `what`. Audits and leaderboards are updated immediately. Returns the id of
 * the entry. If the ledger's ring buffer has no room, counts the dropped entry and returns 0. */
uint32_t ledger_write(struct accounts *accounts, uint32_t tick, const struct ledger_entry *what,
                      struct output *output);

/* Returns 1 if the entry `id` is on disk, otherwise 0. */
int ledger_is_saved(const struct ledger *ledger, uint32_t id);

/* Returns 1 if every entry is on disk, or if the kiosk has no store; otherwise 0. */
int ledger_is_flushed(const struct ledger *ledger);

/* Returns 1 if a payment in this tick will soon be on disk, because the store is healthy, responds,
 * and has room; otherwise 0. */
int ledger_is_safe(const struct ledger *ledger);

/* Returns 1 if the current balance differs from the balance on disk and no waiting entry contains
 * it. The difference arises when a store becomes available after the start, or had no room when the
 * balance changed. */
int ledger_needs_sync(const struct ledger *ledger);

/* Numbers of credits that are on disk and not spent. Only these credits can be played. */
struct ledger_credits {
    uint32_t paid, service;
};
struct ledger_credits ledger_committed_credits(const struct ledger *ledger);

uint64_t ledger_balance_hash(uint64_t hash, const struct balance *balance);
uint64_t ledger_start_hash(uint64_t hash, const struct ledger_start *start);
uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger);

#endif
