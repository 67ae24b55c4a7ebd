/* test_storage_damage.c -- Tests the recovery of a damaged or missing database from its readable
 * entries and from its backup. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/store/storage.h"
#include "tests/unit/support/storage_fixture.h"

/* True if the replaced function opendir() fails. */
static bool cannot_list;

DIR *opendir(const char *path)
{
    if (cannot_list) {
        errno = EMFILE;
        return NULL;
    }
    const int handle = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return handle < 0 ? NULL : fdopendir(handle);
}

static void test_readable_entries_of_a_damaged_file_are_recovered(void **state)
{
    struct fixture *fixture = *state;
    char aside[160];
    fill_and_remove_mirror(fixture);
    damage_file(
        fixture,
        4096L * (query_number(fixture, "SELECT rootpage FROM sqlite_schema WHERE name = 'audits'") -
                 1));
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "damaged-1"));
    assert_non_null(strstr(text(fixture), "4 entries from the backup, 4 later ones"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
    assert_int_equal(load_state(fixture)->audits.count[AUDIT_CAUGHT], 36);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 8);
    path_beside(fixture, ".damaged-1", aside);
    assert_int_equal(access(aside, F_OK), 0);
    work_rounds(fixture, 9, 9);
}

/* The operator has acknowledged the file .damaged-1 and removed it. The next damaged file must get
 * the number 2. With the number 1, it would count as acknowledged. */
static void test_an_acknowledged_damage_does_not_hide_a_later_one(void **state)
{
    struct fixture *fixture = *state;
    char seen[160];
    path_beside(fixture, ".damaged-1.seen", seen);
    write_file(seen, "", 0);
    write_file(fixture->file, "nonsense", 8);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "damaged-2"));
}

static void test_a_damaged_entry_does_not_hide_later_entries(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    do_sql(fixture, "UPDATE entries SET tick = tick + 64 WHERE id = 6;"
                    "UPDATE audits SET count = 0 WHERE name = 'caught'");
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "4 entries from the backup, 3 later ones, 1 lost"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
    assert_int_equal(load_state(fixture)->audits.count[AUDIT_CAUGHT], 36 - 6);
    work_rounds(fixture, 9, 9);
}

static void test_a_damaged_newest_entry_falls_back_to_the_previous_one(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    do_sql(fixture, "UPDATE entries SET paid = paid + 64 WHERE id = 8");
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "4 entries from the backup, 3 later ones, 1 lost"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 7);
    work_rounds(fixture, 8, 8);
}

/* The entries of 300 coins need several pages of the database. After one page is damaged, the
 * entries of all other pages must be recovered. */
static void test_a_damaged_page_does_not_hide_other_pages(void **state)
{
    struct fixture *fixture = *state;
    open_without_thread(fixture);
    for (uint32_t id = 1; id <= 300; id++) {
        const struct ledger_entry coin = { .id = id,
                                           .boot = 1,
                                           .tick = 100 * id,
                                           .kind = LEDGER_COINS,
                                           .count = 1,
                                           .value = 1,
                                           .balance = { .paid = id } };
        assert_int_equal(fixture->device.ledger.ops->append(fixture->device.ledger.self, &coin),
                         HAL_OK);
        storage_work(&fixture->storage);
    }
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    remove_mirror(fixture);
    const long page = query_number(fixture, "SELECT pageno FROM dbstat WHERE name = 'entries' AND"
                                            " pagetype = 'leaf' ORDER BY path LIMIT 1 OFFSET 1");
    damage_file(fixture, 4096L * (page - 1));
    open_without_thread(fixture);
    assert_int_equal(load_state(fixture)->ledger.last_id, 300);
    assert_int_equal(load_state(fixture)->ledger.balance.paid, 300);
    const struct storage *storage = &fixture->storage;
    assert_int_equal(storage->from_backup + storage->salvaged.entries + storage->salvaged.lost,
                     300);
    assert_in_range(storage->salvaged.lost, 1, 150);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM entries"),
                     300 - storage->salvaged.lost);
}

static void test_an_unreadable_file_is_replaced_by_its_backup(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    damage_file(fixture, 0);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "4 entries from the backup, 0 later ones"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 4);
    work_rounds(fixture, 5, 6);
}

