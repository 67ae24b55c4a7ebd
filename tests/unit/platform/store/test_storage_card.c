/* test_storage_card.c -- Tests the store on a memory card that is slow, blocked, full, read-only,
 * missing or from another kiosk.
 *
 * The store must report the state, store as much as possible, and continue when the card works
 * again. tests/power/tape.h makes the system calls of the store fail. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "platform/store/storage.h"
#include "tests/power/tape.h"

static char dir[64], file[96];
static struct tape tape;
static struct storage storage;
static struct hal_storage device;

/* True if access() must report a read-only file system, even to root. */
static bool is_read_only;
int __real_access(const char *path, int mode);
int __wrap_access(const char *path, int mode);
int __wrap_access(const char *path, int mode)
{
    if (is_read_only && (mode & W_OK)) {
        errno = EROFS;
        return -1;
    }
    return __real_access(path, mode);
}

static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-card-XXXXXX");
    if (!mkdtemp(dir)) {
        return -1;
    }
    snprintf(file, sizeof file, "%s/" STORAGE_FILE, dir);
    tape_begin(&tape, dir, NULL, 0);
    tape_sync_us(0);
    tape_fail_writes(0);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    device = storage_device(&storage);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    char command[96];
    is_read_only = false;
    tape_sync_us(0);
    tape_fail_writes(0);
    device.ledger.ops->close(device.ledger.self);
    tape_end();
    tape_free(&tape);
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
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

static bool is_well(void)
{
    return device.ledger.ops->is_healthy(device.ledger.self);
}

static const char *text(void)
{
    return device.ledger.ops->describe(device.ledger.self);
}

static int64_t now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static void pause_ms(long ms)
{
    nanosleep(&(struct timespec){ ms / 1000, ms % 1000 * 1000000L }, NULL);
}

static void wait_until_saved(uint32_t id)
{
    for (int i = 0; i < 1000 && saved_id() < id; i++) {
        pause_ms(10);
    }
    assert_int_equal(saved_id(), id);
}

static int count_entries(void)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(file, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    sqlite3_prepare_v2(db, "SELECT count(*) FROM entries", -1, &statement, NULL);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int count = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return count;
}

static void expect_failure_and_recovery(int error, const char *words)
{
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    keep(1);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
    assert_true(is_well());
    tape_fail_writes(error);
    for (uint32_t id = 2; id <= STORAGE_QUEUE_MAX + 1; id++) {
        assert_int_equal(keep(id), HAL_OK);
    }
    assert_int_equal(keep(STORAGE_QUEUE_MAX + 2), HAL_ERR_BUSY);
    for (int i = 0; i < 3; i++) {
        storage_work(&storage);
        assert_int_equal(saved_id(), 1);
        assert_false(is_well());
    }
    assert_non_null(strstr(text(), words));
    assert_int_equal(device.ledger.ops->failed_count(device.ledger.self), 3);
    tape_fail_writes(0);
    storage_work(&storage);
    assert_int_equal(saved_id(), STORAGE_QUEUE_MAX + 1);
    assert_true(is_well());
    assert_int_equal(count_entries(), STORAGE_QUEUE_MAX + 1);
}

static void test_a_full_card_stores_the_queue_when_it_has_room_again(void **state)
{
    (void)state;
    expect_failure_and_recovery(ENOSPC, "free some space");
}

static void test_a_failed_card_stores_the_queue_when_it_works_again(void **state)
{
    (void)state;
    expect_failure_and_recovery(
        EIO, "64 entries not written: disk I/O error; it is retried each second");
}

static void test_a_read_only_card_stores_the_queue_when_it_is_writable_again(void **state)
{
    (void)state;
    expect_failure_and_recovery(EROFS, "64 entries not written");
}

