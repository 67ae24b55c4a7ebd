/* ledger_read.c -- reads ledger entries and their aggregates (settings, audits and ranking), and
 * computes the checksums of the aggregates. The aggregates have their own rows, so that the kiosk
 * can start without reading all entries of several years. */
#include <string.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"
#include "sql_texts.h"

/* ---- Entries ------------------------------------------------------------------------------- */

static uint32_t column_u32(sqlite3_stmt *row, int column)
{
    return sql_uint(row, column, UINT32_MAX);
}

static uint16_t column_u16(sqlite3_stmt *row, int column)
{
    return (uint16_t)sql_uint(row, column, UINT16_MAX);
}

static uint8_t column_u8(sqlite3_stmt *row, int column)
{
    return (uint8_t)sql_uint(row, column, UINT8_MAX);
}

/* Reads a round. A recovered file may have an older version. Versions 4 and 5 lack the column
 * level, and version 3 also lacks the columns fish_count, round_s and preset. */
static int read_round(struct ledger_file *file, uint32_t id, struct round_record *round)
{
    static const char *const texts[] = { sql_get_round, sql_get_round_4, sql_get_round_3 };
    sqlite3_stmt *row = NULL;
    int code = SQLITE_ERROR;
    for (size_t i = 0; code == SQLITE_ERROR && i < sizeof texts / sizeof texts[0]; i++) {
        code = sqlite3_prepare_v2(file->db, texts[i], -1, &row, NULL);
    }
    sqlite3_bind_int64(row, 1, id);
    if (sql_row(row, &code)) {
        *round = (struct round_record){
            .id = id,
            .seed = column_u32(row, 0),
            .start_tick = column_u32(row, 1),
            .end_tick = column_u32(row, 2),
            .caught = column_u32(row, 3),
            .by_bot = column_u8(row, 4),
            .mode = column_u8(row, 5),
            .grade = column_u8(row, 6),
            .players = column_u8(row, 7),
            .unscored = column_u8(row, 8),
            .fish_count = column_u16(row, 9),
            .round_s = column_u16(row, 10),
            .preset = column_u8(row, 11),
            .level = column_u8(row, 12),
        };
        code = SQLITE_DONE;
    }
    code = sql_end(row, code);
    if (code != SQLITE_OK) {
        return code;
    }
    code = sqlite3_prepare_v2(file->db, sql_get_players, -1, &row, NULL);
    sqlite3_bind_int64(row, 1, id);
    while (sql_row(row, &code)) {
        const uint32_t slot = column_u32(row, 0);
        if (slot < POI_MAX) {
            round->player[slot] = (struct player_record){
                column_u32(row, 1), column_u32(row, 2), column_u32(row, 3),
                column_u32(row, 4), column_u32(row, 5), column_u8(row, 6),
            };
        }
    }
    return sql_end(row, code);
}

#define ENTRY_COLUMNS                                                                              \
    "SELECT id, boot, tick, day, minute, kind, detail, count, value, units, bonus_units, paid,"    \
    " service, untold, open, up_s, dropped_ticks, device_faults, name, sum FROM entries "

/* Reads the first entry that the query `text` selects with the parameter `id`. Returns
 * SQLITE_NOTFOUND if no row matches, or SQLITE_CORRUPT if the entry's checksum is wrong or a value
 * is out of range. */
static int find_entry(struct ledger_file *file, const char *text, uint32_t id,
                      struct ledger_entry *out)
{
    CORE_ASSERT(file->db);
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(file->db, text, -1, &row, NULL);
    sqlite3_bind_int64(row, 1, id);
    if (sql_row(row, &code)) {
        const uint32_t open = column_u32(row, 14);
        *out = (struct ledger_entry){
            .id = column_u32(row, 0),
            .boot = column_u32(row, 1),
            .tick = column_u32(row, 2),
            .day = column_u16(row, 3),
            .minute = column_u16(row, 4),
            .kind = column_u8(row, 5),
            .detail = column_u8(row, 6),
            .count = column_u32(row, 7),
            .value = (int32_t)sqlite3_column_int64(row, 8),
            .balance = { column_u32(row, 9), column_u32(row, 10), column_u32(row, 11),
                         column_u32(row, 12), column_u32(row, 13), (uint8_t)open,
                         (uint8_t)(open >> LEDGER_RETURNED_SHIFT),
                         (uint16_t)(open >> LEDGER_TICKETS_SHIFT) },
            .health = { column_u32(row, 15), column_u32(row, 16), column_u32(row, 17) },
        };
        sql_text(row, 18, out->name, sizeof out->name);
        const int64_t sum = sqlite3_column_int64(row, 19);
        code = out->kind == LEDGER_ROUND ? read_round(file, out->id, &out->round) : SQLITE_OK;
        code = code == SQLITE_OK && (ledger_entry_sum(out) != sum || !ledger_entry_is_valid(out))
                   ? SQLITE_CORRUPT
                   : code;
    } else if (code == SQLITE_DONE) {
        code = SQLITE_NOTFOUND;
    }
    sqlite3_finalize(row);
    return code;
}

