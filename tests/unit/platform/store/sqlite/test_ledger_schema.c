/* test_ledger_schema.c -- Tests that a database of any version is rejected if it has an unknown
 * schema object, such as a trigger. Also tests that an insert that stores nothing is an error. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/sql.h"
#include "tests/unit/support/ledger_fixture.h"

static const char *const additions[] = {
    "CREATE TRIGGER t BEFORE INSERT ON rounds BEGIN SELECT RAISE(IGNORE); END",
    "CREATE TRIGGER t AFTER UPDATE ON rounds BEGIN DELETE FROM rounds; END",
    "CREATE VIEW v AS SELECT 1",
    "CREATE INDEX i ON rounds (seed)",
    "CREATE TABLE others (number)",
    "CREATE VIRTUAL TABLE others USING fts5 (text)",
    "ALTER TABLE rounds ADD COLUMN others TEXT",
    "ALTER TABLE rounds RENAME COLUMN seed TO seeds",
    "ANALYZE",
    "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, 'seed INTEGER',"
    " 'seed INTEGER CHECK (abs(seed) >= 0)') WHERE name = 'rounds'",
    "PRAGMA writable_schema = ON;"
    " UPDATE sqlite_schema SET sql = replace(sql, 'INTEGER', 'integer')",
    "PRAGMA writable_schema = ON; DELETE FROM sqlite_schema WHERE rowid ="
    " (SELECT max(rowid) FROM sqlite_schema)",
};
#define ADDITION_COUNT (sizeof additions / sizeof additions[0])

static void test_a_foreign_schema_object_is_rejected_in_every_version(void **state)
{
    (void)state;
    for (int version = 1; version <= LEDGER_FILE_VERSION; version++) {
        for (size_t i = 0; i < ADDITION_COUNT; i++) {
            take_version(version);
            if (i + 1u == ADDITION_COUNT && version == 1) {
                /* Version 1 has only one table. A file without this table would count as a new
                 * file. */
                continue;
            }
            do_sql(additions[i]);
            assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
            assert_null(file.db);
            assert_int_equal(ledger_file_inspect(&file, path), SQLITE_CORRUPT);
            assert_null(file.db);
        }
    }
}

static void test_every_version_opens_and_is_migrated_to_the_exact_schema(void **state)
{
    (void)state;
    for (int version = 1; version <= LEDGER_FILE_VERSION; version++) {
        take_version(version);
        for (int i = 0; i < 2; i++) {
            assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
            assert_int_equal(ledger_check(file.db), SQLITE_OK);
            ledger_file_close(&file);
        }
        assert_int_equal(ledger_file_inspect(&file, path), SQLITE_OK);
        ledger_file_close(&file);
    }
}

static void test_the_first_foreign_schema_object_is_named(void **state)
{
    (void)state;
    static const struct {
        size_t addition;
        const char *type, *name;
        bool is_changed;
    } cases[] = { { 0, "trigger", "t", false },   { 2, "view", "v", false },
                  { 3, "index", "i", false },     { 4, "table", "others", false },
                  { 6, "table", "rounds", true }, { 9, "table", "rounds", true } };
    for (int version = 1; version <= LEDGER_FILE_VERSION; version++) {
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            struct ledger_foreign foreign;
            sqlite3 *db;
            take_version(version);
            assert_int_equal(sql_open(path, SQLITE_OPEN_READONLY, NULL, &db), SQLITE_OK);
            assert_false(ledger_schema_foreign(db, &foreign));
            sqlite3_close(db);
            do_sql(additions[cases[i].addition]);
            assert_int_equal(sql_open(path, SQLITE_OPEN_READONLY, NULL, &db), SQLITE_OK);
            assert_true(ledger_schema_foreign(db, &foreign));
            sqlite3_close(db);
            assert_string_equal(foreign.type, cases[i].type);
            assert_string_equal(foreign.name, cases[i].name);
            assert_int_equal(foreign.is_changed, cases[i].is_changed);
        }
    }
}

static void test_an_unknown_schema_version_is_rejected(void **state)
{
    (void)state;
    static const char *const versions[] = { "PRAGMA user_version = -1", "PRAGMA user_version = 2",
                                            "PRAGMA user_version = 3", "PRAGMA user_version = 0" };
    for (size_t i = 0; i < sizeof versions / sizeof versions[0]; i++) {
        take_version(LEDGER_FILE_VERSION);
        do_sql(versions[i]);
        assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
    }
}

static void test_an_insert_that_stores_nothing_is_an_error(void **state)
{
    (void)state;
    const int64_t number = 7;
    int64_t count = -1;
    sqlite3 *db;
    sqlite3_stmt *put;
    do_sql("CREATE TABLE numbers (number); CREATE TRIGGER t BEFORE INSERT ON numbers"
           " BEGIN SELECT RAISE(IGNORE); END");
    /* Normally, SQLite runs the trigger, which discards each insert. */
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    sqlite3_prepare_v2(db, "INSERT INTO numbers VALUES (?)", -1, &put, NULL);
    assert_int_equal(sql_put_one(put, &number, 1), SQLITE_CORRUPT);
    assert_int_equal(sql_put(put, &number, 1), SQLITE_OK);
    sqlite3_finalize(put);
    sqlite3_close(db);
    assert_int_equal(sql_open(path, SQLITE_OPEN_READWRITE, NULL, &db), SQLITE_OK);
    sqlite3_prepare_v2(db, "INSERT INTO numbers VALUES (?)", -1, &put, NULL);
    /* sql_open() has disabled triggers, so the insert succeeds. */
    assert_int_equal(sql_put_one(put, &number, 1), SQLITE_OK);
    sqlite3_finalize(put);
    assert_int_equal(sql_number(db, "SELECT count(*) FROM numbers", &count), SQLITE_OK);
    assert_int_equal(count, 1);
    sqlite3_close(db);
}

