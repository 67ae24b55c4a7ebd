/* test_storage.c -- Tests that finished rounds are stored. A fault of the disk must give a message
 * and must not stop the kiosk. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
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

static void test_a_saved_round_is_stored_with_every_field(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    assert_int_equal(saved_id(fixture), 0);
    assert_int_equal(save(fixture, 1, 5, 0), HAL_OK);
    wait_until_saved(fixture, 1);
    assert_int_equal(query_number(fixture,
                                  "SELECT count(*) FROM rounds WHERE entry = 1 AND seed = 7 AND"
                                  " start_tick = 120 AND end_tick = 7320 AND caught = 5 AND"
                                  " by_bot = 0 AND day = 9821"),
                     1);
}

static void test_the_next_start_loads_the_state_of_the_last_run(void **state)
{
    struct fixture *fixture = *state;
    static struct persistent_state memory;
    assert_int_equal(open_store(fixture), HAL_OK);
    assert_int_equal(fixture->device.ledger.ops->load(fixture->device.ledger.self, &memory),
                     HAL_OK);
    assert_int_equal(memory.ledger.last_id, 0);
    assert_int_equal(memory.ledger.boots, 1);
    const struct ledger_entry coin = { .id = 1,
                                       .boot = 1,
                                       .kind = LEDGER_COINS,
                                       .count = 1,
                                       .value = 1,
                                       .balance = { .units = 2, .paid = 3 } };
    fixture->device.ledger.ops->append(fixture->device.ledger.self, &coin);
    save(fixture, 2, 4, 0);
    wait_until_saved(fixture, 2);
    reopen(fixture);
    assert_int_equal(saved_id(fixture), 2);
    assert_int_equal(fixture->device.ledger.ops->load(fixture->device.ledger.self, &memory),
                     HAL_OK);
    assert_int_equal(memory.ledger.last_id, 2);
    assert_int_equal(memory.ledger.boots, 2);
    assert_int_equal(memory.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 4);
}

static void test_a_round_appended_every_frame_is_stored_once(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    for (int frame = 0; frame < 100; frame++) {
        assert_int_equal(save(fixture, 1, 2, 0), HAL_OK);
    }
    wait_until_saved(fixture, 1);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 1);
}

static void test_closing_writes_the_queued_entries(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    for (uint32_t id = 1; id <= 5; id++) {
        assert_int_equal(save(fixture, id, id, 0), HAL_OK);
    }
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 5);
}

/* Another program has locked the database. append() must not block. When the queue is full,
 * append() must return HAL_ERR_BUSY, and no queued entry may be lost. */
static void test_a_blocked_card_never_blocks_a_frame(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    sqlite3 *other;
    sqlite3_open(fixture->file, &other);
    assert_int_equal(sqlite3_exec(other, "BEGIN EXCLUSIVE", 0, 0, 0), SQLITE_OK);

    struct timespec before, after;
    clock_gettime(CLOCK_MONOTONIC, &before);
    uint32_t id = 1;
    while (id <= STORAGE_QUEUE_MAX) {
        assert_int_equal(save(fixture, id, id, 0), HAL_OK);
        id++;
    }
    assert_int_equal(save(fixture, id, id, 0), HAL_ERR_BUSY);
    clock_gettime(CLOCK_MONOTONIC, &after);
    const double ms = (double)(after.tv_sec - before.tv_sec) * 1e3 +
                      (double)(after.tv_nsec - before.tv_nsec) * 1e-6;
    assert_true(ms < 100.0); /* A wait for the lock takes 2 s, so none of the 65 calls has
                                waited. */
    assert_int_equal(saved_id(fixture), 0);

    sqlite3_exec(other, "ROLLBACK", 0, 0, 0);
    sqlite3_close(other);
    wait_until_saved(fixture, STORAGE_QUEUE_MAX);
    assert_int_equal(save(fixture, id, id, 0), HAL_OK);
    wait_until_saved(fixture, id);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), (int)id);
}

