/* ledger_file.h -- the SQLite database of all data that must survive a power cut. The database
 * contains the entries of the ledger (core/ledger.h) and their aggregates: settings, audits,
 * ranking, rounds. The ledger is the append-only list of money events and rounds. Entries and
 * aggregates are written in one transaction, which is on disk when the function returns. After a
 * power cut the file therefore contains either the whole transaction or no part of it. The current
 * balance is the balance of the newest entry. A file of an older version is migrated in one
 * transaction when it is opened. Only one thread at a time may use a file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/ledger.h"
#include "core/persistent_state.h"

struct sqlite3;
struct sqlite3_stmt;

/* Schema version in `user_version`. Version 1 (stored as 0) has one row per round. Version 2 added
 * modes, grades and players. Version 3 added the ledger. Version 4 added the tank of each round.
 * Version 5 has the same tables with additional values. In version 5 the column `open` also
 * contains a returned credit and tickets, entries have the kinds 17 to 19, and a PIN is a negative
 * number. A program that supports only version 4 would report such rows as damage. Version 6 added
 * the level of each round and of each leaderboard. */
#define LEDGER_FILE_VERSION 6

/* Maximum number of stored entries, about 60 bytes each. The number is enough for a month with 500
 * coins and 300 rounds per day. When older entries are deleted, their effect on the settings,
 * audits and ranking remains, and their rounds remain too. */
#define LEDGER_FILE_ENTRIES 32768u
/* Maximum number of stored rounds, about 100 bytes each. The number is enough for half a year.
 * Ranked rounds are stored in addition. */
#define LEDGER_FILE_ROUNDS 65536u

/* Error codes of this module. All other codes are SQLite result codes; SQLITE_OK (0) means
 * success. */
#define LEDGER_FILE_NEWER (-1) /* A newer version wrote the file. The file stays unchanged. */
/* The file is valid but contains entries of a different kiosk. */
#define LEDGER_FILE_FOREIGN (-2)
#define LEDGER_FILE_LOCKED (-3) /* Another process holds the lock of the folder. */
#define LEDGER_FILE_MOVED (-4)  /* The file or its folder was removed, renamed or replaced. */
#define LEDGER_FILE_LINK (-5)   /* The path of the file is a symbolic link. */

/* Number of rows of all leaderboards. */
#define LEDGER_RANKS (RANK_BOARD_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

enum ledger_statement {
    PUT_ENTRY = 0,
    PUT_ROUND,
    PUT_PLAYER,
    PUT_NAME,
    FORGET_NAME,
    PUT_SETTING,
    FORGET_SETTINGS,
    PUT_AUDIT,
    PUT_RANK,
    PUT_STATE,
    PUT_REPLAY,
    GET_REPLAY,
    HAS_REPLAY,
    LEDGER_STATEMENT_COUNT,
};

/* Content of the database on disk, without the list of entries and the replays. */
struct ledger_content {
    /* Persistent state of the core. ledger.boots is the boot number of the newest entry. */
    struct persistent_state memory;
    uint32_t tick; /* Tick of the newest entry. */
    /* 1 if the operator has changed the setting, otherwise 0. */
    uint8_t has_setting[SETTING_COUNT];
    bool has_read; /* True if the content was read from a database. */
};

/* Open database. The caller owns the structure. A structure of zeros means that no database is
 * open. */
struct ledger_file {
    struct sqlite3 *db;
    struct sqlite3_stmt *statement[LEDGER_STATEMENT_COUNT];
    struct ledger_content content;
    /* True if a sync of the write-ahead log may have failed. The log must then be written again
     * (ledger_log_secure()) before SQLite copies the log into the database. */
    bool is_suspect;
    /* Reason why the file is read-only. 0 means that the file can be written. SQLITE_FULL means
     * that the memory card has no space for the index of the write-ahead log. Other values are
     * SQLITE_READONLY, or the reason why a damaged file could not be replaced. */
    int refusal;
};

/* Options for opening a file. Each field may be null, which means the default. */
struct ledger_file_options {
    const char *vfs; /* SQLite's name of a file system layer (vfs). */
    /* Values of the pragmas journal_mode and synchronous, for example "WAL FULL". Benchmarks use
     * the field to measure other modes. */
    const char *journal;
};

