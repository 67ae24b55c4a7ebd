/* test_score_file.c -- what the file of rounds holds, and that a file of yesterday's Kingyo keeps
 * its rounds. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "platform/score_file.h"

/* As the first version wrote it, to the letter. */
static const char first_version[] =
    "PRAGMA journal_mode = DELETE;"
    "CREATE TABLE IF NOT EXISTS rounds ("
    " number INTEGER PRIMARY KEY, id INTEGER NOT NULL, seed INTEGER NOT NULL,"
    " start_tick INTEGER NOT NULL, end_tick INTEGER NOT NULL, caught INTEGER NOT NULL,"
    " by_bot INTEGER NOT NULL, ended_at INTEGER NOT NULL);"
    "INSERT INTO rounds (id, seed, start_tick, end_tick, caught, by_bot, ended_at) VALUES"
    " (1, 7, 360, 7560, 3, 0, strftime('%s', 'now')),"
    " (2, 7, 8000, 9000, 9, 1, strftime('%s', 'now')),"
    " (3, 8, 9500, 9900, 2, 0, strftime('%s', 'now') - 400000)";

static char path[64];
static struct score_file file;

static int set_up(void **state)
{
    (void)state;
    strcpy(path, "/tmp/kingyo-scores-XXXXXX");
    const int handle = mkstemp(path);
    memset(&file, 0, sizeof file);
    return handle < 0 ? -1 : close(handle);
}

static int tear_down(void **state)
{
    (void)state;
    score_file_close(&file);
    return unlink(path);
}

static void do_sql(const char *sql)
{
    sqlite3 *db;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}

