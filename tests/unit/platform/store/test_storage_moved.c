/* test_storage_moved.c -- Tests a data folder that is deleted, renamed, replaced or hidden by a
 * mount while the kiosk runs.
 *
 * The store must report the change within a second, even if nothing is written. Until the folder is
 * back, no entry may be acknowledged. */
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/store/storage.h"

/* Longest time until the store detects a change, in ms: one second, and half a second more for a
 * busy machine. */
#define WITHIN_MS 1500

static char top[64], dir[96], path[128];
static struct storage storage;
static struct hal_storage device;

static void begin(bool without_thread)
{
    storage = (struct storage){ .dir = dir, .without_thread = without_thread };
    device = storage_device(&storage);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
}

static int set_up(void **state)
{
    (void)state;
    strcpy(top, "/tmp/kingyo-moved-XXXXXX");
    if (!mkdtemp(top)) {
        return -1;
    }
    snprintf(dir, sizeof dir, "%s/data", top);
    snprintf(path, sizeof path, "%s/" STORAGE_FILE, dir);
    return 0;
}

static void do_shell(const char *text)
{
    char command[400];
    snprintf(command, sizeof command, "cd %s && %s", top, text);
    assert_int_equal(system(command), 0);
}

static int tear_down(void **state)
{
    (void)state;
    device.ledger.ops->close(device.ledger.self);
    do_shell("rm -rf /tmp/kingyo-moved-gone; cd / && rm -rf \"$OLDPWD\"");
    return 0;
}

static void pause_ms(long ms)
{
    nanosleep(&(struct timespec){ ms / 1000, ms % 1000 * 1000000L }, NULL);
}

static bool is_well(void)
{
    return device.ledger.ops->is_healthy(device.ledger.self);
}

static int keep(uint32_t id)
{
    const struct ledger_entry coin = { .id = id,
                                       .boot = 1,
                                       .tick = 100 * id,
                                       .kind = LEDGER_COINS,
                                       .count = 1,
                                       .value = 1,
                                       .balance = { .paid = id } };
    return device.ledger.ops->append(device.ledger.self, &coin);
}

static uint32_t saved_id(void)
{
    return device.ledger.ops->committed_id(device.ledger.self);
}

static void wait_until_well(int well, long most_ms)
{
    for (long ms = 0; ms < most_ms && is_well() != well; ms += 10) {
        pause_ms(10);
    }
    assert_int_equal(is_well(), well);
}

static void save_three(void)
{
    begin(false);
    for (uint32_t id = 1; id <= 3; id++) {
        assert_int_equal(keep(id), HAL_OK);
    }
    for (int i = 0; i < 500 && saved_id() < 3; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(), 3);
    pause_ms(300); /* Waits until the store has made its first backup. */
    assert_true(is_well());
}

/* Runs the shell command `what`. Asserts that the store reports a fault within WITHIN_MS, and
 * acknowledges no further entry. */
static void is_detected_after(const char *what)
{
    save_three();
    do_shell(what);
    wait_until_well(0, WITHIN_MS);
    const char *text = device.ledger.ops->describe(device.ledger.self);
    assert_non_null(strstr(text, "removed or replaced"));
    assert_non_null(strstr(text, "restart the kiosk"));
    keep(4);
    pause_ms(1100);
    assert_false(is_well());
    assert_int_equal(saved_id(), 3);
}

static void test_a_deleted_folder_is_detected_and_saved_at_the_end(void **state)
{
    (void)state;
    static struct persistent_state memory;
    is_detected_after("rm -rf data");
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    begin(true);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 4); /* Entry 4 was in the queue, and must be stored
                                                   too. */
    assert_int_equal(memory.audits.count[AUDIT_COINS_1], 4);
    assert_non_null(
        strstr(device.ledger.ops->describe(device.ledger.self), "kingyo.db was missing"));
}

static void test_a_recreated_folder_is_detected_and_saved_at_the_end(void **state)
{
    (void)state;
    static struct persistent_state memory;
    is_detected_after("rm -rf data && mkdir data");
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    begin(true);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 4);
}

static void test_a_folder_in_place_of_the_deleted_one_is_not_changed(void **state)
{
    (void)state;
    is_detected_after("rm -rf data && mkdir data && "
                      "cp $OLDPWD/tests/unit/platform/store/files/version-6.db data/kingyo.db");
    /* close() returns the number of lost entries. Only entry 4 is lost, and it was never
     * acknowledged. */
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 1);
    do_shell("cmp -s $OLDPWD/tests/unit/platform/store/files/version-6.db data/kingyo.db");
    begin(true);
}

static void test_a_renamed_folder_is_detected_and_used_after_its_return(void **state)
{
    (void)state;
    is_detected_after("mv data away");
    do_shell("mv away data");
    wait_until_well(1, WITHIN_MS);
    for (int i = 0; i < 200 && saved_id() < 4; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(), 4);
}

static void test_a_replaced_folder_is_detected_and_the_old_one_is_used_again(void **state)
{
    (void)state;
    struct stat about;
    is_detected_after("mv data away && mkdir data");
    /* The store must not create a new database in the folder that replaces the data folder. */
    assert_int_equal(stat(path, &about), -1);
    do_shell("rmdir data && mv away data");
    wait_until_well(1, WITHIN_MS);
}