/* Another program adds a trigger while the file is open. The trigger must not run, and a backup
 * must reject the changed schema. */
static void test_a_trigger_added_while_open_drops_no_entry(void **state)
{
    (void)state;
    const struct ledger_entry coin = { .id = 1, .boot = 1, .kind = LEDGER_COINS, .count = 1 };
    struct ledger_entry found;
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    do_sql("CREATE TRIGGER t BEFORE INSERT ON entries BEGIN SELECT RAISE(IGNORE); END");
    assert_int_equal(ledger_file_write(&file, &coin, 1), SQLITE_OK);
    assert_int_equal(ledger_file_entry(&file, 1, &found), SQLITE_OK);
    char copy[80];
    snprintf(copy, sizeof copy, "%s.copy", path);
    assert_int_equal(ledger_backup_make(&file, copy, false), SQLITE_CORRUPT);
    assert_int_equal(access(copy, F_OK), -1);
}

static void test_the_defensive_options_of_sqlite_are_enabled(void **state)
{
    (void)state;
    static const struct {
        int option, value;
    } options[] = {
        { SQLITE_DBCONFIG_DEFENSIVE, 1 },      { SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0 },
        { SQLITE_DBCONFIG_ENABLE_TRIGGER, 0 }, { SQLITE_DBCONFIG_ENABLE_VIEW, 0 },
        { SQLITE_DBCONFIG_DQS_DML, 0 },        { SQLITE_DBCONFIG_DQS_DDL, 0 },
    };
    int64_t number = -1;
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        int value = -1;
        sqlite3_db_config(file.db, options[i].option, -1, &value);
        assert_int_equal(value, options[i].value);
    }
    assert_int_equal(sql_number(file.db, "PRAGMA trusted_schema", &number), SQLITE_OK);
    assert_int_equal(number, 0);
    assert_int_equal(sql_number(file.db, "PRAGMA cell_size_check", &number), SQLITE_OK);
    assert_int_equal(number, 1);
    assert_int_not_equal(sql_run(file.db, "ATTACH '/tmp/kingyo-never.db' AS other"), SQLITE_OK);
}

/* ---- Tests of files other than regular files ------------------------------------------------ */

static void is_refused(const char *name)
{
    alarm(10); /* alarm() ends the test if opening a FIFO blocks. */
    assert_int_not_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    ledger_file_close(&file);
    assert_int_not_equal(ledger_file_inspect(&file, path), SQLITE_OK);
    alarm(0);
    assert_int_equal(unlink(name), 0);
}

static void test_only_regular_files_are_opened_as_a_database(void **state)
{
    (void)state;
    unlink(path);
    assert_int_equal(mkfifo(path, 0600), 0);
    is_refused(path);
    assert_int_equal(symlink("/dev/zero", path), 0);
    is_refused(path);
    assert_int_equal(symlink("tests/unit/platform/store/files/version-6.db", path), 0);
    is_refused(path);
    take_version(LEDGER_FILE_VERSION);
}

/* Asserts that the database cannot be opened, or can only be read, if its log `name` is not a
 * regular file. */
static void cannot_be_written(const char *name)
{
    alarm(10); /* alarm() ends the test if opening a FIFO blocks. */
    const int code = ledger_file_open(&file, path, NULL);
    assert_true(code != SQLITE_OK || file.refusal != 0);
    ledger_file_close(&file);
    ledger_file_inspect(&file, path);
    ledger_file_close(&file);
    alarm(0);
    assert_int_equal(unlink(name), 0);
}

static void test_only_regular_files_are_opened_beside_the_database(void **state)
{
    (void)state;
    static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
    for (size_t i = 0; i < 3; i++) {
        char name[80], target[80];
        struct stat about;
        snprintf(name, sizeof name, "%s%s", path, suffixes[i]);
        snprintf(target, sizeof target, "%s.foreign", path);
        take_version(LEDGER_FILE_VERSION);
        assert_int_equal(mkfifo(name, 0600), 0);
        cannot_be_written(name);
        take_version(LEDGER_FILE_VERSION);
        assert_int_equal(symlink(target, name), 0);
        cannot_be_written(name);
        /* SQLite must not create a file through the link. */
        assert_int_equal(stat(target, &about), -1);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_a_foreign_schema_object_is_rejected_in_every_version),
        TEST(test_every_version_opens_and_is_migrated_to_the_exact_schema),
        TEST(test_an_unknown_schema_version_is_rejected),
        TEST(test_the_first_foreign_schema_object_is_named),
        TEST(test_an_insert_that_stores_nothing_is_an_error),
        TEST(test_a_trigger_added_while_open_drops_no_entry),
        TEST(test_the_defensive_options_of_sqlite_are_enabled),
        TEST(test_only_regular_files_are_opened_as_a_database),
        TEST(test_only_regular_files_are_opened_beside_the_database),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
