/* test_ledger_range.c -- checks ledger entries with a valid checksum but a value out of range. The
 * mirror file, the database, the replay and the core must reject them. Ids of entries must never
 * wrap around. */
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

#include "core/core.h"
#include "core/game/accounting/accounts.h"
#include "platform/replay/replay.h"
#include "platform/store/sqlite/ledger_recovery.h"
#include "platform/store/storage.h"

static char dir[64], path[96];
static struct core core;

static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-range-XXXXXX");
    if (!mkdtemp(dir)) {
        return -1;
    }
    snprintf(path, sizeof path, "%s/" STORAGE_FILE, dir);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    char command[96];
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
}

static struct ledger_entry coin(uint32_t id)
{
    return (struct ledger_entry){ .id = id,
                                  .boot = 1,
                                  .tick = 100 * id,
                                  .kind = LEDGER_COINS,
                                  .count = 1,
                                  .value = 1,
                                  .balance = { .paid = 5 } };
}

static struct ledger_entry played(uint32_t id)
{
    return (struct ledger_entry){
        .id = id,
        .boot = 1,
        .kind = LEDGER_ROUND,
        .round = { .id = id,
                   .mode = MODE_FESTIVAL,
                   .grade = 5,
                   .players = 1,
                   .caught = 3,
                   .player = { { .caught = 3, .sheets = 1 } } },
    };
}

/* ---- Range of each ledger field -------------------------------------------------------------- */

/* Returns a coin entry with one invalid value, which is selected by `which` (less than
 * BAD_COIN_COUNT). */
static struct ledger_entry bad_coin(uint32_t which)
{
    struct ledger_entry entry = coin(2);
    switch (which) {
    case 0:
        entry.id = LEDGER_ID_MAX + 1u;
        break;
    case 1:
        entry.boot = UINT32_MAX;
        break;
    case 2:
        entry.minute = 1440;
        break;
    case 3:
        entry.kind = LEDGER_KIND_COUNT;
        break;
    case 4:
        entry.detail = COIN_LINE_COUNT;
        break;
    case 5:
        entry.value = -1;
        break;
    case 6:
        entry.balance.open = PAYMENT_SERVICE + 1;
        break;
    default:
        entry.balance.paid = UINT32_MAX;
        break;
    }
    return entry;
}
#define BAD_COIN_COUNT 8u

/* Returns an entry of a round, or of a related kind, with one invalid value. The value is selected
 * by `which`, which counts from BAD_COIN_COUNT. */
static struct ledger_entry bad_round(uint32_t which)
{
    struct ledger_entry entry = played(2);
    switch (which) {
    case 8:
        entry.round.mode = 255;
        break;
    case 9:
        entry.round.mode = MODE_COUNT;
        break;
    case 10:
        entry.round.grade = 8;
        break;
    case 11:
        entry.round.players = 0xff;
        break;
    case 12:
        entry.round.preset = TANK_PRESET_COUNT;
        break;
    case 13:
        entry.round.by_bot = 2;
        break;
    case 14:
        memset(entry.name, 'x', sizeof entry.name);
        break;
    case 15:
        entry.name[0] = '\033';
        break;
    case 16:
        entry.kind = LEDGER_NAME;
        entry.detail = POI_MAX;
        break;
    default:
        entry.kind = LEDGER_REFUND;
        entry.detail = REFUND_CAUSE_COUNT;
        break;
    }
    return entry;
}

static struct ledger_entry bad_entry(uint32_t which)
{
    return which < BAD_COIN_COUNT ? bad_coin(which) : bad_round(which);
}
#define BAD_COUNT 18u

static void test_every_field_has_its_range(void **state)
{
    (void)state;
    const struct ledger_entry good[] = { coin(2), played(2), coin(LEDGER_ID_MAX) };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        assert_true(ledger_entry_is_valid(&good[i]));
    }
    for (uint32_t i = 0; i < BAD_COUNT; i++) {
        const struct ledger_entry entry = bad_entry(i);
        assert_false(ledger_entry_is_valid(&entry));
    }
}

