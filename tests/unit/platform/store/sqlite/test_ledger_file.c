/* test_ledger_file.c -- Tests the ledger file, which is the SQLite database of the store: its
 * content, its atomic writes, and the migration of older files.
 *
 * The files in store/files/ were written by older versions of Kingyo. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/store/sqlite/ledger_file.h"
#include "core/game/game_fields.h"
#include "tests/unit/support/ledger_fixture.h"

/* Runs `query` in a separate connection, as another program would. Returns the only number of its
 * result. */
static int query_number(const char *query)
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
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
}

static void reopen(void)
{
    ledger_file_close(&file);
    open_file();
}

static void write_entry(const struct ledger_entry *entry)
{
    assert_int_equal(ledger_file_write(&file, entry, 1), SQLITE_OK);
}

/* Returns an entry with a different value in each field that all kinds of entries share. The fields
 * that only rounds and names have are 0. */
static struct ledger_entry full_entry(uint32_t id, uint8_t kind)
{
    return (struct ledger_entry){
        .id = id,
        .boot = 3,
        .tick = 1200,
        .day = 9821,
        .minute = 1170,
        .kind = kind,
        .detail = 1,
        .count = 2,
        .value = kind == LEDGER_SETTING ? -5 : 5, /* Only the value of a setting may be negative. */
        .balance = { .units = 1,
                     .bonus_units = 7,
                     .paid = 4,
                     .service = 2,
                     .unlogged = 6,
                     .open = 2 },
        .health = { .up_s = 600, .dropped_ticks = 12, .device_faults = 9 },
    };
}

static struct ledger_entry round_entry(uint32_t id, uint8_t mode, uint32_t first, uint32_t third)
{
    struct ledger_entry entry = full_entry(id, LEDGER_ROUND);
    entry.round = (struct round_record){
        .id = id,
        .seed = 11,
        .start_tick = 600,
        .end_tick = 22200,
        .caught = first + third,
        .fish_count = 70,
        .round_s = 180,
        .preset = 2,
        .mode = mode,
        .grade = 5,
        .players = 1u << 0 | 1u << 2,
        .player = { [0] = { .caught = first,
                            .scoops = 21,
                            .hole_area_mm2 = 150,
                            .sheets = 1,
                            .fouls = 2 },
                    [2] = { .caught = third,
                            .scoops = 5,
                            .torn_tick = 1234,
                            .sheets = 3,
                            .fouls = 1 } },
    };
    return entry;
}

static struct ledger_entry setting_entry(uint32_t id, uint32_t setting, int32_t value)
{
    return (struct ledger_entry){ .id = id,
                                  .boot = 1,
                                  .kind = LEDGER_SETTING,
                                  .detail = (uint8_t)setting,
                                  .count = setting >> 8,
                                  .value = value };
}

/* ---- Tests of single entries ---------------------------------------------------------------- */

static void test_an_entry_is_read_with_every_field(void **state)
{
    (void)state;
    struct ledger_entry entry = full_entry(1, LEDGER_COINS), found;
    strcpy(entry.name, "きんぎょ");
    open_file();
    write_entry(&entry);
    reopen();
    assert_int_equal(ledger_file_entry(&file, 1, &found), SQLITE_OK);
    assert_memory_equal(&found, &entry, sizeof entry);
    assert_int_equal(ledger_file_entry(&file, 2, &found), SQLITE_NOTFOUND);
    entry = full_entry(2, LEDGER_SETTING);
    write_entry(&entry);
    assert_int_equal(ledger_file_entry(&file, 2, &found), SQLITE_OK);
    assert_memory_equal(&found, &entry, sizeof entry);
}

static void test_a_round_is_read_with_every_player(void **state)
{
    (void)state;
    const struct ledger_entry entry = round_entry(1, MODE_CHAMPIONSHIP, 30, 4);
    struct ledger_entry found;
    open_file();
    write_entry(&entry);
    reopen();
    assert_int_equal(ledger_file_entry(&file, 1, &found), SQLITE_OK);
    assert_memory_equal(&found, &entry, sizeof entry);
}

