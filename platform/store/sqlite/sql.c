/* sql.c -- SQL helper functions, and the opening of a database that an attacker may have written,
 * as https://sqlite.org/security.html recommends; see sql.h. */
#include "platform/store/sqlite/sql.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/log.h"

int sql_run(sqlite3 *db, const char *text)
{
    CORE_ASSERT(db);
    return sqlite3_exec(db, text, NULL, NULL, NULL);
}

int sql_number(sqlite3 *db, const char *text, int64_t *out)
{
    sqlite3_stmt *statement = NULL;
    int code = sqlite3_prepare_v2(db, text, -1, &statement, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(statement);
        if (code == SQLITE_ROW) {
            *out = sqlite3_column_int64(statement, 0);
        }
        code = code == SQLITE_ROW || code == SQLITE_DONE ? SQLITE_OK : code;
    }
    sqlite3_finalize(statement);
    return code;
}

int sql_put(sqlite3_stmt *statement, const int64_t *values, int count)
{
    CORE_ASSERT(count == 0 || values);
    for (int i = 0; i < count; i++) {
        sqlite3_bind_int64(statement, i + 1, values[i]);
    }
    const int code = sqlite3_step(statement);
    sqlite3_reset(statement);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

int sql_put_one(sqlite3_stmt *statement, const int64_t *values, int count)
{
    const int code = sql_put(statement, values, count);
    const bool is_in = sqlite3_changes64(sqlite3_db_handle(statement)) == 1;
    return code == SQLITE_OK && !is_in ? SQLITE_CORRUPT : code;
}

uint32_t sql_uint(sqlite3_stmt *statement, int column, uint32_t max)
{
    const int64_t value = sqlite3_column_int64(statement, column);
    return value < 0 || value > (int64_t)max ? 0u : (uint32_t)value;
}

void sql_text(sqlite3_stmt *statement, int column, char *out, int size)
{
    CORE_ASSERT(size > 0);
    const unsigned char *text = sqlite3_column_text(statement, column);
    memset(out, 0, (size_t)size);
    for (int i = 0; text && i < size - 1 && text[i]; i++) {
        out[i] = (char)text[i];
    }
}

bool sql_row(sqlite3_stmt *statement, int *code)
{
    if (*code != SQLITE_OK && *code != SQLITE_ROW) {
        return false;
    }
    *code = sqlite3_step(statement);
    return *code == SQLITE_ROW;
}

int sql_end(sqlite3_stmt *statement, int code)
{
    sqlite3_finalize(statement);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

int sql_commit(sqlite3 *db, int code)
{
    CORE_ASSERT(db);
    code = code == SQLITE_OK ? sql_run(db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        sql_run(db, "ROLLBACK");
    }
    return code;
}

/* ---- Limits and options -------------------------------------------------------------------- */

/* Limits that SQLite enforces on every statement. The limits are well above the needs of Kingyo's
 * own statements. */
static const struct {
    int id, max;
} limits[] = {
    { SQLITE_LIMIT_LENGTH,
      4 * 1024 * 1024 }, /* Maximum length of a value. A replay has at most 3 MiB
                            (SESSION_RECORDER_SIZE). */
    { SQLITE_LIMIT_SQL_LENGTH, 100000 },
    { SQLITE_LIMIT_COLUMN, 100 },
    { SQLITE_LIMIT_EXPR_DEPTH, 32 },
    { SQLITE_LIMIT_COMPOUND_SELECT, 4 },
    { SQLITE_LIMIT_VDBE_OP, 25000 },
    { SQLITE_LIMIT_FUNCTION_ARG, 16 },
    { SQLITE_LIMIT_ATTACHED, 0 },
    { SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 50 },
    { SQLITE_LIMIT_VARIABLE_NUMBER, 50 },
    { SQLITE_LIMIT_TRIGGER_DEPTH, 1 },
};

static const struct {
    int option, value;
} options[] = {
    { SQLITE_DBCONFIG_DEFENSIVE, 1 },       { SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0 },
    { SQLITE_DBCONFIG_ENABLE_TRIGGER, 0 },  { SQLITE_DBCONFIG_ENABLE_VIEW, 0 },
    { SQLITE_DBCONFIG_WRITABLE_SCHEMA, 0 }, { SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0 },
    { SQLITE_DBCONFIG_DQS_DML, 0 },         { SQLITE_DBCONFIG_DQS_DDL, 0 },
};

/* ---- Files --------------------------------------------------------------------------------- */

/* File mode with which SQLite creates a new database by default. SQLite gives its other files the
 * mode of the database. */
#define SQLITE_NEW_FILE 0644

/* Replaces SQLite's open(2) for the database, the write-ahead log, the log's index and the journal.
 * Only regular files are opened, with two exceptions: the folder, which SQLite syncs, and SQLite's
 * source of random numbers. */
static int open_regular(const char *path, int flags, int mode)
{
    struct stat about;
    if (strcmp(path, "/dev/urandom") == 0) {
        return open(path, flags | O_CLOEXEC);
    }
    /* Databases, logs and copies contain the hash of the operator's PIN and the income of the
     * kiosk. Therefore only the owner may read a new file. A file with access for all users is from
     * an older version of Kingyo and becomes private too, except for a group with write access,
     * which only the operator can have given. Any other mode is the operator's choice and stays. */
    const mode_t private = mode == SQLITE_NEW_FILE ? S_IRUSR | S_IWUSR : (mode_t)mode & 0770;
    const int handle = file_handle(path, flags, private);
    /* fchmod() fails for a user who does not own the file. The error is ignored. */
    if (handle >= 0 && (flags & O_ACCMODE) == O_RDWR && fstat(handle, &about) == 0 &&
        (about.st_mode & 0007) != 0 &&
        fchmod(handle, about.st_mode & S_IWGRP ? about.st_mode & 0770 : 0600) == 0 &&
        fstat(handle, &about) == 0) {
        log_print(LOG_LEVEL_WARNING, "%s: all users had access; its mode is %04o now", path,
                  (unsigned)about.st_mode & 07777u);
    } else if (handle < 0 && errno == EISDIR && (flags & O_ACCMODE) == O_RDONLY) {
        return open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    }
    return handle;
}

/* Installs open_regular() in SQLite's default file system layer. The change affects every
 * connection of the process. */
static void take_over_open(void)
{
    sqlite3_vfs *vfs = sqlite3_vfs_find(NULL);
    if (vfs && vfs->iVersion >= 3 && vfs->xSetSystemCall) {
        vfs->xSetSystemCall(vfs, "open", (sqlite3_syscall_ptr)open_regular);
    }
}

/* Resolves symbolic links in the folder part of `path`, but not in the file name.
 * SQLITE_OPEN_NOFOLLOW rejects all links, including those in the folder part. Returns true on
 * success. */
static bool resolve_folder_links(const char *path, char out[PATH_MAX])
{
    char folder[PATH_MAX], whole[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    const int length = slash ? (int)(slash - path) : 1;
    snprintf(folder, sizeof folder, "%.*s", slash == path ? 1 : length, slash ? path : ".");
    if (!realpath(folder, whole)) {
        return false;
    }
    const int size = snprintf(out, PATH_MAX, "%s/%s", strcmp(whole, "/") == 0 ? "" : whole, name);
    return size > 0 && size < PATH_MAX;
}

/* ---- Opening ------------------------------------------------------------------------------- */

static int open_named(const char *name, int flags, const char *vfs, sqlite3 **out)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, take_over_open);
    int code = sqlite3_open_v2(name, out, flags | SQLITE_OPEN_NOMUTEX, vfs);
    if (code == SQLITE_OK) {
        for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
            sqlite3_limit(*out, limits[i].id, limits[i].max);
        }
        for (size_t i = 0; code == SQLITE_OK && i < sizeof options / sizeof options[0]; i++) {
            code = sqlite3_db_config(*out, options[i].option, options[i].value, NULL);
        }
        code = code == SQLITE_OK
                   ? sql_run(*out, "PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0")
                   : code;
    }
    return code;
}

