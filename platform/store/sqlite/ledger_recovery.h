/* ledger_recovery.h -- accesses the ledger mirror, and recovers entries that are newer than the
 * backup. The entries are recovered from a damaged database and from the mirror. */
#pragma once

#include "platform/store/sqlite/ledger_file.h"

/* ---- Ledger mirror ------------------------------------------------------------------------- */

/* The ledger mirror is a second copy of the newest ledger entries, in a file in the folder of
 * the database. Without the mirror, entries newer than the last backup would exist only in the
 * database. A damaged first page or a deleted database would lose up to one hour of entries.
 * Therefore each entry is also written to the mirror before it is acknowledged. The file is a
 * ring buffer of slots of 512 bytes, each with a checksum. The file has its full size from the
 * start, so that a sync writes only existing blocks and no file system metadata. A power cut may
 * damage a disk block and all slots in the block. The database has the entries of these slots
 * because the database is synced before the mirror. The mirror is read only if the database has
 * lost entries. */

/* Number of slots (512 KiB). The next backup is made before half of the slots are used. */
#define LEDGER_MIRROR_SLOTS 1024u
/* Size of a slot in bytes, equal to one disk sector. */
#define LEDGER_MIRROR_SLOT_SIZE 512u

/* Open ledger mirror. The caller owns the structure. A structure of zeros means that the mirror is
 * closed. */
struct ledger_mirror {
    /* Descriptor of the file. 0 means closed, because descriptor 0 is standard input. */
    int handle;
};

/* Opens the mirror and creates the file if necessary. Returns 0. On an error returns -1 and sets
 * errno, and the mirror is closed. */
int ledger_mirror_open(struct ledger_mirror *tail, const char *path);

/* Closes the mirror. Has no effect on a closed mirror. */
void ledger_mirror_close(struct ledger_mirror *tail);

/* Opens the mirror for reading. Returns the open mirror, or a closed mirror if the file does not
 * exist. */
struct ledger_mirror ledger_mirror_inspect(const char *path);

/* Writes entries to the mirror. The ids of the entries must rise. Returns 0 when the entries are on
 * disk. On an error sets errno and returns -1. */
int ledger_mirror_write(struct ledger_mirror *tail, const struct ledger_entry *entries,
                        uint32_t count);

/* Erases the name of the player in slot `player` of the round `round_id`. Returns 0. On an error
 * sets errno and returns -1. The change is on disk only after the next ledger_mirror_write(). */
int ledger_mirror_erase_name(struct ledger_mirror *tail, uint32_t round_id, uint32_t player);

/* Reads the entry `id`. Returns true if the mirror has the entry with a valid checksum. Returns
 * false if the entry is missing or the mirror is closed. */
bool ledger_mirror_entry(const struct ledger_mirror *tail, uint32_t id, struct ledger_entry *out);

/* Returns the newest id in the mirror, or 0 if the mirror is empty. Reads the whole file. */
uint32_t ledger_mirror_last_id(const struct ledger_mirror *tail);

/* ---- Recovery ------------------------------------------------------------------------------ */

/* Relation of two ledgers, determined from their newest common entry. */
enum ledger_relation {
    LEDGER_RELATION_UNKNOWN = 0, /* The ledgers have no common entry. */
    LEDGER_RELATION_SAME,
    /* The ledgers differ: one ledger belongs to another kiosk or was started again from its first
     * entry. */
    LEDGER_RELATION_OTHER,
};

/* Compares the entry `last_id` of `file` and earlier entries with the mirror `tail`, or with the
 * file `other`. Exactly one of `tail` and `other` is null. At most LEDGER_MIRROR_SLOTS entries are
 * compared. The newest common entry determines the result. */
enum ledger_relation ledger_recovery_relation(struct ledger_file *file, uint32_t last_id,
                                              const struct ledger_mirror *tail,
                                              struct ledger_file *other);

struct ledger_recovered {
    uint32_t entries; /* Number of recovered entries. */
    /* Number of lost entries. An entry is lost if its id is above the last id of `to` and at most
     * the newest known id, and if the entry was not recovered. */
    uint32_t lost;
    /* True if the newest id is unknown. The number of lost entries may then be greater than
     * `lost`. */
    bool is_open_ended;
    /* True if the ledger mirror was not used, because it belongs to a foreign ledger. */
    bool has_others_tail;
};

/* Copies all valid entries that are newer than the entries of `to` into `to`. Each entry is read
 * from the file `path`, which may be damaged at any position, or else from the mirror `tail`.
 * `path` is null if the file is missing or empty, because SQLite would delete the log of an empty
 * file. Missing entries are skipped, and the newest valid entry sets the balance. If to->refusal is
 * not 0, only to->content is updated. Returns an SQLite code. An error means that writing failed
 * and `to` is incomplete. */
int ledger_recover(const char *path, const struct ledger_mirror *tail, struct ledger_file *to,
                   struct ledger_recovered *out);