static void test_the_balance_is_that_of_the_newest_entry(void **state)
{
    (void)state;
    struct ledger_entry entry = full_entry(1, LEDGER_COINS);
    struct persistent_state memory = { 0 };
    open_file();
    write_entry(&entry);
    entry.id = 2;
    entry.balance.paid = 9;
    write_entry(&entry);
    reopen();
    ledger_content_load(&file.content, &memory);
    assert_memory_equal(&memory.ledger.balance, &entry.balance, sizeof entry.balance);
    assert_int_equal(memory.ledger.last_id, 2);
    assert_int_equal(memory.ledger.boots, 3);
}

static void test_existing_entries_are_skipped(void **state)
{
    (void)state;
    struct ledger_entry entries[3];
    for (uint32_t i = 0; i < 3; i++) {
        entries[i] = round_entry(i + 1, MODE_FESTIVAL, 2, 0);
    }
    open_file();
    assert_int_equal(ledger_file_write(&file, entries, 2), SQLITE_OK);
    assert_int_equal(ledger_file_write(&file, entries, 3), SQLITE_OK);
    assert_int_equal(query_number("SELECT count(*) FROM rounds"), 3);
    assert_int_equal(query_number("SELECT count FROM audits WHERE name = 'caught'"), 6);
}

static void test_a_batch_is_written_atomically(void **state)
{
    (void)state;
    struct ledger_entry entries[2] = { full_entry(1, LEDGER_COINS),
                                       round_entry(2, MODE_FESTIVAL, 1, 2) };
    open_file();
    do_sql("INSERT INTO round_players VALUES (2, 2, 0, 0, 0, 0, 0, 0, '')");
    assert_int_not_equal(ledger_file_write(&file, entries, 2), SQLITE_OK);
    assert_int_equal(query_number("SELECT count(*) FROM entries"), 0);
    assert_int_equal(file.content.memory.ledger.last_id, 0);
    do_sql("DELETE FROM round_players");
    assert_int_equal(ledger_file_write(&file, entries, 2), SQLITE_OK);
    assert_int_equal(query_number("SELECT count(*) FROM entries"), 2);
    assert_int_equal(query_number("SELECT count(*) FROM round_players"), 2);
}

static void test_a_flipped_bit_in_the_balance_is_detected(void **state)
{
    (void)state;
    const struct ledger_entry entry = full_entry(1, LEDGER_COINS);
    open_file();
    write_entry(&entry);
    ledger_file_close(&file);
    do_sql("UPDATE entries SET paid = paid + 64");
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
}

/* ---- Tests of aggregates (totals and ranking) ----------------------------------------------- */

static void test_a_flipped_bit_in_the_aggregates_is_detected(void **state)
{
    (void)state;
    static const char *const flips[] = {
        "UPDATE settings SET value = value + 4",
        "UPDATE audits SET count = count - 8 WHERE name = 'caught'",
        "UPDATE ranking SET caught = caught + 16",
        "UPDATE ranking SET name = 'b'",
        "UPDATE state SET value = value + 1 WHERE name = 'ranking-boot'",
        "DELETE FROM settings",
    };
    const struct ledger_entry round = round_entry(2, MODE_FESTIVAL, 11, 6);
    const struct ledger_entry volume = {
        .id = 1, .boot = 3, .kind = LEDGER_SETTING, .detail = SET_VOLUME, .value = 40
    };
    for (size_t i = 0; i < sizeof flips / sizeof flips[0]; i++) {
        open_file();
        write_entry(&volume);
        write_entry(&round);
        reopen();
        ledger_file_close(&file);
        do_sql(flips[i]);
        assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
        assert_int_equal(truncate(path, 0), 0);
    }
}

static void test_a_file_without_checksums_is_read(void **state)
{
    (void)state;
    const struct ledger_entry first = round_entry(1, MODE_FESTIVAL, 5, 6);
    const struct ledger_entry next = round_entry(2, MODE_FESTIVAL, 5, 6);
    open_file();
    write_entry(&first);
    ledger_file_close(&file);
    do_sql("DELETE FROM state WHERE name LIKE 'tally-%';"
           "DELETE FROM audits WHERE name = 'tally'");
    open_file();
    write_entry(&next);
    ledger_file_close(&file);
    do_sql("UPDATE audits SET count = 1 WHERE name = 'caught'");
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
}