/* The one number that a query yields, to another program. */
static int ask(const char *query)
{
    sqlite3 *db;
    sqlite3_stmt *statement;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, query, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    const int answer = sqlite3_column_int(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return answer;
}

static void open_file(void)
{
    assert_int_equal(score_file_open(&file, path), SQLITE_OK);
}

static int write_round(uint8_t mode, uint32_t first, uint32_t third, uint8_t by_bot)
{
    const struct round_record record = {
        .id = 4,
        .seed = 11,
        .start_tick = 600,
        .end_tick = 22200,
        .caught = first + third,
        .by_bot = by_bot,
        .mode = mode,
        .grade = 5,
        .players = 1u << 0 | 1u << 2,
        .player = { [0] = { .caught = first, .scoops = 21, .hole_area_mm2 = 150, .fouls = 2 },
                    [1] = { .caught = 77 }, /* Who is not marked did not play. */
                    [2] = { .caught = third, .scoops = 5, .torn_tick = 1234, .fouls = 1 } },
    };
    return score_file_write(&file, &record, (int64_t)time(NULL));
}

static void test_a_round_and_its_players_are_kept_with_every_field(void **state)
{
    (void)state;
    open_file();
    assert_int_equal(write_round(MODE_CHAMPIONSHIP, 30, 4, 0), SQLITE_OK);
    assert_int_equal(ask("SELECT count(*) FROM rounds WHERE id = 4 AND seed = 11 AND"
                         " start_tick = 600 AND end_tick = 22200 AND caught = 34 AND by_bot = 0"
                         " AND mode = 1 AND grade = 5 AND players = 2"),
                     1);
    assert_int_equal(ask("SELECT count(*) FROM round_players"), 2);
    assert_int_equal(ask("SELECT count(*) FROM round_players WHERE round = 1 AND player = 0 AND"
                         " caught = 30 AND scoops = 21 AND hole_area_mm2 = 150 AND"
                         " torn_tick IS NULL AND fouls = 2"),
                     1);
    assert_int_equal(ask("SELECT count(*) FROM round_players WHERE round = 1 AND player = 2 AND"
                         " caught = 4 AND scoops = 5 AND hole_area_mm2 = 0 AND torn_tick = 1234"
                         " AND fouls = 1"),
                     1);
}

static void test_each_mode_has_its_best_of_one_person(void **state)
{
    (void)state;
    uint32_t best[MODE_COUNT] = { 9, 9, 9 };
    open_file();
    write_round(MODE_CHAMPIONSHIP, 30, 4, 0);
    write_round(MODE_CHAMPIONSHIP, 12, 13, 0);
    write_round(MODE_CHAMPIONSHIP, 90, 0, 1); /* A bot's. */
    write_round(MODE_FESTIVAL, 2, 3, 0);
    assert_int_equal(score_file_best_today(&file, best), SQLITE_OK);
    assert_int_equal(best[MODE_FESTIVAL], 3);
    assert_int_equal(best[MODE_CHAMPIONSHIP], 30);
    assert_int_equal(best[MODE_PRACTICE], 0);
}

static void test_a_mode_that_is_not_known_does_no_harm(void **state)
{
    (void)state;
    uint32_t best[MODE_COUNT];
    open_file();
    write_round(200, 50, 0, 0);
    write_round(MODE_FESTIVAL, 1, 0, 0);
    assert_int_equal(score_file_best_today(&file, best), SQLITE_OK);
    assert_int_equal(best[MODE_FESTIVAL], 1);
}

static void test_a_file_of_the_first_version_keeps_its_rounds(void **state)
{
    (void)state;
    uint32_t best[MODE_COUNT];
    do_sql(first_version);
    open_file();
    assert_int_equal(ask("PRAGMA user_version"), SCORE_FILE_VERSION);
    assert_int_equal(ask("SELECT count(*) FROM rounds WHERE mode = 0 AND grade = 6 AND players = 1"
                         " AND (id, seed, start_tick, end_tick, caught, by_bot) IN"
                         " (VALUES (1, 7, 360, 7560, 3, 0), (2, 7, 8000, 9000, 9, 1),"
                         " (3, 8, 9500, 9900, 2, 0))"),
                     3);
    assert_int_equal(ask("SELECT count(*) FROM round_players JOIN rounds ON round = number WHERE"
                         " player = 0 AND round_players.caught = rounds.caught AND fouls = 0 AND"
                         " scoops IS NULL AND hole_area_mm2 IS NULL AND torn_tick IS NULL"),
                     3);
    assert_int_equal(score_file_best_today(&file, best), SQLITE_OK);
    assert_int_equal(best[MODE_FESTIVAL], 3);
    assert_int_equal(write_round(MODE_FESTIVAL, 6, 0, 0), SQLITE_OK); /* And goes on. */
    assert_int_equal(ask("SELECT max(number) FROM rounds"), 4);
}

static void test_a_file_is_brought_up_to_date_once(void **state)
{
    (void)state;
    do_sql(first_version);
    open_file();
    score_file_close(&file);
    open_file();
    assert_int_equal(ask("SELECT count(*) FROM round_players"), 3);
}

static void test_what_cannot_be_brought_up_to_date_stays_as_it_was(void **state)
{
    (void)state;
    do_sql(first_version);
    do_sql("CREATE TABLE round_players (of_somebody_else)"); /* The last step will fail. */
    assert_int_not_equal(score_file_open(&file, path), SQLITE_OK);
    assert_null(file.db);
    assert_int_equal(ask("PRAGMA user_version"), 0);
    assert_int_equal(ask("SELECT count(*) FROM pragma_table_info('rounds')"), 8);
    assert_int_equal(ask("SELECT count(*) FROM rounds"), 3);
}

static void test_a_file_of_a_later_version_is_left_alone(void **state)
{
    (void)state;
    do_sql(first_version);
    do_sql("PRAGMA user_version = 3; PRAGMA journal_mode = WAL"); /* As that one likes it. */
    assert_int_equal(score_file_open(&file, path), SCORE_FILE_NEWER);
    assert_null(file.db);
    assert_string_equal(score_file_error(SCORE_FILE_NEWER), "a later Kingyo wrote it");
    assert_int_equal(ask("PRAGMA user_version"), 3);
    assert_int_equal(ask("SELECT journal_mode = 'wal' FROM pragma_journal_mode"), 1);
    assert_int_equal(ask("SELECT count(*) FROM pragma_table_info('rounds')"), 8);
}

static void test_a_round_is_written_whole_or_not_at_all(void **state)
{
    (void)state;
    open_file();
    do_sql("CREATE TRIGGER full BEFORE INSERT ON round_players WHEN NEW.player = 2"
           " BEGIN SELECT raise(ABORT, 'no room'); END");
    assert_int_not_equal(write_round(MODE_FESTIVAL, 1, 2, 0), SQLITE_OK);
    assert_int_equal(ask("SELECT count(*) FROM rounds"), 0);
    assert_int_equal(ask("SELECT count(*) FROM round_players"), 0);
    do_sql("DROP TRIGGER full");
    assert_int_equal(write_round(MODE_FESTIVAL, 1, 2, 0), SQLITE_OK);
    assert_int_equal(ask("SELECT count(*) FROM round_players"), 2);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_a_round_and_its_players_are_kept_with_every_field),
        TEST(test_each_mode_has_its_best_of_one_person),
        TEST(test_a_mode_that_is_not_known_does_no_harm),
        TEST(test_a_file_of_the_first_version_keeps_its_rounds),
        TEST(test_a_file_is_brought_up_to_date_once),
        TEST(test_what_cannot_be_brought_up_to_date_stays_as_it_was),
        TEST(test_a_file_of_a_later_version_is_left_alone),
        TEST(test_a_round_is_written_whole_or_not_at_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
