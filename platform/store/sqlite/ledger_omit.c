/* ledger_omit.c -- copies the database, and then deletes data from the original in one transaction;
 * see ledger_omit.h. */
#include "platform/store/sqlite/ledger_omit.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/storage.h"

/* Returns 1 if the setting may be deleted, otherwise 0. The PIN and the money settings must stay,
 * and they do not affect a round. Without a PIN everyone could open the menu, and without money
 * settings the game would be free. */
static int may_go(uint32_t id)
{
    return settings_entry(id)->group != GROUP_MONEY && id != SET_PIN;
}

static int forget_settings(sqlite3 *db)
{
    sqlite3_stmt *ledger_leave_delete_rows = NULL;
    int code = sqlite3_prepare_v2(db, "DELETE FROM settings WHERE name = ?1", -1,
                                  &ledger_leave_delete_rows, NULL);
    for (uint32_t id = 0; code == SQLITE_OK && id < SETTING_COUNT; id++) {
        if (may_go(id)) {
            sqlite3_bind_text(ledger_leave_delete_rows, 1, settings_entry(id)->name, -1,
                              SQLITE_STATIC);
            code = sqlite3_step(ledger_leave_delete_rows) == SQLITE_DONE ? SQLITE_OK
                                                                         : sqlite3_errcode(db);
            sqlite3_reset(ledger_leave_delete_rows);
        }
    }
    sqlite3_finalize(ledger_leave_delete_rows);
    return code;
}

static int forget_in(sqlite3 *db, enum panics_left left)
{
    int code = forget_settings(db);
    if (code == SQLITE_OK && left >= LEFT_REPLAYS) {
        code = sql_run(db, "DELETE FROM replays");
    }
    if (code == SQLITE_OK && left >= LEFT_NAMES) {
        code = sql_run(db, "UPDATE ranking SET name = ''; UPDATE round_players SET name = ''");
    }
    return code == SQLITE_OK ? ledger_checksum_put(db) : code;
}

static int ledger_leave_delete_rows(struct ledger_file *file, enum panics_left left)
{
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    code = code == SQLITE_OK ? forget_in(file->db, left) : code;
    code = code == SQLITE_OK ? sql_run(file->db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        sql_run(file->db, "ROLLBACK");
    }
    return ledger_log_result(file, code);
}

/* Writes the path of the first unused copy to `copy` and returns its number. Returns 0 if all
 * numbers are used. */
static uint32_t free_number(const char *path, char copy[LEDGER_PATH_SIZE])
{
    struct stat about;
    for (uint32_t i = 1; i <= LEDGER_LEFT_MAX; i++) {
        snprintf(copy, LEDGER_PATH_SIZE, "%.560s" STORAGE_LEFT_SUFFIX "%u", path, i);
        if (lstat(copy, &about) != 0 && errno == ENOENT) {
            return i;
        }
    }
    return 0;
}

/* Copies the database and deletes the data. Returns an SQLite code; SQLITE_FULL also means that no
 * number is free. */
static int leave(struct ledger_file *file, const char *path, enum panics_left left,
                 uint32_t *number)
{
    char copy[LEDGER_PATH_SIZE];
    *number = free_number(path, copy);
    int code = file->refusal ? file->refusal : *number == 0 ? SQLITE_FULL : SQLITE_OK;
    code = code == SQLITE_OK ? ledger_backup_make(file, copy, true) : code;
    if (code == SQLITE_OK && chmod(copy, 0600) != 0) {
        code = SQLITE_IOERR;
    }
    return code == SQLITE_OK ? ledger_leave_delete_rows(file, left) : code;
}

static int open_and_leave(const char *path, enum panics_left left, char words[LEDGER_LEAVE_WORDS])
{
    struct ledger_file file;
    uint32_t number = 0;
    int code = ledger_file_open(&file, path, NULL);
    if (code == SQLITE_OK) {
        code = leave(&file, path, left, &number);
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

int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS])
{
    char path[STORAGE_PATH_SIZE];
    struct stat about;
    const int length = snprintf(path, sizeof path, "%s/" STORAGE_FILE, data);
    if (length < 0 || (size_t)length >= sizeof path || lstat(path, &about) != 0) {
        snprintf(words, LEDGER_LEAVE_WORDS, "there is no " STORAGE_FILE " to leave it out of");
        return LEDGER_LEAVE_NONE;
    }
    return open_and_leave(path, left, words);
}
