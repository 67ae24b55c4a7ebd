/* ledger_schema.c -- the tables of all file versions, and the migrations from older file
 * versions. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"
#include "sql_texts.h"

/* ---- Tables -------------------------------------------------------------------------------- */

/* The exact SQL text (ledger.sql) of every table in every version of the file.
 *
 * A new file is created from these texts, and the schema of each opened file is compared with
 * these texts. A file with another text or any other schema object (a trigger, a view, an index,
 * another table) is treated as damaged, because a trigger could delete acknowledged rows.
 *
 * To add a version: increase LEDGER_FILE_VERSION and set the last version of each table that
 * changes. Then add the new text to ledger.sql, exactly as SQLite stores it after the migration,
 * and a row that refers to the text. */

#define NOW LEDGER_FILE_VERSION

static const struct table {
    uint8_t first, last; /* First and last file version (`user_version`) that has this table. */
    const char *name, *text;
} tables[] = {
    { 1, 1, "rounds", sql_rounds_1 },
    { 2, 2, "rounds", sql_rounds_2 },
    { 2, 2, "round_players", sql_round_players_2 },
    { 3, NOW, "entries", sql_entries },
    { 3, 3, "rounds", sql_rounds_3 },
    { 4, 5, "rounds", sql_rounds_4 },
    { 6, NOW, "rounds", sql_rounds },
    { 3, NOW, "round_players", sql_round_players },
    { 3, NOW, "settings", sql_settings },
    { 3, NOW, "audits", sql_audits },
    { 3, 5, "ranking", sql_ranking_3 },
    { 6, NOW, "ranking", sql_ranking },
    { 3, NOW, "state", sql_state },
    { 3, NOW, "replays", sql_replays },
};
#define TABLE_COUNT (sizeof tables / sizeof tables[0])

static bool is_of(const struct table *table, int version)
{
    return version >= table->first && version <= table->last;
}

/* Creates all tables of `version`. If `name` is not null, creates only the table `name`. Returns an
 * SQLite code. */
static int make_tables(sqlite3 *db, int version, const char *name)
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

/* Returns the index of the table of `version` that a row of the schema describes, or TABLE_COUNT if
 * there is none. If `by_name` is true, only the type and the name are compared. */
