/* ledger_schema.c -- the SQL statements, and the migrations from older file versions.
 * ledger_tables.c has the tables. */
#include <stddef.h>
#include <stdio.h>

#include <sqlite3.h>

#include "platform/store/sqlite/day.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* ---- SQL text of the migrations ------------------------------------------------------------ */

/* SQL text that migrates a file of version 1. Version 1 had one mode (the festival with paper No.
 * 6) and one player. Version 1 recorded neither the number of scoops nor the paper's damage. */
static const char to_2[] =
    "ALTER TABLE rounds ADD COLUMN mode INTEGER NOT NULL DEFAULT 0;" /* Game mode of the round (enum
                                                                        game_mode). */
    "ALTER TABLE rounds ADD COLUMN grade INTEGER NOT NULL DEFAULT 6;"
    "ALTER TABLE rounds ADD COLUMN players INTEGER NOT NULL DEFAULT 1;"; /* Number of players in the
                                                                            round. */
static const char fill_2[] = "INSERT INTO round_players (round, player, caught, fouls)"
                             " SELECT number, 0, caught, 0 FROM rounds;";

/* SQL text that migrates the rounds of version 3, which did not record the tank. */
static const char set_rounds_aside[] = "ALTER TABLE rounds RENAME TO old_rounds;";
static const char fill_4[] = "INSERT INTO rounds SELECT *, 0, 0, 0 FROM old_rounds;"
                             "DROP TABLE old_rounds;";

static const char set_old_aside[] = "ALTER TABLE rounds RENAME TO old_rounds;"
                                    "ALTER TABLE round_players RENAME TO old_round_players;";

/* SQL text that sets a value to NULL if the old file did not record the value. The column `entry`
 * counts the old rounds in the order of their numbers. */
static const char forget_unknown[] =
    "UPDATE round_players SET sheets = NULL;"
    "UPDATE round_players SET scoops = NULL, hole_area_mm2 = NULL, torn_tick = NULL"
    " WHERE (round, seat) IN (SELECT place, player FROM old_round_players JOIN"
    "  (SELECT number, row_number() OVER (ORDER BY number) AS place FROM old_rounds)"
    "  ON number = round WHERE scoops IS NULL);"
    "DROP TABLE old_round_players;"
    "DROP TABLE old_rounds;";

/* ---- SQL text of the prepared statements --------------------------------------------------- */

static const char *const texts[LEDGER_STATEMENT_COUNT] = {
    [PUT_ENTRY] = "INSERT INTO entries VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12,"
                  " ?13, ?14, ?15, ?16, ?17, ?18, ?20, ?19)",
    [PUT_ROUND] = "INSERT INTO rounds VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?,"
                  " ?, ?)",
    [PUT_PLAYER] = "INSERT INTO round_players (round, seat, caught, scoops, hole_area_mm2,"
                   " torn_tick, sheets, fouls) VALUES (?, ?, ?, ?, ?, nullif(?, 0), ?, ?)",
    [PUT_NAME] = "UPDATE round_players SET name = ?3 WHERE round = ?1 AND seat = ?2",
    [FORGET_NAME] = "UPDATE entries SET name = '' WHERE kind = ?3 AND count = ?1 AND detail = ?2",
    [PUT_SETTING] = "INSERT INTO settings (value, name) VALUES (?1, ?2)"
                    " ON CONFLICT (name) DO UPDATE SET value = ?1",
    [FORGET_SETTINGS] = "DELETE FROM settings",
    [PUT_AUDIT] = "INSERT INTO audits (count, name) VALUES (?1, ?2)"
                  " ON CONFLICT (name) DO UPDATE SET count = ?1",
    [PUT_RANK] = "INSERT OR REPLACE INTO ranking VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
    [PUT_STATE] = "INSERT INTO state (value, name) VALUES (?1, ?2)"
                  " ON CONFLICT (name) DO UPDATE SET value = ?1",
    [PUT_REPLAY] = "INSERT OR REPLACE INTO replays (round, bytes) VALUES (?1, ?2)",
    [GET_REPLAY] = "SELECT bytes FROM replays WHERE round = ?1",
    [HAS_REPLAY] = "SELECT 1 FROM replays WHERE round = ?1",
};

const char *ledger_statement_text(enum ledger_statement which)
{
    return texts[which];
}

/* ---- Migration from versions 1 and 2, in which rounds become entries ----------------------- */

static const char select_old[] =
    "SELECT number, seed, start_tick, end_tick, caught, by_bot, ended_at, mode, grade"
    " FROM old_rounds ORDER BY number";
static const char select_old_players[] =
    "SELECT player, caught, coalesce(scoops, 0), coalesce(hole_area_mm2, 0),"
    " coalesce(torn_tick, 0), fouls FROM old_round_players WHERE round = ?1";

