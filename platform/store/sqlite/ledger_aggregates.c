/* ledger_aggregates.c -- updates, writes and reads the aggregates of the ledger's entries
 * (settings, audits and ranking) and their checksums. The aggregates have their own rows, so that
 * the kiosk can start without reading all entries of several years. */
#include <string.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* A new field of struct rank_row also needs a column (ledger_schema.c) and code in put_rank() and
 * take_rank(). */
_Static_assert(sizeof(struct rank_row) == 12 + LEDGER_NAME_SIZE, "a field of a rank is not kept");
_Static_assert(sizeof(struct ranking) ==
                   12 + sizeof(struct rank_row) * MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS,
               "a field of the ranking is not kept");

#define RANKS (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

/* ---- Updating from an entry ---------------------------------------------------------------- */

void ledger_aggregates_note(struct ledger_content *content, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->id > content->memory.ledger.last_id);
    struct persistent_state *memory = &content->memory;
    memory->ledger =
        (struct ledger_start){ .last_id = entry->id,
                               .boots = entry->boot,
                               .balance = entry->balance,
                               .stand = round_standing_after(memory->ledger.stand, entry) };
    content->tick = entry->tick;
    if (entry->kind == LEDGER_SETTING) {
        const uint32_t id = entry->detail | entry->count << 8;
        if (id < SETTING_COUNT && settings_allows(id, entry->value)) {
            content->memory.settings.value[id] = entry->value;
            content->has_setting[id] = 1;
        }
    } else if (entry->kind == LEDGER_FACTORY) {
        memset(content->has_setting, 0, sizeof content->has_setting);
        memset(&memory->settings, 0, sizeof memory->settings);
    }
    audits_note(&memory->audits, entry);
    ranking_note(&memory->ranking, entry);
}

/* ---- Writing ------------------------------------------------------------------------------- */

/* Writes the value of the row `name` with the statement `which`. Returns an SQLite code. */
static int put_named(struct ledger_file *file, enum ledger_statement which, const char *name,
                     int64_t value)
{
    CORE_ASSERT(name);
    sqlite3_stmt *put = NULL;
    const int code = ledger_statement(file, which, &put);
    if (code != SQLITE_OK) {
        return code;
    }
    sqlite3_bind_text(put, 2, name, -1, SQLITE_TRANSIENT);
    return sql_put_one(put, &value, 1);
}

static const struct rank_row *rank_of(const struct ranking *ranking, uint32_t index)
{
    CORE_ASSERT(index < RANKS);
    return &ranking->row[index / RANK_ROWS / RANK_PERIOD_COUNT]
                        [index / RANK_ROWS % RANK_PERIOD_COUNT][index % RANK_ROWS];
}

static int put_rank(struct ledger_file *file, uint32_t index, const struct rank_row *row)
{
    const int64_t values[] = { index / RANK_ROWS / RANK_PERIOD_COUNT,
                               index / RANK_ROWS % RANK_PERIOD_COUNT,
                               index % RANK_ROWS,
                               row->caught,
                               row->round_id,
                               row->day,
                               row->seat };
    const int count = (int)(sizeof values / sizeof values[0]);
    sqlite3_stmt *put = NULL;
    const int code = ledger_statement(file, PUT_RANK, &put);
    if (code != SQLITE_OK) {
        return code;
    }
    const int size = (int)strnlen(row->name, sizeof row->name);
    sqlite3_bind_text(put, count + 1, row->name, size, SQLITE_STATIC);
    return sql_put_one(put, values, count);
}