static size_t find_table(sqlite3_stmt *row, int version, bool by_name)
{
    size_t i = 0;
    while (i < TABLE_COUNT &&
           !(is_of(&tables[i], version) && is_text(row, 0, "table") &&
             is_text(row, 1, tables[i].name) &&
             (by_name || (is_text(row, 2, tables[i].name) && is_text(row, 3, tables[i].text))))) {
        i++;
    }
    return i;
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
    while (sql_row(row, &code)) {
        const size_t index = find_table(row, version, false);
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

bool ledger_schema_foreign(sqlite3 *db, struct ledger_foreign *out)
{
    int64_t user_version = 0;
    sqlite3_stmt *row = NULL;
    bool has_found = false;
    int code = sql_number(db, "PRAGMA user_version", &user_version);
    const int version = user_version == 0 ? 1 : (int)user_version;
    code = code == SQLITE_OK ? sqlite3_prepare_v2(db, SELECT_SCHEMA, -1, &row, NULL) : code;
    while (version > 0 && !has_found && sql_row(row, &code)) {
        has_found = find_table(row, version, false) == TABLE_COUNT;
        sql_text(row, 0, out->type, sizeof out->type);
        sql_text(row, 1, out->name, sizeof out->name);
        out->is_changed = has_found && find_table(row, version, true) < TABLE_COUNT;
    }
    sqlite3_finalize(row);
    return has_found;
}

const char *ledger_foreign_reason(const struct ledger_foreign *foreign)
{
    return foreign->is_changed ? "whose definition is not Kingyo's" : "which is not Kingyo's";
}

/* ---- Migration from versions 1 and 2, in which rounds become entries ----------------------- */

/* Writes a ledger entry for each round of the old file, as if the current version had recorded the
 * round. The functions for new entries then also compute the aggregates. A round of an unknown mode
 * is marked as unscored, so that it is not ranked. Returns an SQLite code. */
static int carry_over(struct ledger_file *file, sqlite3_stmt *old, sqlite3_stmt *players)
{
    struct ledger_content *content = &file->content;
    const struct ledger_content nothing = { 0 };
    int code = SQLITE_OK;
    uint32_t id = 0;
    while (sql_row(old, &code)) {
        const struct sql_day ended = sql_day_of(sqlite3_column_int64(old, 6));
        const uint32_t mode = sql_uint(old, 7, UINT8_MAX);
        id++;
        struct ledger_entry entry = {
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
        sqlite3_bind_int64(players, 1, sqlite3_column_int64(old, 0));
        while (sql_row(players, &code)) {
            const uint32_t slot = sql_uint(players, 0, UINT32_MAX);
            if (slot < POI_MAX) {
                entry.round.players |= (uint8_t)(1u << slot);
                entry.round.player[slot] = (struct player_record){
                    .caught = sql_uint(players, 1, UINT32_MAX),
                    .scoops = sql_uint(players, 2, UINT32_MAX),
                    .hole_area_mm2 = sql_uint(players, 3, UINT32_MAX),
                    .torn_tick = sql_uint(players, 4, UINT32_MAX),
                    .fouls = (uint8_t)sql_uint(players, 5, UINT8_MAX),
                };
            }
        }
        sqlite3_reset(players);
        code = code == SQLITE_DONE ? ledger_rows_put(file, &entry) : code;
        if (code != SQLITE_OK) {
            return code;
        }
        ledger_aggregates_note(content, &entry);
    }
    return code == SQLITE_DONE ? ledger_aggregates_put(file, &nothing, content) : code;
}

/* Migrates one table: runs `before`, creates the table `name` of `version`, and runs `after`.
 * Returns an SQLite code. */
static int renew_table(sqlite3 *db, const char *before, int version, const char *name,
                       const char *after)
{
    int code = sql_run(db, before);
    code = code == SQLITE_OK ? make_tables(db, version, name) : code;
    return code == SQLITE_OK ? sql_run(db, after) : code;
}

/* Migrates a file of version 1 or 2, or a new file, which has no tables. Returns an SQLite code. */
static int raise_to_now(struct ledger_file *file, int version)
{
    int64_t has_rounds = 0;
    int code = sql_number(file->db, "SELECT count(*) FROM sqlite_schema WHERE name = 'rounds'",
                          &has_rounds);
    if (code == SQLITE_OK && has_rounds && version < 2) {
        code = renew_table(file->db, sql_to_2, 2, "round_players", sql_fill_2);
    }
    if (code == SQLITE_OK && has_rounds) {
        code = sql_run(file->db, sql_rename_old);
    }
    code = code == SQLITE_OK ? make_tables(file->db, LEDGER_FILE_VERSION, NULL) : code;
    if (code == SQLITE_OK && has_rounds) {
        sqlite3_stmt *old = NULL, *players = NULL;
        code = sqlite3_prepare_v2(file->db, sql_select_old, -1, &old, NULL);
        code = code == SQLITE_OK
                   ? sqlite3_prepare_v2(file->db, sql_select_old_players, -1, &players, NULL)
                   : code;
        code = code == SQLITE_OK ? carry_over(file, old, players) : code;
        sqlite3_finalize(players);
        sqlite3_finalize(old);
        code = code == SQLITE_OK ? sql_run(file->db, sql_forget_unknown) : code;
    }
    return code;
}

int ledger_schema_raise(struct ledger_file *file, int version)
{
    CORE_ASSERT(version < LEDGER_FILE_VERSION);
    char text[40];
    int code = SQLITE_OK;
    if (version < 3) {
        code = raise_to_now(file, version);
    } else { /* Versions 4 and 5 have the same tables, so both are migrated in the same way. */
        code = renew_table(file->db, sql_rename_rounds, NOW, "rounds",
                           version == 3 ? sql_fill_rounds_3 : sql_fill_rounds_4);
        code = code == SQLITE_OK
                   ? renew_table(file->db, sql_rename_ranking, NOW, "ranking", sql_fill_ranking)
                   : code;
        code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
    }
    snprintf(text, sizeof text, "PRAGMA user_version = %d", LEDGER_FILE_VERSION);
    return code == SQLITE_OK ? sql_run(file->db, text) : code;
}
