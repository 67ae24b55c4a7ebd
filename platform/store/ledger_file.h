/* ledger_file.h -- the SQLite file of all that must outlive a power cut.
 *
 * It holds the ledger's entries (core/ledger.h) as they came, and what they add up to: settings,
 * audits, ranking, rounds. Both are written in one transaction, on disk when the call comes back,
 * so that a power cut leaves the file as it was before or as it is after. The newest entry's purse
 * is the purse. A file of an earlier version is brought up to this one as it is opened, in one
 * transaction too. One thread at a time. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_FILE_H
#define KINGYO_PLATFORM_STORE_LEDGER_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/ledger.h"
#include "core/memory.h"

struct sqlite3;
struct sqlite3_stmt;

/* The file's `user_version`. 1 (written as 0): a row a round. 2: modes, grades, players. 3: the
 * ledger. 4: what a round was played in. 5: the same tables; the column `open` also holds a
 * returned credit and tickets, entries have the kinds 17 to 19, and a PIN is stored as a negative
 * number. A Kingyo that knows version 4 alone would take such rows for damage. */
#define LEDGER_FILE_VERSION 5

/* Entries that are kept, at about 60 bytes: a month of 500 coins and 300 rounds a day. What they
 * add up to, and their rounds, stay. */
#define LEDGER_FILE_ENTRIES 32768u
/* Rounds that are kept, at about 100 bytes: half a year. Those in the ranking are beyond this. */
#define LEDGER_FILE_ROUNDS 65536u

/* All else that is returned here is SQLite's result code, SQLITE_OK (0) for success. */
#define LEDGER_FILE_NEWER (-1) /* A later Kingyo wrote it: it is left as it is. */
#define LEDGER_FILE_ANOTHERS (-2) /* It is whole, but its entries are not this kiosk's. */
#define LEDGER_FILE_HELD (-3) /* Another stall writes in its folder. */
#define LEDGER_FILE_MOVED (-4) /* The file or its folder was removed, renamed or replaced. */
#define LEDGER_FILE_LINK (-5) /* A symbolic link is in the file's place. */

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

/* What the file says, as far as it is on disk. */
struct ledger_content {
    struct memory memory;             /* ledger.boots: of the newest entry, ... */
    uint32_t tick;                    /* ... as this is. */
    uint8_t has_setting[SETTING_COUNT]; /* 0: the operator never turned it. */
    bool has_read;                    /* A file was. */
};

/* The caller owns it; zero is closed. */
struct ledger_file {
    struct sqlite3 *db;
    struct sqlite3_stmt *statement[LEDGER_STATEMENT_COUNT];
    struct ledger_content content;
    bool is_suspect; /* A sync may have failed: the log must be made durable (ledger_log.c) before
                        it is copied into the database. */
    int refusal; /* Why it can only be read: SQLITE_READONLY, or SQLITE_FULL where the card has no
                    room for the index of its log, or what kept a damaged one from being replaced;
                    0: it can be written. */
};

/* How it is opened, where that is not as usual. Both may be null. */
struct ledger_file_how {
    const char *vfs;     /* SQLite's name of a file system. */
    const char *journal; /* "WAL FULL": its journal_mode and synchronous, to measure others by. */
};

/* Opens or makes the file, looks whether it is whole, brings it up to date and reads it. On an
 * error `file` is closed. SQLITE_CORRUPT and SQLITE_NOTADB: it is damaged. `how` may be null. */
int ledger_file_open(struct ledger_file *file, const char *path,
                     const struct ledger_file_how *how);

/* The same for who only looks: changes nothing. An old version is SQLITE_SCHEMA. */
int ledger_file_look(struct ledger_file *file, const char *path);

/* Looks through a whole database: SQLITE_OK, or why it cannot be used. */
int ledger_check(struct sqlite3 *db);

/* An object in a database that Kingyo did not make. The texts are untrusted. */
struct ledger_foreign {
    char type[16];   /* "table", "index", "view" or "trigger". */
    char name[64];   /* Longer names are cut. */
    bool is_changed; /* A table of Kingyo's whose definition was changed. */
};

/* Returns whether the schema holds an object that Kingyo of that version does not make, and fills
 * `out` with the first one. Returns false if the schema cannot be read. */
bool ledger_schema_foreign(struct sqlite3 *db, struct ledger_foreign *out);

/* ledger_log.c: writes the whole log again and syncs it and the folder, so that what is read from
 * the log afterwards is on disk. Returns SQLITE_BUSY while another program holds the write lock.
 * After an error `is_suspect` stays set. */
int ledger_log_secure(struct ledger_file *file);

/* Writes entries, by rising ids; those that the file has already are passed over. All of them or,
 * after an error, none: `content` is then read again, since a failed commit may have come
 * through. */
int ledger_file_write(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count);

/* Reads entry `id` as it was written. SQLITE_NOTFOUND: there is none; SQLITE_CORRUPT: it is not as
 * it was. */
int ledger_file_entry(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* The same for who judges a round by it. Its id is 0 where the ledger has it no more; one that is
 * not as it was written comes back as no round. */
void ledger_file_round(struct ledger_file *file, uint32_t id, struct ledger_entry *out);

/* What a file says goes over what `out` says: a setting that nobody turned is left as it is. */
void ledger_content_remember(const struct ledger_content *content, struct memory *out);

/* Keeps the replay of a round, in place of one before. */
int ledger_file_put_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                           size_t size);

/* Copies a replay and says its size. SQLITE_NOTFOUND: there is none, SQLITE_TOOBIG: it is larger
 * than `size`. */
int ledger_file_get_replay(struct ledger_file *file, uint32_t round_id, void *bytes, size_t size,
                           size_t *size_out);

/* Returns the first round behind `round_id` that has a replay. SQLITE_NOTFOUND: there is none. */
int ledger_file_next_replay(struct ledger_file *file, uint32_t round_id, uint32_t *out);

/* Replaces a replay that holds a PIN with one that does not, in one transaction, and overwrites the
 * old bytes. The next open also writes the file anew, as after every PIN that was hidden. */
int ledger_file_renew_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                             size_t size);

/* Whether there is one; 0, too, where the file cannot be read. */
int ledger_file_has_replay(struct ledger_file *file, uint32_t round_id);

/* Drops replays of rounds that are not in the ranking any more, and entries and rounds beyond their
 * numbers. Does little when there is little to do: call it when nothing else is. */
int ledger_file_prune(struct ledger_file *file);

void ledger_file_close(struct ledger_file *file);

/* In words, for any of the above. */
const char *ledger_file_error(int code);

#endif
