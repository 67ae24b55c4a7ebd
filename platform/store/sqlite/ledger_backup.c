/* ledger_backup.c -- copies the database with SQLite's backup API, validates the copy and renames
 * it. Also copies the database before a part of its data is deleted; see ledger_backup.h. */
#include "platform/store/sqlite/ledger_backup.h"

#include <errno.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"

#define PAGES_A_STEP 64
/* Number of copied pages after which the copy is synced, so that no single sync has to write the
 * whole copy. A slow memory card writes 2 MiB in less than a second. */
#define PAGES_A_SYNC 512
/* Number of SQLite instructions between two calls of `is_cancelled`. They take less than a
 * millisecond. */
#define CANCEL_INSTRUCTIONS 4000

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
    CORE_ASSERT(path[0]);
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

int ledger_mark(sqlite3 *db, bool is_marked)
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

/* Deletes a write-ahead log or journal that lies beside the previous backup. Otherwise SQLite would
 * apply the log to the new backup, which would then be unreadable. Returns an SQLite code. */
static int remove_old_logs(const struct ledger_backup *backup)
{
    static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
    int code = SQLITE_OK;
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++) {
        char name[LEDGER_PATH_SIZE];
        snprintf(name, sizeof name, "%.580s%s", backup->path, suffixes[i]);
        code = unlink(name) == 0 || errno == ENOENT ? code : SQLITE_IOERR;
    }
    return code;
}

/* Syncs the copied pages after every PAGES_A_SYNC pages. Returns an SQLite code. */
static int sync_copied_pages(const struct ledger_backup *backup)
{
    sqlite3_file *to = NULL;
    const int remaining = sqlite3_backup_remaining(backup->copy);
    const int done = sqlite3_backup_pagecount(backup->copy) - remaining;
    if (done % PAGES_A_SYNC >= PAGES_A_STEP) {
        return SQLITE_OK;
    }
    const int code = sqlite3_file_control(backup->to, "main", SQLITE_FCNTL_FILE_POINTER, &to);
    return code == SQLITE_OK && to && to->pMethods ? to->pMethods->xSync(to, SQLITE_SYNC_NORMAL)
                                                   : code;
}

/* Progress handler of SQLite. Returns 1 if the copy must be aborted, otherwise 0. */
static int abort_if_cancelled(void *context)
{
    const struct ledger_backup *backup = context;
    return backup->is_cancelled(backup->context);
}

/* Validates the complete copy like a database, because a damaged copy must not replace the previous
 * backup. Returns an SQLite code. */
static int check_copy(struct ledger_backup *backup)
{
    if (!backup->is_cancelled) {
        return ledger_check(backup->to);
    }
    sqlite3_progress_handler(backup->to, CANCEL_INSTRUCTIONS, abort_if_cancelled, backup);
    const int code = ledger_check(backup->to);
    sqlite3_progress_handler(backup->to, 0, NULL, NULL);
    return backup->is_cancelled(backup->context) ? SQLITE_INTERRUPT : code;
}

int ledger_backup_step(struct ledger_backup *backup)
{
    CORE_ASSERT(backup->copy);
    int code = sqlite3_backup_step(backup->copy, PAGES_A_STEP);
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
        return SQLITE_BUSY;
    }
    code = code == SQLITE_OK ? sync_copied_pages(backup) : code;
    if (code == SQLITE_OK) {
        return SQLITE_OK;
    }
    if (code == SQLITE_DONE) {
        /* Converts the copy to a file that can be read without a write-ahead log. */
        char name[LEDGER_PATH_SIZE];
        name_part(backup, name);
        code = sqlite3_backup_finish(backup->copy);
        backup->copy = NULL;
        code = code == SQLITE_OK ? sql_run(backup->to, "PRAGMA journal_mode = DELETE") : code;
        code = code == SQLITE_OK ? ledger_mark(backup->to, backup->is_marked) : code;
        code = code == SQLITE_OK ? check_copy(backup) : code;
        if (code == SQLITE_OK) {
            sqlite3_close(backup->to);
            backup->to = NULL;
            code = remove_old_logs(backup);
            code = code == SQLITE_OK && file_rename_durable(name, backup->path) == 0 ? SQLITE_DONE
                                                                                     : SQLITE_IOERR;
        }
    }
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

