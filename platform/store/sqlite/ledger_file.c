/* ledger_file.c -- makes the write-ahead log of the open database durable, stores replays, deletes
 * old data, and closes the database. */
#include "platform/store/sqlite/ledger_file.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/sql.h"
#include "sql_texts.h"

void ledger_file_close(struct ledger_file *file)
{
    /* SQLite must not copy a log that may not be on disk (`is_suspect`) into the database when the
     * database is closed. */
    if (file->db) {
        sqlite3_db_config(file->db, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, (int)file->is_suspect, NULL);
    }
    for (uint32_t i = 0; i < LEDGER_STATEMENT_COUNT; i++) {
        sqlite3_finalize(file->statement[i]);
    }
    sqlite3_close(file->db);
    *file = (struct ledger_file){ 0 };
}

const char *ledger_file_error(int code)
{
    return code == LEDGER_FILE_NEWER     ? "a later Kingyo wrote it"
           : code == LEDGER_FILE_LOCKED  ? "another Kingyo has it open"
           : code == LEDGER_FILE_MOVED   ? "was removed or replaced while it was open"
           : code == LEDGER_FILE_LINK    ? "is a symbolic link, not a file"
           : code == LEDGER_FILE_FOREIGN ? "not the card that it began with"
                                         : sqlite3_errstr(code);
}

/* ---- Write-ahead log ----------------------------------------------------------------------- */

/* Makes the write-ahead log durable before its content is used, and copies the log into the
 * database.
 *
 * After a failed fsync() Linux marks the pages clean. A read then returns the new bytes while the
 * disk keeps the old bytes, and a later fsync() writes nothing and returns 0. A log that is opened
 * may contain such pages, from this process or from a process that was killed. Therefore each used
 * byte of the log is written again and synced before SQLite may copy the log into the database, and
 * before an entry from the log counts as stored. Writing equal bytes in place is always safe,
 * because each sector contains either its old bytes or the bytes that were read.
 *
 * The database file needs no such treatment. SQLite restarts the log only after a checkpoint whose
 * sync succeeded. Until then the log contains every page that the checkpoint copied. After a failed
 * checkpoint, the same connection makes no further checkpoint: `is_suspect` stays true until the
 * file is closed, opened again and made durable. */

/* Number of log pages after which the log is copied into the database. With this limit one
 * transaction copies at most half a MiB. */
#define CHECKPOINT_PAGES 128
/* Number of bytes of the write-ahead log that one write call rewrites. */
#define CHUNK 4096

/* Commit hook, which SQLite calls after each commit. SQLite's default hook ignores a failed
 * checkpoint. Kingyo's hook sets `is_suspect` if a checkpoint fails. */
static int after_commit(void *context, sqlite3 *db, const char *name, int page_count)
{
    struct ledger_file *file = context;
    if (page_count >= CHECKPOINT_PAGES && !file->is_suspect) {
        const int code = sqlite3_wal_checkpoint_v2(db, name, SQLITE_CHECKPOINT_PASSIVE, NULL, NULL);
        file->is_suspect = code != SQLITE_OK && code != SQLITE_BUSY && code != SQLITE_LOCKED;
    }
    return SQLITE_OK;
}

void ledger_log_invalidate(struct ledger_file *file)
{
    CORE_ASSERT(file->db);
    file->is_suspect = true;
    sqlite3_wal_hook(file->db, after_commit, file);
}

static uint32_t big_endian_32(const uint8_t bytes[4])
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* Sets `used` to the number of bytes of the log that SQLite may read: the header and the frames
 * with the salt of the header. The rest of the file may be large. It contains frames from before
 * the log was restarted, or bytes that another program wrote. Returns a code of SQLite. Format:
 * https://sqlite.org/fileformat2.html#walformat */
static int log_used_bytes(sqlite3_file *log, sqlite3_int64 *used)
{
    enum { HEADER = 32, FRAME_HEADER = 24, SALT = 8 };
    uint8_t header[HEADER] = { 0 }, frame[FRAME_HEADER];
    sqlite3_int64 size = 0;
    int code = log->pMethods->xFileSize(log, &size);
    *used = size < HEADER ? size : HEADER;
    if (code == SQLITE_OK && size >= HEADER) {
        code = log->pMethods->xRead(log, header, HEADER, 0);
    }
    const uint32_t page = big_endian_32(&header[8]);
    const sqlite3_int64 step = FRAME_HEADER + (sqlite3_int64)page;
    while (code == SQLITE_OK && page > 0 && size - *used >= step) {
        code = log->pMethods->xRead(log, frame, FRAME_HEADER, *used);
        if (code != SQLITE_OK || memcmp(&frame[8], &header[16], SALT) != 0) {
            break;
        }
        *used += step;
    }
    return code;
}

/* Writes the used part of the write-ahead log again and syncs the log, because after a failed sync
 * the pages may exist only in the kernel's cache. The write lock prevents another program from
 * restarting the log during the rewrite. */