static void test_a_backup_of_an_earlier_version_is_migrated(void **state)
{
    struct fixture *fixture = *state;
    char command[256];
    snprintf(command, sizeof command,
             "cp tests/unit/platform/store/files/version-3.db %s" STORAGE_BACKUP_SUFFIX,
             fixture->file);
    assert_int_equal(system(command), 0);
    write_file(fixture->file, "no database, whatever it says", 29);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "9 entries from the backup"));
    assert_int_equal(load_state(fixture)->ledger.balance.paid, 2);
}

static void test_without_a_backup_a_new_database_is_created(void **state)
{
    struct fixture *fixture = *state;
    char backup[160];
    fill_and_remove_mirror(fixture);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    assert_int_equal(unlink(backup), 0);
    damage_file(fixture, 0);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "0 entries from the backup, 0 later ones"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 0);
}

/* A damaged backup must be renamed, because the next backup would overwrite it. */
static void test_a_damaged_backup_is_set_aside(void **state)
{
    struct fixture *fixture = *state;
    char backup[160], aside[160];
    fill_and_remove_mirror(fixture);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    write_file(backup, "no database, whatever it says", 29);
    damage_file(fixture,
                4096L * (query_number(fixture,
                                      "SELECT rootpage FROM sqlite_schema WHERE name = 'ranking'") -
                         1));
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "0 entries from the backup, 8 later ones"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
    assert_int_not_equal(access(backup, F_OK), 0);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX STORAGE_OTHER_SUFFIX "1", aside);
    struct stat about;
    assert_int_equal(stat(aside, &about), 0);
    assert_int_equal(about.st_size, 29);
}

/* A kiosk that makes its first backup before the first coin has a valid backup without entries. */
static void test_a_valid_backup_without_entries_is_used_and_not_set_aside(void **state)
{
    struct fixture *fixture = *state;
    char backup[160], aside[160], command[400];
    open_without_thread(fixture);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX, backup);
    snprintf(command, sizeof command, "cp %s %s", fixture->file, backup);
    assert_int_equal(system(command), 0);
    assert_int_equal(unlink(fixture->file), 0);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "missing: 0 entries from the backup, 0 later ones"));
    assert_int_equal(access(backup, F_OK), 0);
    path_beside(fixture, STORAGE_BACKUP_SUFFIX STORAGE_OTHER_SUFFIX "1", aside);
    assert_int_not_equal(access(aside, F_OK), 0);
    work_rounds(fixture, 1, 2);
}

static void test_a_missing_file_is_restored_from_its_backup(void **state)
{
    struct fixture *fixture = *state;
    fill_and_remove_mirror(fixture);
    assert_int_equal(unlink(fixture->file), 0);
    open_without_thread(fixture);
    assert_int_equal(load_state(fixture)->ledger.last_id, 4);
}

/* SQLite leaves logs beside the backup if the power is cut while an operator has opened the
 * backup. */
static void test_logs_beside_the_previous_backup_are_deleted(void **state)
{
    struct fixture *fixture = *state;
    static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
    char path[160];
    for (size_t i = 0; i < 3; i++) {
        path_beside(fixture, STORAGE_BACKUP_SUFFIX, path);
        write_file(strcat(path, suffixes[i]), "old log", 7);
    }
    fill_and_remove_mirror(fixture);
    for (size_t i = 0; i < 3; i++) {
        path_beside(fixture, STORAGE_BACKUP_SUFFIX, path);
        assert_int_not_equal(access(strcat(path, suffixes[i]), F_OK), 0);
    }
}

/* A damaged file system or a mistake of the operator can put a folder in the place of the
 * database. */