static void test_tickets_refunds_and_open_rounds_have_their_ranges(void **state)
{
    (void)state;
    struct ledger_entry entry = coin(2);
    entry.balance.open = PAYMENT_PAID | PAYMENT_SPENT;
    entry.balance.returned = PAYMENT_SERVICE;
    entry.balance.tickets = BALANCE_TICKETS_MAX;
    assert_true(ledger_entry_is_valid(&entry));
    entry.balance.tickets++;
    assert_false(ledger_entry_is_valid(&entry));
    entry.balance.tickets = 0;
    entry.balance.returned = PAYMENT_FREE;
    assert_false(ledger_entry_is_valid(&entry));
    entry = coin(2);
    entry.kind = LEDGER_STAND;
    entry.detail = 0x61;
    entry.value = 0x1f0002;
    assert_true(ledger_entry_is_valid(&entry));
    /* The low four bits of `detail` are the mode. Mode 15 does not exist. */
    entry.detail = 0x6f;
    assert_false(ledger_entry_is_valid(&entry));
    entry.detail = 0x61;
    /* Sets the level, which is stored in these bits of `value`, to LEVEL_EASY. */
    entry.value = 0x400000;
    assert_true(ledger_entry_is_valid(&entry));
    /* Sets the level to 3, which does not exist. */
    entry.value = 0x600000;
    assert_false(ledger_entry_is_valid(&entry));
}

/* ---- The mirror and the database ------------------------------------------------------------ */

static void test_a_start_skips_a_mirror_entry_out_of_range(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < BAD_COUNT; i++) {
        static struct persistent_state memory;
        static struct storage storage;
        char tail_path[128], command[128];
        struct ledger_mirror tail;
        const struct ledger_entry entries[] = { coin(1), bad_entry(i), coin(3) };
        snprintf(command, sizeof command, "rm -rf %s/*", dir);
        assert_int_equal(system(command), 0);
        snprintf(tail_path, sizeof tail_path, "%s" STORAGE_MIRROR_SUFFIX, path);
        assert_int_equal(ledger_mirror_open(&tail, tail_path), 0);
        assert_int_equal(ledger_mirror_write(&tail, entries, 3), 0);
        ledger_mirror_close(&tail);
        storage = (struct storage){ .dir = dir, .without_thread = true };
        const struct hal_storage device = storage_device(&storage);
        assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(memory.ledger.last_id, 3);
        const struct core_config config = { .fish_count = 4, .persistent = memory };
        assert_int_equal(core_init(&core, &config), CORE_OK);
        device.ledger.ops->close(device.ledger.self);
    }
}

static void test_the_database_returns_no_entry_out_of_range(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < BAD_COUNT; i++) {
        struct ledger_file file;
        struct ledger_entry entry = bad_entry(i), found;
        unlink(path);
        assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
        if (entry.kind == LEDGER_ROUND && entry.round.mode >= MODE_COUNT) {
            /* Marks the round as unscored, because the ranking asserts that the mode of a scored
             * round is valid. */
            entry.round.unscored = 1;
        }
        assert_int_equal(ledger_file_write(&file, &entry, 1), SQLITE_OK);
        const int code = ledger_file_entry(&file, entry.id, &found);
        assert_true(code == SQLITE_CORRUPT || ledger_entry_is_valid(&found));
        ledger_file_close(&file);
    }
}

/* ---- Aggregates ----------------------------------------------------------------------------- */

/* SQL statements that change the database in ways that Kingyo never does, one for each column of
 * the ranking and of the stored state. `is_read` is 1 if the changed value reaches the core. If it
 * is 0, the value is clamped or skipped. */
static const struct {
    const char *change;
    int is_read;
} changes[] = {
    { "UPDATE ranking SET round = 4294967290", 1 },
    { "UPDATE ranking SET name = char(27) || '[2J'", 1 },
    { "UPDATE ranking SET name = 'a' || char(10)", 1 },
    { "UPDATE ranking SET name = char(127)", 1 },
    { "UPDATE ranking SET mode = mode + 100", 0 },
    { "UPDATE ranking SET period = period + 100", 0 },
    { "UPDATE ranking SET place = place + 100", 0 },
    { "UPDATE ranking SET caught = -1", 0 },
    { "UPDATE ranking SET day = 4294967290", 0 },
    { "UPDATE ranking SET seat = 200", 0 },
    { "INSERT OR REPLACE INTO state VALUES ('ranking-boot', 4294967295)", 0 },
    { "INSERT OR REPLACE INTO state VALUES ('ranking-day', 4294967295)", 0 },
    { "INSERT OR REPLACE INTO state VALUES ('ranking-week', 4294967295)", 0 },
    { "INSERT OR REPLACE INTO state VALUES ('ranking-week-boot', -1)", 0 },
    { "INSERT OR REPLACE INTO settings VALUES ('volume', 4294967295)", 0 },
    { "UPDATE audits SET count = -1", 0 },
};

