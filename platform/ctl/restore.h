/* restore.h -- a copy takes the place of what the stall keeps. */
#ifndef KINGYO_PLATFORM_CTL_RESTORE_H
#define KINGYO_PLATFORM_CTL_RESTORE_H

#include "platform/ctl/books.h"

/* Puts the copy at `from` in place of the stall's file. Refuses while somebody holds that file;
 * nothing is deleted: what was there, and its backup, get names of their own beside it. */
enum exit_code restore(const struct books_words *words, const char *from);

#endif