static void test_the_aggregates_on_disk_match_those_of_the_core(void **state)
{
    (void)state;
    static struct persistent_state sums, found;
    struct ledger_entry entries[13];
    for (uint32_t i = 0; i < 13; i++) {
        entries[i] = i % 3 == 0 && i < 12 ? full_entry(i + 1, (uint8_t)(LEDGER_BOOT + i))
                                          : round_entry(i + 1, (uint8_t)(i % 2), i, 20 - i);
        /* The last entry is of the next day, so it clears the leaderboards of the day. */
        entries[i].day = i == 12 ? 9822 : 9821;
        audits_note(&sums.audits, &entries[i]);
        ranking_note(&sums.ranking, &entries[i]);
    }
    open_file();
    assert_int_equal(ledger_file_write(&file, entries, 5), SQLITE_OK);
    assert_int_equal(ledger_file_write(&file, entries + 5, 7), SQLITE_OK);
    assert_int_equal(ledger_file_write(&file, entries + 12, 1), SQLITE_OK);
    reopen();
    ledger_content_load(&file.content, &found);
    assert_memory_equal(&found.audits, &sums.audits, sizeof sums.audits);
    assert_true(field_hash(0, &ranking_fields, &found.ranking) ==
                field_hash(0, &ranking_fields, &sums.ranking));
}

static void test_a_name_is_stored_with_its_round_and_can_be_withdrawn(void **state)
{
    (void)state;
    const struct ledger_entry round = round_entry(1, MODE_FESTIVAL, 5, 6);
    struct ledger_entry name = {
        .id = 2, .boot = 3, .kind = LEDGER_NAME, .detail = 2, .count = 1, .name = "らんちゅう"
    };
    open_file();
    write_entry(&round);
    write_entry(&name);
    assert_int_equal(query_number("SELECT count(*) FROM round_players WHERE seat = 2 AND"
                                  " name = 'らんちゅう'"),
                     1);
    assert_string_equal(file.content.memory.ranking.row[MODE_FESTIVAL][RANK_EVER][0].name,
                        "らんちゅう");
    reopen();
    assert_string_equal(file.content.memory.ranking.row[MODE_FESTIVAL][RANK_EVER][0].name,
                        "らんちゅう");
    name =
        (struct ledger_entry){ .id = 3, .boot = 3, .kind = LEDGER_NAME, .detail = 2, .count = 1 };
    write_entry(&name);
    assert_int_equal(query_number("SELECT count(*) FROM entries WHERE name <> ''"), 0);
    assert_int_equal(query_number("SELECT count(*) FROM round_players WHERE name <> ''"), 0);
    assert_int_equal(query_number("SELECT count(*) FROM ranking WHERE name <> ''"), 0);
}

static void test_only_changed_settings_are_stored(void **state)
{
    (void)state;
    struct persistent_state memory = { 0 };
    const struct ledger_entry volume = setting_entry(1, SET_VOLUME, 35);
    const struct ledger_entry slot = setting_entry(2, SET_CALIBRATION_END - 1, -12345);
    settings_reset(&memory.settings);
    /* The price comes from a configuration file instead of the ledger, so it must not change. */
    memory.settings.value[SET_PRICE] = 3;
    open_file();
    write_entry(&volume);
    write_entry(&slot);
    reopen();
    ledger_content_load(&file.content, &memory);
    assert_int_equal(memory.settings.value[SET_VOLUME], 35);
    assert_int_equal(memory.settings.value[SET_CALIBRATION_END - 1], -12345);
    assert_int_equal(memory.settings.value[SET_PRICE], 3);
    assert_int_equal(query_number("SELECT count(*) FROM settings"), 2);
}

static void test_a_factory_reset_deletes_every_setting(void **state)
{
    (void)state;
    struct ledger_entry entries[3] = { setting_entry(1, SET_VOLUME, 35),
                                       full_entry(2, LEDGER_FACTORY),
                                       setting_entry(3, SET_PRICE, 2) };
    open_file();
    assert_int_equal(ledger_file_write(&file, entries, 1), SQLITE_OK);
    assert_int_equal(ledger_file_write(&file, entries, 3), SQLITE_OK);
    reopen();
    assert_int_equal(file.content.has_setting[SET_VOLUME], 0);
    assert_int_equal(file.content.has_setting[SET_PRICE], 1);
    assert_int_equal(query_number("SELECT count(*) FROM settings"), 1);
}

