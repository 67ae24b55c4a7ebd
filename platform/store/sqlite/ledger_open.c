/* ledger_open.c -- opens, validates, migrates and reads the database. If an older version stored a
 * PIN as plain digits, replaces the digits by their salted hash. A database that cannot be written
 * is opened read-only. */
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "core/pin.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"

/* Maximum time in milliseconds that a call waits while another program (kingyoctl, a backup) locks
 * the file. */
#define BUSY_MS 2000

/* Journal mode and synchronous mode: a write-ahead log with a sync per transaction. Of all journal
 * modes that lose no data in a power cut, WAL FULL has the fewest writes and syncs (`make
 * bench-journals`). A rollback journal with the synchronous mode EXTRA needs three times as many
 * syncs. ledger_file.c copies the log into the database. cache_size is the memory in KiB that one
 * transaction needs. */
#define JOURNAL "WAL FULL"
/* SQL text that reads the version of the file. */
#define VERSION "PRAGMA user_version"
static const char settings[] = "PRAGMA cache_size = -1024";

/* Sets the journal mode, checks that SQLite uses a write-ahead log, and makes the log durable. The
 * check is necessary because SQLite reports no error if it cannot create a write-ahead log and
 * keeps another journal mode. If the caller has selected a journal mode, checks nothing and
 * guarantees no durability. Returns an SQLite code. */
static int set_up(struct ledger_file *file, const struct ledger_file_options *how)
{
    char mode[16] = "", sync[16] = "", text[120];
    const bool is_chosen = how && how->journal;
    sqlite3_stmt *statement = NULL;
    if (sscanf(is_chosen ? how->journal : JOURNAL, "%15s %15s", mode, sync) != 2) {
        return SQLITE_MISUSE;
    }
    snprintf(text, sizeof text, "PRAGMA journal_mode = %s; PRAGMA synchronous = %s", mode, sync);
    int code = sql_run(file->db, text);
    code = code == SQLITE_OK ? sql_run(file->db, settings) : code;
    if (code != SQLITE_OK || is_chosen) {
        file->is_suspect = file->is_suspect && !is_chosen;
        return code;
    }
    code = sqlite3_prepare_v2(file->db, "PRAGMA journal_mode", -1, &statement, NULL);
    if (sql_row(statement, &code)) {
        const unsigned char *found = sqlite3_column_text(statement, 0);
        code = found && strcmp((const char *)found, "wal") == 0 ? SQLITE_OK : SQLITE_IOERR;
    }
    sqlite3_finalize(statement);
    code = code == SQLITE_OK ? ledger_log_secure(file) : code;
    /* Another program holds the write lock. The log is made durable later, and `file->is_suspect`
     * stays true until then. */
    return code == SQLITE_BUSY ? SQLITE_OK : code;
}

/* ---- Validation ---------------------------------------------------------------------------- */

/* Returns SQLITE_CORRUPT if `code` is an error that a damaged schema may cause, otherwise `code`. A
 * schema with a flipped bit may still be valid SQL, but a later statement may fail. The caller must
 * first exclude other causes of the error, such as a full memory card. */
static int as_damage(int code)
{
    return code == SQLITE_ERROR || code == SQLITE_SCHEMA || code == SQLITE_MISMATCH ||
                   code == SQLITE_CONSTRAINT
               ? SQLITE_CORRUPT
               : code;
}

/* The schema is validated first, because SQLite's integrity check evaluates expressions of the
 * schema. */
int ledger_check(sqlite3 *db)
{
    int64_t version = 0;
    int code = sql_number(db, VERSION, &version);
    if (code == SQLITE_OK && version > LEDGER_FILE_VERSION) {
        return LEDGER_FILE_NEWER;
    }
    code = code == SQLITE_OK ? ledger_schema_check(db, version) : code;
    if (code == SQLITE_OK) {
        /* SQLite's integrity check finds most damage. */
        sqlite3_stmt *check = NULL;
        code = sqlite3_prepare_v2(db, "PRAGMA quick_check(1)", -1, &check, NULL);
        if (sql_row(check, &code)) {
            const unsigned char *verdict = sqlite3_column_text(check, 0);
            const bool good = verdict && strcmp((const char *)verdict, "ok") == 0;
            code = good ? SQLITE_OK : SQLITE_CORRUPT;
        }
        sqlite3_finalize(check);
    }
    if (code == SQLITE_OK && version >= LEDGER_CHECKSUM_VERSION) {
        code = ledger_checksum_check(db);
    }
    return as_damage(code);
}

/* ---- Hiding a PIN -------------------------------------------------------------------------- */

/* Hides a PIN that an older version stored as plain digits: replaces the digits by their salted
 * hash (core/pin.h).
 *
 * The digits are in the PIN setting and in each entry that records a change of the PIN setting. All
 * copies of a PIN are hashed with the same salt. Settings that are rebuilt from the entries are
 * therefore equal to the stored settings.
 *
 * Old bytes remain in free pages and in gaps of pages. VACUUM rewrites the file, and the following
 * checkpoint empties the write-ahead log. Each of the two steps may fail after the rows were
 * committed. Therefore a row of the table `state` marks the file until VACUUM and the checkpoint
 * have succeeded. */