static void test_no_frame_waits_for_a_slow_card(void **state)
{
    (void)state;
    storage.without_thread = false;
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    pause_ms(300); /* Waits until the store has made its first backup. */
    tape_sync_us(200000);
    int64_t longest_ms = 0;
    for (uint32_t id = 1; id <= 20; id++) {
        const int64_t begin_ms = now_ms();
        assert_int_equal(keep(id), HAL_OK);
        saved_id();
        is_well();
        const int64_t took_ms = now_ms() - begin_ms;
        longest_ms = took_ms > longest_ms ? took_ms : longest_ms;
        pause_ms(10);
    }
    /* Each sync of the slow card takes 200 ms, so no call has waited for a sync. */
    assert_true(longest_ms < 100);
    wait_until_saved(20);
    assert_true(is_well()); /* A slow card must not be reported as a fault. */
}

static void test_a_card_that_does_not_recover_is_reported(void **state)
{
    (void)state;
    storage.without_thread = false;
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    pause_ms(300);
    tape_sync_us(999999);
    keep(1);
    pause_ms(100);
    assert_true(is_well());
    /* Instead of waiting for the timeout, the test moves the start of the write into the past. */
    atomic_fetch_sub(&storage.busy_since_ms, STORAGE_STUCK_MS);
    assert_false(is_well());
    assert_non_null(strstr(text(), "has not answered for 3 s; 1 entries wait"));
    tape_sync_us(0);
    wait_until_saved(1);
    assert_true(is_well());
}

/* Creates a link to a missing file in place of the database, as if the card had been removed. */
static void take_card_away(void)
{
    assert_int_equal(symlink("/tmp/kingyo-no-such-card/kingyo.db", file), 0);
}

/* Removes the file at the path of the database. The separate process `rm` is used, so that
 * tests/power/tape.h neither records nor refuses the call. */
static void put_away(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm %s", file);
    assert_int_equal(system(command), 0);
}

/* The core counted entries that no store accepted, so a new database may not begin with the entries
 * that follow them. */
static void test_an_empty_card_inserted_late_is_used_after_a_restart(void **state)
{
    (void)state;
    static struct persistent_state memory;
    take_card_away();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_ERR_IO);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_ERR_ABSENT);
    assert_int_equal(keep(1), HAL_ERR_ABSENT);
    assert_false(is_well());
    put_away();
    storage_work(&storage);
    assert_true(device.ledger.ops->needs_restart(device.ledger.self));
    assert_int_equal(keep(2), HAL_ERR_ABSENT);
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_true(is_well());
    assert_int_equal(keep(1), HAL_OK);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
}

/* The card that is inserted late has a database with entries. The kiosk must not overwrite it, so
 * the store requests a restart that loads these entries. */
static void test_a_card_with_data_inserted_late_is_used_after_a_restart(void **state)
{
    (void)state;
    static struct persistent_state memory;
    char command[256];
    take_card_away();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_ERR_IO);
    put_away();
    snprintf(command, sizeof command, "cp tests/unit/platform/store/files/version-6.db %s", file);
    assert_int_equal(system(command), 0);
    storage_work(&storage);
    assert_int_equal(keep(1), HAL_ERR_ABSENT);
    assert_false(is_well());
    assert_non_null(strstr(text(), "restart"));
    assert_int_equal(device.ledger.ops->needs_restart(device.ledger.self), 1);
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 9);
    assert_int_equal(device.ledger.ops->needs_restart(device.ledger.self), 0);
}

/* The card is read-only at the start, and the stored credits must be loaded. When the card becomes
 * writable, coins must be stored without a restart. */
static void test_a_card_that_is_read_only_at_the_start_is_used_when_writable(void **state)
{
    (void)state;
    static struct persistent_state memory;
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    keep(1);
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    is_read_only = true;
    tape_fail_writes(EROFS);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.balance.paid, 1);
    keep(2);
    storage_work(&storage);
    assert_false(is_well());
    assert_non_null(strstr(text(), "not written"));
    is_read_only = false;
    tape_fail_writes(0);
    storage_work(&storage);
    assert_true(is_well());
    assert_int_equal(saved_id(), 2);
}

