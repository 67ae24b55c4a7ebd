/* ledger_omit.h -- deletes a part of the stored data after panics, because the data may have caused
 * the panics.
 *
 * The whole database is first copied to kingyo.db.left-out-N in the same folder. `kingyoctl backup
 * --restore` can restore the copy. Coins, credits, entries, audits and scores are never deleted.
 * The PIN and the money settings are never deleted either. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H

#include "platform/panic_count.h"

/* Maximum number of copies. When all numbers are used, no more data are deleted. */
#define LEDGER_LEFT_MAX 99u
/* Size in bytes of the result text. */
#define LEDGER_LEAVE_WORDS 160u
#define LEDGER_LEAVE_NONE 1 /* Result of ledger_leave_out() if there is no database. */

/* Opens kingyo.db in the folder `data` and deletes the data of `left`. The caller must have locked
 * the folder (directory_lock()). Writes the result as text to `words`. Returns 0, or
 * LEDGER_LEAVE_NONE if there is no database. Returns -1 if nothing was changed because the database
 * cannot be copied or written. */
int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS]);

#endif
