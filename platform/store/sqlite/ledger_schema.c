/* ledger_schema.c -- the SQL statements, the tables of all file versions, and the migrations from
 * older file versions. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/sqlite/ledger_internal.h"

/* ---- SQL text of the migrations ------------------------------------------------------------ */

/* SQL text that migrates a file of version 1. Version 1 had only one game mode (the festival with
 * paper No. 6) and one player. Version 1 recorded neither the number of scoops nor the damage of
 * the paper. */
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
    CORE_ASSERT(which < LEDGER_STATEMENT_COUNT);
    CORE_ASSERT(texts[which]);
    return texts[which];
}

/* ---- Migration from versions 1 and 2, in which rounds become entries ----------------------- */

static const char select_old[] =
    "SELECT number, seed, start_tick, end_tick, caught, by_bot, ended_at, mode, grade"
    " FROM old_rounds ORDER BY number";
static const char select_old_players[] =
    "SELECT player, caught, coalesce(scoops, 0), coalesce(hole_area_mm2, 0),"
    " coalesce(torn_tick, 0), fouls FROM old_round_players WHERE round = ?1";

/* Converts a round of an old file to an entry. A round of an unknown mode is marked as unscored, so
 * that it is not ranked. */
static struct ledger_entry old_entry(sqlite3_stmt *old, uint32_t id)
{
    const struct sql_day ended = sql_day_of(sqlite3_column_int64(old, 6));
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

/* Writes a ledger entry for each round of the old file, as if the current version had recorded the
 * round. The functions for new entries then also compute the aggregates. Returns an SQLite code. */
static int carry_over(struct ledger_file *file, sqlite3_stmt *old, sqlite3_stmt *players)
{
    struct ledger_content *content = &file->content;
    int code;
    uint32_t id = 0;
    while ((code = sqlite3_step(old)) == SQLITE_ROW) {
        struct ledger_entry entry = old_entry(old, ++id);
        sqlite3_bind_int64(players, 1, (sqlite3_column_int64(old, 0)));
        while ((code = sqlite3_step(players)) == SQLITE_ROW) {
            const uint32_t seat = sql_uint(players, 0, UINT32_MAX);
            if (seat < POI_MAX) {
                entry.round.players |= (uint8_t)(1u << seat);
                entry.round.player[seat] = (struct player_record){
                    .caught = sql_uint(players, 1, UINT32_MAX),
                    .scoops = sql_uint(players, 2, UINT32_MAX),
                    .hole_area_mm2 = sql_uint(players, 3, UINT32_MAX),
                    .torn_tick = sql_uint(players, 4, UINT32_MAX),
                    .fouls = (uint8_t)sql_uint(players, 5, UINT8_MAX),
                };
            }
        }
        sqlite3_reset(players);
        code = code == SQLITE_DONE ? SQLITE_OK : code;
        code = code == SQLITE_OK ? ledger_rows_put(file, &entry) : code;
        if (code != SQLITE_OK) {
            return code;
        }
        ledger_aggregates_note(content, &entry);
    }
    const struct ledger_content nothing = { 0 };
    return code == SQLITE_DONE ? ledger_aggregates_put(file, &nothing, content) : code;
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
    CORE_ASSERT(version < LEDGER_FILE_VERSION);
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
    if (code == SQLITE_OK) {
        sqlite3_stmt *old = NULL, *players = NULL;
        code = sqlite3_prepare_v2(file->db, select_old, -1, &old, NULL);
        code = code == SQLITE_OK
                   ? sqlite3_prepare_v2(file->db, select_old_players, -1, &players, NULL)
                   : code;
        code = code == SQLITE_OK ? carry_over(file, old, players) : code;
        sqlite3_finalize(players);
        sqlite3_finalize(old);
    }
    return code == SQLITE_OK ? sql_run(file->db, forget_unknown) : code;
}

/* ---- Tables -------------------------------------------------------------------------------- */

/* The exact SQL text of every table in every version of the file.
 *
 * A new file is created from these texts, and each opened file is compared with them. A file with
 * another text or any other schema object (a trigger, a view, an index, another table) is treated
 * as damaged, because a trigger could delete acknowledged rows.
 *
 * To add a version: increase LEDGER_FILE_VERSION and set the last version of each table that
 * changes. Then add a row with the new text, exactly as SQLite stores it after the migration. */

#define NOW LEDGER_FILE_VERSION

/* Tables of all versions. The columns have the names of the fields in core/ledger.h. SQLite stores
 * a zero without any byte of data. NULL in a player's column means that an earlier version did not
 * record the number. */
static const struct table {
    uint8_t first, last; /* First and last `user_version` that have this table. */
    const char *name, *text;
} tables[] = {
    { 1, 1, "rounds",
      "CREATE TABLE rounds ("
      " number INTEGER PRIMARY KEY," /* Number of the round, counted over all program runs. */
      " id INTEGER NOT NULL,"        /* Number of the round, counted within one program run. */
      " seed INTEGER NOT NULL,"
      " start_tick INTEGER NOT NULL,"
      " end_tick INTEGER NOT NULL,"
      " caught INTEGER NOT NULL," /* Total of all players' caught fish. */
      " by_bot INTEGER NOT NULL,"
      " ended_at INTEGER NOT NULL)" }, /* Unix time in seconds. */
    { 2, 2, "rounds",                  /* The definition is the table of version 1 with the columns
                                          that ALTER TABLE has appended. */
      "CREATE TABLE rounds ("
      " number INTEGER PRIMARY KEY, id INTEGER NOT NULL, seed INTEGER NOT NULL,"
      " start_tick INTEGER NOT NULL, end_tick INTEGER NOT NULL, caught INTEGER NOT NULL,"
      " by_bot INTEGER NOT NULL, ended_at INTEGER NOT NULL,"
      " mode INTEGER NOT NULL DEFAULT 0, grade INTEGER NOT NULL DEFAULT 6,"
      " players INTEGER NOT NULL DEFAULT 1)" },
    { 2, 2, "round_players",
      "CREATE TABLE round_players ("
      " round INTEGER NOT NULL REFERENCES rounds (number) ON DELETE CASCADE,"
      " player INTEGER NOT NULL," /* Number of the player, counted from 0. */
      " caught INTEGER NOT NULL, scoops INTEGER, hole_area_mm2 INTEGER, torn_tick INTEGER,"
      " fouls INTEGER NOT NULL,"
      " PRIMARY KEY (round, player)) WITHOUT ROWID" },
    { 3, NOW, "entries",
      "CREATE TABLE entries ("
      " id INTEGER PRIMARY KEY, boot INTEGER NOT NULL, tick INTEGER NOT NULL,"
      " day INTEGER NOT NULL, minute INTEGER NOT NULL, kind INTEGER NOT NULL,"
      " detail INTEGER NOT NULL, count INTEGER NOT NULL, value INTEGER NOT NULL,"
      " units INTEGER NOT NULL, bonus_units INTEGER NOT NULL, paid INTEGER NOT NULL,"
      " service INTEGER NOT NULL, untold INTEGER NOT NULL, open INTEGER NOT NULL,"
      " up_s INTEGER NOT NULL, dropped_ticks INTEGER NOT NULL, device_faults INTEGER NOT NULL,"
      " name TEXT NOT NULL,"
      " sum INTEGER NOT NULL)" }, /* Checksum of all columns except the name, because a name may be
                                     revoked. */
    { 3, 3, "rounds",
      "CREATE TABLE rounds ("
      " entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,"
      " minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,"
      " end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,"
      " mode INTEGER NOT NULL, grade INTEGER NOT NULL,"
      " players INTEGER NOT NULL," /* Bit set of the players of the round. */
      " unscored INTEGER NOT NULL)" },
    { 4, NOW, "rounds",
      "CREATE TABLE rounds ("
      " entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,"
      " minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,"
      " end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,"
      " mode INTEGER NOT NULL, grade INTEGER NOT NULL,"
      " players INTEGER NOT NULL," /* Bit set of the players of the round. */
      " unscored INTEGER NOT NULL,"
      " fish_count INTEGER NOT NULL," /* Number of fish. 0 means that fish_count, round_s and preset
                                         are unknown. */
      " round_s INTEGER NOT NULL, preset INTEGER NOT NULL)" },
    { 3, NOW, "round_players",
      "CREATE TABLE round_players ("
      " round INTEGER NOT NULL, seat INTEGER NOT NULL, caught INTEGER NOT NULL,"
      " scoops INTEGER, hole_area_mm2 INTEGER, torn_tick INTEGER, sheets INTEGER,"
      " fouls INTEGER NOT NULL, name TEXT NOT NULL DEFAULT '',"
      " PRIMARY KEY (round, seat)) WITHOUT ROWID" },
    { 3, NOW, "settings",
      "CREATE TABLE settings (name TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID" },
    { 3, NOW, "audits",
      "CREATE TABLE audits (name TEXT PRIMARY KEY, count INTEGER NOT NULL) WITHOUT ROWID" },
    { 3, NOW, "ranking",
      "CREATE TABLE ranking ("
      " mode INTEGER NOT NULL, period INTEGER NOT NULL, place INTEGER NOT NULL,"
      " caught INTEGER NOT NULL, round INTEGER NOT NULL, day INTEGER NOT NULL,"
      " seat INTEGER NOT NULL, name TEXT NOT NULL,"
      " PRIMARY KEY (mode, period, place)) WITHOUT ROWID" },
    { 3, NOW, "state",
      "CREATE TABLE state (name TEXT PRIMARY KEY, value INTEGER NOT NULL) WITHOUT ROWID" },
    { 3, NOW, "replays", "CREATE TABLE replays (round INTEGER PRIMARY KEY, bytes BLOB NOT NULL)" },
};
#define TABLE_COUNT (sizeof tables / sizeof tables[0])

static bool is_of(const struct table *table, int version)
{
    return version >= table->first && version <= table->last;
}

int ledger_tables_make(sqlite3 *db, int version, const char *name)
{
    CORE_ASSERT(version >= 1 && version <= LEDGER_FILE_VERSION);
    int code = SQLITE_OK;
    for (size_t i = 0; code == SQLITE_OK && i < TABLE_COUNT; i++) {
        if (is_of(&tables[i], version) && (!name || strcmp(name, tables[i].name) == 0)) {
            code = sql_run(db, tables[i].text);
        }
    }
    return code;
}

/* ---- Comparison with a file's schema ------------------------------------------------------- */

static bool is_text(sqlite3_stmt *row, int column, const char *text)
{
    const unsigned char *found = sqlite3_column_text(row, column);
    return found && (size_t)sqlite3_column_bytes(row, column) == strlen(text) &&
           strcmp((const char *)found, text) == 0;
}

#define SELECT_SCHEMA "SELECT type, name, tbl_name, sql FROM sqlite_schema"

/* Returns the index of the table that a row of the schema describes, or TABLE_COUNT if no table
 * matches. */
static size_t find_table(sqlite3_stmt *row, int version)
{
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        if (is_of(&tables[i], version) && is_text(row, 0, "table") &&
            is_text(row, 1, tables[i].name) && is_text(row, 2, tables[i].name) &&
            is_text(row, 3, tables[i].text)) {
            return i;
        }
    }
    return TABLE_COUNT;
}