int ledger_file_entry(struct ledger_file *file, uint32_t id, struct ledger_entry *out)
{
    return find_entry(file, ENTRY_COLUMNS "WHERE id = ?1", id, out);
}

void ledger_file_round(struct ledger_file *file, uint32_t id, struct ledger_entry *out)
{
    *out = (struct ledger_entry){ 0 };
    const int code = ledger_file_entry(file, id, out);
    if (code != SQLITE_OK) {
        *out = (struct ledger_entry){ .id = code == SQLITE_NOTFOUND ? 0u : id };
    }
}

/* ---- Content of the file ------------------------------------------------------------------- */

void ledger_content_load(const struct ledger_content *content, struct persistent_state *out)
{
    const struct persistent_state *memory = &content->memory;
    out->ledger = memory->ledger;
    out->audits = memory->audits;
    out->ranking = memory->ranking;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (content->has_setting[id]) {
            out->settings.value[id] = memory->settings.value[id];
        }
    }
}

/* Function that copies one row of a table to `content`. A row that only another version of Kingyo
 * uses stays in the file and is ignored. */
typedef void take_row(struct ledger_content *content, sqlite3_stmt *row);

static void take_setting(struct ledger_content *content, sqlite3_stmt *row)
{
    char name[LEDGER_ROW_NAME_SIZE];
    sql_text(row, 0, name, sizeof name);
    const int64_t value = sqlite3_column_int64(row, 1);
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (strcmp(settings_entry(id)->name, name) == 0 && value >= INT32_MIN &&
            value <= INT32_MAX && settings_allows(id, (int32_t)value)) {
            content->memory.settings.value[id] = (int32_t)value;
            content->has_setting[id] = 1;
        }
    }
}

static void take_audit(struct ledger_content *content, sqlite3_stmt *row)
{
    char name[LEDGER_ROW_NAME_SIZE], own[AUDIT_NAME_SIZE];
    sql_text(row, 0, name, sizeof name);
    for (uint32_t id = 0; id < AUDIT_COUNT; id++) {
        audits_name(id, own);
        if (strcmp(name, own) == 0) {
            content->memory.audits.count[id] = column_u32(row, 1);
        }
    }
}

static void take_rank(struct ledger_content *content, sqlite3_stmt *row)
{
    const uint32_t level = column_u32(row, 0), mode = column_u32(row, 1);
    const uint32_t period = column_u32(row, 2), place = column_u32(row, 3);
    const uint32_t board =
        mode < MODE_COUNT && level < LEVEL_COUNT ? ranking_board((uint8_t)mode, (uint8_t)level) : 0;
    if (ranking_board_at(board).mode == mode && ranking_board_at(board).level == level &&
        period < RANK_PERIOD_COUNT && place < RANK_ROWS) {
        struct rank_row *rank = &content->memory.ranking.row[board][period][place];
        rank->caught = column_u32(row, 4);
        rank->round_id = column_u32(row, 5);
        rank->day = column_u16(row, 6);
        rank->slot = (uint8_t)sql_uint(row, 7, POI_MAX - 1u);
        sql_text(row, 8, rank->name, sizeof rank->name);
    }
}

static void take_state(struct ledger_content *content, sqlite3_stmt *row)
{
    struct ranking *ranking = &content->memory.ranking;
    char name[LEDGER_ROW_NAME_SIZE];
    sql_text(row, 0, name, sizeof name);
    if (strcmp(name, "ranking-boot") == 0) {
        ranking->boot = column_u32(row, 1);
    } else if (strcmp(name, "ranking-day") == 0) {
        ranking->day = column_u16(row, 1);
    } else if (strcmp(name, "ranking-week") == 0) {
        ranking->week = column_u16(row, 1);
    } else if (strcmp(name, "ranking-week-boot") == 0) {
        ranking->week_boot = column_u32(row, 1);
    }
}

int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out)
{
    CORE_ASSERT(file->db);
    _Static_assert(LEDGER_BEGIN == 4 && LEDGER_STAND == 17, "the kinds of the statement");
    static const struct {
        const char *text;
        take_row *take;
    } tables[] = {
        { "SELECT name, value FROM settings", take_setting },
        { "SELECT name, count FROM audits", take_audit },
        { "SELECT level, mode, period, place, caught, round, day, seat, name FROM ranking",
          take_rank },
        { "SELECT name, value FROM state", take_state },
    };
    *out = (struct ledger_content){ .has_read = true };
    struct ledger_start *start = &out->memory.ledger;
    struct ledger_entry newest = { 0 };
    int code =
        find_entry(file, ENTRY_COLUMNS "WHERE id >= ?1 ORDER BY id DESC LIMIT 1", 0, &newest);
    if (code == SQLITE_OK) {
        *start = (struct ledger_start){ .last_id = newest.id,
                                        .boots = newest.boot,
                                        .balance = newest.balance };
        out->tick = newest.tick;
        if (newest.balance.open & PAYMENT_SPENT) {
            /* Reads the newest entry that records the start or the state of an open round. */
            code = find_entry(
                file, ENTRY_COLUMNS "WHERE id >= ?1 AND kind IN (4, 17) ORDER BY id DESC LIMIT 1",
                0, &newest);
            start->stand =
                code == SQLITE_OK ? round_standing_after(start->stand, &newest) : start->stand;
        }
    }
    code = code == SQLITE_NOTFOUND ? SQLITE_OK : code;
    for (size_t i = 0; code == SQLITE_OK && i < sizeof tables / sizeof tables[0]; i++) {
        sqlite3_stmt *row = NULL;
        code = sqlite3_prepare_v2(file->db, tables[i].text, -1, &row, NULL);
        while (sql_row(row, &code)) {
            tables[i].take(out, row);
        }
        code = sql_end(row, code);
    }
    return code == SQLITE_OK && !ledger_state_is_valid(&out->memory) ? SQLITE_CORRUPT : code;
}

