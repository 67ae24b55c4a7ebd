/* sql_open.c -- opens a database that an attacker may have written, as
 * https://sqlite.org/security.html recommends. */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/sqlite/sql.h"

#include "platform/os/file.h"

/* Limits of SQLite that are well above the needs of Kingyo's own statements. */
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

/* SQLite's default mode for a new database. SQLite gives its other files the mode of the
 * database. */
#define SQLITE_NEW_FILE 0644

/* Returns the mode for a new file. Databases, logs and copies contain the hash of the operator's
 * PIN and all takings, therefore only the owner may read a new file. If an older file is readable
 * for all users, only its owner and group may read its new companion files. */
static mode_t private_mode(int mode)
{
    return mode == SQLITE_NEW_FILE ? S_IRUSR | S_IWUSR : (mode_t)mode & 0770;
}

static void close_to_others(int handle, mode_t mode, int flags)
{
    if ((mode & 0007) != 0 && (flags & O_ACCMODE) == O_RDWR) {
        fchmod(handle, mode & 0770); /* fchmod() fails for users other than the owner. The error is
                                        ignored. */
    }
}

/* Replaces SQLite's open(2) for the database, the log, the log's index and the journal. Only
 * regular files are opened, with two exceptions: the folder, which SQLite syncs, and SQLite's
 * source of random numbers. */
static int open_regular(const char *path, int flags, int mode)
{
    struct stat about;
    if (strcmp(path, "/dev/urandom") == 0) {
        return open(path, flags | O_CLOEXEC);
    }
    const int handle = file_handle(path, flags, private_mode(mode));
    if (handle >= 0 && fstat(handle, &about) == 0) {
        close_to_others(handle, about.st_mode, flags);
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
static bool resolve(const char *path, char out[PATH_MAX])
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

static int harden(sqlite3 *db)
{
    for (size_t i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        sqlite3_limit(db, limits[i].id, limits[i].max);
    }
    int code = SQLITE_OK;
    for (size_t i = 0; code == SQLITE_OK && i < sizeof options / sizeof options[0]; i++) {
        code = sqlite3_db_config(db, options[i].option, options[i].value, NULL);
    }
    return code == SQLITE_OK ? sql_run(db, "PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0")
                             : code;
}

static int open_named(const char *name, int flags, const char *vfs, sqlite3 **out)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, take_over_open);
    const int code = sqlite3_open_v2(name, out, flags | SQLITE_OPEN_NOMUTEX, vfs);
    return code == SQLITE_OK ? harden(*out) : code;
}

int sql_open(const char *path, int flags, const char *vfs, sqlite3 **out)
{
    char whole[PATH_MAX];
    *out = NULL;
    if (vfs) {
        return open_named(path, flags, vfs, out);
    }
    return resolve(path, whole) ? open_named(whole, flags | SQLITE_OPEN_NOFOLLOW, NULL, out)
                                : SQLITE_CANTOPEN;
}

int sql_open_unwritable(const char *path, sqlite3 **out)
{
    char whole[PATH_MAX], uri[3 * PATH_MAX + 32] = "file:";
    size_t at = strlen(uri);
    *out = NULL;
    if (!resolve(path, whole)) {
        return SQLITE_CANTOPEN;
    }
    for (const char *c = whole; *c; c++) {
        at += (size_t)snprintf(uri + at, sizeof uri - at, strchr("%?#", *c) ? "%%%02X" : "%c", *c);
    }
    snprintf(uri + at, sizeof uri - at, "?immutable=1");
    return open_named(uri, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOFOLLOW, NULL,
                      out);
}
