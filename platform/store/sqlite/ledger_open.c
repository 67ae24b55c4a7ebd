/* ledger_open.c -- opens, validates, migrates and reads the database, with read-only fallbacks. */
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* Time in ms for which another program (kingyoctl, a backup) may lock the file. */
#define BUSY_MS 2000

/* A write-ahead log, the cheapest of all journals that lose nothing in a power cut (`make
 * bench-journals`). This journal needs the fewest writes and the fewest syncs, a third of a
 * rollback journal at EXTRA. ledger_log.c copies the log into the file. The cache size is what a
 * transaction needs, in KiB. */
#define JOURNAL "WAL FULL"
static const char settings[] = "PRAGMA cache_size = -1024";

static int set_up(sqlite3 *db, const struct ledger_file_options *how)
{
    char mode[16] = "", sync[16] = "", text[120];
    const char *journal = how && how->journal ? how->journal : JOURNAL;
    if (sscanf(journal, "%15s %15s", mode, sync) != 2) {
        return SQLITE_MISUSE;
    }
    snprintf(text, sizeof text, "PRAGMA journal_mode = %s; PRAGMA synchronous = %s", mode, sync);
    const int code = sql_run(db, text);
    return code == SQLITE_OK ? sql_run(db, settings) : code;
}

/* Checks the journal mode and makes the log durable. If SQLite cannot create a write-ahead log, it
 * keeps another journal without an error. A caller that selects another journal gets no durability
 * guarantee. */
static int secure(struct ledger_file *file, const struct ledger_file_options *how)
{
    sqlite3_stmt *ask = NULL;
    if (how && how->journal) {
        file->is_suspect = false;
        return SQLITE_OK;
    }
    int code = sqlite3_prepare_v2(file->db, "PRAGMA journal_mode", -1, &ask, NULL);
    code = code == SQLITE_OK ? sqlite3_step(ask) : code;
    if (code == SQLITE_ROW) {
        const unsigned char *mode = sqlite3_column_text(ask, 0);
        code = mode && strcmp((const char *)mode, "wal") == 0 ? SQLITE_OK : SQLITE_IOERR;
    }
    sqlite3_finalize(ask);
    code = code == SQLITE_OK ? ledger_log_secure(file) : code;
    return code == SQLITE_BUSY ? SQLITE_OK : code; /* `is_suspect` stays set for the caller. */
}

/* ---- Validation ----------------------------------------------------------------------------- */

/* Maps errors of a damaged schema to SQLITE_CORRUPT. A flipped bit in the schema may be valid SQL
 * that fails later. The caller has excluded causes such as a full card. */
static int as_damage(int code)
{
    return code == SQLITE_ERROR || code == SQLITE_SCHEMA || code == SQLITE_MISMATCH ||
                   code == SQLITE_CONSTRAINT
               ? SQLITE_CORRUPT
               : code;
}

/* Runs SQLite's integrity check, because SQLite finds most damage only in this check. */
static int check_pages(sqlite3 *db)
{
    sqlite3_stmt *check = NULL;
    int code = sqlite3_prepare_v2(db, "PRAGMA quick_check(1)", -1, &check, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(check);
        if (code == SQLITE_ROW) {
            const unsigned char *verdict = sqlite3_column_text(check, 0);
            const bool good = verdict && strcmp((const char *)verdict, "ok") == 0;
            code = good ? SQLITE_OK : SQLITE_CORRUPT;
        }
    }
    sqlite3_finalize(check);
    return code;
}

/* Validates the schema first because the page check evaluates expressions of the schema. */
int ledger_check(sqlite3 *db)
{
    int64_t version = 0;
    int code = sql_number(db, "PRAGMA user_version", &version);
    if (code == SQLITE_OK && version > LEDGER_FILE_VERSION) {
        return LEDGER_FILE_NEWER;
    }
    code = code == SQLITE_OK ? ledger_schema_check(db, version) : code;
    code = code == SQLITE_OK ? check_pages(db) : code;
    if (code == SQLITE_OK && version >= LEDGER_CHECKSUM_VERSION) {
        code = ledger_checksum_check(db);
    }
    return as_damage(code);
}

/* ---- Opening -------------------------------------------------------------------------------- */

/* Prepares all statements at once, so that a file in which a statement would fail is detected at
 * the opening. */
static int prepare_all(struct ledger_file *file)
{
    sqlite3_stmt *statement;
    int code = SQLITE_OK;
    for (uint32_t i = 0; code == SQLITE_OK && i < LEDGER_STATEMENT_COUNT; i++) {
        code = ledger_statement(file, (enum ledger_statement)i, &statement);
    }
    return code;
}

static int read_version(struct ledger_file *file, int64_t *version)
{
    *version = 0;
    return sql_number(file->db, "PRAGMA user_version", version);
}

/* Migrates the file in one transaction. If two programs open an old file, the second one finds the
 * migration done. */
static int bring_up_to_date(struct ledger_file *file)
{
    int64_t version;
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = read_version(file, &version);
    if (code == SQLITE_OK && version < LEDGER_FILE_VERSION) {
        code = ledger_schema_raise(file, (int)version);
    }
    code = code == SQLITE_OK ? sql_run(file->db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        sql_run(file->db, "ROLLBACK");
    }
    return code;
}

static int raise_version(struct ledger_file *file, int64_t version)
{
    if (version > LEDGER_FILE_VERSION) {
        return LEDGER_FILE_NEWER;
    }
    if (version == LEDGER_FILE_VERSION) {
        return SQLITE_OK;
    }
    return file->refusal ? file->refusal : bring_up_to_date(file);
}

