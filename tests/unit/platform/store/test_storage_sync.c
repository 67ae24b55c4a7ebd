/* test_storage_sync.c -- Tests failed sync calls. After such a failure, an entry may be
 * acknowledged only if its bytes were written again and synced. Also tests a database that is
 * renamed during a write.
 *
 * `make test-power` makes sync calls fail at random positions. */
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
#include <sys/syscall.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "platform/store/storage.h"

static char dir[64], file[96], wal[96], tail[96], part[128];
static struct storage storage;
static struct hal_storage device;

/* ---- Replaced file functions of libc, whose syncs can fail ---------------------------------- */

static const char *failing; /* Path of the file whose syncs fail. NULL means no file, and "" means
                               every file. */
static uint32_t fails_left; /* Number of further syncs that will fail. */
static const char *moving;  /* Path to which the next sync of the log or of a new backup renames the
                               database. NULL means no renaming. */
/* Path to which the next write to the file `watched` renames the database. NULL means no
 * renaming. */
static const char *moving_at_write;
static uint64_t written; /* Number of bytes written to the file `watched`. */
static const char *watched;

static bool is_of(int fd, const char *path)
{
    struct stat one, other;
    return path && (!path[0] || (fstat(fd, &one) == 0 && stat(path, &other) == 0 &&
                                 one.st_ino == other.st_ino));
}

static int sync_or_fail(int fd)
{
    if (moving && is_of(fd, part)) {
        assert_int_equal(rename(file, moving), 0);
        moving = NULL;
    }
    if (moving && is_of(fd, wal)) {
        assert_int_equal(rename(file, moving), 0);
        moving = NULL;
    }
    if (fails_left > 0 && is_of(fd, failing)) {
        fails_left--;
        errno = EIO;
        return -1;
    }
    return 0;
}

#pragma GCC diagnostic ignored "-Wredundant-decls"
int fsync(int fd)
{
    return sync_or_fail(fd);
}

int fdatasync(int fd)
{
    return sync_or_fail(fd);
}

static ssize_t note_write(int fd, const void *bytes, size_t size, off_t at)
{
    if (is_of(fd, watched)) {
        written += size;
        if (moving_at_write) {
            assert_int_equal(rename(file, moving_at_write), 0);
            moving_at_write = NULL;
            written = 0;
        }
    }
    return syscall(SYS_pwrite64, fd, bytes, size, at);
}

ssize_t pwrite(int fd, const void *bytes, size_t size, off_t at)
{
    return note_write(fd, bytes, size, at);
}

ssize_t pwrite64(int fd, const void *bytes, size_t size, off64_t at)
{
    return note_write(fd, bytes, size, at);
}

static void fail_syncs(const char *path, uint32_t count)
{
    failing = path;
    fails_left = count;
}

/* ---- Store and simulated faults ------------------------------------------------------------- */

static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-sync-XXXXXX");
    if (!mkdtemp(dir)) {
        return -1;
    }
    snprintf(file, sizeof file, "%s/" STORAGE_FILE, dir);
    snprintf(wal, sizeof wal, "%s/" STORAGE_FILE "-wal", dir);
    snprintf(tail, sizeof tail, "%s/" STORAGE_FILE STORAGE_MIRROR_SUFFIX, dir);
    snprintf(part, sizeof part, "%s/" STORAGE_FILE STORAGE_BACKUP_SUFFIX LEDGER_PART_SUFFIX, dir);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    device = storage_device(&storage);
    fail_syncs(NULL, 0);
    moving = moving_at_write = NULL;
    watched = NULL;
    written = 0;
    return device.ledger.ops->open(device.ledger.self) == HAL_OK ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char command[80];
    device.ledger.ops->close(device.ledger.self);
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
}

static void drop_coins(uint32_t first, uint32_t last)
{
    for (uint32_t id = first; id <= last; id++) {
        const struct ledger_entry coin = {
            .id = id, .boot = 1, .tick = id, .kind = LEDGER_COINS, .count = 1
        };
        assert_int_equal(device.ledger.ops->append(device.ledger.self, &coin), HAL_OK);
    }
    storage_work(&storage);
}

static uint32_t saved(void)
{
    return device.ledger.ops->committed_id(device.ledger.self);
}

static uint64_t size_of(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 ? (uint64_t)about.st_size : 0u;
}

/* ---- Tests ---------------------------------------------------------------------------------- */

static void test_after_a_failed_sync_the_log_is_rewritten(void **state)
{
    (void)state;
    drop_coins(1, 1);
    watched = wal;
    fail_syncs(wal, 2); /* Two syncs fail: the sync of the COMMIT, and the sync when the file is
                           closed. */
    drop_coins(2, 3);
    assert_int_equal(saved(), 1);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    const uint64_t size = size_of(wal);
    assert_true(size > 0);
    written = 0;
    storage_work(&storage);
    assert_int_equal(saved(), 3);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    assert_true(written >= size);
}