_Static_assert(TABLE_COUNT < 32u, "a bit for each table");

/* Compares the schema with the tables of `user_version`. Version 1 did not set `user_version`,
 * which is then 0. A new file also has 0, but no tables. */
int ledger_schema_check(sqlite3 *db, int64_t user_version)
{
    const int version = user_version == 0 ? 1 : (int)user_version;
    uint32_t found = 0;
    bool has_other = user_version < 0 || user_version > LEDGER_FILE_VERSION;
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(db, SELECT_SCHEMA, -1, &row, NULL);
    while ((code == SQLITE_OK || code == SQLITE_ROW) && (code = sqlite3_step(row)) == SQLITE_ROW) {
        const size_t index = find_table(row, version);
        has_other = has_other || index == TABLE_COUNT || (found >> index & 1u) != 0;
        found |= index < TABLE_COUNT ? 1u << index : 0u;
    }
    code = sql_end(row, code);
    const bool is_new = user_version == 0 && found == 0;
    uint32_t all = 0;
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        all |= is_of(&tables[i], version) ? 1u << i : 0u;
    }
    return code == SQLITE_OK && (has_other || (found != all && !is_new)) ? SQLITE_CORRUPT : code;
}

static bool is_name_of_table(sqlite3_stmt *row, int version)
{
    bool is_name = false;
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        is_name = is_name || (is_of(&tables[i], version) && is_text(row, 0, "table") &&
                              is_text(row, 1, tables[i].name));
    }
    return is_name;
}

bool ledger_schema_foreign(sqlite3 *db, struct ledger_foreign *out)
{
    int64_t user_version = 0;
    sqlite3_stmt *row = NULL;
    bool has_found = false;
    int code = sql_number(db, "PRAGMA user_version", &user_version);
    const int version = user_version == 0 ? 1 : (int)user_version;
    code = code == SQLITE_OK ? sqlite3_prepare_v2(db, SELECT_SCHEMA, -1, &row, NULL) : code;
    while (code == SQLITE_OK && version > 0 && !has_found && sqlite3_step(row) == SQLITE_ROW) {
        has_found = find_table(row, version) == TABLE_COUNT;
        sql_text(row, 0, out->type, sizeof out->type);
        sql_text(row, 1, out->name, sizeof out->name);
        out->is_changed = has_found && is_name_of_table(row, version);
    }
    sqlite3_finalize(row);
    return has_found;
}
