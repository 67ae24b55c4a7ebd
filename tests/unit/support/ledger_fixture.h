/* ledger_fixture.h -- test fixture that gives each test a new temporary folder for a ledger file.
 * The ledger is the list of all money events, to which entries are only appended. A test may open,
 * close, damage and replace the file. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_LEDGER_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_LEDGER_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sqlite3.h>

#include "platform/store/sqlite/ledger_file.h"

static char folder[32];
static char path[64]; /* Path of the ledger file in `folder`. The file does not exist at the start
                         of a test. */
static struct ledger_file file;

/* Creates the temporary folder; a cmocka setup function. */
static inline int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/kingyo-ledger-XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/kingyo.db", folder);
    memset(&file, 0, sizeof file);
    return 0;
}

/* Closes the ledger file and removes the temporary folder; a cmocka teardown function. */
static inline int tear_down(void **state)
{
    (void)state;
    char command[64];
    ledger_file_close(&file);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

/* Runs `sql` on the ledger file through a second connection, as another program would. `sql` may
 * also change SQLite's own tables. */
static inline void do_sql(const char *sql)
{
    sqlite3 *db;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 0, NULL);
    assert_int_equal(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}

/* Copies tests/unit/platform/store/files/version-N.db to `path`, where N is `version`. The file is
 * a ledger of an older Kingyo version. */
static inline void take_version(int version)
{
    char command[120];
    snprintf(command, sizeof command, "cp tests/unit/platform/store/files/version-%d.db %s",
             version, path);
    assert_int_equal(system(command), 0);
}

#endif
