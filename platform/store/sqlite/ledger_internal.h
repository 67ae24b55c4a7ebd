/* ledger_internal.h -- the interface between the source files of the database, not for other
 * modules. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_INTERNAL_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_INTERNAL_H

#include "platform/store/sqlite/ledger_file.h"

/* Size in bytes of the name of a setting, an audit or a state. All names that Kingyo writes fit
 * into this size. */
#define LEDGER_ROW_NAME_SIZE 64u

/* ledger_file.c: writes a prepared statement to `out`. The statement is prepared at its first use,
 * because its tables may not exist earlier. Returns an SQLite code. */
int ledger_statement(struct ledger_file *file, enum ledger_statement which,
                     struct sqlite3_stmt **out);

/* ledger_file.c: ledger_log_distrust() prevents SQLite from copying the write-ahead log into the
 * database until ledger_log_secure() succeeds. ledger_log_before_close() also prevents the copy
 * that SQLite makes when the database is closed. */
void ledger_log_distrust(struct ledger_file *file);
void ledger_log_before_close(struct ledger_file *file);
/* Returns `code`, the result of a write. If `code` is SQLITE_OK but the checkpoint after the commit
 * failed, returns SQLITE_IOERR. */
int ledger_log_result(const struct ledger_file *file, int code);

/* ledger_schema.c: returns the SQL text of a statement. */
const char *ledger_statement_text(enum ledger_statement which);
/* Migrates the file from `version` to LEDGER_FILE_VERSION, inside the caller's transaction. Returns
 * an SQLite code. */
int ledger_schema_raise(struct ledger_file *file, int version);

/* ledger_schema.c: creates all tables of `version`. If `name` is not null, creates only the table
 * `name`. Returns an SQLite code. */
int ledger_tables_make(struct sqlite3 *db, int version, const char *name);

/* Compares the text of the whole schema with the tables of the file version `user_version`. Returns
 * SQLITE_CORRUPT if a table differs or is missing, or if the file has any other schema object, such
 * as a trigger. */
int ledger_schema_check(struct sqlite3 *db, int64_t user_version);

/* ledger_rows.c: writes one entry without its aggregates. Returns an SQLite code. */
int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_rows.c: writes the value of an existing entry and its new checksum. Returns an SQLite
 * code. */
int ledger_rows_put_value(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_open.c: hides each PIN that settings or entries contain as plain digits (core/pin.h).
 * Removes the old bytes from free pages and from the write-ahead log. Returns an SQLite code. After
 * an error the next open tries again. Replays of an older version may still contain the PIN until
 * platform/kiosk/recorder/pin_sweep.h has replaced them. */
int ledger_pin_hide(struct ledger_file *file);

/* ledger_open.c: marks the file, inside the caller's transaction, as possibly containing old bytes
 * of a PIN. The next ledger_pin_hide() then rewrites the file. The caller must update the
 * checksums. */
int ledger_pin_mark(struct ledger_file *file);

/* ledger_rows.c: reads the newest entry. Returns SQLITE_NOTFOUND if there is no entry. */
int ledger_rows_newest(struct ledger_file *file, struct ledger_entry *out);
/* Reads the state of the open round (a round that has started but has no result yet). Writes zeros
 * if no state is stored. */
int ledger_rows_state(struct ledger_file *file, struct ledger_stand *out);

/* ledger_aggregates.c: updates the aggregates in `content` from one entry. */
void ledger_aggregates_note(struct ledger_content *content, const struct ledger_entry *entry);
/* Writes the aggregates that differ between `before` and `after` to the database. Returns an SQLite
 * code. */
int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after);
/* Reads the aggregates (settings, audits, ranking). Returns SQLITE_CORRUPT if the rows contain
 * values that core_init() would reject. */
int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out);

/* First file version in which the tables have checksums. */
#define LEDGER_CHECKSUM_VERSION 4

/* ledger_aggregates.c: writes the table checksums. Call inside the caller's transaction, after its
 * other changes. Returns an SQLite code. */
int ledger_checksum_put(struct sqlite3 *db);
/* Verifies the table checksums. Returns SQLITE_CORRUPT if settings, audits or ranking differ from
 * the written values. */
int ledger_checksum_check(struct sqlite3 *db);

#endif
