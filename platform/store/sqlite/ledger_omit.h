/* ledger_omit.h -- deletes a part of the stored data, after panics that this data may have caused.
 *
 * The whole database is first copied to kingyo.db.left-out-N beside it, which `kingyoctl backup
 * --restore` can restore. Coins, credits, entries, audits and scores are kept, and so are the PIN
 * and the money settings. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H
#define KINGYO_PLATFORM_STORE_SQLITE_LEDGER_OMIT_H

#include "platform/panic_count.h"

/* Largest number of copies; at this number nothing more is deleted. */
#define LEDGER_LEFT_MAX 99u
#define LEDGER_LEAVE_WORDS 160u
#define LEDGER_LEAVE_NONE 1 /* There is no database. */

/* Opens kingyo.db in the folder `data`, which the caller has locked (directory_lock()), and deletes
 * the data that `left` names. Writes the result as text to `words`. Returns 0, LEDGER_LEAVE_NONE,
 * or -1 if nothing was changed because the database cannot be copied or written. */
int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS]);

#endif