int ledger_log_secure(struct ledger_file *file)
{
    CORE_ASSERT(file->db);
    sqlite3_file *log = NULL;
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = sqlite3_file_control(file->db, "main", SQLITE_FCNTL_JOURNAL_POINTER, &log);
    code = code == SQLITE_OK && (!log || !log->pMethods) ? SQLITE_IOERR : code;
    if (code == SQLITE_OK) {
        uint8_t bytes[CHUNK];
        sqlite3_int64 size = 0;
        code = log_used_bytes(log, &size);
        for (sqlite3_int64 at = 0; code == SQLITE_OK && at < size; at += CHUNK) {
            const int count = size - at < CHUNK ? (int)(size - at) : CHUNK;
            code = log->pMethods->xRead(log, bytes, count, at);
            code = code == SQLITE_OK ? log->pMethods->xWrite(log, bytes, count, at) : code;
        }
        code = code == SQLITE_OK && size > 0 ? log->pMethods->xSync(log, SQLITE_SYNC_NORMAL) : code;
    }
    if (code == SQLITE_OK) {
        /* Syncs the folder of the database. SQLite also syncs the folder for a new log, but ignores
         * an error of this sync. */
        const char *path = sqlite3_db_filename(file->db, "main");
        code = !path || !path[0] || file_sync_parent(path) == 0 ? SQLITE_OK : SQLITE_IOERR;
    }
    sql_run(file->db, "ROLLBACK");
    file->is_suspect = code != SQLITE_OK;
    return code & 0xff; /* Returns only the low byte, which is SQLite's primary result code. */
}

int ledger_log_result(const struct ledger_file *file, int code)
{
    return code == SQLITE_OK && file->is_suspect ? SQLITE_IOERR : code;
}

/* ---- Replays and old data ------------------------------------------------------------------ */

_Static_assert(LEDGER_FILE_ENTRIES == 32768u && LEDGER_FILE_ROUNDS == 65536u, "sql_prune differs");

int ledger_file_prune(struct ledger_file *file)
{
    CORE_ASSERT(file->db);
    return ledger_log_result(file, sql_commit(file->db, sql_run(file->db, sql_prune)));
}

int ledger_file_put_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                           size_t size)
{
    CORE_ASSERT(bytes);
    const int64_t round = round_id;
    sqlite3_stmt *put = NULL;
    int code = ledger_statement(file, PUT_REPLAY, &put);
    if (code == SQLITE_OK) {
        sqlite3_bind_blob64(put, 2, bytes, size, SQLITE_STATIC);
        code = sql_put_one(put, &round, 1);
        sqlite3_clear_bindings(put);
    }
    return ledger_log_result(file, code);
}

int ledger_file_get_replay(struct ledger_file *file, uint32_t round_id, void *bytes, size_t size,
                           size_t *size_out)
{
    CORE_ASSERT(bytes && size_out);
    sqlite3_stmt *get = NULL;
    int code = ledger_statement(file, GET_REPLAY, &get);
    if (code != SQLITE_OK) {
        return code;
    }
    sqlite3_bind_int64(get, 1, round_id);
    code = sqlite3_step(get);
    if (code == SQLITE_ROW) {
        const void *blob = sqlite3_column_blob(get, 0);
        *size_out = (size_t)sqlite3_column_bytes(get, 0);
        code = !blob ? SQLITE_NOMEM : *size_out > size ? SQLITE_TOOBIG : SQLITE_OK;
        if (blob) {
            memcpy(bytes, blob, *size_out < size ? *size_out : size);
        }
    } else if (code == SQLITE_DONE) {
        code = SQLITE_NOTFOUND;
    }
    sqlite3_reset(get);
    return code;
}

int ledger_file_next_replay(struct ledger_file *file, uint32_t round_id, uint32_t *out)
{
    char text[120];
    int64_t next = 0;
    snprintf(text, sizeof text,
             "SELECT coalesce(min(round), 0) FROM replays WHERE round > %u AND round <= %u",
             round_id, UINT32_MAX);
    const int code = sql_number(file->db, text, &next);
    *out = (uint32_t)next;
    return code == SQLITE_OK && next == 0 ? SQLITE_NOTFOUND : code;
}

int ledger_file_renew_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                             size_t size)
{
    int code = sql_run(file->db, "PRAGMA secure_delete = ON; BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = ledger_pin_mark(file);
    if (code == SQLITE_OK && bytes) {
        code = ledger_file_put_replay(file, round_id, bytes, size);
    } else if (code == SQLITE_OK) {
        char text[64];
        snprintf(text, sizeof text, "DELETE FROM replays WHERE round = %u", round_id);
        code = sql_run(file->db, text);
    }
    code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
    return ledger_log_result(file, sql_commit(file->db, code));
}

bool ledger_file_has_replay(struct ledger_file *file, uint32_t round_id)
{
    sqlite3_stmt *has = NULL;
    if (ledger_statement(file, HAS_REPLAY, &has) != SQLITE_OK) {
        return false;
    }
    sqlite3_bind_int64(has, 1, round_id);
    const int code = sqlite3_step(has);
    sqlite3_reset(has);
    return code == SQLITE_ROW;
}
