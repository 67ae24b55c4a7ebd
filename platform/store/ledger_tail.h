/* ledger_tail.h -- the newest entries once more, in a file of their own beside the database.
 *
 * Between two backups the database alone would have what was acknowledged since; a damaged first
 * page, or a file that somebody removed, would take an hour along. So each entry is written here as
 * well before the kiosk is told that it is safe: a slot of 512 bytes with a sum of its own, in a
 * ring that has its full size from the start, so that a sync writes blocks that are there and no
 * word of the file system's. A power cut that tears a block may take neighbours along: those the
 * database has, which is synced first. What it says is taken only where the database has lost
 * something. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_TAIL_H
#define KINGYO_PLATFORM_STORE_LEDGER_TAIL_H

#include <stdbool.h>
#include <stdint.h>

#include "core/ledger.h"

#define LEDGER_TAIL_SLOTS 1024u /* 512 KiB: the next backup comes before half of them are taken. */
#define LEDGER_TAIL_SLOT_SIZE 512u

/* The caller owns it; zero is closed. */
struct ledger_tail {
    int handle; /* 0: none: the first three are the program's own streams. */
};

/* Makes the file where there is none. 0 or -1: errno, and it is closed. */
int ledger_tail_open(struct ledger_tail *tail, const char *path);
void ledger_tail_close(struct ledger_tail *tail);

/* For who only reads; closed where there is none. */
struct ledger_tail ledger_tail_look(const char *path);

/* Entries by rising ids; on disk when it comes back with 0. -1: errno. */
int ledger_tail_write(struct ledger_tail *tail, const struct ledger_entry *entries, uint32_t count);

/* Takes the names back that were given to who played in `seat` of that round. 0 or -1: errno; the
 * next write makes it durable. */
int ledger_tail_forget_name(struct ledger_tail *tail, uint32_t round_id, uint32_t seat);

/* Whether entry `id` is there as it was written. False for a closed one. */
bool ledger_tail_entry(const struct ledger_tail *tail, uint32_t id, struct ledger_entry *out);

/* The newest id there; 0: none. Reads all of it. */
uint32_t ledger_tail_last_id(const struct ledger_tail *tail);

#endif
