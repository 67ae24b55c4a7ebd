/* ledger_internal.h -- internal interface between the source files of the database. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_INTERNAL_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_INTERNAL_H

#include "platform/store/sqlite/ledger_file.h"

/* Size of the name of a setting, an audit or a state; longer names are not written by Kingyo. */
#define LEDGER_ROW_NAME_SIZE 64u

/* ledger_file.c: returns a prepared statement, ready to bind. The statement is prepared at its
 * first use, after its tables exist. */
int ledger_statement(struct ledger_file *file, enum ledger_statement which,
                     struct sqlite3_stmt **out);

/* ledger_log.c: suspends copying of the write-ahead log into the database, also at closing, from
 * the opening until ledger_log_secure() succeeds. */
void ledger_log_distrust(struct ledger_file *file);
void ledger_log_before_close(struct ledger_file *file);
/* Returns `code` of a write, or SQLITE_IOERR if the checkpoint after its commit failed. */
int ledger_log_result(const struct ledger_file *file, int code);

/* ledger_schema.c: returns the SQL text of a statement. */
const char *ledger_statement_text(enum ledger_statement which);
/* Migrates the file from `version`, inside the caller's transaction. */
int ledger_schema_raise(struct ledger_file *file, int version);

/* ledger_tables.c: creates the tables of a version, or only the table `name` if it is not null. */
int ledger_tables_make(struct sqlite3 *db, int version, const char *name);

/* Compares the whole schema with that of `user_version`, text by text. Returns SQLITE_CORRUPT if a
 * table differs or is missing, or if there is any other object, such as a trigger. */
int ledger_schema_check(struct sqlite3 *db, int64_t user_version);

/* ledger_rows.c: writes one entry, without its aggregates. */
int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_rows.c: writes the value of an existing entry, and its new checksum. */
int ledger_rows_put_value(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_pin.c: hides each PIN that settings or entries store as plain digits (core/pin.h), and
 * removes the old bytes from free pages and from the log. After an error the next open tries again.
 * A replay that an older version stored while a PIN was set contains that PIN until
 * platform/kiosk/pin_sweep.h has replayed it. */
int ledger_pin_hide(struct ledger_file *file);

/* ledger_pin.c: marks the file, inside the caller's transaction, as possibly containing old
 * bytes of a PIN, so that the next ledger_pin_hide() rewrites the file. The caller updates the
 * checksums. */
int ledger_pin_mark(struct ledger_file *file);

/* ledger_rows.c: reads the newest entry. */
int ledger_rows_newest(struct ledger_file *file, struct ledger_entry *out);
/* Reads the state of the open round; zero if no state is stored. */
int ledger_rows_state(struct ledger_file *file, struct ledger_stand *out);

/* ledger_aggregates.c: adds one entry to the aggregates. */
void ledger_aggregates_note(struct ledger_content *content, const struct ledger_entry *entry);
/* Writes the differences between `before` and `after`. */
int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after);
/* Reads the aggregates. Returns SQLITE_CORRUPT if the rows contain values that core_init() would
 * reject. */
int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out);

/* First version of the file whose table checksums are verified. */
#define LEDGER_CHECKSUM_VERSION 4

/* ledger_checksum.c: writes the table checksums, inside the caller's transaction and after its
 * changes. */
int ledger_checksum_put(struct sqlite3 *db);
/* Verifies the table checksums. Returns SQLITE_CORRUPT if settings, audits or ranking differ from
 * what was written. */
int ledger_checksum_check(struct sqlite3 *db);

#endif
