/* test_storage_replacement.c -- Tests which database is used if there are several, for example
 * after a replacement of the database was interrupted. An interrupted replacement must be
 * completed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/store/storage.h"
#include "tests/unit/support/storage_fixture.h"

static int last_id_of(const char *path)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, "SELECT max(id) FROM entries", -1, &statement, NULL),
                     SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

/* Opens a database with fewer entries than its backup. Asserts that this database is quarantined
 * and that its backup replaces it. */
static void continues_from_backup(struct fixture *fixture)
{
    char backup[160], aside[160];
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "4 entries from the backup, 0 later ones"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 4);
    path_beside(fixture, ".damaged-1", aside);
    assert_int_equal(access(aside, F_OK), 0);
    storage_work(&fixture->storage);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    assert_int_equal(last_id_of(backup), 4);
}

static void test_an_empty_file_with_a_backup_is_damage(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    assert_int_equal(truncate(fixture->file, 0), 0);
    continues_from_backup(fixture);
}

static void test_a_file_with_fewer_entries_than_its_backup_is_damage(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    do_sql(fixture, "DELETE FROM entries WHERE id > 3");
    continues_from_backup(fixture);
}

/* An operator makes a copy with `kingyoctl backup`. Later the operator restores the copy by
 * renaming it to the database, as the help text describes. */
static void test_a_restored_copy_is_used(void **state)
{
    struct fixture *fixture = *state;
    char copy[160], backup[160], before[160];
    path_beside(fixture, "-copy", copy);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    path_beside(fixture, STORAGE_BEFORE_SUFFIX, before);
    open_without_thread(fixture);
    work_rounds(fixture, 1, 2);
    assert_int_equal(ledger_backup_make(&fixture->storage.file, copy, true), SQLITE_OK);
    work_rounds(fixture, 3, 4);
    fixture->storage.backup_due_s = 0;
    storage_work(&fixture->storage);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    assert_int_equal(last_id_of(backup), 4);
    assert_int_equal(rename(copy, fixture->file), 0);
    open_without_thread(fixture);
    assert_null(strstr(text(fixture), "damaged"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 2);
    storage_work(&fixture->storage);
    assert_int_equal(last_id_of(backup), 2);
    assert_int_equal(last_id_of(before), 4);
    work_rounds(fixture, 3, 5);
    fixture->storage.backup_due_s = 0;
    storage_work(&fixture->storage);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    /* Deletes entries. The database then has fewer entries than the backup without being a copy of
     * the backup, so it counts as damaged. */
    do_sql(fixture, "DELETE FROM entries WHERE id > 3");
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "damaged-1"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 5);
}

static void test_a_log_without_its_database_is_quarantined(void **state)
{
    struct fixture *fixture = *state;
    char log[160];
    write_file(fixture->file, "", 0);
    path_beside(fixture, "-wal", log);
    write_file(log, "of a file that is no more", 25);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "damaged-1"));
    path_beside(fixture, ".damaged-1-wal", log);
    assert_int_equal(access(log, F_OK), 0);
}

static void test_a_backup_is_not_overwritten_by_a_file_with_fewer_entries(void **state)
{
    struct fixture *fixture = *state;
    char backup[160];
    fill_and_close(fixture);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    open_without_thread(fixture);
    /* Reduces the newest id in memory, as if an older file had replaced the database. */
    fixture->storage.file.content.memory.ledger.last_id = 3;
    storage_work(&fixture->storage);
    assert_int_equal(last_id_of(backup), 4);
    assert_int_equal(fixture->device.ledger.ops->failed_count(fixture->device.ledger.self), 1);
}

/* Each of these changes damages the name of one column in the stored schema. */
static void test_altered_tables_are_damage(void **state)
{
    struct fixture *fixture = *state;
    static const char *const flips[] = {
        "UPDATE sqlite_schema SET sql = replace(sql, 'bonus_units', 'bonus_ujits')",
        "UPDATE sqlite_schema SET sql = replace(sql, 'count INTEGER', 'cou~t INTEGER')",
        "UPDATE sqlite_schema SET sql = replace(sql, 'seat INTEGER', 'sdat INTEGER')",
    };
    for (size_t i = 0; i < sizeof flips / sizeof flips[0]; i++) {
        char command[160];
        sqlite3 *db;
        snprintf(command, sizeof command, "rm -f %s*", fixture->file);
        fixture->device.ledger.ops->close(fixture->device.ledger.self);
        assert_int_equal(system(command), 0);
        fill_and_close(fixture);
        sqlite3_open(fixture->file, &db);
        sqlite3_exec(db, "PRAGMA writable_schema = ON", 0, 0, 0);
        assert_int_equal(sqlite3_exec(db, flips[i], 0, 0, 0), 0);
        sqlite3_close(db);
        open_without_thread(fixture);
        assert_non_null(strstr(text(fixture), "damaged-1"));
        assert_true(load_state(fixture)->ledger.last_id >= 4);
        work_rounds(fixture, 9, 9);
    }
}

static void test_an_interrupted_replacement_is_completed(void **state)
{
    struct fixture *fixture = *state;
    char fresh[160], log[160], aside[160];
    fill_and_close(fixture);
    path_beside(fixture, STORAGE_NEW_SUFFIX, fresh);
    path_beside(fixture, "-wal", log);
    /* Simulates a power cut during a replacement. The old database is already quarantined, but the
     * new one has not been renamed yet. */
    assert_int_equal(rename(fixture->file, fresh), 0);
    write_file(log, "of the damaged one", 18); /* The log of the quarantined database is still in
                                                  the folder. */
    open_without_thread(fixture);
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
    path_beside(fixture, ".damaged-1-wal", aside);
    assert_int_equal(access(aside, F_OK), 0);
    assert_int_equal(access(fresh, F_OK), -1);
}

