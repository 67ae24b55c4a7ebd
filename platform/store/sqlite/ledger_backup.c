/* ledger_backup.c -- copies the database with SQLite's backup API, validates the copy and renames
 * it; see ledger_backup.h. */
#include "platform/store/sqlite/ledger_backup.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

#define PAGES_A_STEP 64

static void name_part(const struct ledger_backup *backup, char out[LEDGER_PATH_SIZE])
{
    snprintf(out, LEDGER_PATH_SIZE, "%.580s" LEDGER_PART_SUFFIX, backup->path);
}

/* ---- Copying ------------------------------------------------------------------------------- */

void ledger_backup_drop(struct ledger_backup *backup)
{
    char part[LEDGER_PATH_SIZE];
    name_part(backup, part);
    sqlite3_backup_finish(backup->copy);
    sqlite3_close(backup->to);
    if (backup->path[0]) {
        unlink(part);
    }
    *backup = (struct ledger_backup){ 0 };
}

int ledger_backup_begin(struct ledger_backup *backup, struct ledger_file *from, const char *path)
{
    char part[LEDGER_PATH_SIZE], journal[LEDGER_PATH_SIZE];
    *backup = (struct ledger_backup){ 0 };
    snprintf(backup->path, sizeof backup->path, "%s", path);
    name_part(backup, part);
    snprintf(journal, sizeof journal, "%.580s-journal", part);
    unlink(journal);
    unlink(part);
    int code = sql_open(part, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, NULL, &backup->to);
    code = code == SQLITE_OK ? sql_run(backup->to, "PRAGMA cache_size = -256") : code;
    if (code == SQLITE_OK) {
        backup->copy = sqlite3_backup_init(backup->to, "main", from->db, "main");
        code = backup->copy ? SQLITE_OK : sqlite3_errcode(backup->to);
    }
    if (code != SQLITE_OK) {
        ledger_backup_drop(backup);
    }
    return code;
}

static int ledger_backup_set_mark(sqlite3 *db, bool is_marked)
{
    char text[64];
    snprintf(text, sizeof text, "PRAGMA application_id = %d", is_marked ? LEDGER_COPY_MARK : 0);
    return sql_run(db, text);
}

bool ledger_is_marked(struct ledger_file *file)
{
    int64_t id = 0;
    return sql_number(file->db, "PRAGMA application_id", &id) == SQLITE_OK &&
           id == LEDGER_COPY_MARK;
}

int ledger_unmark(struct ledger_file *file)
{
    return ledger_backup_set_mark(file->db, false);
}

/* Completes the copy as a file that can be read without a log. The copy is validated like a
 * database, because a damaged copy must not replace the last backup. Returns SQLITE_DONE or an
 * SQLite error code. */
static int end_copy(struct ledger_backup *backup)
{
    char part[LEDGER_PATH_SIZE];
    name_part(backup, part);
    int code = sqlite3_backup_finish(backup->copy);
    backup->copy = NULL;
    code = code == SQLITE_OK ? sql_run(backup->to, "PRAGMA journal_mode = DELETE") : code;
    code = code == SQLITE_OK ? ledger_backup_set_mark(backup->to, backup->is_marked) : code;
    code = code == SQLITE_OK ? ledger_check(backup->to) : code;
    if (code == SQLITE_OK) {
        sqlite3_close(backup->to);
        backup->to = NULL;
        code = file_rename_durable(part, backup->path) == 0 ? SQLITE_DONE : SQLITE_IOERR;
    }
    return code;
}

int ledger_backup_step(struct ledger_backup *backup)
{
    int code = sqlite3_backup_step(backup->copy, PAGES_A_STEP);
    if (code == SQLITE_OK || code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        return code == SQLITE_OK ? SQLITE_OK : SQLITE_BUSY;
    }
    code = code == SQLITE_DONE ? end_copy(backup) : code;
    ledger_backup_drop(backup);
    return code;
}

int ledger_backup_make(struct ledger_file *from, const char *path, bool is_marked)
{
    struct ledger_backup backup;
    int code = ledger_backup_begin(&backup, from, path);
    backup.is_marked = is_marked;
    while (code == SQLITE_OK) {
        code = ledger_backup_step(&backup);
    }
    if (code == SQLITE_BUSY) {
        ledger_backup_drop(&backup);
    }
    return code == SQLITE_DONE ? SQLITE_OK : code;
}