/* Hides the PIN. A card without enough space is retried at the next start; until then the PIN opens
 * the menu as before. */
static int hide_pin(struct ledger_file *file)
{
    const int code = file->refusal ? SQLITE_OK : ledger_pin_hide(file);
    return code == SQLITE_CORRUPT || code == SQLITE_NOTADB ? code : SQLITE_OK;
}

/* Validates and reads an open connection. A file that is damaged or newer is not changed. */
static int ledger_open_begin(struct ledger_file *file, const struct ledger_file_options *how)
{
    int64_t version = 0;
    ledger_log_distrust(file);
    sqlite3_extended_result_codes(file->db, 0);
    sqlite3_busy_timeout(file->db, BUSY_MS);
    if (sqlite3_db_readonly(file->db, "main") == 1) {
        file->refusal = SQLITE_READONLY;
    }
    int code = ledger_check(file->db);
    code = code == SQLITE_OK ? read_version(file, &version) : code;
    code = code == SQLITE_OK && version > LEDGER_FILE_VERSION ? LEDGER_FILE_NEWER : code;
    if (code == SQLITE_OK && !file->refusal) {
        code = set_up(file->db, how);
        code = code == SQLITE_OK ? secure(file, how) : code;
    }
    if (code != SQLITE_OK) {
        return code;
    }
    code = raise_version(file, version);
    code = code == SQLITE_OK ? hide_pin(file) : code;
    code = code == SQLITE_OK ? prepare_all(file) : code;
    return as_damage(code == SQLITE_OK ? ledger_aggregates_read(file, &file->content) : code);
}

static bool has_log(const char *path)
{
    char log[PATH_MAX + 8];
    struct stat about;
    snprintf(log, sizeof log, "%s-wal", path);
    return strlen(path) >= PATH_MAX || (stat(log, &about) == 0 && about.st_size > 0);
}

/* Opens a file that cannot be written. SQLite can read a log only if its index can be written. A
 * file without a log, as a closed kiosk leaves it, is read without any lock because no process can
 * write it. */
static int open_unwritable(struct ledger_file *file, const char *path)
{
    if (has_log(path)) {
        return SQLITE_CANTOPEN;
    }
    return sql_open_unwritable(path, &file->db);
}

/* Returns true if the permissions of the file or folder are the cause. */
static bool is_unwritable(int code)
{
    return code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
}

/* Returns true if the card is full. SQLite reports only a general error when it cannot create the
 * index of the log. */
static bool is_full(struct ledger_file *file, int code)
{
    return code == SQLITE_FULL ||
           (code == SQLITE_IOERR && sqlite3_extended_errcode(file->db) == SQLITE_IOERR_SHMSIZE);
}

/* Opens a file on a full card, with the index of the log in memory. Only one program at a time may
 * do this, therefore readers must wait until the file is closed. Entries of an existing log stay
 * suspect because the log cannot be rewritten. */
static int open_full(struct ledger_file *file, const char *path,
                     const struct ledger_file_options *how)
{
    const bool had_log = has_log(path);
    int code = sql_open(path, SQLITE_OPEN_READWRITE, how ? how->vfs : NULL, &file->db);
    code = code == SQLITE_OK ? sql_run(file->db, "PRAGMA locking_mode = EXCLUSIVE") : code;
    file->refusal = SQLITE_FULL;
    code = code == SQLITE_OK ? ledger_open_begin(file, how) : code;
    file->is_suspect = had_log;
    return code;
}

int ledger_file_open(struct ledger_file *file, const char *path,
                     const struct ledger_file_options *how)
{
    const char *vfs = how ? how->vfs : NULL;
    *file = (struct ledger_file){ 0 };
    int code = sql_open(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, vfs, &file->db);
    code = code == SQLITE_OK ? ledger_open_begin(file, how) : code;
    if (is_unwritable(code) && !vfs) {
        ledger_file_close(file);
        code = open_unwritable(file, path);
        code = code == SQLITE_OK ? ledger_open_begin(file, how) : code;
        file->is_suspect = false;
    } else if (is_full(file, code)) {
        ledger_file_close(file);
        code = open_full(file, path, how);
    }
    if (code != SQLITE_OK) {
        ledger_file_close(file);
    }
    return code;
}

int ledger_file_inspect(struct ledger_file *file, const char *path)
{
    int64_t version = 0;
    *file = (struct ledger_file){ .refusal = SQLITE_READONLY };
    int code = sql_open(path, SQLITE_OPEN_READONLY, NULL, &file->db);
    if (code == SQLITE_OK) {
        sqlite3_busy_timeout(file->db, BUSY_MS);
        code = read_version(file, &version);
    }
    if (is_unwritable(code)) {
        ledger_file_close(file);
        code = open_unwritable(file, path);
        code = code == SQLITE_OK ? read_version(file, &version) : code;
    }
    code = code != SQLITE_OK && is_full(file, code) ? SQLITE_FULL : code;
    if (code == SQLITE_OK && version != LEDGER_FILE_VERSION) {
        code = version > LEDGER_FILE_VERSION ? LEDGER_FILE_NEWER : SQLITE_SCHEMA;
    }
    code = code == SQLITE_OK ? ledger_schema_check(file->db, version) : code;
    code = code == SQLITE_OK ? ledger_aggregates_read(file, &file->content) : code;
    if (code != SQLITE_OK) {
        ledger_file_close(file);
    }
    return code;
}