/* Name of the `state` row that exists while old bytes of a PIN may be in the file. */
#define MARK "'pin-vacuum'"
/* Part of an SQL statement that selects the entries with a PIN as plain digits. */
#define PLAIN_ENTRIES "FROM entries WHERE kind = %d AND detail = %d AND count = 0 AND value > 0"

/* Replaces the PIN by its salted hash in the entries that contain the PIN as plain digits. Few
 * entries contain a PIN: one for each PIN that was ever set. Returns an SQLite code. */
static int hide_entries(struct ledger_file *file, uint32_t salt)
{
    struct ledger_entry entry;
    char text[160], change[120];
    int64_t id = 0;
    int code;
    snprintf(text, sizeof text, "SELECT coalesce(max(id), 0) " PLAIN_ENTRIES, LEDGER_SETTING,
             SET_PIN);
    while ((code = sql_number(file->db, text, &id)) == SQLITE_OK && id > 0) {
        code = ledger_file_entry(file, (uint32_t)id, &entry);
        if (code == SQLITE_OK) {
            entry.value = pin_is_plain(entry.value) ? pin_hide((uint32_t)entry.value, salt) : 0;
            snprintf(change, sizeof change,
                     "UPDATE entries SET value = %d, sum = %" PRId64 " WHERE id = %u", entry.value,
                     ledger_entry_sum(&entry), entry.id);
            code = sql_run(file->db, change);
            code = code == SQLITE_OK && sqlite3_changes64(file->db) != 1 ? SQLITE_CORRUPT : code;
        }
        if (code != SQLITE_OK) {
            return code;
        }
    }
    return code;
}

int ledger_pin_mark(struct ledger_file *file)
{
    return sql_run(file->db, "INSERT OR REPLACE INTO state VALUES (" MARK ", 1)");
}

/* Replaces each PIN that settings or entries contain as plain digits by its salted hash
 * (core/pin.h), and removes the old bytes from free pages and from the write-ahead log. Returns an
 * SQLite code. After an error the next open tries again. Replays of an older version may still
 * contain the PIN until platform/kiosk/recorder/pin_sweep.h has replaced them. */
static int hide_pin(struct ledger_file *file)
{
    uint32_t salt = 0;
    int64_t reasons = 0;
    /* Counts the rows that require a rewrite of the file: rows with a plain PIN, and the row
     * MARK. */
    char text[320];
    snprintf(text, sizeof text,
             "SELECT (SELECT count(*) " PLAIN_ENTRIES ") +"
             " (SELECT count(*) FROM settings WHERE name = 'pin' AND value BETWEEN 1 AND %d) +"
             " (SELECT count(*) FROM state WHERE name = " MARK ")",
             LEDGER_SETTING, SET_PIN, PIN_MAX);
    int code = sql_number(file->db, text, &reasons);
    if (code != SQLITE_OK || reasons == 0) {
        return code;
    }
    sqlite3_randomness(sizeof salt, &salt);
    code = sql_run(file->db, "PRAGMA secure_delete = ON; BEGIN IMMEDIATE");
    if (code == SQLITE_OK) {
        code = ledger_pin_mark(file);
        code = code == SQLITE_OK ? hide_entries(file, salt) : code;
        if (code == SQLITE_OK) {
            char change[120];
            int64_t kept = 0;
            code = sql_number(file->db, "SELECT value FROM settings WHERE name = 'pin'", &kept);
            if (code == SQLITE_OK && pin_is_plain((int32_t)kept)) {
                snprintf(change, sizeof change, "UPDATE settings SET value = %d WHERE name = 'pin'",
                         pin_hide((uint32_t)kept, salt));
                code = sql_run(file->db, change);
            }
            code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
        }
        code = sql_commit(file->db, code);
    }
    if (code == SQLITE_OK) {
        /* Rewrites the file with VACUUM. VACUUM attaches its new file as a second database. Because
         * sql_open() has set the limit of attached databases to 0, the limit is raised during
         * VACUUM. */
        sqlite3_limit(file->db, SQLITE_LIMIT_ATTACHED, 1);
        code = sql_run(file->db, "VACUUM");
        sqlite3_limit(file->db, SQLITE_LIMIT_ATTACHED, 0);
        code = code == SQLITE_OK ? sqlite3_wal_checkpoint_v2(file->db, "main",
                                                             SQLITE_CHECKPOINT_TRUNCATE, NULL, NULL)
                                 : code;
    }
    if (code == SQLITE_OK) {
        code = sql_run(file->db, "BEGIN IMMEDIATE");
        if (code == SQLITE_OK) {
            code = sql_run(file->db, "DELETE FROM state WHERE name = " MARK);
            code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
            code = sql_commit(file->db, code);
        }
    }
    file->is_suspect = file->is_suspect || (code != SQLITE_OK && code != SQLITE_BUSY);
    return code;
}

/* ---- Opening ------------------------------------------------------------------------------- */