static void test_an_unknown_setting_is_ignored(void **state)
{
    (void)state;
    open_file();
    ledger_file_close(&file);
    do_sql("DELETE FROM state; DELETE FROM audits;"
           "INSERT INTO settings VALUES ('volume', 1000), ('of-tomorrow', 1), ('price', 2);"
           "INSERT INTO audits VALUES ('of-tomorrow', 7);"
           "INSERT INTO ranking VALUES (0, 0, 0, 999, 1, 1, 1, 1, ''),"
           " (0, 9, 0, 0, 1, 1, 1, 1, ''), (9, 0, 0, 0, 1, 1, 1, 1, ''),"
           " (1, 1, 0, 0, 1, 1, 1, 1, '')");
    open_file();
    assert_int_equal(file.content.has_setting[SET_VOLUME], 0);
    assert_int_equal(file.content.memory.settings.value[SET_PRICE], 2);
    assert_int_equal(query_number("SELECT count(*) FROM settings WHERE name = 'of-tomorrow'"), 1);
}

/* ---- Tests of replays and of the deletion of old rows --------------------------------------- */

static void test_a_replay_is_read_byte_for_byte(void **state)
{
    (void)state;
    static uint8_t bytes[300000], found[300000];
    size_t size = 0;
    for (size_t i = 0; i < sizeof bytes; i++) {
        bytes[i] = (uint8_t)(i * 2654435761u >> 24);
    }
    open_file();
    assert_int_equal(ledger_file_put_replay(&file, 7, bytes, sizeof bytes), SQLITE_OK);
    reopen();
    assert_int_equal(ledger_file_get_replay(&file, 7, found, sizeof found, &size), SQLITE_OK);
    assert_int_equal(size, sizeof bytes);
    assert_memory_equal(found, bytes, sizeof bytes);
    memset(found, 0, sizeof found);
    assert_int_equal(ledger_file_get_replay(&file, 7, found, 1000, &size), SQLITE_TOOBIG);
    assert_int_equal(size, sizeof bytes);
    assert_memory_equal(found, bytes, 1000);
    assert_int_equal(found[1000], 0);
    assert_int_equal(ledger_file_get_replay(&file, 8, found, sizeof found, &size), SQLITE_NOTFOUND);
}

static void test_replays_of_rounds_that_leave_the_ranking_are_deleted(void **state)
{
    (void)state;
    open_file();
    /* Each round has a larger catch than the rounds before it. */
    for (uint32_t id = 1; id <= RANK_ROWS + 1; id++) {
        struct ledger_entry entry = round_entry(id, MODE_FESTIVAL, id, 0);
        entry.round.players = 1;
        write_entry(&entry);
        assert_int_equal(ledger_file_put_replay(&file, id, "replay", 6), SQLITE_OK);
        assert_int_equal(ledger_file_prune(&file), SQLITE_OK);
    }
    assert_int_equal(query_number("SELECT count(*) FROM replays"), RANK_ROWS);
    assert_int_equal(query_number("SELECT count(*) FROM replays WHERE round = 1"), 0);
    assert_int_equal(query_number("SELECT count(*) FROM rounds"), RANK_ROWS + 1);
}

static void test_old_entries_are_deleted_and_the_newest_kept(void **state)
{
    (void)state;
    static struct ledger_entry entries[1000];
    open_file();
    for (uint32_t id = 1; id <= LEDGER_FILE_ENTRIES + 300; id += 1000) {
        for (uint32_t i = 0; i < 1000; i++) {
            entries[i] = full_entry(id + i, LEDGER_COINS);
        }
        assert_int_equal(ledger_file_write(&file, entries, 1000), SQLITE_OK);
    }
    const int last = query_number("SELECT max(id) FROM entries");
    assert_int_equal(ledger_file_prune(&file), SQLITE_OK);
    assert_int_equal(query_number("SELECT count(*) FROM entries"), LEDGER_FILE_ENTRIES);
    assert_int_equal(query_number("SELECT max(id) FROM entries"), last);
    reopen();
    assert_int_equal(file.content.memory.ledger.last_id, last);
}

/* ---- Tests of files of older versions ------------------------------------------------------- */

