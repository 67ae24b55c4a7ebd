/* ledger_backup.h -- copies the database in steps, while the store continues to write entries.
 *
 * The copy is written under a temporary name and validated. Then the copy is renamed and replaces
 * the previous copy. A complete copy therefore exists at every moment. */
#pragma once

#include "platform/panics.h"
#include "platform/store/sqlite/ledger_file.h"

/* Name of the database in its folder. */
#define STORAGE_FILE "kingyo.db"
/* Suffix of the copy of the database that ledger_leave_out() makes before it deletes data. A number
 * follows the suffix. */
#define STORAGE_LEFT_SUFFIX ".left-out-"
/* Size in bytes of the database's path. */
#define STORAGE_PATH_SIZE 512u
/* Size in bytes of the path of a file that belongs to the database. */
#define LEDGER_PATH_SIZE 600u
/* Suffix of temporary files. A temporary file may be deleted at any program start. */
#define LEDGER_PART_SUFFIX ".kingyo-part"

/* Value of `application_id` that marks a copy that the operator may restore. A marked copy may have
 * fewer entries than the kiosk's automatic backup. Because of the mark, the kiosk does not treat
 * the missing entries as damage. */
#define LEDGER_COPY_MARK 0x6b6e6779

struct sqlite3_backup;

/* State of a backup in progress. The caller owns the structure. A structure of zeros means that no
 * backup is in progress. */
struct ledger_backup {
    struct sqlite3 *to;
    struct sqlite3_backup *copy;
    char path[LEDGER_PATH_SIZE];
    /* True if the copy gets the mark LEDGER_COPY_MARK. Set after ledger_backup_begin(). */
    bool is_marked;
    /* Returns true if the copy must be aborted. Called repeatedly while a complete copy is
     * validated, which takes seconds for a large database. Null means that the copy is never
     * aborted. Set with `context` after ledger_backup_begin(). */
    bool (*is_cancelled)(void *context);
    void *context; /* Argument of `is_cancelled`. */
};

/* Starts a copy of the open database `from` to `path`. Returns an SQLite code. After an error no
 * backup is in progress. */
int ledger_backup_begin(struct ledger_backup *backup, struct ledger_file *from, const char *path);

/* Copies the next 256 KiB of the database. Returns SQLITE_OK if a part of the database remains to
 * be copied. Returns SQLITE_BUSY if the caller must retry later. Returns SQLITE_DONE if the
 * complete copy is on disk at its path. After any other code the copy is aborted and the file at
 * the path is unchanged. The code is SQLITE_INTERRUPT if `is_cancelled` returned true. */
int ledger_backup_step(struct ledger_backup *backup);

/* Aborts the copy and deletes its temporary file. */
void ledger_backup_drop(struct ledger_backup *backup);

/* Copies the open database `from` to the file `path`, validates the copy and syncs it, in one call.
 * If `is_marked` is true, the copy gets the mark LEDGER_COPY_MARK. Returns an SQLite code. */
int ledger_backup_make(struct ledger_file *from, const char *path, bool is_marked);

/* ledger_is_marked() returns true if the open database is a marked copy. ledger_mark() sets the
 * mark, or removes it if `is_marked` is false, because a restored copy becomes the kiosk's
 * database. Returns an SQLite code. */
bool ledger_is_marked(struct ledger_file *file);
int ledger_mark(struct sqlite3 *db, bool is_marked);

/* ---- Deleting data after panics ----------------------------------------------------------- */

/* Deletes a part of the stored data after panics, because the data may have caused the panics.
 *
 * Before the deletion, the whole database is copied to kingyo.db.left-out-N in the same folder.
 * `kingyoctl backup --restore` can restore the copy. Coins, credits, entries, audits and scores
 * are never deleted. The PIN and the money settings are never deleted either. */

/* Maximum number N in the name of a copy. If all numbers are in use, no copy can be made. In this
 * case no further data are deleted. */
#define LEDGER_LEFT_MAX 99u
/* Size in bytes of the buffer for the result text of ledger_leave_out(). */
#define LEDGER_LEAVE_WORDS 160u
/* Value that ledger_leave_out() returns if the folder has no database. */
#define LEDGER_LEAVE_NONE 1

/* Opens the database kingyo.db in the folder `data`, copies it, and deletes the parts of the data
 * that `left` selects. The caller must have locked the folder (file_lock_folder()). Writes a text
 * about the result to `words`. Returns 0 on success, or LEDGER_LEAVE_NONE if there is no database.
 * Returns -1 and changes nothing if the database cannot be copied or written. */
int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS]);
