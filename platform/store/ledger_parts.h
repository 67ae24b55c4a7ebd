/* ledger_parts.h -- what the pieces of the ledger's file have of each other, and nobody else. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_PARTS_H
#define KINGYO_PLATFORM_STORE_LEDGER_PARTS_H

#include "platform/store/ledger_file.h"

#define LEDGER_ROW_NAME_SIZE 64u /* Of a setting, an audit or a state; longer ones are not ours. */

/* ledger_file.c: a statement that is ready to bind; made at its first use, when its tables are. */
int ledger_statement(struct ledger_file *file, enum ledger_statement which,
                     struct sqlite3_stmt **out);

/* ledger_log.c: between opening and ledger_log_secure() nothing copies the write-ahead log into the
 * database, not even closing. */
void ledger_log_distrust(struct ledger_file *file);
void ledger_log_before_close(struct ledger_file *file);
/* `code` of a write, or SQLITE_IOERR where the checkpoint behind its commit failed. */
int ledger_log_result(const struct ledger_file *file, int code);

/* ledger_schema.c: the statements, and the file's versions. */
const char *ledger_statement_text(enum ledger_statement which);
/* Within the transaction that the caller began. */
int ledger_schema_raise(struct ledger_file *file, int version);

/* ledger_tables.c: makes the tables of a version, or `name` alone where that is not null. */
int ledger_tables_make(struct sqlite3 *db, int version, const char *name);

/* Compares the whole schema with that of `user_version`, text by text. Returns SQLITE_CORRUPT if a
 * table differs or is missing, or if there is any other object, such as a trigger. */
int ledger_schema_check(struct sqlite3 *db, int64_t user_version);

/* ledger_rows.c: one entry in and out, without what it adds up to. */
int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_rows.c: writes the value of an entry that is there, and its new sum. */
int ledger_rows_put_value(struct ledger_file *file, const struct ledger_entry *entry);

/* ledger_pin.c: hides each PIN that settings or entries store in plain digits (core/pin.h), and
 * removes the old bytes from free pages and from the log. After an error the next open tries again.
 * A replay that an older Kingyo kept while a PIN was set still holds that PIN until
 * platform/kiosk/pin_sweep.h has played it. */
int ledger_pin_hide(struct ledger_file *file);

/* ledger_pin.c: within the caller's transaction, marks the file as one that may hold old bytes of a
 * PIN: the next ledger_pin_hide() writes it anew. The caller renews the tallies. */
int ledger_pin_mark(struct ledger_file *file);
int ledger_rows_newest(struct ledger_file *file, struct ledger_entry *out);
/* The stand of the open round; zero where none is written. */
int ledger_rows_stand(struct ledger_file *file, struct ledger_stand *out);

/* ledger_sums.c: what entries add up to. */
void ledger_sums_note(struct ledger_content *content, const struct ledger_entry *entry);
/* Writes what differs between the two. */
int ledger_sums_put(struct ledger_file *file, const struct ledger_content *before,
                    const struct ledger_content *after);
/* Returns SQLITE_CORRUPT if the rows hold values that core_init() would reject. */
int ledger_sums_read(struct ledger_file *file, struct ledger_content *out);

/* The first version of the file whose tallies are checked. */
#define LEDGER_TALLY_VERSION 4

/* ledger_tally.c: within the caller's transaction, after what it changed. */
int ledger_tally_put(struct sqlite3 *db);
/* SQLITE_CORRUPT: settings, audits or ranking are not as they were written. */
int ledger_tally_check(struct sqlite3 *db);

#endif
