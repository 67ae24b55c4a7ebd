/* ledger_leave.h -- leaves a part of what the store remembers out, after panics that it may cause.
 *
 * The whole database is first copied to kingyo.db.left-out-N beside it, which `kingyoctl backup
 * --restore` can put back. Coins, credits, entries, audits and scores stay, and so do the settings
 * that concern money and the PIN. */
#ifndef KINGYO_PLATFORM_STORE_LEDGER_LEAVE_H
#define KINGYO_PLATFORM_STORE_LEDGER_LEAVE_H

#include "platform/panics.h"

#define LEDGER_LEFT_MAX 99u             /* Copies; with so many nothing more is left out. */
#define LEDGER_LEAVE_WORDS 160u
#define LEDGER_LEAVE_NONE 1             /* There is no database. */

/* Opens kingyo.db in the folder `data`, which the caller holds (folder_hold()), and deletes what
 * `left` names. Writes the result into `words`. Returns 0, LEDGER_LEAVE_NONE, or -1 if nothing was
 * changed because the database cannot be copied or written. */
int ledger_leave_out(const char *data, enum panics_left left, char words[LEDGER_LEAVE_WORDS]);

#endif
