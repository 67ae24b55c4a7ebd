/* score_file.c -- SQL, all of it. */
#include "platform/score_file.h"

#include <stdbool.h>
#include <string.h>

#include <sqlite3.h>

#define BUSY_MS 2000 /* Another program (kingyoctl, a backup) may hold the file this long. */

/* A rollback journal, not WAL: one small write a minute, and no extra file has to survive for the
 * last one to count. EXTRA also syncs the folder after the journal is gone, so that a power cut
 * cannot bring the journal back and undo a round that was said to be written. */
static const char settings[] = "PRAGMA journal_mode = DELETE;"
                               "PRAGMA synchronous = EXTRA;"
                               "PRAGMA foreign_keys = ON;";

/* What the first version made, and every file begins as. */
static const char version_1[] = "CREATE TABLE IF NOT EXISTS rounds ("
                                " number INTEGER PRIMARY KEY," /* Over all runs of the kiosk. */
                                " id INTEGER NOT NULL,"        /* Within one run. */
                                " seed INTEGER NOT NULL,"
                                " start_tick INTEGER NOT NULL,"
                                " end_tick INTEGER NOT NULL,"
                                " caught INTEGER NOT NULL," /* Of all players together. */
                                " by_bot INTEGER NOT NULL,"
                                " ended_at INTEGER NOT NULL);"; /* Unix time, seconds. */

/* There was one mode, the festival with paper No. 6, and one player; how often it scooped and what
 * became of its paper was not kept. */
static const char version_2[] =
    "ALTER TABLE rounds ADD COLUMN mode INTEGER NOT NULL DEFAULT 0;" /* enum game_mode */
    "ALTER TABLE rounds ADD COLUMN grade INTEGER NOT NULL DEFAULT 6;"
    "ALTER TABLE rounds ADD COLUMN players INTEGER NOT NULL DEFAULT 1;" /* How many. */
    "CREATE TABLE round_players ("
    " round INTEGER NOT NULL REFERENCES rounds (number) ON DELETE CASCADE,"
    " player INTEGER NOT NULL," /* From 0. */
    " caught INTEGER NOT NULL,"
    " scoops INTEGER,"        /* Null: not known. */
    " hole_area_mm2 INTEGER," /* Null: not known. */
    " torn_tick INTEGER,"     /* Null: the paper lasted, or it is not known. */
    " fouls INTEGER NOT NULL,"
    " PRIMARY KEY (round, player)) WITHOUT ROWID;"
    "INSERT INTO round_players (round, player, caught, fouls)"
    " SELECT number, 0, caught, 0 FROM rounds;";

static const char insert_round[] =
    "INSERT INTO rounds (id, seed, start_tick, end_tick, caught, by_bot, ended_at, mode, grade,"
    " players) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

static const char insert_player[] =
    "INSERT INTO round_players (round, player, caught, scoops, hole_area_mm2, torn_tick, fouls)"
    " VALUES (?, ?, ?, ?, ?, nullif(?, 0), ?)";

static const char select_best[] =
    "SELECT mode, max(round_players.caught) FROM rounds JOIN round_players ON round = number"
    " WHERE by_bot = 0 AND ended_at >="
    " CAST(strftime('%s', 'now', 'localtime', 'start of day', 'utc') AS INTEGER) GROUP BY mode";

static int run(struct score_file *file, const char *sql)
{
    return sqlite3_exec(file->db, sql, NULL, NULL, NULL);
}

/* ---- Opening -------------------------------------------------------------------------------- */

/* SQLITE_OK, or why the file cannot be used. SQLite finds most damage only when asked to look. */
static int check(struct score_file *file)
{
    sqlite3_stmt *check = NULL;
    int code = sqlite3_prepare_v2(file->db, "PRAGMA quick_check(1)", -1, &check, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(check);
        if (code == SQLITE_ROW) {
            const unsigned char *verdict = sqlite3_column_text(check, 0);
            const bool good = verdict && strcmp((const char *)verdict, "ok") == 0;
            code = good ? SQLITE_OK : SQLITE_CORRUPT;
        }
    }
    sqlite3_finalize(check);
    return code;
}

static int read_version(struct score_file *file, int *version)
{
    sqlite3_stmt *ask = NULL;
    int code = sqlite3_prepare_v2(file->db, "PRAGMA user_version", -1, &ask, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(ask);
        if (code == SQLITE_ROW) {
            *version = sqlite3_column_int(ask, 0);
            code = SQLITE_OK;
        }
    }
    sqlite3_finalize(ask);
    return code;
}

static int raise_version(struct score_file *file, int version)
{
    int code = version > SCORE_FILE_VERSION ? SCORE_FILE_NEWER : SQLITE_OK;
    if (version < 2) {
        code = run(file, version_1);
        code = code == SQLITE_OK ? run(file, version_2) : code;
        code = code == SQLITE_OK ? run(file, "PRAGMA user_version = 2") : code;
    }
    return code;
}