static void test_a_foreign_database_folder_in_its_place_is_detected(void **state)
{
    (void)state;
    save_three();
    do_shell("mv data away && mkdir data && "
             "cp $OLDPWD/tests/unit/platform/store/files/version-6.db data/kingyo.db");
    wait_until_well(0, WITHIN_MS);
    keep(4);
    pause_ms(1100);
    assert_false(is_well());
    assert_int_equal(saved_id(), 3);
}

static void test_a_deleted_or_replaced_file_is_detected(void **state)
{
    (void)state;
    is_detected_after("rm data/kingyo.db");
    device.ledger.ops->close(device.ledger.self);
    do_shell("rm -rf data");
    is_detected_after("mv data/kingyo.db data/old && cp data/old data/kingyo.db && "
                      "rm data/old data/kingyo.db-*");
}

/* Only the database is deleted, or the database and its mirror. The folder keeps a backup that has
 * fewer entries. */
static void test_a_database_deleted_beside_its_backup_is_saved_at_the_end(void **state)
{
    (void)state;
    static struct persistent_state memory;
    static const char *const commands[] = { "rm data/kingyo.db",
                                            "rm data/kingyo.db data/kingyo.db.tail" };
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        begin(true);
        keep(1);
        storage_work(&storage); /* Also makes the backup. */
        keep(2);
        storage_work(&storage);
        assert_int_equal(saved_id(), 2);
        do_shell("test -s data/kingyo.db.backup");
        do_shell(commands[i]);
        storage_work(&storage);
        assert_false(is_well());
        keep(3);
        storage_work(&storage);
        assert_int_equal(saved_id(), 2);
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
        begin(true);
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(memory.ledger.last_id, 3);
        assert_int_equal(memory.audits.count[AUDIT_COINS_1], 3);
        device.ledger.ops->close(device.ledger.self);
        do_shell("rm -rf data");
    }
}

static void test_a_deleted_log_is_detected_and_loses_nothing(void **state)
{
    (void)state;
    static struct persistent_state memory;
    begin(true);
    keep(1);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
    do_shell("rm data/kingyo.db-wal");
    keep(2);
    storage_work(&storage);
    storage_work(&storage);
    assert_int_equal(saved_id(), 2);
    do_shell("rm -f data/kingyo.db-wal.lost");
    device.ledger.ops->close(device.ledger.self);
    begin(true);
    device.ledger.ops->load(device.ledger.self, &memory);
    assert_int_equal(memory.ledger.last_id, 2);
}

static void test_a_deleted_log_is_reported_and_the_database_is_reopened(void **state)
{
    (void)state;
    static struct persistent_state memory;
    save_three();
    const uint32_t refused = device.ledger.ops->failed_count(device.ledger.self);
    do_shell("rm data/kingyo.db-wal");
    wait_until_well(0, WITHIN_MS);
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self), "removed or replaced"));
    assert_true(device.ledger.ops->failed_count(device.ledger.self) > refused);
    keep(4);
    wait_until_well(1, 2 * WITHIN_MS);
    for (int i = 0; i < 200 && saved_id() < 4; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(), 4);
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    begin(true);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 4);
}

static void test_a_log_deleted_right_before_the_end_loses_nothing(void **state)
{
    (void)state;
    static struct persistent_state memory;
    begin(true);
    keep(1);
    storage_work(&storage);
    keep(2);
    do_shell("rm data/kingyo.db-wal");
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
    begin(true);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 2);
}

static void test_an_entry_in_a_deleted_file_is_not_acknowledged(void **state)
{
    (void)state;
    begin(true);
    keep(1);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
    /* The folder is moved, and an entry is appended before the next check of the folder. */
    do_shell("mv data away");
    keep(2);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
    assert_false(is_well());
    do_shell("mv away data");
    storage_work(&storage);
    assert_true(is_well());
    assert_int_equal(saved_id(), 2);
}

/* The test mounts a file system in its own mount namespace. The test is skipped if it has no
 * permission to create a namespace. */
static void test_a_mount_over_the_folder_is_detected(void **state)
{
    (void)state;
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0) {
        skip();
    }
    save_three();
    assert_int_equal(mount("none", dir, "tmpfs", 0, NULL), 0);
    wait_until_well(0, WITHIN_MS);
    keep(4);
    pause_ms(1100);
    assert_false(is_well());
    assert_int_equal(saved_id(), 3);
    assert_int_equal(umount(dir), 0);
    wait_until_well(1, WITHIN_MS);
    for (int i = 0; i < 200 && saved_id() < 4; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(), 4);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_a_deleted_folder_is_detected_and_saved_at_the_end),
        TEST(test_a_recreated_folder_is_detected_and_saved_at_the_end),
        TEST(test_a_folder_in_place_of_the_deleted_one_is_not_changed),
        TEST(test_a_renamed_folder_is_detected_and_used_after_its_return),
        TEST(test_a_replaced_folder_is_detected_and_the_old_one_is_used_again),
        TEST(test_a_foreign_database_folder_in_its_place_is_detected),
        TEST(test_a_deleted_or_replaced_file_is_detected),
        TEST(test_a_database_deleted_beside_its_backup_is_saved_at_the_end),
        TEST(test_a_deleted_log_is_detected_and_loses_nothing),
        TEST(test_a_deleted_log_is_reported_and_the_database_is_reopened),
        TEST(test_a_log_deleted_right_before_the_end_loses_nothing),
        TEST(test_an_entry_in_a_deleted_file_is_not_acknowledged),
        TEST(test_a_mount_over_the_folder_is_detected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