static void test_while_every_sync_fails_nothing_is_acknowledged(void **state)
{
    (void)state;
    drop_coins(1, 2);
    fail_syncs("", UINT32_MAX);
    for (uint32_t id = 3; id < 12; id++) {
        drop_coins(id, id);
        assert_int_equal(saved(), 2);
        assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    }
    fail_syncs(NULL, 0);
    storage_work(&storage);
    assert_int_equal(saved(), 11);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
}

static void test_close_counts_the_entries_that_no_sync_confirmed(void **state)
{
    (void)state;
    drop_coins(1, 2);
    fail_syncs("", UINT32_MAX);
    drop_coins(3, 5);
    storage_work(&storage);
    assert_int_equal(saved(), 2);
    /* The entries can be read back from the cache of the kernel. They may still be lost. */
    assert_int_equal(device.ledger.ops->close(device.ledger.self), 3);
    fail_syncs(NULL, 0);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
}

static void test_a_failed_sync_of_the_mirror_is_not_acknowledged(void **state)
{
    (void)state;
    drop_coins(1, 1);
    watched = tail;
    fail_syncs(tail, 1);
    drop_coins(2, 2);
    assert_int_equal(saved(), 1);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    written = 0;
    storage_work(&storage);
    assert_int_equal(saved(), 2);
    assert_true(written >= LEDGER_MIRROR_SLOTS * LEDGER_MIRROR_SLOT_SIZE);
}

static void test_a_failed_checkpoint_closes_the_file_and_loses_nothing(void **state)
{
    (void)state;
    fail_syncs(file, 1);
    uint32_t id = 0;
    while (fails_left > 0 && id < 500u) {
        id++;
        drop_coins(id, id);
    }
    assert_int_equal(fails_left, 0);
    assert_int_equal(saved(), id - 1u);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_null(storage.file.db);
    watched = wal;
    written = 0;
    const uint64_t size = size_of(wal);
    storage_work(&storage);
    assert_int_equal(saved(), id);
    assert_true(written >= size);
}

/* Leaves the files as SIGKILL would leave them: copies the database, its log and the mirror while
 * the store is open. The copies are used from then on. */
static void simulate_kill(void)
{
    char command[512];
    snprintf(command, sizeof command, "mkdir %s/copy && cp %s %s %s %s/copy", dir, file, wal, tail,
             dir);
    assert_int_equal(system(command), 0);
    device.ledger.ops->close(device.ledger.self);
    snprintf(command, sizeof command, "mv %s/copy/* %s", dir, dir);
    assert_int_equal(system(command), 0);
    storage = (struct storage){ .dir = dir, .without_thread = true };
}

static void test_a_log_found_at_the_start_is_rewritten_before_it_is_acknowledged(void **state)
{
    (void)state;
    drop_coins(1, 5);
    simulate_kill();
    watched = wal;
    written = 0;
    const uint64_t size = size_of(wal);
    assert_true(size > 0);
    fail_syncs(wal, 1);
    assert_int_not_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    device.ledger.ops->close(device.ledger.self);
    storage = (struct storage){ .dir = dir, .without_thread = true };
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    assert_int_equal(saved(), 5);
    assert_true(written >= 2u * size);
}