static void test_a_foreign_card_is_not_written(void **state)
{
    (void)state;
    char command[256];
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    keep(1);
    storage_work(&storage);
    tape_fail_writes(EIO);
    keep(2);
    storage_work(&storage);
    /* Replaces the database by that of another kiosk, as if the card had been exchanged. */
    snprintf(command, sizeof command, "rm %s*; cp tests/unit/platform/store/files/version-6.db %s",
             file, file);
    assert_int_equal(system(command), 0);
    tape_fail_writes(0);
    storage_work(&storage);
    assert_false(is_well());
    assert_non_null(strstr(text(), "not the card that it began with"));
    assert_int_equal(count_entries(), 9);
    assert_int_equal(saved_id(), 1);
    /* No restart may be requested, because it would load the balances of the other kiosk. */
    assert_int_equal(device.ledger.ops->needs_restart(device.ledger.self), 0);
}

/* ---- Tests of a card that is full when the kiosk starts ------------------------------------- */

/* Leaves the files as SIGKILL would leave them: a database, and a log with the entries 1 to 5, but
 * no index of the log. */
static void leave_five_entries_in_the_log(void)
{
    char command[400];
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    for (uint32_t id = 1; id <= 5; id++) {
        keep(id);
        storage_work(&storage);
    }
    snprintf(command, sizeof command,
             "cd %s && mkdir left && cp -a " STORAGE_FILE " " STORAGE_FILE "-wal left", dir);
    assert_int_equal(system(command), 0);
    device.ledger.ops->close(device.ledger.self);
    snprintf(command, sizeof command,
             "cd %s && rm -f " STORAGE_FILE "* && mv left/* . && "
             "rmdir left",
             dir);
    assert_int_equal(system(command), 0);
    storage = (struct storage){ .dir = dir, .without_thread = true };
}

/* Opens the store on a full card with five entries. The store may report the entries up to `proven`
 * as stored. After that, space is freed, and a new entry must be stored. */
static void expect_writes_resume(uint32_t proven)
{
    static struct persistent_state memory;
    tape_fail_writes(ENOSPC);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 5);
    assert_int_equal(memory.ledger.balance.paid, 5);
    assert_false(is_well());
    assert_non_null(strstr(text(), "full; free some space"));
    assert_int_equal(saved_id(), proven);
    assert_int_equal(keep(6), HAL_OK); /* This entry must wait in the queue until the card has
                                          space. */
    storage_work(&storage);
    assert_false(is_well());
    assert_int_equal(saved_id(), proven);
    tape_fail_writes(0);
    storage.retry_due_ms = 0; /* Makes the next retry due at once. */
    storage_work(&storage);
    assert_true(is_well());
    assert_int_equal(saved_id(), 6);
    assert_int_equal(count_entries(), 6);
}

static void test_a_card_that_is_full_at_the_start_is_read_and_later_written(void **state)
{
    (void)state;
    leave_five_entries_in_the_log();
    /* The entries are only in the log. The log may not be completely on the card, and it cannot be
     * written again on a full card. Therefore no entry counts as stored. */
    expect_writes_resume(0);
}

static void test_a_full_card_that_was_closed_cleanly_is_read_and_later_written(void **state)
{
    (void)state;
    device.ledger.ops->open(device.ledger.self);
    for (uint32_t id = 1; id <= 5; id++) {
        keep(id);
    }
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    /* A clean close moves all entries from the log to the database, so all five count as stored. */
    expect_writes_resume(5);
}

static void test_other_programs_can_read_a_full_card(void **state)
{
    (void)state;
    leave_five_entries_in_the_log();
    tape_fail_writes(ENOSPC);
    device.ledger.ops->open(device.ledger.self);
    tape_fail_writes(0);
    assert_int_equal(count_entries(), 5);
}

/* ---- Tests of a card that cannot be used ---------------------------------------------------- */