/* Opens or creates the file `path`, then validates, migrates and reads it. `how` may be null.
 * Returns an SQLite code or an error code of this module; SQLITE_CORRUPT or SQLITE_NOTADB means
 * that the file is damaged. After an error `file` is closed. */
int ledger_file_open(struct ledger_file *file, const char *path,
                     const struct ledger_file_options *how);

/* Opens an existing file for reading only. The file is not migrated or changed. Returns an SQLite
 * code or an error code of this module. SQLITE_SCHEMA means that an old version of Kingyo wrote the
 * file, or that the file has no tables yet, and that ledger_check() found no damage. */
int ledger_file_inspect(struct ledger_file *file, const char *path);

/* Validates a whole database. Returns SQLITE_OK, or the reason why the database cannot be used. */
int ledger_check(struct sqlite3 *db);

/* Schema object (table, index, view or trigger) that Kingyo did not create. `type` and `name` come
 * from the file and are not trusted. */
struct ledger_foreign {
    char type[16];   /* Type of the object: "table", "index", "view" or "trigger". */
    char name[64];   /* Name of the object. Longer names are cut. */
    bool is_changed; /* True if the object is one of Kingyo's tables with a changed definition. */
};

/* Searches the schema for an object that Kingyo does not create in the file's version. If there is
 * an object, writes the first one to `out` and returns true. Returns false if there is no object,
 * or if the schema cannot be read. */
bool ledger_schema_foreign(struct sqlite3 *db, struct ledger_foreign *out);

/* Returns the end of a message "holds the TYPE 'NAME', .." about a foreign schema object. */
const char *ledger_foreign_reason(const struct ledger_foreign *foreign);

/* Writes the whole write-ahead log again, and syncs the log and its folder. All data that are read
 * from the log afterwards are on disk. Returns SQLITE_BUSY while another program holds the write
 * lock. After an error `is_suspect` stays true. Defined in ledger_file.c. */
int ledger_log_secure(struct ledger_file *file);

/* Writes entries in one transaction. The ids of the entries must rise. Entries that the file
 * already contains are skipped. Returns SQLITE_OK if all entries are written. After a failed
 * transaction, `content` is read again, because SQLite may have written all entries although it
 * reported an error. */
int ledger_file_write(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count);

/* Reads the entry `id`. Returns SQLITE_NOTFOUND if there is no such entry, or SQLITE_CORRUPT if its
 * checksum is wrong. */
int ledger_file_entry(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* Reads the ledger entry `id`, which describes a round, for the replay verifier. If the ledger no
 * longer has the entry, sets all fields of `out` to 0. If the entry cannot be read, for example
 * because its checksum is wrong, sets `out->id` to `id` and all other fields to 0. */
void ledger_file_round(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* Copies the content to `out`. For a setting that the operator has never changed, the value in
 * `out` stays unchanged. */
void ledger_content_load(const struct ledger_content *content, struct persistent_state *out);

/* Stores the replay of a round and replaces an earlier replay of the round. Returns an SQLite
 * code. */
int ledger_file_put_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                           size_t size);

/* Copies the replay of a round to `bytes` and sets `*size_out` to the size of the replay. If the
 * replay is larger than `size`, copies the first `size` bytes and returns SQLITE_TOOBIG. Returns
 * SQLITE_NOTFOUND if there is no replay. */
int ledger_file_get_replay(struct ledger_file *file, uint32_t round_id, void *bytes, size_t size,
                           size_t *size_out);

/* Finds the first round after `round_id` that has a replay, and writes its id to `out`. Returns
 * SQLITE_NOTFOUND if no later round has a replay. */
int ledger_file_next_replay(struct ledger_file *file, uint32_t round_id, uint32_t *out);

/* Replaces a replay that may contain a PIN by a replay without the PIN, in one transaction, and
 * overwrites the old bytes. If `bytes` is null, deletes the replay instead. The next open also
 * rewrites the whole file, to remove old bytes of the PIN. Returns an SQLite code. */
int ledger_file_renew_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                             size_t size);