static void test_migrating_a_version_1_file_keeps_its_rounds(void **state)
{
    (void)state;
    take_version(1);
    assert_int_equal(query_number("PRAGMA user_version"), 0);
    open_file();
    assert_int_equal(query_number("PRAGMA user_version"), LEDGER_FILE_VERSION);
    assert_int_equal(
        query_number("SELECT count(*) FROM rounds WHERE mode = 0 AND grade = 6 AND players = 1"
                     " AND (entry, seed, start_tick, end_tick, caught, by_bot) IN"
                     " (VALUES (1, 7, 360, 7560, 3, 0), (2, 7, 8000, 9000, 9, 1),"
                     " (3, 8, 9500, 9900, 2, 0))"),
        3);
    assert_int_equal(
        query_number("SELECT count(*) FROM round_players JOIN rounds ON round = entry WHERE"
                     " seat = 0 AND round_players.caught = rounds.caught AND fouls = 0 AND"
                     " scoops IS NULL AND hole_area_mm2 IS NULL AND torn_tick IS NULL"),
        3);
    const struct rank_row *best = file.content.memory.ranking.row[MODE_FESTIVAL][RANK_EVER];
    /* A bot played the best round in the file, with nine fish, so this round must not be ranked. */
    assert_int_equal(best[0].caught, 3);
    assert_int_equal(best[1].caught, 2);
    assert_int_equal(best[2].caught, 0);
    /* The migrated file must accept new entries. */
    const struct ledger_entry next = round_entry(4, MODE_FESTIVAL, 6, 0);
    write_entry(&next);
    reopen();
    assert_int_equal(file.content.memory.ledger.last_id, 4);
}

static void test_migrating_a_version_2_file_keeps_rounds_and_players(void **state)
{
    (void)state;
    struct ledger_entry first;
    take_version(2);
    assert_int_equal(query_number("PRAGMA user_version"), 2);
    open_file();
    assert_int_equal(ledger_file_entry(&file, 1, &first), SQLITE_OK);
    assert_int_equal(first.kind, LEDGER_ROUND);
    assert_int_equal(first.round.seed, 11);
    assert_int_equal(first.round.mode, MODE_CHAMPIONSHIP);
    assert_int_equal(first.round.grade, 5);
    assert_int_equal(first.round.players, 1u << 0 | 1u << 2);
    assert_int_equal(first.round.player[0].scoops, 41);
    assert_int_equal(first.round.player[2].torn_tick, 1234);
    assert_int_equal(first.round.player[2].fouls, 1);
    assert_int_equal(query_number("SELECT count(*) FROM rounds"), 4);
    assert_int_equal(query_number("SELECT count(*) FROM round_players"), 6);
    assert_int_equal(query_number("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'old%'"), 0);
    const struct ranking *ranking = &file.content.memory.ranking;
    assert_int_equal(ranking->row[MODE_CHAMPIONSHIP][RANK_EVER][0].caught, 30);
    assert_int_equal(ranking->row[MODE_FESTIVAL][RANK_EVER][0].caught, 3);
    assert_int_equal(ranking->row[MODE_FESTIVAL][RANK_EVER][1].round_id, 4);
    assert_int_equal(ranking->row[MODE_FESTIVAL][RANK_EVER][2].caught, 2);
    assert_in_range(first.day, 9460, 9461); /* Day 9460 is 2025-11-25. The time zone of the machine
                                               may shift it by a day. */
    /* The round of the bot, with nine fish, must not be counted. */
    assert_int_equal(file.content.memory.audits.count[AUDIT_CAUGHT], 34 + 3 + 5);
}

/* Asserts that the file has the content of version-3.db. All files from version-4.db to
 * version-6.db were made from this file by migration. */