static void put_a_later_kingyos_file(void)
{
    char command[256];
    snprintf(command, sizeof command, "cp tests/unit/platform/store/files/version-6.db %s", file);
    assert_int_equal(system(command), 0);
    sqlite3 *db;
    assert_int_equal(sqlite3_open(file, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, "PRAGMA user_version = 99", NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}

/* Returns how often the store has failed to open the file. */
static uint32_t looks(void)
{
    return device.ledger.ops->failed_count(device.ledger.self);
}

/* The second kiosk must wait, because two kiosks with one database would give different entries the
 * same id. */
static void test_a_second_kiosk_on_the_same_folder_waits_until_the_first_exits(void **state)
{
    (void)state;
    static struct storage second;
    second = (struct storage){ .dir = dir, .without_thread = true };
    const struct hal_storage other = storage_device(&second);
    const struct ledger_entry coin = { .id = 1, .boot = 1, .kind = LEDGER_COINS, .count = 1 };
    device.ledger.ops->open(device.ledger.self);
    keep(1);
    storage_work(&storage);
    assert_int_equal(other.ledger.ops->open(other.ledger.self), HAL_ERR_IO);
    assert_int_equal(other.ledger.ops->append(other.ledger.self, &coin), HAL_ERR_ABSENT);
    assert_non_null(
        strstr(other.ledger.ops->describe(other.ledger.self), "another Kingyo has it open"));
    storage_work(&second);
    assert_false(other.ledger.ops->is_healthy(other.ledger.self));
    device.ledger.ops->close(device.ledger.self);
    storage_work(&second);
    /* Only a restart lets the second kiosk load the entries of the first kiosk. */
    assert_true(other.ledger.ops->needs_restart(other.ledger.self));
    other.ledger.ops->close(other.ledger.self);
}

static void test_an_unusable_file_is_retried_with_increasing_delays(void **state)
{
    (void)state;
    put_a_later_kingyos_file();
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_ERR_IO);
    storage_work(&storage);
    assert_int_equal(looks(), 1);
    for (int64_t wait_ms = STORAGE_RETRY_MS, i = 0; i < 8; i++) {
        storage_work(&storage);
        assert_int_equal(looks(), 1 + i); /* The delay has not passed, so there was no retry. */
        assert_int_equal(storage.retry_wait_ms, wait_ms);
        storage.retry_due_ms -= wait_ms;
        storage_work(&storage);
        assert_int_equal(looks(), 2 + i); /* The delay has passed, so there was one retry. */
        wait_ms = 2 * wait_ms < STORAGE_RETRY_MS_MAX ? 2 * wait_ms : STORAGE_RETRY_MS_MAX;
    }
    assert_int_equal(storage.retry_wait_ms, STORAGE_RETRY_MS_MAX);
}

static bool is_beside(const char *suffix)
{
    char path[160];
    snprintf(path, sizeof path, "%s%s", file, suffix);
    return access(path, F_OK) == 0;
}

static void keep_eight_and_close(void)
{
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    /* The first step of the loop also makes the backup, so the backup has only entry 1. The
     * database has all eight entries. */
    for (uint32_t id = 1; id <= 8; id++) {
        assert_int_equal(keep(id), HAL_OK);
        storage_work(&storage);
    }
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
}

/* Opens the store on a full card. Asserts that all data are loaded, and that no file is quarantined
 * or replaced before the card has space. */
static void is_read_and_left(void)
{
    static struct persistent_state memory;
    tape_fail_writes(ENOSPC);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
    assert_int_equal(memory.ledger.last_id, 8);
    assert_int_equal(memory.ledger.balance.paid, 8);
    assert_int_equal(memory.audits.count[AUDIT_UNITS], 8);
    assert_false(is_well());
    assert_int_equal(keep(9), HAL_OK);
    for (int i = 0; i < 4; i++) {
        storage.retry_due_ms = 0;
        storage_work(&storage);
        assert_false(is_beside(".damaged-1") || is_beside(".missing-1") || is_beside(".new"));
        assert_false(is_well());
    }
    tape_fail_writes(0);
    storage.retry_due_ms = 0;
    storage_work(&storage);
    assert_true(is_well());
    assert_int_equal(saved_id(), 9);
    assert_int_equal(count_entries(), 9);
}

static void test_a_damaged_file_on_a_full_card_is_read_and_not_changed(void **state)
{
    static const char dirt[4096] = { 1, 2, 3 };
    (void)state;
    keep_eight_and_close();
    FILE *out = fopen(file, "r+b");
    assert_non_null(out);
    fseek(out, 3 * (long)sizeof dirt, SEEK_SET);
    assert_int_equal(fwrite(dirt, sizeof dirt, 1, out), 1);
    fclose(out);
    is_read_and_left();
    assert_true(is_beside(".damaged-1"));
}

static void test_a_backup_on_a_full_card_without_a_database_is_read_and_not_changed(void **state)
{
    (void)state;
    keep_eight_and_close();
    assert_int_equal(unlink(file), 0);
    is_read_and_left();
    assert_true(is_beside(".missing-1"));
}

static void test_a_change_of_free_space_causes_no_retry(void **state)
{
    (void)state;
    put_a_later_kingyos_file();
    device.ledger.ops->open(device.ledger.self);
    storage_work(&storage);
    storage.room = 0; /* The free space has changed since the last attempt, which is no reason for a
                         retry. */
    storage_work(&storage);
    assert_int_equal(looks(), 1);
}

static void test_a_changed_file_is_retried_immediately(void **state)
{
    (void)state;
    put_a_later_kingyos_file();
    device.ledger.ops->open(device.ledger.self);
    for (int i = 0; i < 8; i++) {
        storage.retry_due_ms = 0;
        storage_work(&storage);
    }
    assert_int_equal(storage.retry_wait_ms, STORAGE_RETRY_MS_MAX);
    put_away(); /* An empty card is inserted in place of the unusable file. */
    storage_work(&storage);
    assert_true(device.ledger.ops->needs_restart(device.ledger.self));
}

/* ---- Tests of replays on a faulty card ------------------------------------------------------ */

static const uint8_t replay[] = "all that the hand did";

static void play_round(uint32_t id, uint32_t caught)
{
    const struct ledger_entry round = {
        .id = id,
        .boot = 1,
        .kind = LEDGER_ROUND,
        .round = { .id = id, .caught = caught, .players = 1, .player = { { .caught = caught } } },
    };
    assert_int_equal(device.ledger.ops->append(device.ledger.self, &round), HAL_OK);
}

static struct ledger_entry fetched;

static int fetch(uint32_t round_id, uint8_t *bytes, size_t size)
{
    assert_int_equal(
        device.replays.ops->fetch(device.replays.self, round_id, bytes, size, &fetched), HAL_OK);
    assert_int_equal(device.replays.ops->fetched(device.replays.self), HAL_ERR_BUSY);
    storage_work(&storage);
    return device.replays.ops->fetched(device.replays.self);
}

static void test_the_replay_of_a_ranked_round_is_stored_and_loaded(void **state)
{
    (void)state;
    uint8_t found[64];
    device.ledger.ops->open(device.ledger.self);
    play_round(1, 5); /* One call of storage_work() must write the round first and then its
                         replay. */
    assert_int_equal(device.replays.ops->store(device.replays.self, 1, replay, sizeof replay),
                     HAL_OK);
    assert_int_equal(device.replays.ops->store(device.replays.self, 2, replay, sizeof replay),
                     HAL_ERR_BUSY);
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), 0);
    storage_work(&storage);
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), 1);
    assert_int_equal(fetch(1, found, sizeof found), sizeof replay);
    assert_memory_equal(found, replay, sizeof replay);
    assert_int_equal(fetched.id, 1); /* The fetched data include the ledger entry of the round. */
    assert_int_equal(fetched.round.caught, 5);
    assert_int_equal(fetch(1, found, 4), HAL_ERR_ABSENT);
    assert_int_equal(fetch(7, found, sizeof found), HAL_ERR_ABSENT);
}

