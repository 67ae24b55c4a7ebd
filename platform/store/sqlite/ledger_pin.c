/* ledger_pin.c -- hides a PIN that an older version stored as plain digits.
 *
 * The digits are in the PIN setting and in each entry that records a change of the PIN setting. All
 * copies of a PIN are hidden with the same salt. Settings that are rebuilt from the entries are
 * therefore equal to the stored settings. Old bytes remain in free pages and in gaps of pages.
 * VACUUM rewrites the file, and the following checkpoint empties the log. Each of the two steps may
 * fail after the rows were committed. Therefore a row of `state` marks the file until both steps
 * have succeeded. */
#include <sqlite3.h>
#include <stdio.h>

#include "core/pin.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* Name of the `state` row that exists while old bytes of a PIN may be in the file. */
#define MARK "'pin-vacuum'"
/* SQL text that selects the entries with a PIN as plain digits. */
#define PLAIN_ENTRIES "FROM entries WHERE kind = %d AND detail = %d AND count = 0 AND value > 0"

/* Hides the PIN in its entries. The entries are few: one for each PIN that was ever set. Returns an
 * SQLite code. */
static int hide_entries(struct ledger_file *file, uint32_t salt)
{
    struct ledger_entry entry;
    char text[160];
    int64_t id = 0;
    int code;
    snprintf(text, sizeof text, "SELECT coalesce(max(id), 0) " PLAIN_ENTRIES, LEDGER_SETTING,
             SET_PIN);
    while ((code = sql_number(file->db, text, &id)) == SQLITE_OK && id > 0) {
        code = ledger_file_entry(file, (uint32_t)id, &entry);
        if (code == SQLITE_OK) {
            entry.value = pin_is_plain(entry.value) ? pin_hide((uint32_t)entry.value, salt) : 0;
            code = ledger_rows_put_value(file, &entry);
        }
        if (code != SQLITE_OK) {
            return code;
        }
    }
    return code;
}

static int hide_setting(struct ledger_file *file, uint32_t salt)
{
    char text[120];
    int64_t kept = 0;
    int code = sql_number(file->db, "SELECT value FROM settings WHERE name = 'pin'", &kept);
    if (code == SQLITE_OK && pin_is_plain((int32_t)kept)) {
        snprintf(text, sizeof text, "UPDATE settings SET value = %d WHERE name = 'pin'",
                 pin_hide((uint32_t)kept, salt));
        code = sql_run(file->db, text);
    }
    return code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
}

/* Counts the rows because of which the file must be rewritten: rows with a plain PIN and the row
 * MARK. Returns an SQLite code. */
static int count_reasons(struct ledger_file *file, int64_t *count)
{
    char text[320];
    snprintf(text, sizeof text,
             "SELECT (SELECT count(*) " PLAIN_ENTRIES ") +"
             " (SELECT count(*) FROM settings WHERE name = 'pin' AND value BETWEEN 1 AND %d) +"
             " (SELECT count(*) FROM state WHERE name = " MARK ")",
             LEDGER_SETTING, SET_PIN, PIN_MAX);
    return sql_number(file->db, text, count);
}

static int end_transaction(struct ledger_file *file, int code)
{
    code = code == SQLITE_OK ? sql_run(file->db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        sql_run(file->db, "ROLLBACK");
    }
    return code;
}

int ledger_pin_mark(struct ledger_file *file)
{
    return sql_run(file->db, "INSERT OR REPLACE INTO state VALUES (" MARK ", 1)");
}

static int hide_all(struct ledger_file *file, uint32_t salt)
{
    int code = sql_run(file->db, "PRAGMA secure_delete = ON; BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = ledger_pin_mark(file);
    code = code == SQLITE_OK ? hide_entries(file, salt) : code;
    code = code == SQLITE_OK ? hide_setting(file, salt) : code;
    return end_transaction(file, code);
}

/* Rewrites the file with VACUUM. VACUUM attaches its new file, which a limit of sql_open() forbids.
 * The limit is raised for this call. Returns an SQLite code. */
static int write_anew(struct ledger_file *file)
{
    sqlite3_limit(file->db, SQLITE_LIMIT_ATTACHED, 1);
    const int code = sql_run(file->db, "VACUUM");
    sqlite3_limit(file->db, SQLITE_LIMIT_ATTACHED, 0);
    return code == SQLITE_OK
               ? sqlite3_wal_checkpoint_v2(file->db, "main", SQLITE_CHECKPOINT_TRUNCATE, NULL, NULL)
               : code;
}

static int remove_mark(struct ledger_file *file)
{
    int code = sql_run(file->db, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = sql_run(file->db, "DELETE FROM state WHERE name = " MARK);
    code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
    return end_transaction(file, code);
}

int ledger_pin_hide(struct ledger_file *file)
{
    uint32_t salt = 0;
    int64_t reasons = 0;
    int code = count_reasons(file, &reasons);
    if (code != SQLITE_OK || reasons == 0) {
        return code;
    }
    sqlite3_randomness(sizeof salt, &salt);
    code = hide_all(file, salt);
    code = code == SQLITE_OK ? write_anew(file) : code;
    code = code == SQLITE_OK ? remove_mark(file) : code;
    file->is_suspect = file->is_suspect || (code != SQLITE_OK && code != SQLITE_BUSY);
    return code;
}