int sql_open(const char *path, int flags, const char *vfs, sqlite3 **out)
{
    char whole[PATH_MAX];
    *out = NULL;
    if (vfs) {
        return open_named(path, flags, vfs, out);
    }
    return resolve_folder_links(path, whole)
               ? open_named(whole, flags | SQLITE_OPEN_NOFOLLOW, NULL, out)
               : SQLITE_CANTOPEN;
}

int sql_open_unwritable(const char *path, sqlite3 **out)
{
    char whole[PATH_MAX], uri[3 * PATH_MAX + 32] = "file:";
    size_t at = strlen(uri);
    *out = NULL;
    if (!resolve_folder_links(path, whole)) {
        return SQLITE_CANTOPEN;
    }
    for (const char *c = whole; *c; c++) {
        at += (size_t)snprintf(uri + at, sizeof uri - at, strchr("%?#", *c) ? "%%%02X" : "%c", *c);
    }
    snprintf(uri + at, sizeof uri - at, "?immutable=1");
    return open_named(uri, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOFOLLOW, NULL,
                      out);
}

/* ---- Days and dates ------------------------------------------------------------------------ */

#define DAY_S 86400
#define DAYS_TO_2000 10957 /* Days from 1970-01-01 to 2000-01-01. */

struct sql_day sql_day_of(int64_t unix_s)
{
    const time_t moment = (time_t)unix_s;
    struct tm local;
    if (!localtime_r(&moment, &local)) {
        return (struct sql_day){ 0 };
    }
    struct tm midnight = { .tm_year = local.tm_year,
                           .tm_mon = local.tm_mon,
                           .tm_mday = local.tm_mday };
    const int64_t day = timegm(&midnight) / DAY_S - DAYS_TO_2000;
    if (day <= 0 || day > UINT16_MAX) {
        return (struct sql_day){ 0 };
    }
    return (struct sql_day){ .day = (uint16_t)day,
                             .minute = (uint16_t)(local.tm_hour * 60 + local.tm_min) };
}

void sql_day_text(uint16_t day, char out[SQL_DAY_TEXT_SIZE])
{
    const time_t moment = ((time_t)day + DAYS_TO_2000) * DAY_S;
    struct tm date;
    if (day == 0 || !gmtime_r(&moment, &date) ||
        strftime(out, SQL_DAY_TEXT_SIZE, "%Y-%m-%d", &date) == 0) {
        snprintf(out, SQL_DAY_TEXT_SIZE, "-");
    }
}
