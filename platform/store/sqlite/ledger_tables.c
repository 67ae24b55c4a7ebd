/* ledger_tables.c -- the exact SQL text of every table in every version of the file.
 *
 * A new file is created from these texts, and each opened file is compared with them. A file with
 * another text or any other schema object (a trigger, a view, an index, another table) is treated
 * as damaged, because a trigger could delete acknowledged rows.
 *
 * To add a version: increase LEDGER_FILE_VERSION and set the last version of each table that
 * changes. Then add a row with the new text, exactly as SQLite stores it after the migration. */
#include <string.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

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
    { 2, 2, "rounds",                  /* The table of version 1 with columns appended by ALTER
                                          TABLE. */
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
      " players INTEGER NOT NULL," /* Players of the round, one bit each. */
      " unscored INTEGER NOT NULL)" },
    { 4, NOW, "rounds",
      "CREATE TABLE rounds ("
      " entry INTEGER PRIMARY KEY, boot INTEGER NOT NULL, day INTEGER NOT NULL,"
      " minute INTEGER NOT NULL, seed INTEGER NOT NULL, start_tick INTEGER NOT NULL,"
      " end_tick INTEGER NOT NULL, caught INTEGER NOT NULL, by_bot INTEGER NOT NULL,"
      " mode INTEGER NOT NULL, grade INTEGER NOT NULL,"
      " players INTEGER NOT NULL," /* Players of the round, one bit each. */
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

static uint32_t all_of(int version)
{
    uint32_t all = 0;
    for (size_t i = 0; i < TABLE_COUNT; i++) {
        all |= is_of(&tables[i], version) ? 1u << i : 0u;
    }
    return all;
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
    return code == SQLITE_OK && (has_other || (found != all_of(version) && !is_new))
               ? SQLITE_CORRUPT
               : code;
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