static void test_an_unranked_round_stores_no_replay(void **state)
{
    (void)state;
    uint8_t found[64];
    device.ledger.ops->open(device.ledger.self);
    for (uint32_t id = 1; id <= RANK_ROWS + 1; id++) {
        play_round(id, id <= RANK_ROWS ? 9 : 1);
    }
    device.replays.ops->store(device.replays.self, RANK_ROWS + 1, replay, sizeof replay);
    storage_work(&storage);
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), RANK_ROWS + 1);
    assert_int_equal(fetch(RANK_ROWS + 1, found, sizeof found), HAL_ERR_ABSENT);
}

/* The replay of a round that is not ranked would be deleted. While the round cannot be written, its
 * replay must therefore wait. */
static void test_a_replay_is_written_only_after_its_round(void **state)
{
    (void)state;
    uint8_t found[64];
    device.ledger.ops->open(device.ledger.self);
    tape_fail_writes(ENOSPC);
    play_round(1, 5);
    assert_int_equal(device.replays.ops->store(device.replays.self, 1, replay, sizeof replay),
                     HAL_OK);
    for (int i = 0; i < 3; i++) {
        storage_work(&storage);
        assert_int_equal(saved_id(), 0);
        assert_int_equal(device.replays.ops->stored_id(device.replays.self), 0);
    }
    tape_fail_writes(0);
    storage_work(&storage);
    assert_int_equal(saved_id(), 1);
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), 1);
    assert_int_equal(fetch(1, found, sizeof found), sizeof replay);
}

