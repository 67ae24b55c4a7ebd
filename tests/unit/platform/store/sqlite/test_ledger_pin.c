/* test_ledger_pin.c -- Tests the erasure of a plain PIN. Older versions of Kingyo stored the digits
 * of the PIN in the database, its log, its backup and the mirror.
 *
 * No byte of the digits may remain, and the PIN must still open the menu. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "core/pin.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/ledger_recovery.h"

#define PIN 4071
#define ENTRIES 400u /* Enough entries to fill more than four pages of the database. */

/* ---- Replaced sync functions of libc, one call of which can fail ---------------------------- */

static uint32_t syncs;         /* Number of sync calls so far. */
static uint32_t failing = ~0u; /* Index of the sync call that fails, from 0. By default no call
                                  fails. */

static int sync_or_fail(void)
{
    if (syncs++ == failing) {
        errno = EIO;
        return -1;
    }
    return 0;
}

#pragma GCC diagnostic ignored "-Wredundant-decls"
int fsync(int fd)
{
    (void)fd;
    return sync_or_fail();
}

int fdatasync(int fd)
{
    (void)fd;
    return sync_or_fail();
}

static void fail_sync(uint32_t number)
{
    syncs = 0;
    failing = number;
}

/* ---- Temporary files of the tests ----------------------------------------------------------- */

static char folder[] = "/tmp/kingyo-pin-XXXXXX";
static char path[64], other[80];

static const char *beside(const char *suffix)
{
    snprintf(other, sizeof other, "%s%s", path, suffix);
    return other;
}

static int setup(void **state)
{
    (void)state;
    strcpy(folder + sizeof folder - 7, "XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/kingyo.db", folder);
    fail_sync(~0u);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    static const char *const suffixes[] = { "", "-wal", "-shm", ".copy", ".tail" };
    for (size_t i = 0; i < sizeof suffixes / sizeof suffixes[0]; i++) {
        unlink(beside(suffixes[i]));
    }
    return rmdir(folder);
}

/* Returns the ledger entry of a changed setting: the PIN if `id` is odd, otherwise the volume. */
static struct ledger_entry entry_of(uint32_t id)
{
    return (struct ledger_entry){ .id = id,
                                  .boot = 1,
                                  .tick = id,
                                  .kind = LEDGER_SETTING,
                                  .detail = id % 2u ? SET_PIN : SET_VOLUME,
                                  .value = id % 2u ? PIN : 50 };
}

static void write_as_before(struct ledger_file *file)
{
    static struct ledger_entry entries[ENTRIES];
    for (uint32_t i = 0; i < ENTRIES; i++) {
        entries[i] = entry_of(i + 1u);
    }
    assert_int_equal(ledger_file_write(file, entries, ENTRIES), 0);
}

/* Returns how many times `file` contains the bytes `expected`. Returns 0 if the file does not
 * exist. */
static unsigned count_in(const char *file, const void *expected, size_t size)
{
    static uint8_t bytes[4u * 1024u * 1024u];
    FILE *in = fopen(file, "rb");
    const size_t length = in ? fread(bytes, 1, sizeof bytes, in) : 0;
    unsigned count = 0;
    for (size_t i = 0; i + size <= length; i++) {
        count += memcmp(bytes + i, expected, size) == 0;
    }
    if (in) {
        fclose(in);
    }
    return count;
}

/* Returns the number of rows of the settings table that contain the plain PIN, including deleted
 * rows in free pages. SQLite stores the PIN as an integer of two bytes behind the name of the
 * setting. */
static unsigned plain_settings_in(const char *suffix)
{
    static const uint8_t row[] = { 'p', 'i', 'n', PIN >> 8, PIN & 0xFF };
    return count_in(beside(suffix), row, sizeof row);
}

/* Returns the number of rows of the entries table that contain the plain PIN, including deleted
 * rows in free pages. The two bytes of the PIN follow the columns `kind` and `detail`. */
static unsigned plain_entries_in(const char *suffix)
{
    static const uint8_t row[] = { LEDGER_SETTING, SET_PIN, PIN >> 8, PIN & 0xFF };
    return count_in(beside(suffix), row, sizeof row);
}

static unsigned plain_in(const char *suffix)
{
    return plain_settings_in(suffix) + plain_entries_in(suffix);
}

/* Runs `sql` as another program would. secure_delete is off, so deleted rows stay readable in free
 * pages. */
static void do_sql(const char *sql)
{
    sqlite3 *db = NULL;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, "PRAGMA secure_delete = OFF", NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}

/* Creates a database that contains the plain PIN in the settings table, in 100 entries and in free
 * pages. */
static void make_old_database(void)
{
    struct ledger_file file;
    unlink(path);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    write_as_before(&file);
    ledger_file_close(&file);
    do_sql("DELETE FROM entries WHERE id BETWEEN 101 AND 300");
    assert_int_equal(plain_settings_in(""), 1);
    assert_true(plain_entries_in("") > 100); /* The PIN is in 100 existing rows. All further copies
                                                are in free pages. */
}