static void holds_nine_entries_and_a_replay(void)
{
    struct ledger_entry round;
    size_t size = 0;
    char replay[8] = "";
    const struct persistent_state *memory = &file.content.memory;
    assert_int_equal(memory->ledger.last_id, 9);
    assert_int_equal(memory->ledger.boots, 2);
    assert_int_equal(memory->ledger.balance.paid, 2);
    assert_int_equal(memory->settings.value[SET_VOLUME], 35);
    assert_int_equal(memory->audits.count[AUDIT_CAUGHT], 7);
    assert_string_equal(memory->ranking.row[MODE_FESTIVAL][RANK_WEEK][0].name, "きんぎょ");
    assert_int_equal(ledger_file_entry(&file, 6, &round), SQLITE_OK);
    assert_int_equal(round.round.player[1].torn_tick, 7000);
    assert_int_equal(ledger_file_get_replay(&file, 6, replay, sizeof replay, &size), SQLITE_OK);
    assert_string_equal(replay, "replay");
    assert_int_equal(round.round.fish_count, 0); /* Version 3 did not store the number of fish in
                                                    the tank. */
    for (uint32_t id = 1; id <= 9; id++) {
        /* Reading an entry also verifies its checksum. */
        assert_int_equal(ledger_file_entry(&file, id, &round), SQLITE_OK);
    }
}

static void test_migrating_a_version_3_file_keeps_everything(void **state)
{
    (void)state;
    struct ledger_entry found, next = round_entry(10, MODE_FESTIVAL, 6, 0);
    take_version(3);
    assert_int_equal(query_number("PRAGMA user_version"), 3);
    open_file();
    holds_nine_entries_and_a_replay();
    write_entry(&next);
    reopen();
    assert_int_equal(ledger_file_entry(&file, 10, &found), SQLITE_OK);
    assert_int_equal(found.round.fish_count, 70);
    assert_int_equal(found.round.round_s, 180);
    assert_int_equal(found.round.preset, 2);
    assert_int_equal(query_number("PRAGMA user_version"), LEDGER_FILE_VERSION);
    assert_int_equal(query_number("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'old%'"), 0);
}

/* Version 5 has the same tables as version 4, but new values in them. The version number was
 * increased because programs for version 4 would reject these values. */
static void test_migrating_a_version_4_file_keeps_everything(void **state)
{
    (void)state;
    take_version(4);
    assert_int_equal(query_number("PRAGMA user_version"), 4);
    assert_int_equal(ledger_file_inspect(&file, path), SQLITE_SCHEMA);
    open_file();
    holds_nine_entries_and_a_replay();
    assert_int_equal(query_number("PRAGMA user_version"), LEDGER_FILE_VERSION);
    reopen();
    holds_nine_entries_and_a_replay();
}

static void test_migrating_a_version_5_file_counts_its_rounds_as_master(void **state)
{
    (void)state;
    struct ledger_entry found, next = round_entry(10, MODE_FESTIVAL, 200, 0);
    next.round.level = LEVEL_EASY;
    take_version(5);
    open_file();
    holds_nine_entries_and_a_replay();
    reopen();
    holds_nine_entries_and_a_replay();
    write_entry(&next);
    reopen();
    const uint32_t easy = ranking_board(MODE_FESTIVAL, LEVEL_EASY);
    assert_int_equal(file.content.memory.ranking.row[easy][RANK_EVER][0].caught, 200);
    assert_int_equal(file.content.memory.audits.count[AUDIT_ROUNDS_EASIER + 1], 1);
    assert_int_equal(ledger_file_entry(&file, 10, &found), SQLITE_OK);
    assert_int_equal(found.round.level, LEVEL_EASY);
    assert_int_equal(query_number("SELECT count(*) FROM rounds WHERE level <> 0"), 1);
    do_sql("UPDATE rounds SET level = 1 WHERE entry = 10");
    assert_int_equal(ledger_file_entry(&file, 10, &found), SQLITE_CORRUPT);
}

static void test_a_flipped_bit_in_a_version_4_file_is_detected(void **state)
{
    (void)state;
    take_version(4);
    open_file();
    const struct ledger_entry next = round_entry(10, MODE_FESTIVAL, 6, 0);
    write_entry(&next); /* This write adds checksums to the file. version-4.db has none. */
    ledger_file_close(&file);
    do_sql("PRAGMA user_version = 4; UPDATE ranking SET caught = caught + 1");
    assert_int_equal(ledger_file_open(&file, path, NULL), SQLITE_CORRUPT);
    assert_int_equal(query_number("PRAGMA user_version"), 4);
}

static void test_a_file_of_the_current_version_is_not_migrated(void **state)
{
    (void)state;
    take_version(6);
    assert_int_equal(query_number("PRAGMA user_version"), LEDGER_FILE_VERSION);
    open_file();
    holds_nine_entries_and_a_replay();
}

