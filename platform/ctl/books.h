/* books.h -- what the commands that read the ledger's file share: where it lies, and why not. */
#ifndef KINGYO_PLATFORM_CTL_BOOKS_H
#define KINGYO_PLATFORM_CTL_BOOKS_H

#include "platform/ctl/ctl.h"
#include "platform/folder.h"
#include "platform/store/ledger_file.h"

#define BOOKS_PATH_SIZE (FOLDER_PATH_MAX + 32u)

struct books_words {
    const char *data;    /* A folder; null: the service's, else the caller's own. */
    uint8_t as_json;
};

#define BOOKS_USAGE                                                                                \
    "  --data DIR   where the stall keeps it: else /var/lib/kingyo, else your own data folder\n"   \
    "  --json       for programs\n"

/* Takes the word at argv[*at], and its value, when it is one of BOOKS_USAGE; 0: it is not. */
int books_take(struct books_words *words, int argc, const char *const *argv, int *at);

/* Where the stall's file lies, or would. */
void books_path(const struct books_words *words, char out[BOOKS_PATH_SIZE]);

/* Whether both names lead to the same file. */
int books_is_same(const char *one, const char *other);

/* Whether the file at `path` is one that a Kingyo wrote: SQLITE_OK, and `out` is how far it came,
 * zero where that was an earlier version. SQLITE_NOTFOUND: a database, but none of ours. */
int books_look_at_copy(const char *path, struct ledger_start *out);

/* Prints one line that names the object because of which ledger_check() takes the database for
 * damaged, with `advice` behind it. Returns whether there is such an object. */
int books_tell_foreign(const char *command, const char *path, const char *advice);

/* Opens the file for reading; it may be a stall's that runs. Tells, as `command`, what is wrong:
 * EXIT_IO where there is none, EXIT_BAD_DATA where it is none that we can read. */
enum exit_code books_open(const char *command, const struct books_words *words,
                          struct ledger_file *out);

#endif