/* Migrates the file in one transaction. If two programs open an old file, the second program
 * detects that the first program has already migrated the file. Returns an SQLite code. */
static int bring_up_to_date(struct ledger_file *file)
{
    int64_t version = 0;
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = sql_number(file->db, VERSION, &version);
    if (code == SQLITE_OK && version < LEDGER_FILE_VERSION) {
        code = ledger_schema_raise(file, (int)version);
    }
    return sql_commit(file->db, code);
}

/* Validates the database of an open connection and reads its version and content into `file`. A
 * damaged file or a file of a newer version is not changed. Returns an SQLite code or an error code
 * of ledger_file.h. */
static int ledger_open_begin(struct ledger_file *file, const struct ledger_file_options *how)
{
    int64_t version = 0;
    ledger_log_invalidate(file);
    sqlite3_extended_result_codes(file->db, 0);
    sqlite3_busy_timeout(file->db, BUSY_MS);
    if (sqlite3_db_readonly(file->db, "main") == 1) {
        file->refusal = SQLITE_READONLY;
    }
    int code = ledger_check(file->db);
    code = code == SQLITE_OK ? sql_number(file->db, VERSION, &version) : code;
    if (code == SQLITE_OK && version > LEDGER_FILE_VERSION) {
        return LEDGER_FILE_NEWER;
    }
    code = code == SQLITE_OK && !file->refusal ? set_up(file, how) : code;
    if (code != SQLITE_OK) {
        return code;
    }
    code = version == LEDGER_FILE_VERSION ? SQLITE_OK
           : file->refusal                ? file->refusal
                                          : bring_up_to_date(file);
    if (code == SQLITE_OK) {
        /* If hide_pin() fails, for example because the memory card is full, the kiosk starts
         * nevertheless. The next program start tries again. Until then the PIN stays in the file as
         * plain digits and still opens the menu. */
        code = file->refusal ? SQLITE_OK : hide_pin(file);
        code = code == SQLITE_CORRUPT || code == SQLITE_NOTADB ? code : SQLITE_OK;
    }
    if (code == SQLITE_OK) {
        /* Prepares all statements, so that a file in which a statement fails is detected when it is
         * opened. */
        sqlite3_stmt *statement;
        for (uint32_t i = 0; code == SQLITE_OK && i < LEDGER_STATEMENT_COUNT; i++) {
            code = ledger_statement(file, (enum ledger_statement)i, &statement);
        }
    }
    return as_damage(code == SQLITE_OK ? ledger_aggregates_read(file, &file->content) : code);
}

static bool has_log(const char *path)
{
    char log[PATH_MAX + 8];
    struct stat about;
    snprintf(log, sizeof log, "%s-wal", path);
    return strlen(path) >= PATH_MAX || (stat(log, &about) == 0 && about.st_size > 0);
}

/* Opens a file that cannot be written. SQLite can read a write-ahead log only if it can write the
 * log's index. A kiosk that was closed leaves a file without a log. Such a file is read without a
 * lock, which is safe because no process can write the file. */
static int open_unwritable(struct ledger_file *file, const char *path)
{
    return has_log(path) ? SQLITE_CANTOPEN : sql_open_unwritable(path, &file->db);
}

/* Returns true if missing permissions of the file or folder may be the cause of the error. */
static bool is_unwritable(int code)
{
    return code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
}

/* Returns true if the memory card is full. The error code alone is not sufficient, because SQLite
 * returns only a general I/O error if it cannot create the index of the write-ahead log. */
static bool is_card_full(struct ledger_file *file, int code)
{
    return code == SQLITE_FULL ||
           (code == SQLITE_IOERR && sqlite3_extended_errcode(file->db) == SQLITE_IOERR_SHMSIZE);
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
    } else if (is_card_full(file, code)) {
        ledger_file_close(file);
        const bool had_log = has_log(path);
        code = sql_open(path, SQLITE_OPEN_READWRITE, how ? how->vfs : NULL, &file->db);
        code = code == SQLITE_OK ? sql_run(file->db, "PRAGMA locking_mode = EXCLUSIVE") : code;
        file->refusal = SQLITE_FULL;
        code = code == SQLITE_OK ? ledger_open_begin(file, how) : code;
        file->is_suspect = had_log;
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
        code = sql_number(file->db, VERSION, &version);
    }
    if (is_unwritable(code)) {
        ledger_file_close(file);
        code = open_unwritable(file, path);
        code = code == SQLITE_OK ? sql_number(file->db, VERSION, &version) : code;
    }
    code = code != SQLITE_OK && is_card_full(file, code) ? SQLITE_FULL : code;
    if (code == SQLITE_OK && version != LEDGER_FILE_VERSION) {
        code = ledger_check(file->db);
        code = code == SQLITE_OK ? SQLITE_SCHEMA : code;
    }
    code = code == SQLITE_OK ? ledger_schema_check(file->db, version) : code;
    code = code == SQLITE_OK ? ledger_aggregates_read(file, &file->content) : code;
    if (code != SQLITE_OK) {
        ledger_file_close(file);
    }
    return code;
}
