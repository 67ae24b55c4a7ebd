/* test_ledger_recovery.c -- Tests how ledger entries are recovered into a new database, from a
 * damaged database and from the mirror (a second file with the newest entries). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "platform/store/sqlite/ledger_recovery.h"
#include "tests/unit/support/ledger_fixture.h"

static char from_path[96], to_path[96], tail_path[96];

static int set_up_paths(void **state)
{
    set_up(state);
    snprintf(from_path, sizeof from_path, "%s/from.db", folder);
    snprintf(to_path, sizeof to_path, "%s/to.db", folder);
    snprintf(tail_path, sizeof tail_path, "%s/from.db.tail", folder);
    return 0;
}

static struct ledger_entry coin(uint32_t id)
{
    return (struct ledger_entry){ .id = id,
                                  .boot = 1,
                                  .tick = 100u * id,
                                  .day = 9000,
                                  .kind = LEDGER_COINS,
                                  .count = 1,
                                  .value = 1,
                                  .balance.paid = id };
}

static void put_file(const char *at, uint32_t count)
{
    assert_int_equal(ledger_file_open(&file, at, NULL), SQLITE_OK);
    for (uint32_t id = 1; id <= count; id++) {
        const struct ledger_entry entry = coin(id);
        assert_int_equal(ledger_file_write(&file, &entry, 1), SQLITE_OK);
    }
    ledger_file_close(&file);
}

static void put_tail(uint32_t first, uint32_t last)
{
    struct ledger_mirror tail;
    assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
    for (uint32_t id = first; id <= last; id++) {
        const struct ledger_entry entry = coin(id);
        assert_int_equal(ledger_mirror_write(&tail, &entry, 1), 0);
    }
    ledger_mirror_close(&tail);
}

/* Recovers the entries of the database `from` and of the mirror into a new database. Asserts that
 * `entries` entries were recovered, and that the new database has the entries 1 to `last`. */
static void expect_salvaged(const char *from, uint32_t last, uint32_t entries)
{
    struct ledger_file to;
    struct ledger_recovered salvaged;
    struct ledger_entry entry;
    struct ledger_mirror tail = ledger_mirror_inspect(tail_path);
    assert_int_equal(ledger_file_open(&to, to_path, NULL), SQLITE_OK);
    assert_int_equal(ledger_recover(from, &tail, &to, &salvaged), SQLITE_OK);
    assert_int_equal(salvaged.entries, entries);
    assert_int_equal(salvaged.lost, 0);
    assert_int_equal(to.content.memory.ledger.last_id, last);
    assert_int_equal(to.content.memory.ledger.balance.paid, last);
    for (uint32_t id = 1; id <= last; id++) {
        assert_int_equal(ledger_file_entry(&to, id, &entry), SQLITE_OK);
        assert_int_equal(entry.tick, 100u * id);
    }
    ledger_file_close(&to);
    ledger_mirror_close(&tail);
}

static void test_entries_missing_from_the_backup_come_from_the_damaged_file(void **state)
{
    (void)state;
    put_file(from_path, 5);
    put_file(to_path, 2);
    expect_salvaged(from_path, 5, 3);
}

static void test_entries_missing_from_the_damaged_file_come_from_the_mirror(void **state)
{
    (void)state;
    put_file(from_path, 3);
    put_file(to_path, 1);
    put_tail(2, 6);
    expect_salvaged(from_path, 6, 5);
}

static void test_without_a_database_entries_come_from_the_mirror(void **state)
{
    (void)state;
    put_file(to_path, 2);
    put_tail(1, 4);
    expect_salvaged(NULL, 4, 2);
}

/* Recovers the mirror into a database whose entries 1 and 2 have the given boot number and tick.
 * The mirror has the entries 11 and 12 of boot 1, the last with tick 1200. Returns true if the
 * mirror counts as that of a foreign ledger. */
static bool is_mirror_foreign(uint32_t boot, uint32_t tick)
{
    struct ledger_file to;
    struct ledger_recovered salvaged;
    unlink(to_path);
    assert_int_equal(ledger_file_open(&to, to_path, NULL), SQLITE_OK);
    for (uint32_t id = 1; id <= 2; id++) {
        struct ledger_entry entry = coin(id);
        entry.boot = boot;
        entry.tick = tick;
        assert_int_equal(ledger_file_write(&to, &entry, 1), SQLITE_OK);
    }
    struct ledger_mirror tail = ledger_mirror_inspect(tail_path);
    assert_int_equal(ledger_recover(NULL, &tail, &to, &salvaged), SQLITE_OK);
    assert_int_equal(salvaged.entries, salvaged.has_others_tail ? 0 : 2);
    ledger_mirror_close(&tail);
    ledger_file_close(&to);
    return salvaged.has_others_tail;
}

static void test_an_older_mirror_without_a_common_entry_is_foreign(void **state)
{
    (void)state;
    put_tail(11, 12);
    assert_false(is_mirror_foreign(1, 1200));
    assert_true(is_mirror_foreign(1, 1201));
    assert_true(is_mirror_foreign(2, 100));
    assert_false(is_mirror_foreign(0, 1201));
}

/* Layout of an entry in the mirror file, as in ledger_mirror.c. */
struct slot {
    uint32_t version, size;
    struct ledger_entry entry;
    uint64_t sum;
};

/* Mirrors of version 100 have padding with any value in the place of the level. This byte must be
 * ignored. */
static void test_a_round_in_a_mirror_of_version_100_counts_as_master(void **state)
{
    (void)state;
    struct ledger_entry found, round = coin(3);
    struct slot slot;
    round.kind = LEDGER_ROUND;
    round.round = (struct round_record){ .level = LEVEL_EASY, .players = 1 };
    struct ledger_mirror tail;
    assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
    assert_int_equal(ledger_mirror_write(&tail, &round, 1), 0);
    assert_true(ledger_mirror_entry(&tail, 3, &found));
    assert_int_equal(found.round.level, LEVEL_EASY);
    const off_t at = 3 * LEDGER_MIRROR_SLOT_SIZE;
    assert_int_equal(pread(tail.handle, &slot, sizeof slot, at), sizeof slot);
    slot.version = 100;
    slot.entry.round.level = 0xa5;
    slot.sum = hash_bytes(HASH_START, &slot, offsetof(struct slot, sum));
    assert_int_equal(pwrite(tail.handle, &slot, sizeof slot, at), sizeof slot);
    assert_true(ledger_mirror_entry(&tail, 3, &found));
    assert_int_equal(found.round.level, LEVEL_MASTER);
    ledger_mirror_close(&tail);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up_paths, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_entries_missing_from_the_backup_come_from_the_damaged_file),
        TEST(test_entries_missing_from_the_damaged_file_come_from_the_mirror),
        TEST(test_without_a_database_entries_come_from_the_mirror),
        TEST(test_an_older_mirror_without_a_common_entry_is_foreign),
        TEST(test_a_round_in_a_mirror_of_version_100_counts_as_master),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
