/* ledger_log.c -- makes the write-ahead log durable before its content is used, and copies the log
 * into the database.
 *
 * After a failed fsync() Linux marks the pages clean. A read then returns the new bytes while the
 * disk keeps the old bytes, and a later fsync() writes nothing and returns 0. A log that is opened
 * may contain such pages, from this process or from a process that was killed. Therefore each byte
 * of the log is written again and synced before SQLite may copy the log into the database, and
 * before an entry from the log counts as stored. Writing equal bytes in place is always safe,
 * because each sector contains either its old bytes or the bytes that were read.
 *
 * The database file needs no such treatment. SQLite restarts the log only after a checkpoint whose
 * sync succeeded. Until then the log contains every page that the checkpoint copied. A failed
 * checkpoint is not repeated in the same connection. `is_suspect` stays true until the file is
 * closed, opened again and made durable. */
#include <sqlite3.h>
#include <stdint.h>

#include "platform/store/sqlite/ledger_backup.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* Number of log pages after which the log is copied into the database. With this limit one
 * transaction copies at most half a MiB. */
#define CHECKPOINT_PAGES 128
/* Number of bytes that are written again at a time. */
#define CHUNK 4096

/* Commit hook, which SQLite calls after each commit. SQLite's default hook ignores a failed
 * checkpoint; this hook sets `is_suspect`. */
static int after_commit(void *context, sqlite3 *db, const char *name, int page_count)
{
    struct ledger_file *file = context;
    if (page_count >= CHECKPOINT_PAGES && !file->is_suspect) {
        const int code = sqlite3_wal_checkpoint_v2(db, name, SQLITE_CHECKPOINT_PASSIVE, NULL, NULL);
        file->is_suspect = code != SQLITE_OK && code != SQLITE_BUSY && code != SQLITE_LOCKED;
    }
    return SQLITE_OK;
}

void ledger_log_distrust(struct ledger_file *file)
{
    file->is_suspect = true;
    sqlite3_wal_hook(file->db, after_commit, file);
}

void ledger_log_before_close(struct ledger_file *file)
{
    if (file->db) {
        sqlite3_db_config(file->db, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, (int)file->is_suspect, NULL);
    }
}

static int rewrite(sqlite3_file *log)
{
    uint8_t bytes[CHUNK];
    sqlite3_int64 size = 0;
    int code = log->pMethods->xFileSize(log, &size);
    for (sqlite3_int64 at = 0; code == SQLITE_OK && at < size; at += CHUNK) {
        const int count = size - at < CHUNK ? (int)(size - at) : CHUNK;
        code = log->pMethods->xRead(log, bytes, count, at);
        code = code == SQLITE_OK ? log->pMethods->xWrite(log, bytes, count, at) : code;
    }
    return code == SQLITE_OK && size > 0 ? log->pMethods->xSync(log, SQLITE_SYNC_NORMAL) : code;
}

/* Syncs the folder of the database, because SQLite ignores an error when it syncs the folder for a
 * new log. Returns an SQLite code. */
static int sync_names(struct ledger_file *file)
{
    const char *path = sqlite3_db_filename(file->db, "main");
    return !path || !path[0] || file_sync_parent(path) == 0 ? SQLITE_OK : SQLITE_IOERR;
}

/* Writes the log again. The write lock prevents another program from restarting the log during the
 * rewrite. */
int ledger_log_secure(struct ledger_file *file)
{
    sqlite3_file *log = NULL;
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = sqlite3_file_control(file->db, "main", SQLITE_FCNTL_JOURNAL_POINTER, &log);
    code = code == SQLITE_OK && (!log || !log->pMethods) ? SQLITE_IOERR : code;
    code = code == SQLITE_OK ? rewrite(log) : code;
    code = code == SQLITE_OK ? sync_names(file) : code;
    sql_run(file->db, "ROLLBACK");
    file->is_suspect = code != SQLITE_OK;
    return code & 0xff; /* The low byte is SQLite's primary code. The extended code is dropped. */
}

int ledger_log_result(const struct ledger_file *file, int code)
{
    return code == SQLITE_OK && file->is_suspect ? SQLITE_IOERR : code;
}