/* Within one transaction, so that of two programs that open an old file one finds it done. */
static int bring_up_to_date(struct score_file *file)
{
    int version = 0;
    int code = run(file, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = read_version(file, &version);
    code = code == SQLITE_OK ? raise_version(file, version) : code;
    code = code == SQLITE_OK ? run(file, "COMMIT") : code;
    if (code != SQLITE_OK) {
        run(file, "ROLLBACK");
    }
    return code;
}

static int prepare(struct score_file *file)
{
    const unsigned flags = SQLITE_PREPARE_PERSISTENT;
    const int code =
        sqlite3_prepare_v3(file->db, insert_round, -1, flags, &file->insert_round, NULL);
    return code != SQLITE_OK ? code
                             : sqlite3_prepare_v3(file->db, insert_player, -1, flags,
                                                  &file->insert_player, NULL);
}

/* Before anything that would change the file. */
static int refuse_newer(struct score_file *file)
{
    int version = 0;
    const int code = read_version(file, &version);
    return code == SQLITE_OK && version > SCORE_FILE_VERSION ? SCORE_FILE_NEWER : code;
}

int score_file_open(struct score_file *file, const char *path)
{
    const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
    int code = sqlite3_open_v2(path, &file->db, flags, NULL);
    if (code == SQLITE_OK) {
        sqlite3_busy_timeout(file->db, BUSY_MS);
        code = check(file);
    }
    code = code == SQLITE_OK ? refuse_newer(file) : code;
    code = code == SQLITE_OK ? run(file, settings) : code;
    code = code == SQLITE_OK ? bring_up_to_date(file) : code;
    code = code == SQLITE_OK ? prepare(file) : code;
    if (code != SQLITE_OK) {
        score_file_close(file);
    }
    return code;
}

void score_file_close(struct score_file *file)
{
    sqlite3_finalize(file->insert_round);
    sqlite3_finalize(file->insert_player);
    sqlite3_close(file->db);
    *file = (struct score_file){ 0 };
}

/* ---- Rows ----------------------------------------------------------------------------------- */

int score_file_best_today(struct score_file *file, uint32_t best[MODE_COUNT])
{
    sqlite3_stmt *select = NULL;
    int code = sqlite3_prepare_v2(file->db, select_best, -1, &select, NULL);
    memset(best, 0, MODE_COUNT * sizeof best[0]);
    while (code == SQLITE_OK || code == SQLITE_ROW) {
        code = sqlite3_step(select);
        const int64_t mode = code == SQLITE_ROW ? sqlite3_column_int64(select, 0) : MODE_COUNT;
        if (mode >= 0 && mode < MODE_COUNT) {
            best[mode] = (uint32_t)sqlite3_column_int64(select, 1);
        }
    }
    sqlite3_finalize(select);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

static int insert(sqlite3_stmt *statement, const int64_t *values, int count)
{
    for (int i = 0; i < count; i++) {
        sqlite3_bind_int64(statement, i + 1, values[i]);
    }
    const int code = sqlite3_step(statement);
    sqlite3_reset(statement);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

static int64_t count_players(const struct round_record *record)
{
    int64_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += record->players >> i & 1u;
    }
    return count;
}

static int write_round(struct score_file *file, const struct round_record *record, int64_t ended_s)
{
    const int64_t values[] = { record->id,     record->seed,   record->start_tick, record->end_tick,
                               record->caught, record->by_bot, ended_s,            record->mode,
                               record->grade,  count_players(record) };
    return insert(file->insert_round, values, (int)(sizeof values / sizeof values[0]));
}

static int write_players(struct score_file *file, const struct round_record *record)
{
    const int64_t number = sqlite3_last_insert_rowid(file->db);
    int code = SQLITE_OK;
    for (uint32_t i = 0; code == SQLITE_OK && i < POI_MAX; i++) {
        const struct player_record *player = &record->player[i];
        const int64_t values[] = { number,         i,
                                   player->caught, player->scoops,
                                   player->hole_area_mm2,
                                   player->torn_tick, player->fouls };
        if (record->players >> i & 1u) {
            code = insert(file->insert_player, values, (int)(sizeof values / sizeof values[0]));
        }
    }
    return code;
}

int score_file_write(struct score_file *file, const struct round_record *record, int64_t ended_s)
{
    int code = run(file, "BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = write_round(file, record, ended_s);
    code = code == SQLITE_OK ? write_players(file, record) : code;
    code = code == SQLITE_OK ? run(file, "COMMIT") : code;
    if (code != SQLITE_OK) {
        run(file, "ROLLBACK");
    }
    return code;
}

const char *score_file_error(int code)
{
    return code == SCORE_FILE_NEWER ? "a later Kingyo wrote it" : sqlite3_errstr(code);
}