/* ---- Deleting data after panics ----------------------------------------------------------- */

static int ledger_leave_delete_rows(struct ledger_file *file, enum panics_left left)
{
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code == SQLITE_OK) {
        sqlite3_stmt *forget = NULL;
        code =
            sqlite3_prepare_v2(file->db, "DELETE FROM settings WHERE name = ?1", -1, &forget, NULL);
        for (uint32_t id = 0; code == SQLITE_OK && id < SETTING_COUNT; id++) {
            /* The money settings and the PIN are kept, because they do not affect a round. Without
             * a PIN everyone could open the operator's menu, and without money settings the game
             * would be free. */
            if (settings_entry(id)->group != GROUP_MONEY && id != SET_PIN) {
                sqlite3_bind_text(forget, 1, settings_entry(id)->name, -1, SQLITE_STATIC);
                code = sqlite3_step(forget) == SQLITE_DONE ? SQLITE_OK : sqlite3_errcode(file->db);
                sqlite3_reset(forget);
            }
        }
        sqlite3_finalize(forget);
        if (code == SQLITE_OK && left >= LEFT_REPLAYS) {
            code = sql_run(file->db, "DELETE FROM replays");
        }
        if (code == SQLITE_OK && left >= LEFT_NAMES) {
            code = sql_run(file->db,
                           "UPDATE ranking SET name = ''; UPDATE round_players SET name = ''");
        }
        code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
    }
    return ledger_log_result(file, sql_commit(file->db, code));
}

int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS])
{
    CORE_ASSERT(left != LEFT_NOTHING);
    char path[STORAGE_PATH_SIZE];
    struct stat about;
    const int length = snprintf(path, sizeof path, "%s/" STORAGE_FILE, data);
    if (length < 0 || (size_t)length >= sizeof path || lstat(path, &about) != 0) {
        snprintf(words, LEDGER_LEAVE_WORDS, "there is no " STORAGE_FILE " to leave it out of");
        return LEDGER_LEAVE_NONE;
    }
    struct ledger_file file;
    uint32_t number = 0;
    int code = ledger_file_open(&file, path, NULL);
    if (code == SQLITE_OK) {
        char copy[LEDGER_PATH_SIZE];
        do { /* Finds the first unused number for the name of the copy. */
            number++;
            snprintf(copy, sizeof copy, "%.560s" STORAGE_LEFT_SUFFIX "%u", path, number);
        } while (number <= LEDGER_LEFT_MAX && (lstat(copy, &about) == 0 || errno != ENOENT));
        code = file.refusal ? file.refusal : number > LEDGER_LEFT_MAX ? SQLITE_FULL : SQLITE_OK;
        code = code == SQLITE_OK ? ledger_backup_make(&file, copy, true) : code;
        if (code == SQLITE_OK && chmod(copy, 0600) != 0) {
            code = SQLITE_IOERR;
        }
        code = code == SQLITE_OK ? ledger_leave_delete_rows(&file, left) : code;
        ledger_file_close(&file);
    }
    if (code == SQLITE_OK) {
        snprintf(words, LEDGER_LEAVE_WORDS,
                 STORAGE_FILE STORAGE_LEFT_SUFFIX "%u is the database "
                                                  "from before; coins and credits are unchanged",
                 number);
    } else {
        snprintf(words, LEDGER_LEAVE_WORDS,
                 "nothing was changed, because " STORAGE_FILE
                 " could not be copied or written: %.60s",
                 ledger_file_error(code));
    }
    return code == SQLITE_OK ? 0 : -1;
}
