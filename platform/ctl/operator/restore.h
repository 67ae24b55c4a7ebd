/* restore.h -- replaces the kiosk's ledger database with a backup copy. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_RESTORE_H
#define KINGYO_PLATFORM_CTL_OPERATOR_RESTORE_H

#include "platform/ctl/operator/books.h"

/* Replaces the kiosk's ledger database with the copy at `from`. Fails while a process has the
 * database open. No file is deleted, because the old database and its backup are renamed in the
 * same folder. Returns EXIT_OK, or prints one line to standard error and returns another exit
 * code. */
enum exit_code restore_backup(const struct books_words *words, const char *from);

#endif
