/* ledger_aggregates.c -- updates, writes and reads the aggregates of the ledger's entries:
 * settings, audits and ranking.
 *
 * The aggregates have rows of their own, so that the kiosk starts without reading the entries of
 * years. */
#include <string.h>

#include <sqlite3.h>

#include "core/game/accounting/ledger_range.h"
#include "core/game/accounting/round_standing.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* A new field of struct rank_row also needs a column (ledger_tables.c) and code in put_rank() and
 * take_rank(). */
_Static_assert(sizeof(struct rank_row) == 12 + LEDGER_NAME_SIZE, "a field of a rank is not kept");
_Static_assert(sizeof(struct ranking) ==
                   12 + sizeof(struct rank_row) * MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS,
               "a field of the ranking is not kept");

#define RANKS (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

/* ---- Updating from an entry ---------------------------------------------------------------- */

static void note_setting(struct ledger_content *content, const struct ledger_entry *entry)
{
    const uint32_t id = entry->detail | entry->count << 8;
    if (id < SETTING_COUNT && settings_allows(id, entry->value)) {
        content->memory.settings.value[id] = entry->value;
        content->has_setting[id] = 1;
    }
}

void ledger_aggregates_note(struct ledger_content *content, const struct ledger_entry *entry)
{
    struct persistent_state *memory = &content->memory;
    memory->ledger = (struct ledger_start){ .last_id = entry->id,
                                            .boots = entry->boot,
                                            .balance = entry->balance,
                                            .stand = stand_after(memory->ledger.stand, entry) };
    content->tick = entry->tick;
    if (entry->kind == LEDGER_SETTING) {
        note_setting(content, entry);
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
    sqlite3_stmt *put = NULL;
    const int code = ledger_statement(file, which, &put);
    if (code != SQLITE_OK) {
        return code;
    }
    sqlite3_bind_text(put, 2, name, -1, SQLITE_TRANSIENT);
    return sql_put_one(put, &value, 1);
}

/* Writes the changed settings. If a setting must be deleted, deletes all settings and writes the
 * remaining ones again. */
static int put_settings(struct ledger_file *file, const struct ledger_content *before,
                        const struct ledger_content *after)
{
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
    return code;
}

static int put_audits(struct ledger_file *file, const struct audits *before,
                      const struct audits *after)
{
    char name[AUDIT_NAME_SIZE];
    int code = SQLITE_OK;
    for (uint32_t id = 0; code == SQLITE_OK && id < AUDIT_COUNT; id++) {
        if (after->count[id] != before->count[id]) {
            audits_name(id, name);
            code = put_named(file, PUT_AUDIT, name, after->count[id]);
        }
    }
    return code;
}

static const struct rank_row *rank_of(const struct ranking *ranking, uint32_t index)
{
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

static int put_ranks(struct ledger_file *file, const struct ranking *before,
                     const struct ranking *after)
{
    int code = SQLITE_OK;
    for (uint32_t i = 0; code == SQLITE_OK && i < RANKS; i++) {
        const struct rank_row *row = rank_of(after, i);
        if (memcmp(row, rank_of(before, i), sizeof *row) != 0) {
            code = put_rank(file, i, row);
        }
    }
    if (code == SQLITE_OK && after->boot != before->boot) {
        code = put_named(file, PUT_STATE, "ranking-boot", after->boot);
    }
    if (code == SQLITE_OK && after->day != before->day) {
        code = put_named(file, PUT_STATE, "ranking-day", after->day);
    }
    if (code == SQLITE_OK && after->week != before->week) {
        code = put_named(file, PUT_STATE, "ranking-week", after->week);
    }
    if (code == SQLITE_OK && after->week_boot != before->week_boot) {
        code = put_named(file, PUT_STATE, "ranking-week-boot", after->week_boot);
    }
    return code;
}

int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after)
{
    int code = put_settings(file, before, after);
    code =
        code == SQLITE_OK ? put_audits(file, &before->memory.audits, &after->memory.audits) : code;
    code =
        code == SQLITE_OK ? put_ranks(file, &before->memory.ranking, &after->memory.ranking) : code;
    return code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
}

/* ---- Reading (rows that this version does not know stay in the file and are ignored) ------- */

typedef void take_row(struct ledger_content *content, sqlite3_stmt *row);

static int read_rows(struct ledger_file *file, const char *text, take_row *take,
                     struct ledger_content *out)
{
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(file->db, text, -1, &row, NULL);
    while ((code == SQLITE_OK || code == SQLITE_ROW) && (code = sqlite3_step(row)) == SQLITE_ROW) {
        take(out, row);
    }
    return sql_end(row, code);
}

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

static int read_start(struct ledger_file *file, struct ledger_content *out)
{
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
    return code == SQLITE_NOTFOUND ? SQLITE_OK : code;
}

int ledger_aggregates_read(struct ledger_file *file, struct ledger_content *out)
{
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
    int code = read_start(file, out);
    for (size_t i = 0; code == SQLITE_OK && i < sizeof tables / sizeof tables[0]; i++) {
        code = read_rows(file, tables[i].text, tables[i].take, out);
    }
    return code == SQLITE_OK && !ledger_state_is_valid(&out->memory) ? SQLITE_CORRUPT : code;
}
