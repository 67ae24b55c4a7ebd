/* books.h -- helpers for the commands that read the ledger database.
 *
 * The functions find the database file, open it and report errors. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_BOOKS_H
#define KINGYO_PLATFORM_CTL_OPERATOR_BOOKS_H

#include "platform/ctl/lib/ctl.h"
#include "platform/os/directory.h"
#include "platform/store/sqlite/ledger_file.h"

/* Size in bytes of a buffer for the path of the database. */
#define BOOKS_PATH_SIZE (DIRECTORY_PATH_MAX + 32u)

/* Options that the reading commands share. */
struct books_words {
    const char *data; /* Data folder given with --data. Null selects the folder of the system
                         service, or the user's own data folder if the service has no database. */
    uint8_t as_json;
};

#define BOOKS_USAGE                                                                                \
    "  --data DIR   where the stall keeps it: else /var/lib/kingyo, else your own data folder\n"   \
    "  --json       for programs\n"

/* Parses argv[*at], and its value if it has one, if it is an option of BOOKS_USAGE.
 *
 * Returns 1 and advances *at past the value, or returns 0 if argv[*at] is not such an option. */
int books_take(struct books_words *words, int argc, const char *const *argv, int *at);

/* Writes the path of the kiosk's database to `out`. The file may not exist. */
void books_path(const struct books_words *words, char out[BOOKS_PATH_SIZE]);

/* Returns whether both paths name the same file (same device and inode). */
int books_is_same(const char *one, const char *other);

/* Checks whether the file at `path` was written by Kingyo.
 *
 * Returns SQLITE_OK and fills `out` with the ledger state of the file. The ledger state is all zero
 * if an earlier version wrote the file. Returns SQLITE_NOTFOUND if the file is a database of
 * another program, or another SQLite error code. */
int books_check_copy(const char *path, struct ledger_start *out);

/* Prints one line that names the foreign object because of which ledger_check() reports the
 * database as damaged. `advice` ends the line. Returns whether the database has such an object. */
int books_tell_foreign(const char *command, const char *path, const char *advice);

/* Opens the database for reading. A running kiosk may have the database open at the same time.
 *
 * Returns EXIT_OK, EXIT_IO if there is no database or an I/O error occurs, or EXIT_BAD_DATA if the
 * database cannot be interpreted. Prints each error on standard error with the prefix `command`.
 * The caller closes `out` with ledger_file_close(). */
enum exit_code books_open(const char *command, const struct books_words *words,
                          struct ledger_file *out);

#endif