int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after)
{
    CORE_ASSERT(file->db && !file->refusal);
    /* Write the changed settings. If a setting must be deleted, delete all settings and write
     * the remaining ones again. */
    int code = SQLITE_OK;
    int is_kept = 1;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        is_kept &= after->has_setting[id] >= before->has_setting[id];
    }
    if (!is_kept) {
        sqlite3_stmt *forget = NULL;
        code = ledger_statement(file, FORGET_SETTINGS, &forget);
        code = code == SQLITE_OK ? sql_put(forget, NULL, 0) : code;
    }
    for (uint32_t id = 0; code == SQLITE_OK && id < SETTING_COUNT; id++) {
        const int32_t value = after->memory.settings.value[id];
        const int is_same =
            is_kept && before->has_setting[id] && before->memory.settings.value[id] == value;
        if (after->has_setting[id] && !is_same) {
            code = put_named(file, PUT_SETTING, settings_entry(id)->name, value);
        }
    }
    if (code == SQLITE_OK) {
        char name[AUDIT_NAME_SIZE];
        for (uint32_t id = 0; code == SQLITE_OK && id < AUDIT_COUNT; id++) {
            if (after->memory.audits.count[id] != before->memory.audits.count[id]) {
                audits_name(id, name);
                code = put_named(file, PUT_AUDIT, name, after->memory.audits.count[id]);
            }
        }
    }
    if (code == SQLITE_OK) {
        for (uint32_t i = 0; code == SQLITE_OK && i < RANKS; i++) {
            const struct rank_row *row = rank_of(&after->memory.ranking, i);
            if (memcmp(row, rank_of(&before->memory.ranking, i), sizeof *row) != 0) {
                code = put_rank(file, i, row);
            }
        }
        if (code == SQLITE_OK && after->memory.ranking.boot != before->memory.ranking.boot) {
            code = put_named(file, PUT_STATE, "ranking-boot", after->memory.ranking.boot);
        }
        if (code == SQLITE_OK && after->memory.ranking.day != before->memory.ranking.day) {
            code = put_named(file, PUT_STATE, "ranking-day", after->memory.ranking.day);
        }
        if (code == SQLITE_OK && after->memory.ranking.week != before->memory.ranking.week) {
            code = put_named(file, PUT_STATE, "ranking-week", after->memory.ranking.week);
        }
        if (code == SQLITE_OK &&
            after->memory.ranking.week_boot != before->memory.ranking.week_boot) {
            code = put_named(file, PUT_STATE, "ranking-week-boot", after->memory.ranking.week_boot);
        }
    }
    return code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
}

/* ---- Reading (rows that only another version writes stay in the file and are ignored) ------- */

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
            content->memory.audits.count[id] = sql_uint(row, 1, UINT32_MAX);
        }
    }
}

static void take_rank(struct ledger_content *content, sqlite3_stmt *row)
{
    const uint32_t mode = sql_uint(row, 0, UINT32_MAX), period = sql_uint(row, 1, UINT32_MAX);
    const uint32_t place = sql_uint(row, 2, UINT32_MAX);
    if (mode < MODE_COUNT && period < RANK_PERIOD_COUNT && place < RANK_ROWS) {
        struct rank_row *rank = &content->memory.ranking.row[mode][period][place];
        rank->caught = sql_uint(row, 3, UINT32_MAX);
        rank->round_id = sql_uint(row, 4, UINT32_MAX);
        rank->day = (uint16_t)sql_uint(row, 5, UINT16_MAX);
        rank->seat = (uint8_t)sql_uint(row, 6, POI_MAX - 1u);
        sql_text(row, 7, rank->name, sizeof rank->name);
    }
}

static void take_state(struct ledger_content *content, sqlite3_stmt *row)
{
    char name[LEDGER_ROW_NAME_SIZE];
    sql_text(row, 0, name, sizeof name);
    if (strcmp(name, "ranking-boot") == 0) {
        content->memory.ranking.boot = sql_uint(row, 1, UINT32_MAX);
    } else if (strcmp(name, "ranking-day") == 0) {
        content->memory.ranking.day = (uint16_t)sql_uint(row, 1, UINT16_MAX);
    } else if (strcmp(name, "ranking-week") == 0) {
        content->memory.ranking.week = (uint16_t)sql_uint(row, 1, UINT16_MAX);
    } else if (strcmp(name, "ranking-week-boot") == 0) {
        content->memory.ranking.week_boot = sql_uint(row, 1, UINT32_MAX);
    }
}

