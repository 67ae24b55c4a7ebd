/* test_ledger_omit.c -- Tests the recovery after repeated panics. At each start one more part of
 * the stored data is left out: settings, then replays, then names.
 *
 * The money, the PIN and the scores must stay. A copy of the database keeps all data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/store/sqlite/ledger_backup.h"
#include "tests/unit/support/ledger_fixture.h"

static char words[LEDGER_LEAVE_WORDS];

static struct ledger_entry setting(uint32_t id, uint32_t which, int32_t value)
{
    return (struct ledger_entry){ .id = id,
                                  .boot = 1,
                                  .kind = LEDGER_SETTING,
                                  .detail = (uint8_t)which,
                                  .count = which >> 8,
                                  .value = value,
                                  .balance = { .paid = 3, .units = 1 } };
}

static void fill(void)
{
    struct ledger_entry round = { .id = 4, .boot = 1, .tick = 99, .kind = LEDGER_ROUND };
    round.balance = (struct balance){ .paid = 3, .units = 1 };
    round.round = (struct round_record){ .id = 4,
                                         .start_tick = 1,
                                         .end_tick = 90,
                                         .caught = 6,
                                         .grade = 6,
                                         .players = 1,
                                         .player[0] = { .caught = 6, .sheets = 1 } };
    struct ledger_entry name = {
        .id = 5, .boot = 1, .kind = LEDGER_NAME, .count = 4, .balance = round.balance, .name = "AYA"
    };
    const struct ledger_entry entries[] = { setting(1, SET_VOLUME, 30), setting(2, SET_PRICE, 4),
                                            setting(3, SET_PIN, 4711), round, name };
    assert_int_equal(ledger_file_open(&file, path, NULL), 0);
    assert_int_equal(ledger_file_write(&file, entries, 5), 0);
    assert_int_equal(ledger_file_put_replay(&file, 4, "replay", 6), 0);
    ledger_file_close(&file);
}

static void open_now(const char *suffix)
{
    char named[96];
    snprintf(named, sizeof named, "%s%s", path, suffix);
    assert_int_equal(ledger_file_inspect(&file, named), 0);
    assert_int_equal(ledger_check(file.db), 0);
}

static const struct rank_row *best(void)
{
    return &file.content.memory.ranking.row[0][RANK_EVER][0];
}

/* Asserts that the data that the recovery must never remove are unchanged. */
static void assert_money_and_score(void)
{
    assert_int_equal(file.content.memory.ledger.last_id, 5);
    assert_int_equal(file.content.memory.ledger.balance.paid, 3);
    assert_int_equal(file.content.memory.ledger.balance.units, 1);
    assert_int_equal(file.content.has_setting[SET_PRICE], 1);
    assert_int_equal(file.content.has_setting[SET_PIN], 1);
    assert_int_equal(best()->caught, 6);
}

static void assert_holds(const char *suffix, int has_volume, int has_replay, const char *name)
{
    open_now(suffix);
    assert_money_and_score();
    assert_int_equal(file.content.has_setting[SET_VOLUME], has_volume);
    assert_int_equal(ledger_file_has_replay(&file, 4), has_replay);
    assert_string_equal(best()->name, name);
    ledger_file_close(&file);
}

static void test_settings_replays_and_names_are_removed_in_order_and_money_is_kept(void **state)
{
    (void)state;
    struct stat about;
    char copy[96];
    fill();
    assert_holds("", 1, 1, "AYA");
    assert_int_equal(ledger_leave_out(folder, LEFT_SETTINGS, words), 0);
    assert_holds("", 0, 1, "AYA");
    assert_int_equal(ledger_leave_out(folder, LEFT_REPLAYS, words), 0);
    assert_holds("", 0, 0, "AYA");
    assert_int_equal(ledger_leave_out(folder, LEFT_NAMES, words), 0);
    assert_holds("", 0, 0, "");
    assert_holds(".left-out-1", 1, 1, "AYA");
    assert_holds(".left-out-2", 0, 1, "AYA");
    assert_holds(".left-out-3", 0, 0, "AYA");
    snprintf(copy, sizeof copy, "%s.left-out-1", path);
    assert_int_equal(stat(copy, &about), 0);
    assert_int_equal(about.st_mode & 0777, 0600);
    assert_non_null(strstr(words, "kingyo.db.left-out-3"));
}

static void test_without_a_database_no_file_is_created(void **state)
{
    (void)state;
    assert_int_equal(ledger_leave_out(folder, LEFT_NAMES, words), LEDGER_LEAVE_NONE);
    assert_non_null(strstr(words, "there is no kingyo.db"));
    assert_int_not_equal(access(path, F_OK), 0);
}

static void test_nothing_is_removed_if_no_copy_can_be_made(void **state)
{
    (void)state;
    char name[96];
    fill();
    for (unsigned i = 1; i <= LEDGER_LEFT_MAX; i++) {
        snprintf(name, sizeof name, "%s.left-out-%u", path, i);
        assert_int_equal(symlink("nowhere", name), 0);
    }
    assert_int_equal(ledger_leave_out(folder, LEFT_NAMES, words), -1);
    assert_non_null(strstr(words, "nothing was changed"));
    assert_holds("", 1, 1, "AYA");
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_settings_replays_and_names_are_removed_in_order_and_money_is_kept),
        TEST(test_without_a_database_no_file_is_created),
        TEST(test_nothing_is_removed_if_no_copy_can_be_made),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