static void test_an_incomplete_replacement_file_is_discarded(void **state)
{
    struct fixture *fixture = *state;
    char fresh[160];
    fill_and_close(fixture);
    path_beside(fixture, STORAGE_NEW_SUFFIX, fresh);
    write_file(fresh, "half", 4);
    open_without_thread(fixture);
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
    assert_int_equal(access(fresh, F_OK), -1);
}

static void test_damage_at_run_time_is_recovered_as_at_the_start(void **state)
{
    struct fixture *fixture = *state;
    open_without_thread(fixture);
    work_rounds(fixture, 1, 4);
    work_rounds(fixture, 5, 8);
    sqlite3_wal_checkpoint_v2(fixture->storage.file.db, NULL, SQLITE_CHECKPOINT_TRUNCATE, NULL,
                              NULL);
    sqlite3_db_release_memory(fixture->storage.file.db);
    damage_file(
        fixture,
        4096L * (query_number(fixture, "SELECT rootpage FROM sqlite_schema WHERE name = 'audits'") -
                 1));
    save(fixture, 9, 9, 0);
    for (int i = 0; i < 3; i++) {
        storage_work(&fixture->storage);
    }
    assert_int_equal(saved_id(fixture), 9);
    assert_non_null(strstr(text(fixture), "damaged-1"));
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 9);
}

static void test_a_store_out_of_memory_reports_it_and_retries(void **state)
{
    struct fixture *fixture = *state;
    open_without_thread(fixture);
    work_rounds(fixture, 1, 1);
    sqlite3_db_release_memory(fixture->storage.file.db);
    sqlite3_hard_heap_limit64(sqlite3_memory_used() + 512);
    assert_int_equal(save(fixture, 2, 2, 0), HAL_OK);
    storage_work(&fixture->storage);
    assert_int_equal(saved_id(fixture), 1);
    assert_int_equal(fixture->device.ledger.ops->is_healthy(fixture->device.ledger.self), 0);
    assert_non_null(strstr(text(fixture), "out of memory"));
    sqlite3_hard_heap_limit64(STORAGE_HEAP_MAX);
    storage_work(&fixture->storage);
    assert_int_equal(saved_id(fixture), 2);
    assert_int_equal(fixture->device.ledger.ops->is_healthy(fixture->device.ledger.self), 1);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 2);
}

static void test_a_second_damaged_file_does_not_replace_the_first(void **state)
{
    struct fixture *fixture = *state;
    char first[128], second[128];
    snprintf(first, sizeof first, "%s.damaged-1", fixture->file);
    snprintf(second, sizeof second, "%s.damaged-2", fixture->file);
    write_file(first, "kept", 4);
    write_file(fixture->file, "this was never a database", 25);
    assert_int_equal(open_store(fixture), HAL_OK);
    struct stat info;
    assert_int_equal(stat(first, &info), 0);
    assert_int_equal(info.st_size, 4);
    assert_int_equal(access(second, F_OK), 0);
}

/* A number that does not fit 32 bits after it is increased must not wrap to a number in use. */
static void test_a_huge_number_in_a_file_name_leads_to_no_overwritten_file(void **state)
{
    struct fixture *fixture = *state;
    static const char *const numbers[] = { "4294967295", "18446744073709551615", "0" };
    char path[160];
    struct stat info;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        snprintf(path, sizeof path, "%s" STORAGE_QUARANTINE_SUFFIX "%s", fixture->file, numbers[i]);
        write_file(path, "kept", 4);
    }
    write_file(fixture->file, "this was never a database", 25);
    assert_int_equal(open_store(fixture), HAL_OK);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        snprintf(path, sizeof path, "%s" STORAGE_QUARANTINE_SUFFIX "%s", fixture->file, numbers[i]);
        assert_int_equal(stat(path, &info), 0);
        assert_int_equal(info.st_size, 4);
    }
    snprintf(path, sizeof path, "%s" STORAGE_QUARANTINE_SUFFIX "1", fixture->file);
    assert_int_equal(stat(path, &info), 0);
    assert_int_equal(info.st_size, 25);
}

static void test_a_file_of_a_later_version_is_reported_and_not_changed(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    sqlite3 *db;
    sqlite3_open(fixture->file, &db);
    assert_int_equal(sqlite3_exec(db, "PRAGMA user_version = 99", 0, 0, 0), 0);
    sqlite3_close(db);
    assert_int_equal(open_store(fixture), HAL_ERR_IO);
    assert_non_null(strstr(text(fixture), "a later Kingyo wrote it"));
    assert_int_equal(query_number(fixture, "PRAGMA user_version"), 99);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_A_FOLDER(test_an_empty_file_with_a_backup_is_damage),
        IN_A_FOLDER(test_a_file_with_fewer_entries_than_its_backup_is_damage),
        IN_A_FOLDER(test_a_restored_copy_is_used),
        IN_A_FOLDER(test_a_log_without_its_database_is_quarantined),
        IN_A_FOLDER(test_a_backup_is_not_overwritten_by_a_file_with_fewer_entries),
        IN_A_FOLDER(test_altered_tables_are_damage),
        IN_A_FOLDER(test_an_interrupted_replacement_is_completed),
        IN_A_FOLDER(test_an_incomplete_replacement_file_is_discarded),
        IN_A_FOLDER(test_damage_at_run_time_is_recovered_as_at_the_start),
        IN_A_FOLDER(test_a_store_out_of_memory_reports_it_and_retries),
        IN_A_FOLDER(test_a_second_damaged_file_does_not_replace_the_first),
        IN_A_FOLDER(test_a_huge_number_in_a_file_name_leads_to_no_overwritten_file),
        IN_A_FOLDER(test_a_file_of_a_later_version_is_reported_and_not_changed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