static void test_a_file_is_migrated_once(void **state)
{
    (void)state;
    take_version(2);
    open_file();
    reopen();
    assert_int_equal(query_number("SELECT count(*) FROM entries"), 4);
}

static void test_a_failed_migration_changes_nothing(void **state)
{
    (void)state;
    take_version(1);
    /* A table with this name already exists, so a late step of the migration must fail. */
    do_sql("CREATE TABLE ranking (of_somebody_else)");
    assert_int_not_equal(ledger_file_open(&file, path, NULL), SQLITE_OK);
    assert_null(file.db);
    assert_int_equal(query_number("PRAGMA user_version"), 0);
    assert_int_equal(query_number("SELECT count(*) FROM pragma_table_info('rounds')"), 8);
    assert_int_equal(query_number("SELECT count(*) FROM rounds"), 3);
}

static void test_a_file_of_a_later_version_is_not_changed(void **state)
{
    (void)state;
    take_version(2);
    /* Marks the file as written by a newer version of Kingyo. Such a file must not be changed. */
    do_sql("PRAGMA user_version = 99; PRAGMA journal_mode = WAL");
    assert_int_equal(ledger_file_open(&file, path, NULL), LEDGER_FILE_NEWER);
    assert_null(file.db);
    assert_string_equal(ledger_file_error(LEDGER_FILE_NEWER), "a later Kingyo wrote it");
    assert_int_equal(query_number("PRAGMA user_version"), 99);
    assert_int_equal(query_number("SELECT journal_mode = 'wal' FROM pragma_journal_mode"), 1);
}

static void test_a_read_only_open_changes_nothing(void **state)
{
    (void)state;
    const struct ledger_entry round = round_entry(1, MODE_FESTIVAL, 5, 6);
    take_version(2);
    assert_int_equal(ledger_file_inspect(&file, path), SQLITE_SCHEMA);
    assert_int_equal(query_number("PRAGMA user_version"), 2);
    unlink(path);
    open_file();
    write_entry(&round);
    ledger_file_close(&file);
    assert_int_equal(ledger_file_inspect(&file, path), SQLITE_OK);
    assert_int_equal(file.content.memory.audits.count[AUDIT_CAUGHT], 11);
    const struct ledger_entry next = round_entry(2, MODE_FESTIVAL, 5, 6);
    assert_int_not_equal(ledger_file_write(&file, &next, 1), SQLITE_OK);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_an_entry_is_read_with_every_field),
        TEST(test_a_round_is_read_with_every_player),
        TEST(test_the_balance_is_that_of_the_newest_entry),
        TEST(test_existing_entries_are_skipped),
        TEST(test_a_batch_is_written_atomically),
        TEST(test_a_flipped_bit_in_the_balance_is_detected),
        TEST(test_a_flipped_bit_in_the_aggregates_is_detected),
        TEST(test_a_file_without_checksums_is_read),
        TEST(test_the_aggregates_on_disk_match_those_of_the_core),
        TEST(test_a_name_is_stored_with_its_round_and_can_be_withdrawn),
        TEST(test_only_changed_settings_are_stored),
        TEST(test_a_factory_reset_deletes_every_setting),
        TEST(test_an_unknown_setting_is_ignored),
        TEST(test_a_replay_is_read_byte_for_byte),
        TEST(test_replays_of_rounds_that_leave_the_ranking_are_deleted),
        TEST(test_old_entries_are_deleted_and_the_newest_kept),
        TEST(test_migrating_a_version_1_file_keeps_its_rounds),
        TEST(test_migrating_a_version_2_file_keeps_rounds_and_players),
        TEST(test_migrating_a_version_3_file_keeps_everything),
        TEST(test_migrating_a_version_4_file_keeps_everything),
        TEST(test_migrating_a_version_5_file_counts_its_rounds_as_master),
        TEST(test_a_flipped_bit_in_a_version_4_file_is_detected),
        TEST(test_a_file_of_the_current_version_is_not_migrated),
        TEST(test_a_file_is_migrated_once),
        TEST(test_a_failed_migration_changes_nothing),
        TEST(test_a_file_of_a_later_version_is_not_changed),
        TEST(test_a_read_only_open_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
