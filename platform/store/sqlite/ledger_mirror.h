/* ledger_mirror.h -- the ledger mirror: a second copy of the newest entries, in a file beside the
 * database.
 *
 * Entries newer than the last backup would exist only in the database. A damaged first page or a
 * deleted file would lose up to an hour of entries. Therefore each entry is also written here
 * before it is acknowledged.
 *
 * The file is a ring of slots of 512 bytes, each with a checksum. It has its full size from the
 * start, so that a sync writes only existing blocks and no file system metadata. A power cut that
 * tears a block may damage neighbouring slots; the database has those entries because it is synced
 * first. The mirror is read only if the database has lost entries. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_MIRROR_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_MIRROR_H

#include <stdbool.h>
#include <stdint.h>

#include "core/ledger.h"

/* 512 KiB; the next backup is made before half of the slots are used. */
#define LEDGER_MIRROR_SLOTS 1024u
#define LEDGER_MIRROR_SLOT_SIZE 512u

/* An open mirror. The caller owns the structure; zero is closed. */
struct ledger_mirror {
    int handle; /* File descriptor; 0: closed, because 0 is standard input. */
};

/* Opens the mirror and creates the file if necessary. Returns 0, or -1 with errno set and the
 * mirror closed. */
int ledger_mirror_open(struct ledger_mirror *tail, const char *path);

/* Closes the mirror. Has no effect on a closed one. */
void ledger_mirror_close(struct ledger_mirror *tail);

/* Opens the mirror for reading. Returns a closed one if there is no file. */
struct ledger_mirror ledger_mirror_inspect(const char *path);

/* Writes entries with rising ids. Returns 0 when they are on disk, or -1 with errno set. */
int ledger_mirror_write(struct ledger_mirror *tail, const struct ledger_entry *entries,
                        uint32_t count);

/* Erases the names of the player in `seat` of that round. Returns 0, or -1 with errno set. The next
 * write makes the change durable. */
int ledger_mirror_erase_name(struct ledger_mirror *tail, uint32_t round_id, uint32_t seat);

/* Returns true if entry `id` is in the mirror with a valid checksum. Returns false if the mirror is
 * closed. */
bool ledger_mirror_entry(const struct ledger_mirror *tail, uint32_t id, struct ledger_entry *out);

/* Returns the newest id in the mirror, or 0 if it is empty. Reads the whole file. */
uint32_t ledger_mirror_last_id(const struct ledger_mirror *tail);

#endif