static void test_a_log_locked_by_another_program_at_the_start_is_not_acknowledged(void **state)
{
    (void)state;
    sqlite3 *other = NULL;
    drop_coins(1, 5);
    simulate_kill();
    assert_int_equal(sqlite3_open(file, &other), SQLITE_OK);
    assert_int_equal(sqlite3_exec(other, "BEGIN IMMEDIATE", NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(saved(), 0);
        assert_false(device.ledger.ops->is_healthy(device.ledger.self));
        storage_work(&storage); /* The other program has still locked the database, so no entry may
                                   be acknowledged. */
    }
    assert_non_null(
        strstr(device.ledger.ops->describe(device.ledger.self), "another program holds it"));
    assert_int_equal(sqlite3_exec(other, "ROLLBACK", NULL, NULL, NULL), SQLITE_OK);
    watched = wal;
    written = 0;
    fail_syncs(wal, 1);
    /* The first sync fails, so the store opens the file again and writes the log a second time. */
    storage_work(&storage);
    assert_int_equal(fails_left, 0);
    assert_int_equal(saved(), 5);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    assert_true(written >= 2u * size_of(wal));
    sqlite3_close(other);
}

static void test_an_entry_is_written_only_after_a_suspect_log_is_rewritten(void **state)
{
    (void)state;
    sqlite3 *other = NULL;
    struct ledger_file suspect;
    const struct ledger_entry coin = {
        .id = 6, .boot = 1, .tick = 6, .kind = LEDGER_COINS, .count = 1
    };
    drop_coins(1, 5);
    simulate_kill();
    assert_int_equal(sqlite3_open(file, &other), SQLITE_OK);
    assert_int_equal(sqlite3_exec(other, "BEGIN IMMEDIATE", NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(ledger_file_open(&suspect, file, NULL), SQLITE_OK);
    /* The log was found at the start, so its bytes may not be on the disk. `is_suspect` stays true,
     * because the store cannot write the log again while the other program has a lock. */
    assert_true(suspect.is_suspect);
    assert_int_equal(sqlite3_exec(other, "ROLLBACK", NULL, NULL, NULL), SQLITE_OK);
    watched = wal;
    written = 0;
    const uint64_t size = size_of(wal);
    assert_int_equal(ledger_file_write(&suspect, &coin, 1), SQLITE_OK);
    assert_true(written > size);
    assert_false(suspect.is_suspect);
    assert_int_equal(suspect.content.memory.ledger.last_id, 6);
    ledger_file_close(&suspect);
    sqlite3_close(other);
}

/* The validation of a large backup takes seconds. The store must not wait for its end before the
 * loss is reported. */
static void test_a_backup_is_aborted_if_the_database_moves_before_the_validation(void **state)
{
    (void)state;
    char away[96], backup[96];
    snprintf(away, sizeof away, "%s/away", dir);
    snprintf(backup, sizeof backup, "%s/" STORAGE_FILE STORAGE_BACKUP_SUFFIX, dir);
    drop_coins(1, 5);
    assert_int_equal(access(backup, F_OK), 0);
    assert_int_equal(unlink(backup), 0);
    storage.backup_due_s = 0;
    moving = away;
    storage_work(&storage);
    assert_null(moving); /* The sync function above has renamed the database during the backup. */
    assert_int_not_equal(access(backup, F_OK), 0);
    assert_int_not_equal(access(part, F_OK), 0);
    storage_work(&storage);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_int_equal(rename(away, file), 0);
    storage_work(&storage);
    storage_work(&storage);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
    assert_int_equal(access(backup, F_OK), 0);
}

static void test_a_database_that_moves_during_a_write_acknowledges_nothing(void **state)
{
    (void)state;
    char away[96];
    snprintf(away, sizeof away, "%s/away", dir);
    drop_coins(1, 1);
    moving = away;
    drop_coins(2, 3);
    assert_null(moving); /* The sync function above has renamed the database during the write. */
    assert_int_equal(saved(), 1);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_non_null(strstr(device.ledger.ops->describe(device.ledger.self), "removed or replaced"));
    assert_int_equal(rename(away, file), 0);
    storage_work(&storage);
    assert_int_equal(saved(), 3);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
}

/* Copying a large database may take seconds. The store must check its files meanwhile. */
static void test_a_database_that_moves_during_a_backup_is_detected_after_one_step(void **state)
{
    (void)state;
    static const uint8_t replay[2u << 20];
    char away[96];
    snprintf(away, sizeof away, "%s/away", dir);
    drop_coins(1, 1);
    assert_int_equal(ledger_file_put_replay(&storage.file, 1, replay, sizeof replay), SQLITE_OK);
    storage.backup_due_s = 0;
    watched = part;
    moving_at_write = away;
    storage_work(&storage);
    assert_null(moving_at_write); /* The write function above has renamed the database. */
    assert_true(written < sizeof replay / 2u);
    storage_work(&storage);
    assert_false(device.ledger.ops->is_healthy(device.ledger.self));
    assert_int_equal(size_of(part), 0); /* The incomplete copy was removed. */
    assert_int_equal(rename(away, file), 0);
    storage_work(&storage);
    assert_true(device.ledger.ops->is_healthy(device.ledger.self));
}

static void test_a_withdrawn_name_is_rewritten_after_a_failed_sync_of_the_mirror(void **state)
{
    (void)state;
    struct ledger_entry name = {
        .id = 1, .boot = 1, .kind = LEDGER_NAME, .count = 9, .detail = 1, .name = "A WORD"
    };
    device.ledger.ops->append(device.ledger.self, &name);
    storage_work(&storage);
    memset(name.name, 0, sizeof name.name);
    name.id = 2;
    struct ledger_mirror own = ledger_mirror_inspect(tail);
    ledger_mirror_close(&own);
    assert_int_equal(ledger_mirror_open(&own, tail), 0);
    assert_int_equal(ledger_mirror_erase_name(&own, 9, 1), 0);
    watched = tail;
    written = 0;
    assert_int_equal(ledger_mirror_erase_name(&own, 9, 1), 0);
    assert_int_equal(written, LEDGER_MIRROR_SLOT_SIZE);
    ledger_mirror_close(&own);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_after_a_failed_sync_the_log_is_rewritten),
        TEST(test_while_every_sync_fails_nothing_is_acknowledged),
        TEST(test_close_counts_the_entries_that_no_sync_confirmed),
        TEST(test_a_failed_sync_of_the_mirror_is_not_acknowledged),
        TEST(test_a_failed_checkpoint_closes_the_file_and_loses_nothing),
        TEST(test_a_log_found_at_the_start_is_rewritten_before_it_is_acknowledged),
        TEST(test_a_log_locked_by_another_program_at_the_start_is_not_acknowledged),
        TEST(test_an_entry_is_written_only_after_a_suspect_log_is_rewritten),
        TEST(test_a_database_that_moves_during_a_write_acknowledges_nothing),
        TEST(test_a_database_that_moves_during_a_backup_is_detected_after_one_step),
        TEST(test_a_backup_is_aborted_if_the_database_moves_before_the_validation),
        TEST(test_a_withdrawn_name_is_rewritten_after_a_failed_sync_of_the_mirror),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