static void test_unwritten_rounds_are_counted_and_reported(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    sqlite3 *other;
    sqlite3_open(fixture->file, &other);
    assert_int_equal(sqlite3_exec(other, "BEGIN EXCLUSIVE", 0, 0, 0), SQLITE_OK);
    save(fixture, 1, 4, 0);
    save(fixture, 2, 5, 0);
    for (int i = 0;
         i < 500 && fixture->device.ledger.ops->failed_count(fixture->device.ledger.self) == 0;
         i++) {
        pause_ms(10);
    }
    assert_true(fixture->device.ledger.ops->failed_count(fixture->device.ledger.self) > 0);
    assert_non_null(strstr(text(fixture), "2 entries not written"));
    assert_non_null(strstr(text(fixture), "locked"));
    assert_int_equal(fixture->device.ledger.ops->close(fixture->device.ledger.self), 2);
    assert_non_null(strstr(text(fixture), "lost"));
    sqlite3_exec(other, "ROLLBACK", 0, 0, 0);
    sqlite3_close(other);
    assert_int_equal(query_number(fixture, "SELECT count(*) FROM rounds"), 0);
}

static void test_the_data_folder_is_created_if_possible(void **state)
{
    struct fixture *fixture = *state;
    char dir[160];
    snprintf(dir, sizeof dir, "%s/not/there/yet", fixture->dir);
    fixture->storage.dir = dir;
    assert_int_equal(open_store(fixture), HAL_OK);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);

    memset(&fixture->storage, 0, sizeof fixture->storage);
    write_file(fixture->file, "", 0);
    snprintf(dir, sizeof dir, "%s/below-a-file", fixture->file);
    fixture->storage.dir = dir;
    assert_int_equal(open_store(fixture), HAL_ERR_IO);
    assert_non_null(strstr(text(fixture), "no store"));
    assert_non_null(strstr(text(fixture), "make that folder"));
}

static void test_an_unwritable_folder_gives_a_one_line_message(void **state)
{
    struct fixture *fixture = *state;
    fixture->storage.dir = "/proc"; /* /proc does not allow new files, even for root. */
    assert_int_equal(open_store(fixture), HAL_ERR_IO);
    assert_non_null(strstr(text(fixture), "/proc"));
    assert_null(strchr(text(fixture), '\n'));
    static struct persistent_state memory;
    assert_int_equal(save(fixture, 1, 1, 0), HAL_ERR_ABSENT);
    assert_int_equal(fixture->device.ledger.ops->load(fixture->device.ledger.self, &memory),
                     HAL_ERR_ABSENT);
    assert_int_equal(saved_id(fixture), 0);
}

static void test_a_missing_data_option_is_reported(void **state)
{
    struct fixture *fixture = *state;
    fixture->storage.dir = NULL;
    assert_int_equal(open_store(fixture), HAL_ERR_ABSENT);
    assert_non_null(strstr(text(fixture), "--data"));
}

static void test_a_file_that_is_not_a_database_is_quarantined(void **state)
{
    struct fixture *fixture = *state;
    char junk[4096], aside[128];
    memset(junk, 'x', sizeof junk);
    write_file(fixture->file, junk, sizeof junk);
    assert_int_equal(open_store(fixture), HAL_OK);
    assert_non_null(strstr(text(fixture), "damaged"));
    snprintf(aside, sizeof aside, "%s.damaged-1", fixture->file);
    struct stat info;
    assert_int_equal(stat(aside, &info), 0);
    assert_int_equal(info.st_size, sizeof junk); /* The junk was moved to the quarantined file with
                                                    all its bytes. */
    save(fixture, 1, 1, 0);
    wait_until_saved(fixture, 1);
}

static void test_sqlite_has_a_hard_memory_limit(void **state)
{
    struct fixture *fixture = *state;
    assert_int_equal(open_store(fixture), HAL_OK);
    assert_int_equal(sqlite3_hard_heap_limit64(-1), STORAGE_HEAP_MAX);
    save(fixture, 1, 1, 0);
    wait_until_saved(fixture, 1);
    assert_true(sqlite3_memory_highwater(0) < STORAGE_HEAP_MAX / 8);
}

static bool has_replay(const struct fixture *fixture, uint32_t round_id)
{
    return fixture->device.replays.ops->has(fixture->device.replays.self, round_id);
}