static void test_a_replay_rejected_by_the_card_is_dropped_after_its_timeout(void **state)
{
    (void)state;
    device.ledger.ops->open(device.ledger.self);
    play_round(1, 5);
    storage_work(&storage);
    tape_fail_writes(ENOSPC);
    device.replays.ops->store(device.replays.self, 1, replay, sizeof replay);
    storage_work(&storage);
    storage_work(&storage);
    /* The replay is not stored yet, and the store must retry the write. */
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), 0);
    /* The start of the write is moved into the past, so that the write times out and is
     * abandoned. */
    storage.put_since_ms -= STORAGE_REPLAY_MS;
    storage_work(&storage);
    assert_int_equal(device.replays.ops->stored_id(device.replays.self), 1);
    tape_fail_writes(0);
    assert_int_equal(device.replays.ops->store(device.replays.self, 1, replay, sizeof replay),
                     HAL_OK);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_a_full_card_stores_the_queue_when_it_has_room_again),
        TEST(test_a_failed_card_stores_the_queue_when_it_works_again),
        TEST(test_a_read_only_card_stores_the_queue_when_it_is_writable_again),
        TEST(test_no_frame_waits_for_a_slow_card),
        TEST(test_a_card_that_does_not_recover_is_reported),
        TEST(test_an_empty_card_inserted_late_is_used_after_a_restart),
        TEST(test_a_card_with_data_inserted_late_is_used_after_a_restart),
        TEST(test_a_card_that_is_read_only_at_the_start_is_used_when_writable),
        TEST(test_a_foreign_card_is_not_written),
        TEST(test_a_card_that_is_full_at_the_start_is_read_and_later_written),
        TEST(test_a_full_card_that_was_closed_cleanly_is_read_and_later_written),
        TEST(test_other_programs_can_read_a_full_card),
        TEST(test_a_second_kiosk_on_the_same_folder_waits_until_the_first_exits),
        TEST(test_an_unusable_file_is_retried_with_increasing_delays),
        TEST(test_a_damaged_file_on_a_full_card_is_read_and_not_changed),
        TEST(test_a_backup_on_a_full_card_without_a_database_is_read_and_not_changed),
        TEST(test_a_change_of_free_space_causes_no_retry),
        TEST(test_a_changed_file_is_retried_immediately),
        TEST(test_the_replay_of_a_ranked_round_is_stored_and_loaded),
        TEST(test_an_unranked_round_stores_no_replay),
        TEST(test_a_replay_is_written_only_after_its_round),
        TEST(test_a_replay_rejected_by_the_card_is_dropped_after_its_timeout),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
