/* ledger_file.h -- the SQLite database of all data that must survive a power cut.
 *
 * The database holds the entries of the ledger (core/ledger.h) and their aggregates: settings,
 * audits, ranking, rounds. Both are written in one transaction, which is on disk when the call
 * returns. A power cut therefore leaves the file either before or after the transaction. The
 * balance is that of the newest entry. A file of an older version is migrated when it is opened,
 * also in one transaction. Only one thread at a time may use a file. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_FILE_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/ledger.h"
#include "core/persistent_state.h"

struct sqlite3;
struct sqlite3_stmt;

/* Schema version in `user_version`. 1 (stored as 0): one row a round. 2: modes, grades, players. 3:
 * the ledger. 4: the tank of each round. 5: the same tables, but the column `open` also holds a
 * returned credit and tickets, entries have the kinds 17 to 19, and a PIN is stored as a negative
 * number. A program that supports only version 4 would report such rows as damage. */
#define LEDGER_FILE_VERSION 5

/* Entries that are kept, at about 60 bytes each: a month with 500 coins and 300 rounds a day. The
 * aggregates of older entries, and their rounds, are kept. */
#define LEDGER_FILE_ENTRIES 32768u
/* Rounds that are kept, at about 100 bytes each: half a year. Ranked rounds are kept in
 * addition. */
#define LEDGER_FILE_ROUNDS 65536u

/* Error codes of this module; all other codes are SQLite result codes, with SQLITE_OK (0) for
 * success. */
#define LEDGER_FILE_NEWER (-1)   /* Written by a newer version; the file stays unchanged. */
#define LEDGER_FILE_FOREIGN (-2) /* Valid, but with the entries of a foreign kiosk. */
#define LEDGER_FILE_LOCKED (-3)  /* Another process holds the lock of the folder. */
#define LEDGER_FILE_MOVED (-4)   /* The file or its folder was removed, renamed or replaced. */
#define LEDGER_FILE_LINK (-5)    /* The file's path is a symbolic link. */

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

/* Content of the file, as far as it is on disk. */
struct ledger_content {
    struct persistent_state memory;     /* Persistent state; ledger.boots is that of the newest
                                           entry. */
    uint32_t tick;                      /* Tick of the newest entry. */
    uint8_t has_setting[SETTING_COUNT]; /* 0: the operator never changed the setting. */
    bool has_read;                      /* 1: a file was read. */
};

/* An open database. The caller owns the structure; zero is closed. */
struct ledger_file {
    struct sqlite3 *db;
    struct sqlite3_stmt *statement[LEDGER_STATEMENT_COUNT];
    struct ledger_content content;
    bool is_suspect; /* 1: a sync may have failed. The log must be made durable (ledger_log.c)
                        before it is copied into the database. */
    int refusal; /* Reason why the file is read-only; 0: the file can be written. SQLITE_READONLY,
                    SQLITE_FULL if the card has no space for the index of the log, or the reason why
                    a damaged file could not be replaced. */
};

/* Options for opening a file in a non-default way. Both may be null. */
struct ledger_file_options {
    const char *vfs;     /* SQLite's name of a file system layer. */
    const char *journal; /* "WAL FULL": journal_mode and synchronous, to benchmark other modes. */
};

/* Opens or creates the file, validates, migrates and reads it. On an error `file` is closed.
 * Returns SQLITE_CORRUPT or SQLITE_NOTADB if the file is damaged. `how` may be null. */
int ledger_file_open(struct ledger_file *file, const char *path,
                     const struct ledger_file_options *how);

/* Opens an existing file for reading and changes nothing. Returns SQLITE_SCHEMA for an old
 * version. */
int ledger_file_inspect(struct ledger_file *file, const char *path);

/* Validates a whole database. Returns SQLITE_OK, or the reason why the database cannot be used. */
int ledger_check(struct sqlite3 *db);

/* Object in a database that Kingyo did not create. The texts are untrusted. */
struct ledger_foreign {
    char type[16];   /* "table", "index", "view" or "trigger". */
    char name[64];   /* Longer names are cut. */
    bool is_changed; /* A table of Kingyo whose definition was changed. */
};

/* Returns true if the schema contains an object that Kingyo does not create in that version, and
 * writes the first such object to `out`. Returns false if the schema cannot be read. */
bool ledger_schema_foreign(struct sqlite3 *db, struct ledger_foreign *out);

/* ledger_log.c: writes the whole log again and syncs the log and the folder, so that data read from
 * the log afterwards is on disk. Returns SQLITE_BUSY while another program holds the write lock.
 * After an error `is_suspect` stays set. */
int ledger_log_secure(struct ledger_file *file);

/* Writes entries with rising ids; entries that the file already contains are skipped. Writes all of
 * them or, after an error, none. After an error `content` is read again, because a failed commit
 * may have succeeded. */
int ledger_file_write(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count);

/* Reads entry `id`. Returns SQLITE_NOTFOUND if there is no such entry, or SQLITE_CORRUPT if its
 * checksum is wrong. */
int ledger_file_entry(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* Reads the entry of a round for the replay verifier. The id of `out` is 0 if the ledger no longer
 * has the entry. An entry with a wrong checksum is returned as an entry that is no round. */
void ledger_file_round(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* Copies the content to `out`. A setting that the operator never changed keeps its value in
 * `out`. */
void ledger_content_load(const struct ledger_content *content, struct persistent_state *out);

/* Stores the replay of a round, in place of an earlier one. */
int ledger_file_put_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                           size_t size);

/* Copies a replay and sets its size. Returns SQLITE_NOTFOUND if there is none, or SQLITE_TOOBIG if
 * it is larger than `size`. */
int ledger_file_get_replay(struct ledger_file *file, uint32_t round_id, void *bytes, size_t size,
                           size_t *size_out);

/* Finds the first round after `round_id` that has a replay. Returns SQLITE_NOTFOUND if there is
 * none. */
int ledger_file_next_replay(struct ledger_file *file, uint32_t round_id, uint32_t *out);

/* Replaces a replay that contains a PIN by one without, in one transaction, and overwrites the old
 * bytes. The next open also rewrites the file, as after every PIN that was hidden. */
int ledger_file_renew_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                             size_t size);

/* Returns 1 if the round has a replay; 0 also if the file cannot be read. */
int ledger_file_has_replay(struct ledger_file *file, uint32_t round_id);

/* Deletes replays of rounds that are no longer ranked, and entries and rounds beyond their limits.
 * Returns quickly if there is little to delete. Call when no other work is pending. */
int ledger_file_prune(struct ledger_file *file);

/* Closes the file and its statements. Has no effect on a closed file. */
void ledger_file_close(struct ledger_file *file);

/* Returns the text for any code of this module. */
const char *ledger_file_error(int code);

#endif