static void test_a_ranked_round_has_a_seal_while_its_replay_is_stored(void **state)
{
    struct fixture *fixture = *state;
    static const uint8_t bytes[64] = { 1, 2, 3 };
    open_without_thread(fixture);
    assert_int_equal(save(fixture, 1, 5, 0), HAL_OK);
    storage_work(&fixture->storage);
    assert_false(has_replay(fixture, 1));
    assert_int_equal(
        fixture->device.replays.ops->store(fixture->device.replays.self, 1, bytes, sizeof bytes),
        HAL_OK);
    assert_false(has_replay(fixture, 1));
    storage_work(&fixture->storage);
    assert_true(has_replay(fixture, 1));
    assert_false(has_replay(fixture, 2));
    assert_false(has_replay(fixture, 0));
    reopen(fixture);
    assert_true(has_replay(fixture, 1));
    /* Ten better rounds push round 1 out of the ranking, so its replay must be deleted. */
    for (uint32_t id = 2; id <= 1u + RANK_ROWS; id++) {
        assert_int_equal(save(fixture, id, 9, 0), HAL_OK);
    }
    wait_until_saved(fixture, 1u + RANK_ROWS);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    open_without_thread(fixture);
    storage_work(&fixture->storage);
    assert_false(has_replay(fixture, 1));
}

/* Sets the permissions of the database file to `before`, and then opens and closes the store.
 * Asserts that the permissions of the file are `after` then, and that the log has `lines` lines. */
static void assert_mode(struct fixture *fixture, mode_t before, mode_t after, int lines)
{
    char path[160], log[1024], expected[80];
    struct stat about;
    path_beside(fixture, ".log", path);
    snprintf(expected, sizeof expected, "kingyo.db: all users had access; its mode is %04o now",
             (unsigned)after);
    assert_int_equal(chmod(fixture->file, before), 0);
    fflush(stderr);
    const int saved = dup(STDERR_FILENO);
    assert_non_null(freopen(path, "w", stderr));
    open_without_thread(fixture);
    fixture->device.ledger.ops->close(fixture->device.ledger.self);
    fflush(stderr);
    assert_true(dup2(saved, STDERR_FILENO) >= 0);
    close(saved);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    int count = 0;
    while (fgets(log, sizeof log, file)) {
        assert_non_null(strstr(log, expected));
        count++;
    }
    fclose(file);
    assert_int_equal(count, lines);
    assert_int_equal(stat(fixture->file, &about), 0);
    assert_int_equal(about.st_mode & 0777, after);
}

/* Older versions created the database with mode 0644. A mode without access for all users is the
 * operator's choice, and so is write access for the group. */
static void test_a_database_with_access_for_all_users_becomes_private(void **state)
{
    struct fixture *fixture = *state;
    fill_and_close(fixture);
    assert_mode(fixture, 0644, 0600, 1);
    assert_mode(fixture, 0664, 0660, 1);
    assert_mode(fixture, 0600, 0600, 0);
    assert_mode(fixture, 0640, 0640, 0);
    assert_mode(fixture, 0660, 0660, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_A_FOLDER(test_a_saved_round_is_stored_with_every_field),
        IN_A_FOLDER(test_the_next_start_loads_the_state_of_the_last_run),
        IN_A_FOLDER(test_a_round_appended_every_frame_is_stored_once),
        IN_A_FOLDER(test_closing_writes_the_queued_entries),
        IN_A_FOLDER(test_a_blocked_card_never_blocks_a_frame),
        IN_A_FOLDER(test_unwritten_rounds_are_counted_and_reported),
        IN_A_FOLDER(test_the_data_folder_is_created_if_possible),
        IN_A_FOLDER(test_an_unwritable_folder_gives_a_one_line_message),
        IN_A_FOLDER(test_a_missing_data_option_is_reported),
        IN_A_FOLDER(test_a_file_that_is_not_a_database_is_quarantined),
        IN_A_FOLDER(test_a_database_with_access_for_all_users_becomes_private),
        IN_A_FOLDER(test_sqlite_has_a_hard_memory_limit),
        cmocka_unit_test_setup_teardown(test_a_ranked_round_has_a_seal_while_its_replay_is_stored,
                                        set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
