/* ledger_backup.h -- a copy of the ledger's file, made piece by piece while the file is written to.
 *
 * A copy grows under a name of its own, is checked, and takes the place of the one before by a
 * rename: there is always a whole one. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_BACKUP_H
#define KINGYO_PLATFORM_STORE_LEDGER_BACKUP_H

#include "platform/store/ledger_file.h"

#define LEDGER_PATH_SIZE 600u
#define LEDGER_PART_SUFFIX ".kingyo-part" /* What ends so is ours to remove. */

/* A copy that is made to be put back says so (its `application_id`): it is meant to have less than
 * the stall's own backup, and is not taken for a file that lost something. */
#define LEDGER_COPY_MARK 0x6b6e6779

struct sqlite3_backup;

/* The caller owns it; zero is idle. */
struct ledger_backup {
    struct sqlite3 *to;
    struct sqlite3_backup *copy;
    char path[LEDGER_PATH_SIZE];
    bool is_marked; /* To be set behind begin(): see LEDGER_COPY_MARK. */
};

/* Begins a copy of an open file to `path`. On an error it is idle. */
int ledger_backup_begin(struct ledger_backup *backup, struct ledger_file *from, const char *path);

/* Copies 256 KiB more. SQLITE_OK: there is more to do; SQLITE_DONE: `path` is the new copy, on
 * disk. Else it is given up, and what was at `path` is still there. BUSY: not now. */
int ledger_backup_step(struct ledger_backup *backup);

/* Gives it up. */
void ledger_backup_drop(struct ledger_backup *backup);

/* All of it at once. */
int ledger_backup_make(struct ledger_file *from, const char *path, bool is_marked);

/* Whether an open file is such a copy; and makes it the stall's own. */
bool ledger_is_marked(struct ledger_file *file);
int ledger_unmark(struct ledger_file *file);

/* Makes a rename, a new name or a removed one in this file's folder durable. 0 or -1. */
int ledger_sync_folder(const char *path);

#endif
