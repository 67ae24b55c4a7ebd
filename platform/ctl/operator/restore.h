/* restore.h -- replaces the kiosk's database with a copy. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_RESTORE_H
#define KINGYO_PLATFORM_CTL_OPERATOR_RESTORE_H

#include "platform/ctl/operator/books.h"

/* Replaces the kiosk's database with the copy at `from`. Rejects the request while a process has
 * the database open. Nothing is deleted: the old database and its backup are renamed in the same
 * folder. Returns EXIT_OK, or prints one line to standard error and returns another code. */
enum exit_code restore_backup(const struct books_words *words, const char *from);

#endif