static void test_a_folder_in_place_of_the_database_is_quarantined(void **state)
{
    struct fixture *fixture = *state;
    char aside[160], inside[200];
    struct stat info;
    fill_and_remove_mirror(fixture);
    assert_int_equal(unlink(fixture->file), 0);
    assert_int_equal(mkdir(fixture->file, 0755), 0);
    snprintf(inside, sizeof inside, "%s/somebody's", fixture->file);
    write_file(inside, "words", 5);
    open_without_thread(fixture);
    assert_non_null(strstr(text(fixture), "damaged-1: 4 entries from the backup"));
    assert_int_equal(load_state(fixture)->ledger.last_id, 4);
    path_beside(fixture, ".damaged-1/somebody's", aside);
    assert_int_equal(stat(aside, &info), 0);
    assert_int_equal(info.st_size, 5);
    work_rounds(fixture, 5, 6);
}

/* The database is replaced by a link to itself, for which stat() fails. On a faulty card, stat()
 * can fail in the same way. */
static void test_a_file_whose_status_cannot_be_read_is_not_treated_as_missing(void **state)
{
    struct fixture *fixture = *state;
    char hidden[160];
    path_beside(fixture, "-hidden", hidden);
    fill_and_close(fixture);
    assert_int_equal(rename(fixture->file, hidden), 0);
    assert_int_equal(symlink(strrchr(fixture->file, '/') + 1, fixture->file), 0);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    memset(&fixture->storage, 0, sizeof fixture->storage);
    fixture->storage.dir = fixture->dir;
    fixture->storage.without_thread = true;
    assert_int_not_equal(open_store(fixture), HAL_OK);
    assert_int_equal(fixture->device.ledger.ops->is_healthy(fixture->device.ledger.self), 0);
    assert_int_equal(rename(hidden, fixture->file), 0); /* Moves the database back to its path. */
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    open_without_thread(fixture);
    assert_int_equal(load_state(fixture)->ledger.last_id, 8);
}

/* A number that is in use must not be chosen, because the file with this number would be replaced.
 */
static void test_a_folder_that_cannot_be_listed_replaces_no_quarantined_file(void **state)
{
    struct fixture *fixture = *state;
    char aside[160];
    struct stat about;
    fill_and_remove_mirror(fixture);
    path_beside(fixture, STORAGE_QUARANTINE_SUFFIX "1", aside);
    write_file(aside, "older", 5);
    damage_file(fixture, 0);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    fixture->storage = (struct storage){ .dir = fixture->dir, .without_thread = true };
    cannot_list = true;
    open_store(fixture);
    cannot_list = false;
    assert_int_equal(stat(aside, &about), 0);
    assert_int_equal(about.st_size, 5);
    assert_int_equal(fixture->device.ledger.ops->is_healthy(fixture->device.ledger.self), 0);
    /* Closing the store retries, and the folder can be listed again. */
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    assert_int_equal(stat(aside, &about), 0);
    assert_int_equal(about.st_size, 5);
    path_beside(fixture, STORAGE_QUARANTINE_SUFFIX "2", aside);
    assert_int_equal(access(aside, F_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_A_FOLDER(test_readable_entries_of_a_damaged_file_are_recovered),
        IN_A_FOLDER(test_an_acknowledged_damage_does_not_hide_a_later_one),
        IN_A_FOLDER(test_a_damaged_entry_does_not_hide_later_entries),
        IN_A_FOLDER(test_a_damaged_newest_entry_falls_back_to_the_previous_one),
        IN_A_FOLDER(test_a_damaged_page_does_not_hide_other_pages),
        IN_A_FOLDER(test_an_unreadable_file_is_replaced_by_its_backup),
        IN_A_FOLDER(test_a_backup_of_an_earlier_version_is_migrated),
        IN_A_FOLDER(test_without_a_backup_a_new_database_is_created),
        IN_A_FOLDER(test_a_damaged_backup_is_set_aside),
        IN_A_FOLDER(test_logs_beside_the_previous_backup_are_deleted),
        IN_A_FOLDER(test_a_valid_backup_without_entries_is_used_and_not_set_aside),
        IN_A_FOLDER(test_a_missing_file_is_restored_from_its_backup),
        IN_A_FOLDER(test_a_folder_that_cannot_be_listed_replaces_no_quarantined_file),
        IN_A_FOLDER(test_a_folder_in_place_of_the_database_is_quarantined),
        IN_A_FOLDER(test_a_file_whose_status_cannot_be_read_is_not_treated_as_missing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