/* Writes a database and executes the SQL statement `change` on it. Removes the stored checksums,
 * which earlier versions did not have, so that only the range checks can detect the change. */
static void write_changed_file(const char *change)
{
    struct ledger_file file;
    sqlite3 *db = NULL;
    char command[128];
    const struct ledger_entry entry = played(1);
    snprintf(command, sizeof command, "rm -rf %s/*", dir);
    assert_int_equal(system(command), 0);
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    assert_int_equal(ledger_file_write(&file, &entry, 1), SQLITE_OK);
    ledger_file_close(&file);
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, change, NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db,
                                  "DELETE FROM audits WHERE name = 'tally';"
                                  "DELETE FROM state WHERE name LIKE 'tally-%'",
                                  0, 0, 0),
                     SQLITE_OK);
    sqlite3_close(db);
}

/* Checks that the store opens in spite of each change. If `has_backup` is true, a backup file with
 * the same change exists beside the database. */
static void expect_a_start_for_each_change(bool has_backup)
{
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        static struct persistent_state memory;
        static struct storage storage;
        struct ledger_file file;
        char command[256];
        write_changed_file(changes[i].change);
        snprintf(command, sizeof command, "cp %s %s" STORAGE_BACKUP_SUFFIX, path, path);
        assert_int_equal(has_backup ? system(command) : 0, 0);
        const int code = ledger_file_inspect(&file, path);
        assert_int_equal(code, changes[i].is_read ? SQLITE_CORRUPT : SQLITE_OK);
        ledger_file_close(&file);
        storage = (struct storage){ .dir = dir, .without_thread = true };
        const struct hal_storage device = storage_device(&storage);
        memset(&memory, 0, sizeof memory);
        assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
        assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
        assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
        const struct core_config config = { .fish_count = 4, .persistent = memory };
        assert_int_equal(core_init(&core, &config), CORE_OK);
        assert_int_equal(memory.ledger.last_id, 1);
        /* The ledger entries themselves are valid. If the changed value was invalid, the store has
         * rebuilt the ranking from the entries. */
        if (changes[i].is_read) {
            assert_int_equal(memory.ranking.row[MODE_FESTIVAL][RANK_EVER][0].round_id, 1);
            assert_int_equal(memory.ranking.row[MODE_FESTIVAL][RANK_EVER][0].caught, 3);
        }
    }
}

static void test_a_start_rebuilds_sums_that_the_core_would_reject(void **state)
{
    (void)state;
    expect_a_start_for_each_change(false);
}

static void test_a_start_rebuilds_rejected_sums_that_the_backup_also_holds(void **state)
{
    (void)state;
    expect_a_start_for_each_change(true);
}

/* ---- Entry ids ------------------------------------------------------------------------------- */

static void test_a_database_whose_ids_would_wrap_keeps_its_credits_over_a_restart(void **state)
{
    (void)state;
    static const uint32_t ids[] = { LEDGER_ID_MAX + 1u, 4294967293u, 4294967294u, 4294967295u };
    for (size_t i = 0; i < sizeof ids / sizeof ids[0]; i++) {
        static struct persistent_state memory;
        static struct storage storage;
        struct ledger_file file;
        char command[128];
        snprintf(command, sizeof command, "rm -rf %s/*", dir);
        assert_int_equal(system(command), 0);
        const struct ledger_entry first = coin(7), last = coin(ids[i]);
        assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
        assert_int_equal(ledger_file_write(&file, &first, 1), SQLITE_OK);
        assert_int_equal(ledger_file_write(&file, &last, 1), SQLITE_OK);
        ledger_file_close(&file);
        /* Starts twice. The second start reads the entries that the first start wrote. */
        for (uint32_t start = 0; start < 2; start++) {
            storage = (struct storage){ .dir = dir, .without_thread = true };
            const struct hal_storage device = storage_device(&storage);
            assert_int_equal(device.ledger.ops->open(device.ledger.self), HAL_OK);
            assert_int_equal(device.ledger.ops->load(device.ledger.self, &memory), HAL_OK);
            assert_int_equal(memory.ledger.last_id, 7u + start);
            assert_int_equal(memory.ledger.balance.paid, 5);
            struct ledger_entry next = coin(8u + start);
            next.boot = 2;
            assert_int_equal(device.ledger.ops->append(device.ledger.self, &next), HAL_OK);
            assert_int_equal(device.ledger.ops->close(device.ledger.self), 0);
        }
    }
}