int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out)
{
    CORE_ASSERT(file->db);
    static const struct {
        const char *text;
        take_row *take;
    } tables[] = {
        { "SELECT name, value FROM settings", take_setting },
        { "SELECT name, count FROM audits", take_audit },
        { "SELECT mode, period, place, caught, round, day, seat, name FROM ranking", take_rank },
        { "SELECT name, value FROM state", take_state },
    };
    *out = (struct ledger_content){ .has_read = true };
    struct ledger_entry newest;
    int code = ledger_rows_newest(file, &newest);
    if (code == SQLITE_OK) {
        out->memory.ledger = (struct ledger_start){ .last_id = newest.id,
                                                    .boots = newest.boot,
                                                    .balance = newest.balance };
        out->tick = newest.tick;
        if (newest.balance.open & PAYMENT_SPENT) {
            code = ledger_rows_state(file, &out->memory.ledger.stand);
        }
    }
    code = code == SQLITE_NOTFOUND ? SQLITE_OK : code;
    for (size_t i = 0; code == SQLITE_OK && i < sizeof tables / sizeof tables[0]; i++) {
        sqlite3_stmt *row = NULL;
        code = sqlite3_prepare_v2(file->db, tables[i].text, -1, &row, NULL);
        while ((code == SQLITE_OK || code == SQLITE_ROW) &&
               (code = sqlite3_step(row)) == SQLITE_ROW) {
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

/* SQL text for each table checksum: to read the checksum, to write it, and to read the rows that it
 * covers. The checksum of the audits is stored in the table of the audits, because the checksum and
 * the audits change with nearly every entry. Writing one table saves one page per write. */
#define STATE_TALLY "SELECT value FROM state WHERE name = "
static const struct tally {
    const char *get, *put;
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
      .rows = { "SELECT * FROM ranking ORDER BY mode, period, place",
                "SELECT * FROM state WHERE name NOT LIKE 'tally-%' ORDER BY name" } },
};
#define TALLY_COUNT (sizeof tallies / sizeof tallies[0])

static int hash_rows(sqlite3 *db, const char *text, uint64_t *hash)
{
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(db, text, -1, &row, NULL);
    while ((code == SQLITE_OK || code == SQLITE_ROW) && (code = sqlite3_step(row)) == SQLITE_ROW) {
        uint64_t sum = *hash;
        for (int column = 0; column < sqlite3_column_count(row); column++) {
            if (sqlite3_column_type(row, column) == SQLITE_INTEGER) {
                sum = hash_u64(sum, (uint64_t)sqlite3_column_int64(row, column));
            } else {
                const void *bytes = sqlite3_column_blob(row, column);
                const size_t size = (size_t)sqlite3_column_bytes(row, column);
                sum = hash_u64(sum, size);
                sum = bytes ? hash_bytes(sum, bytes, size) : sum;
            }
        }
        *hash = sum;
    }
    return sql_end(row, code);
}

/* Computes the checksum of a table and writes it to `out`. The checksum is never 0, because 0 means
 * that no checksum is stored. */
static int add_up(sqlite3 *db, const struct tally *tally, int64_t *out)
{
    uint64_t hash = HASH_START;
    int code = hash_rows(db, tally->rows[0], &hash);
    if (code == SQLITE_OK && tally->rows[1]) {
        code = hash_rows(db, tally->rows[1], &hash);
    }
    *out = hash != 0 ? (int64_t)hash : 1;
    return code;
}

static int put_tally_sum(sqlite3 *db, const struct tally *tally, int64_t sum)
{
    sqlite3_stmt *statement = NULL;
    int code = sqlite3_prepare_v2(db, tally->put, -1, &statement, NULL);
    code = code == SQLITE_OK ? sql_put_one(statement, &sum, 1) : code;
    sqlite3_finalize(statement);
    return code;
}

int ledger_checksum_put(sqlite3 *db)
{
    CORE_ASSERT(db);
    int code = SQLITE_OK;
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        int64_t kept = 0, sum = 0;
        code = sql_number(db, tallies[i].get, &kept);
        code = code == SQLITE_OK ? add_up(db, &tallies[i], &sum) : code;
        if (code == SQLITE_OK && kept != sum) {
            code = put_tally_sum(db, &tallies[i], sum);
        }
    }
    return code;
}

int ledger_checksum_check(sqlite3 *db)
{
    int code = sql_run(db, "BEGIN"); /* The transaction prevents another program from writing
                                        between the read of a checksum and the read of the rows that
                                        the checksum covers. */
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        /* A file without a checksum is accepted, because a version of Kingyo without checksums
         * may have written the file last. */
        int64_t kept = 0, sum = 0;
        code = sql_number(db, tallies[i].get, &kept);
        code = code == SQLITE_OK ? add_up(db, &tallies[i], &sum) : code;
        code = code == SQLITE_OK && kept != 0 && kept != sum ? SQLITE_CORRUPT : code;
    }
    sql_run(db, "ROLLBACK");
    return code;
}