static int read_old_players(sqlite3_stmt *players, int64_t number, struct round_record *round)
{
    int code;
    sqlite3_bind_int64(players, 1, number);
    while ((code = sqlite3_step(players)) == SQLITE_ROW) {
        const uint32_t seat = sql_uint(players, 0, UINT32_MAX);
        if (seat < POI_MAX) {
            round->players |= (uint8_t)(1u << seat);
            round->player[seat] = (struct player_record){
                .caught = sql_uint(players, 1, UINT32_MAX),
                .scoops = sql_uint(players, 2, UINT32_MAX),
                .hole_area_mm2 = sql_uint(players, 3, UINT32_MAX),
                .torn_tick = sql_uint(players, 4, UINT32_MAX),
                .fouls = (uint8_t)sql_uint(players, 5, UINT8_MAX),
            };
        }
    }
    sqlite3_reset(players);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

/* Converts an old round to an entry. A round of an unknown mode is marked as unscored, so that it
 * is not ranked. */
static struct ledger_entry old_entry(sqlite3_stmt *old, uint32_t id)
{
    const struct day_minute ended = day_minute_of(sqlite3_column_int64(old, 6));
    const uint32_t mode = sql_uint(old, 7, UINT8_MAX);
    return (struct ledger_entry){
        .id = id,
        .day = ended.day,
        .minute = ended.minute,
        .kind = LEDGER_ROUND,
        .round = {
            .id = id,
            .seed = sql_uint(old, 1, UINT32_MAX),
            .start_tick = sql_uint(old, 2, UINT32_MAX),
            .end_tick = sql_uint(old, 3, UINT32_MAX),
            .caught = sql_uint(old, 4, UINT32_MAX),
            .by_bot = (uint8_t)sql_uint(old, 5, 1),
            .mode = (uint8_t)(mode < MODE_COUNT ? mode : MODE_PRACTICE),
            .grade = (uint8_t)sql_uint(old, 8, SHEET_GRADE_MAX),
            .unscored = mode >= MODE_PRACTICE,
        },
    };
}

/* Writes an entry for each old round, as if the current version had recorded it. The functions for
 * new entries then also compute the aggregates. Returns an SQLite code. */
static int carry_over(struct ledger_file *file, sqlite3_stmt *old, sqlite3_stmt *players)
{
    struct ledger_content *content = &file->content;
    int code;
    uint32_t id = 0;
    while ((code = sqlite3_step(old)) == SQLITE_ROW) {
        struct ledger_entry entry = old_entry(old, ++id);
        code = read_old_players(players, sqlite3_column_int64(old, 0), &entry.round);
        code = code == SQLITE_OK ? ledger_rows_put(file, &entry) : code;
        if (code != SQLITE_OK) {
            return code;
        }
        ledger_aggregates_note(content, &entry);
    }
    const struct ledger_content nothing = { 0 };
    return code == SQLITE_DONE ? ledger_aggregates_put(file, &nothing, content) : code;
}

static int carry_all_over(struct ledger_file *file)
{
    sqlite3_stmt *old = NULL, *players = NULL;
    int code = sqlite3_prepare_v2(file->db, select_old, -1, &old, NULL);
    code = code == SQLITE_OK ? sqlite3_prepare_v2(file->db, select_old_players, -1, &players, NULL)
                             : code;
    code = code == SQLITE_OK ? carry_over(file, old, players) : code;
    sqlite3_finalize(players);
    sqlite3_finalize(old);
    return code;
}

static int put_version(sqlite3 *db)
{
    char text[40];
    snprintf(text, sizeof text, "PRAGMA user_version = %d", LEDGER_FILE_VERSION);
    return sql_run(db, text);
}

static int make_now(sqlite3 *db)
{
    const int code = ledger_tables_make(db, LEDGER_FILE_VERSION, NULL);
    return code == SQLITE_OK ? put_version(db) : code;
}

static int raise_1_to_2(sqlite3 *db)
{
    int code = sql_run(db, to_2);
    code = code == SQLITE_OK ? ledger_tables_make(db, 2, "round_players") : code;
    return code == SQLITE_OK ? sql_run(db, fill_2) : code;
}

static int raise_3_to_4(sqlite3 *db)
{
    int code = sql_run(db, set_rounds_aside);
    code = code == SQLITE_OK ? ledger_tables_make(db, 4, "rounds") : code;
    return code == SQLITE_OK ? sql_run(db, fill_4) : code;
}

int ledger_schema_raise(struct ledger_file *file, int version)
{
    if (version >= 3) { /* The tables are the same in versions 4 and 5. */
        const int raised = version == 3 ? raise_3_to_4(file->db) : SQLITE_OK;
        return raised == SQLITE_OK ? put_version(file->db) : raised;
    }
    int64_t has_rounds = 0;
    int code = sql_number(file->db, "SELECT count(*) FROM sqlite_schema WHERE name = 'rounds'",
                          &has_rounds);
    if (code != SQLITE_OK || !has_rounds) {
        return code != SQLITE_OK ? code : make_now(file->db);
    }
    code = version < 2 ? raise_1_to_2(file->db) : code;
    code = code == SQLITE_OK ? sql_run(file->db, set_old_aside) : code;
    code = code == SQLITE_OK ? make_now(file->db) : code;
    code = code == SQLITE_OK ? carry_all_over(file) : code;
    return code == SQLITE_OK ? sql_run(file->db, forget_unknown) : code;
}