static void test_the_core_writes_no_entry_beyond_the_last_id(void **state)
{
    (void)state;
    static struct output output;
    const struct core_config config = {
        .fish_count = 4,
        .credit_coins = 1,
        .persistent.ledger = { .last_id = LEDGER_ID_MAX - 1u, .boots = 1 },
    };
    struct input input = { .store_well = 1, .record_saved_id = LEDGER_ID_MAX - 1u };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    for (uint32_t i = 0; i < 300; i++) {
        input.coin_count[0] = i == 200;
        core_tick(&core, &input, &output);
        input.record_saved_id = output.entry_id > 0 ? output.entry_id : input.record_saved_id;
        assert_true(core.game.accounts.ledger.last_id <= LEDGER_ID_MAX);
    }
    assert_int_equal(core.game.accounts.ledger.last_id, LEDGER_ID_MAX);
    /* The ledger is not safe, so the coin slot must be closed. */
    assert_false(ledger_is_safe(&core.game.accounts.ledger));
    /* The last entry before a shutdown would have an id that no reader accepts. */
    struct ledger_entry last;
    assert_false(core_final_entry(&core, &input, &last));
}

/* ---- The core and the replay ----------------------------------------------------------------- */

static void test_the_core_and_the_replay_reject_a_state_that_is_out_of_range(void **state)
{
    (void)state;
    static struct core_config good, late, bad[13], back;
    static uint8_t bytes[REPLAY_INITIAL_STATE_MAX];
    good =
        (struct core_config){ .fish_count = 4, .persistent.ledger = { .last_id = 9, .boots = 2 } };
    assert_int_equal(core_init(&core, &good), CORE_OK);
    good = core.config;
    late = good;
    late.session.tick = 120;
    late.session.ledger = core.game.accounts.ledger;
    late.session.ledger.store_came_late = 1;
    /* These are the largest valid values. core_init() accepts them at the end of the test. */
    late.persistent.ranking.row[1][2][3].round_id = LEDGER_ID_MAX;
    late.session.credit.pending_coins[0].units = 2u * BALANCE_MAX;
    for (size_t i = 0; i < 13; i++) {
        bad[i] = late;
    }
    bad[0].persistent.ledger.last_id = LEDGER_ID_MAX + 1u;
    bad[1].persistent.ledger.boots = UINT32_MAX;
    bad[2].persistent.ledger.balance.open = 9;
    bad[3].persistent.ledger.balance.paid = UINT32_MAX;
    bad[4].persistent.ranking.row[0][0][0].slot = POI_MAX;
    memset(bad[5].persistent.ranking.row[2][1][9].name, 'x', LEDGER_NAME_SIZE);
    bad[6].persistent.ranking.row[1][2][3].round_id = UINT32_MAX;
    bad[7].session.ledger.last_id = UINT32_MAX;
    bad[8].session.ledger.saved_id = bad[8].session.ledger.last_id + 1u;
    bad[9].session.ledger.after[LEDGER_RING - 1u].units = UINT32_MAX;
    bad[10].session.ledger.committed.open = 200;
    bad[11].session.credit.pending_coins[0].owed = UINT32_MAX;
    bad[12].session.ledger.store_came_late = 2;
    for (size_t i = 0; i < 13; i++) {
        assert_int_equal(core_init(&core, &bad[i]), CORE_ERR_RANGE);
        /* The encoder cannot represent the values of cases 4 and 5, so these cases are skipped. */
        if (i != 4 && i != 5) {
            const size_t size = replay_initial_state_encode(&bad[i], bytes);
            memset(&back, 0, sizeof back);
            assert_int_equal(replay_initial_state_decode(&back, bytes, size, REPLAY_VERSION), 0);
        }
    }
    assert_int_equal(core_init(&core, &good), CORE_OK);
    assert_int_equal(core_init(&core, &late), CORE_OK);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_every_field_has_its_range),
        TEST(test_tickets_refunds_and_open_rounds_have_their_ranges),
        TEST(test_a_start_skips_a_mirror_entry_out_of_range),
        TEST(test_the_database_returns_no_entry_out_of_range),
        TEST(test_a_start_rebuilds_sums_that_the_core_would_reject),
        TEST(test_a_start_rebuilds_rejected_sums_that_the_backup_also_holds),
        TEST(test_a_database_whose_ids_would_wrap_keeps_its_credits_over_a_restart),
        TEST(test_the_core_writes_no_entry_beyond_the_last_id),
        TEST(test_the_core_and_the_replay_reject_a_state_that_is_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
