/* books.h -- helpers for the commands that read the ledger database, which stores the kiosk's money
 * and its leaderboards.
 *
 * The functions find the database file, open it and report errors. The ledger is the append-only
 * list of money events. */
#pragma once

#include <stdbool.h>

#include "platform/ctl/lib/ctl.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_file.h"

/* Size in bytes of a buffer for the path of the ledger database. */
#define BOOKS_PATH_SIZE (FILE_FOLDER_MAX + 32u)

/* Options that all commands for the ledger database share. Commands with further options have this
 * structure as the first member of their own structure. */
struct books_words {
    /* Data folder given with --data, or null if the option is absent. Null selects the folder of
     * the system service, or the user's own data folder if the service has no database. */
    const char *data;
    bool as_json;
};

/* Table of the options that all commands for the ledger database share. The parsed values are
 * stored in struct books_words. */
extern const struct option_table books_options;

/* Writes the path of the kiosk's ledger database to `out`. The file may not exist. */
void books_path(const struct books_words *words, char out[BOOKS_PATH_SIZE]);

/* Returns true if the two paths lead to the same file (same device and inode). */
bool books_is_same(const char *one, const char *other);

/* Checks whether the file at `path` is a ledger database that Kingyo wrote.
 *
 * Returns SQLITE_OK and fills `out` with the start record of the ledger. The record is all zero if
 * an earlier version of Kingyo wrote the file. Returns SQLITE_NOTFOUND if the database has no
 * tables. Returns SQLITE_CORRUPT if the database is damaged, or if its tables are not the tables of
 * its version. Otherwise returns an error code of ledger_file.h. */
int books_check_copy(const char *path, struct ledger_start *out);

/* Used if ledger_check() reports a damaged database: searches for a foreign object in the database,
 * for example a table of another program. If there is one, prints one line with the name of the
 * object and then `advice`, and returns true. Otherwise returns false. */
bool books_report_foreign(const char *command, const char *path, const char *advice);

/* Opens the ledger database for reading. A kiosk that is running may have the database open at the
 * same time.
 *
 * Returns EXIT_OK. Returns EXIT_IO if there is no database or an I/O error occurs, and
 * EXIT_BAD_DATA if the content of the database is invalid. Prints each error on standard error with
 * the prefix `command`. The caller closes `out` with ledger_file_close(). */
enum exit_code books_open(const char *command, const struct books_words *words,
                          struct ledger_file *out);
