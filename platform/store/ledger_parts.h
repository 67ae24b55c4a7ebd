/* ledger_parts.h -- what the pieces of the ledger's file have of each other, and nobody else. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_PARTS_H
#define KINGYO_PLATFORM_STORE_LEDGER_PARTS_H

#include "platform/store/ledger_file.h"

#define LEDGER_ROW_NAME_SIZE 64u /* Of a setting, an audit or a state; longer ones are not ours. */

/* ledger_file.c: a statement that is ready to bind; made at its first use, when its tables are. */
int ledger_statement(struct ledger_file *file, enum ledger_statement which,
                     struct sqlite3_stmt **out);

/* ledger_schema.c: the statements, and the file's versions. */
const char *ledger_statement_text(enum ledger_statement which);
/* Within the transaction that the caller began. */
int ledger_schema_raise(struct ledger_file *file, int version);

/* Whether each table of a file of this version is as it was made: SQLITE_CORRUPT, where a bit of
 * its words has flipped. */
int ledger_schema_check(struct sqlite3 *db);

/* ledger_rows.c: one entry in and out, without what it adds up to. */
int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry);
int ledger_rows_newest(struct ledger_file *file, struct ledger_entry *out);

/* ledger_sums.c: what entries add up to. */
void ledger_sums_note(struct ledger_content *content, const struct ledger_entry *entry);
/* Writes what differs between the two. */
int ledger_sums_put(struct ledger_file *file, const struct ledger_content *before,
                    const struct ledger_content *after);
int ledger_sums_read(struct ledger_file *file, struct ledger_content *out);

/* ledger_tally.c: within the caller's transaction, after what it changed. */
int ledger_tally_put(struct sqlite3 *db);
/* SQLITE_CORRUPT: settings, audits or ranking are not as they were written. */
int ledger_tally_check(struct sqlite3 *db);

#endif