/* Returns true if the round has a replay. Returns false if the round has no replay or the file
 * cannot be read. */
bool ledger_file_has_replay(struct ledger_file *file, uint32_t round_id);

/* Deletes the replays of rounds that are no longer ranked. Also deletes the oldest entries and
 * rounds if there are more than the maximum number. Returns quickly if there is little to delete.
 * Call when no other work is pending. Returns an SQLite code. */
int ledger_file_prune(struct ledger_file *file);

/* Closes the file and its statements. Has no effect on a closed file. */
void ledger_file_close(struct ledger_file *file);

/* Returns the text for an SQLite code or an error code of this module. */
const char *ledger_file_error(int code);

/* ---- Functions that only the source files of the database call ----------------------------- */

/* Size in bytes of the name of a setting, an audit or a state. All names that Kingyo writes fit
 * into this size. */
#define LEDGER_ROW_NAME_SIZE 64u

/* The database column `open` contains three fields of the balance: `open` in the low 8 bits,
 * `returned` shifted left by LEDGER_RETURNED_SHIFT, and `tickets` shifted left by
 * LEDGER_TICKETS_SHIFT. Older files have 0 in the upper two fields, so their rows and checksums
 * remain valid. */
#define LEDGER_RETURNED_SHIFT 8u
#define LEDGER_TICKETS_SHIFT 16u

/* Writes a prepared statement to `out`. The statement is prepared at its first use, because its
 * tables may not exist earlier. Returns an SQLite code. Defined in ledger_write.c. */
int ledger_statement(struct ledger_file *file, enum ledger_statement which,
                     struct sqlite3_stmt **out);

/* Prevents SQLite from copying the write-ahead log into the database until ledger_log_secure()
 * succeeds. Defined in ledger_file.c. */
void ledger_log_invalidate(struct ledger_file *file);
/* Returns the result of a write whose SQLite code is `code`. If `code` is SQLITE_OK but the
 * checkpoint after the commit failed, the result is SQLITE_IOERR, otherwise `code`. */
int ledger_log_result(const struct ledger_file *file, int code);

/* Migrates the file from `version` to LEDGER_FILE_VERSION, inside the caller's transaction. Returns
 * an SQLite code. Defined in ledger_schema.c. */
int ledger_schema_raise(struct ledger_file *file, int version);

/* Compares the text of the whole schema with the tables of the file version `user_version`. Returns
 * SQLITE_CORRUPT if a table differs or is missing, or if the file has any other schema object, such
 * as a trigger. */
int ledger_schema_check(struct sqlite3 *db, int64_t user_version);

/* Writes one entry without its aggregates. Returns an SQLite code. Defined in ledger_write.c. */
int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry);

/* Returns the checksum of an entry. The checksum does not cover the name in the entry, because the
 * name may be revoked later. The checksum is needed because SQLite detects an incompletely written
 * page but not a flipped bit. */
int64_t ledger_entry_sum(const struct ledger_entry *entry);

/* Marks the file, inside the caller's transaction, as possibly containing old bytes of a PIN. The
 * next open then rewrites the file. The caller must afterwards call ledger_checksum_put() in the
 * same transaction. Defined in ledger_open.c. */
int ledger_pin_mark(struct ledger_file *file);

/* Updates the aggregates in `content` from one entry. Defined in ledger_write.c. */
void ledger_aggregates_note(struct ledger_content *content, const struct ledger_entry *entry);
/* Writes the aggregates that differ between `before` and `after` to the database. Returns an SQLite
 * code. */
int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after);
/* Reads the aggregates (settings, audits, ranking). Returns SQLITE_CORRUPT if the rows contain
 * values that core_init() would reject. Defined in ledger_read.c. */
int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out);

/* First file version in which the tables have checksums. */
#define LEDGER_CHECKSUM_VERSION 4

/* Writes the table checksums. Call inside the caller's transaction, after its other changes.
 * Returns an SQLite code. Defined in ledger_read.c. */
int ledger_checksum_put(struct sqlite3 *db);
/* Verifies the table checksums. Returns SQLITE_CORRUPT if settings, audits or ranking differ from
 * the written values. */
int ledger_checksum_check(struct sqlite3 *db);
