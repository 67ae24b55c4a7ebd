/* ledger_backup.h -- copies the database in steps while entries are still written.
 *
 * The copy is written under a temporary name, validated and then renamed over the previous copy, so
 * that a complete copy exists at every moment. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_BACKUP_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_BACKUP_H

#include "platform/store/sqlite/ledger_file.h"

#define LEDGER_PATH_SIZE 600u
/* Suffix of temporary files, which may be deleted at any start. */
#define LEDGER_PART_SUFFIX ".kingyo-part"

/* Mark in `application_id` of a copy that is intended to be restored. Such a copy may have fewer
 * entries than the kiosk's backup without being treated as a damaged database. */
#define LEDGER_COPY_MARK 0x6b6e6779

struct sqlite3_backup;

/* A backup in progress. The caller owns the structure; zero is idle. */
struct ledger_backup {
    struct sqlite3 *to;
    struct sqlite3_backup *copy;
    char path[LEDGER_PATH_SIZE];
    bool is_marked; /* Set after begin() to mark the copy with LEDGER_COPY_MARK. */
};

/* Starts a copy of an open file to `path`. Returns an SQLite code; after an error the backup is
 * idle. */
int ledger_backup_begin(struct ledger_backup *backup, struct ledger_file *from, const char *path);

/* Copies 256 KiB more. Returns SQLITE_OK if more is left, SQLITE_BUSY to retry later, or
 * SQLITE_DONE when `path` is the new copy, on disk. After any other code the copy is aborted and
 * the file at `path` is unchanged. */
int ledger_backup_step(struct ledger_backup *backup);

/* Aborts the copy and deletes its temporary file. */
void ledger_backup_drop(struct ledger_backup *backup);

/* Makes a complete copy at once. Returns an SQLite code. */
int ledger_backup_make(struct ledger_file *from, const char *path, bool is_marked);

/* Returns true if an open file is a marked copy. ledger_unmark() removes the mark, so that the copy
 * becomes the kiosk's database. */
bool ledger_is_marked(struct ledger_file *file);
int ledger_unmark(struct ledger_file *file);

/* Syncs the folder of this file, which makes a rename, a new name or a deletion durable. Returns 0
 * or -1. */
int ledger_sync_folder(const char *path);

#endif
