/* ledger_omit.h -- deletes a part of the stored data after panics, because the data may have caused
 * the panics.
 *
 * Before the deletion, the whole database is copied to kingyo.db.left-out-N in the same folder.
 * `kingyoctl backup --restore` can restore the copy. Coins, credits, entries, audits and scores are
 * never deleted. The PIN and the money settings are never deleted either. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H

#include "platform/panic_count.h"

/* Maximum number N in the name of a copy. If all numbers are in use, no copy can be made, and
 * therefore no more data are deleted. */
#define LEDGER_LEFT_MAX 99u
/* Size in bytes of the result text. */
#define LEDGER_LEAVE_WORDS 160u
/* Value that ledger_leave_out() returns if the folder has no database. */
#define LEDGER_LEAVE_NONE 1

/* Opens the database kingyo.db in the folder `data`, copies it, and deletes the parts of the data
 * that `left` selects. The caller must have locked the folder (file_lock_folder()). Writes a text
 * about the result to `words`. Returns 0 on success, or LEDGER_LEAVE_NONE if there is no database.
 * Returns -1 and changes nothing if the database cannot be copied or written. */
int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS]);

#endif
