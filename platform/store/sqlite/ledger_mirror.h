/* ledger_mirror.h -- the ledger mirror: a second copy of the newest ledger entries, in a file
 * beside the database.
 *
 * Without the mirror, entries newer than the last backup would exist only in the database. A
 * damaged first page or a deleted file would lose up to one hour of entries. Therefore each entry
 * is also written to the mirror before it is acknowledged.
 *
 * The file is a ring of slots of 512 bytes, each with a checksum. The file has its full size from
 * the start, so that a sync writes only existing blocks and no file system metadata. A power cut
 * may damage a block and the neighbouring slots in it. The database has the entries of these slots
 * because it is synced first. The mirror is read only if the database has lost entries. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_MIRROR_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_MIRROR_H

#include <stdbool.h>
#include <stdint.h>

#include "core/ledger.h"

/* Number of slots (512 KiB). The next backup is made before half of the slots are used. */
#define LEDGER_MIRROR_SLOTS 1024u
/* Size of a slot in bytes, equal to one disk sector. */
#define LEDGER_MIRROR_SLOT_SIZE 512u

/* Open mirror. The caller owns the structure. Zeros mean that the mirror is closed. */
struct ledger_mirror {
    int handle; /* Descriptor of the file. 0 means closed, because descriptor 0 is standard
                   input. */
};

/* Opens the mirror and creates the file if necessary. Returns 0. On an error returns -1 and sets
 * errno, and the mirror is closed. */
int ledger_mirror_open(struct ledger_mirror *tail, const char *path);

/* Closes the mirror. Has no effect on a closed mirror. */
void ledger_mirror_close(struct ledger_mirror *tail);

/* Opens the mirror for reading. Returns a closed mirror if there is no file. */
struct ledger_mirror ledger_mirror_inspect(const char *path);

/* Writes entries with rising ids. Returns 0 when the entries are on disk, or -1 and sets errno. */
int ledger_mirror_write(struct ledger_mirror *tail, const struct ledger_entry *entries,
                        uint32_t count);

/* Erases the player name of the slot `seat` in the round `round_id`. Returns 0, or -1 and sets
 * errno. The change is on disk only after the next ledger_mirror_write(). */
int ledger_mirror_erase_name(struct ledger_mirror *tail, uint32_t round_id, uint32_t seat);

/* Reads the entry `id`. Returns true if the mirror has the entry with a valid checksum. Returns
 * false if the entry is missing or the mirror is closed. */
bool ledger_mirror_entry(const struct ledger_mirror *tail, uint32_t id, struct ledger_entry *out);

/* Returns the newest id in the mirror, or 0 if the mirror is empty. Reads the whole file. */
uint32_t ledger_mirror_last_id(const struct ledger_mirror *tail);

#endif