static void test_the_plain_pin_is_erased_from_every_byte_of_an_old_database(void **state)
{
    (void)state;
    struct ledger_file file;
    make_old_database();
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    const int32_t kept = file.content.memory.settings.value[SET_PIN];
    assert_true(kept < 0 && pin_matches(kept, PIN));
    for (uint32_t id = 1; id <= ENTRIES; id += id == 100u ? 201u : 1u) {
        struct ledger_entry entry, expected = entry_of(id);
        expected.value = id % 2u ? kept : expected.value;
        /* Reading an entry verifies its checksum, so the checksum must have been updated for the
         * new value. */
        assert_int_equal(ledger_file_entry(&file, id, &entry), 0);
        assert_memory_equal(&entry, &expected, sizeof entry);
    }
    assert_int_equal(plain_in("") + plain_in("-wal"), 0);
    assert_int_equal(ledger_backup_make(&file, beside(".copy"), true), 0);
    assert_int_equal(plain_in(".copy"), 0);
    ledger_file_close(&file);
    assert_int_equal(plain_in("") + plain_in("-wal"), 0);
    /* Opening the file verifies the checksums of all tables, so they must have been updated too. */
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(file.content.memory.settings.value[SET_PIN], kept);
    ledger_file_close(&file);
}

/* Each repetition of the loop makes a later sync call fail during the migration. The next start
 * must complete the migration. */
static void test_a_failed_migration_is_completed_at_the_next_start(void **state)
{
    (void)state;
    struct ledger_file file;
    uint32_t number = 0, unfinished = 0;
    /* True if opening the file made at most `number` sync calls, so that none has failed. */
    bool is_over = false;
    for (; !is_over; number++) {
        make_old_database();
        fail_sync(number);
        ledger_file_open(&file, path, NULL); /* This call may fail, and the file is then already
                                                closed. */
        ledger_file_close(&file);
        is_over = syncs <= number;
        fail_sync(~0u);
        unfinished += plain_in("") > 0;
        assert_int_equal(ledger_file_open(&file, path, NULL), 0);
        assert_true(pin_matches(file.content.memory.settings.value[SET_PIN], PIN));
        ledger_file_close(&file);
        assert_int_equal(plain_in("") + plain_in("-wal"), 0);
    }
    print_message("%u syncs, %u opens left plain digits\n", number, unfinished);
    assert_true(number > 3 && unfinished > 1);
}

static void test_a_migration_blocked_by_a_reader_is_completed_at_the_next_start(void **state)
{
    (void)state;
    struct ledger_file file;
    sqlite3 *reader = NULL;
    make_old_database();
    assert_int_equal(sqlite3_open(path, &reader), SQLITE_OK);
    assert_int_equal(sqlite3_exec(reader, "BEGIN; SELECT * FROM entries", NULL, NULL, NULL), 0);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_true(pin_matches(file.content.memory.settings.value[SET_PIN], PIN));
    /* The other connection still reads the old pages, so the PIN could not be erased yet. */
    assert_true(plain_in("") > 0);
    sqlite3_close(reader);
    ledger_file_close(&file);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    ledger_file_close(&file);
    assert_int_equal(plain_in("") + plain_in("-wal"), 0);
}

static void test_an_invalid_pin_setting_is_not_migrated_at_every_start(void **state)
{
    (void)state;
    struct ledger_file file;
    struct ledger_entry entry = entry_of(2);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(ledger_file_write(&file, &entry, 1), 0);
    ledger_file_close(&file);
    do_sql("DELETE FROM state; INSERT INTO settings VALUES ('pin', 10000)");
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    /* 10000 is not a PIN of four digits, so nothing may be migrated. */
    assert_int_equal(sqlite3_total_changes(file.db), 0);
    ledger_file_close(&file);
}

static void test_a_database_without_a_pin_is_not_written(void **state)
{
    (void)state;
    struct ledger_file file;
    struct ledger_entry entry = entry_of(2);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(ledger_file_write(&file, &entry, 1), 0);
    entry = entry_of(3);
    entry.value = pin_hide(PIN, 9);
    assert_int_equal(ledger_file_write(&file, &entry, 1), 0);
    ledger_file_close(&file);
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(file.content.memory.settings.value[SET_PIN], entry.value);
    ledger_file_close(&file);
}

static void test_the_plain_pin_is_erased_from_every_byte_of_the_mirror(void **state)
{
    (void)state;
    struct ledger_mirror tail;
    struct ledger_entry entry = entry_of(7), found;
    const size_t size = offsetof(struct ledger_entry, value) + sizeof entry.value;
    assert_int_equal(ledger_mirror_open(&tail, beside(".tail")), 0);
    assert_int_equal(ledger_mirror_write(&tail, &entry, 1), 0);
    ledger_mirror_close(&tail);
    assert_int_equal(count_in(beside(".tail"), &entry, size), 1);
    /* The file still contains the digits, but reading the entry must return the hidden form of the
     * PIN. */
    tail = ledger_mirror_inspect(beside(".tail"));
    assert_true(ledger_mirror_entry(&tail, 7, &found) && pin_matches(found.value, PIN));
    ledger_mirror_close(&tail);
    assert_int_equal(ledger_mirror_open(&tail, beside(".tail")), 0);
    assert_int_equal(count_in(beside(".tail"), &entry, size), 0);
    assert_true(ledger_mirror_entry(&tail, 7, &found));
    assert_true(found.value < 0 && pin_matches(found.value, PIN));
    ledger_mirror_close(&tail);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            test_the_plain_pin_is_erased_from_every_byte_of_an_old_database, setup, teardown),
        cmocka_unit_test_setup_teardown(test_a_failed_migration_is_completed_at_the_next_start,
                                        setup, teardown),
        cmocka_unit_test_setup_teardown(
            test_a_migration_blocked_by_a_reader_is_completed_at_the_next_start, setup, teardown),
        cmocka_unit_test_setup_teardown(test_an_invalid_pin_setting_is_not_migrated_at_every_start,
                                        setup, teardown),
        cmocka_unit_test_setup_teardown(test_a_database_without_a_pin_is_not_written, setup,
                                        teardown),
        cmocka_unit_test_setup_teardown(test_the_plain_pin_is_erased_from_every_byte_of_the_mirror,
                                        setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