/* ---- Checksums of the tables --------------------------------------------------------------- */

/* Writes and verifies a checksum of each aggregate table.
 *
 * Without these checksums, a flipped bit in a setting, an audit or a score would not be detected,
 * because SQLite has no checksums. Each ledger entry has its own checksum. */

/* SQL texts for each table checksum: one to read the stored checksum, one to write it, and the
 * queries of the rows that the checksum covers. The checksum of the audits is stored in the same
 * table as the audits, because both change with nearly every entry. A write then changes one page
 * less than with two tables. */
#define STATE_TALLY "SELECT value FROM state WHERE name = "
static const struct tally {
    const char *get, *put;
    /* SQL texts of one or two queries that read the rows. Null means no second query. */
    const char *rows[2];
} tallies[] = {
    { .get = STATE_TALLY "'tally-settings'",
      .put = "INSERT OR REPLACE INTO state (name, value) VALUES ('tally-settings', ?1)",
      .rows = { "SELECT * FROM settings ORDER BY name" } },
    { .get = "SELECT count FROM audits WHERE name = 'tally'",
      .put = "INSERT OR REPLACE INTO audits (name, count) VALUES ('tally', ?1)",
      .rows = { "SELECT * FROM audits WHERE name <> 'tally' ORDER BY name" } },
    { .get = STATE_TALLY "'tally-ranking'",
      .put = "INSERT OR REPLACE INTO state (name, value) VALUES ('tally-ranking', ?1)",
      .rows = { "SELECT * FROM ranking ORDER BY 1, 2, 3, 4",
                "SELECT * FROM state WHERE name NOT LIKE 'tally-%' ORDER BY name" } },
};
#define TALLY_COUNT (sizeof tallies / sizeof tallies[0])

/* Reads the stored checksum of a table to `kept` and computes the checksum of its rows to `out`. A
 * stored checksum of 0 means that no checksum is stored, so the computed checksum is never 0. */
static int add_up(sqlite3 *db, const struct tally *tally, int64_t *kept, int64_t *out)
{
    uint64_t sum = HASH_START;
    int code = sql_number(db, tally->get, kept);
    for (size_t i = 0; code == SQLITE_OK && i < 2u && tally->rows[i]; i++) {
        sqlite3_stmt *row = NULL;
        code = sqlite3_prepare_v2(db, tally->rows[i], -1, &row, NULL);
        while (sql_row(row, &code)) {
            for (int column = 0; column < sqlite3_column_count(row); column++) {
                if (sqlite3_column_type(row, column) == SQLITE_INTEGER) {
                    sum = hash_u64(sum, (uint64_t)sqlite3_column_int64(row, column));
                    continue;
                }
                const void *bytes = sqlite3_column_blob(row, column);
                const size_t size = (size_t)sqlite3_column_bytes(row, column);
                sum = hash_u64(sum, size);
                sum = bytes ? hash_bytes(sum, bytes, size) : sum;
            }
        }
        code = sql_end(row, code);
    }
    *out = sum != 0 ? (int64_t)sum : 1;
    return code;
}

int ledger_checksum_put(sqlite3 *db)
{
    CORE_ASSERT(db);
    int code = SQLITE_OK;
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        int64_t kept = 0, sum = 0;
        code = add_up(db, &tallies[i], &kept, &sum);
        if (code == SQLITE_OK && kept != sum) {
            sqlite3_stmt *put = NULL;
            code = sqlite3_prepare_v2(db, tallies[i].put, -1, &put, NULL);
            code = code == SQLITE_OK ? sql_put_one(put, &sum, 1) : code;
            sqlite3_finalize(put);
        }
    }
    return code;
}

int ledger_checksum_check(sqlite3 *db)
{
    /* Begins a transaction, so that no other program writes between the read of a checksum and the
     * read of the rows that the checksum covers. */
    int code = sql_run(db, "BEGIN");
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        /* A checksum that is not stored (0) is accepted, because a version of Kingyo without
         * checksums may have written the file last. */
        int64_t kept = 0, sum = 0;
        code = add_up(db, &tallies[i], &kept, &sum);
        code = code == SQLITE_OK && kept != 0 && kept != sum ? SQLITE_CORRUPT : code;
    }
    sql_run(db, "ROLLBACK");
    return code;
}
