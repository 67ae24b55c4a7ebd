/* ledger_stand.h -- test fixture with a new temporary folder and a ledger file for each test.
 *
 * A test may open, close, damage and replace the file. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_LEDGER_STAND_H
#define KINGYO_TESTS_UNIT_SUPPORT_LEDGER_STAND_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sqlite3.h>

#include "platform/store/sqlite/ledger_file.h"

static char folder[32];
static char path[64]; /* Path of the ledger file in that folder. The file does not exist at the
                         start of a test. */
static struct ledger_file file;

/* Creates the temporary folder. This is a cmocka setup function. */
static inline int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/kingyo-ledger-XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/kingyo.db", folder);
    memset(&file, 0, sizeof file);
    return 0;
}

/* Closes the ledger file and removes the folder. This is a cmocka teardown function. */
static inline int tear_down(void **state)
{
    (void)state;
    char command[64];
    ledger_file_close(&file);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

/* Runs `sql` on the file from a second connection, as another program would. `sql` may also change
 * SQLite's own tables. */
static inline void do_sql(const char *sql)
{
    sqlite3 *db;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 0, NULL);
    assert_int_equal(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}

/* Copies tests/unit/platform/store/files/version-N.db, which an older Kingyo wrote, to `path`. */
static inline void take_version(int version)
{
    char command[120];
    snprintf(command, sizeof command, "cp tests/unit/platform/store/files/version-%d.db %s",
             version, path);
    assert_int_equal(system(command), 0);
}

#endif
