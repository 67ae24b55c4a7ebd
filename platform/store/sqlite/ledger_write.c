/* ledger_write.c -- writes ledger entries and their aggregates (settings, audits and ranking) to
 * the open database, in one transaction. */
#include <string.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/sql.h"
#include "sql_texts.h"

/* A new field of struct balance, struct health or struct player_record also needs a column
 * (ledger_schema.c), code in this file and in ledger_read.c, and a term in ledger_entry_sum(). */
_Static_assert(sizeof(struct balance) == 24, "a field of the balance is not stored");
_Static_assert(sizeof(struct health) == 12, "a field of the health is not kept");
_Static_assert(sizeof(struct player_record) == 24, "a field of the player's record is not kept");
/* A new field of struct rank_row also needs a column (ledger_schema.c) and code in put_ranking()
 * and in take_rank() of ledger_read.c. */
_Static_assert(sizeof(struct rank_row) == 12 + LEDGER_NAME_SIZE, "a field of a rank is not kept");
_Static_assert(sizeof(struct ranking) == 12 + sizeof(struct rank_row) * LEDGER_RANKS,
               "a field of the ranking is not kept");

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

/* ---- Checksum of an entry ------------------------------------------------------------------ */

static uint32_t pack_open(const struct balance *balance)
{
    return balance->open | (uint32_t)balance->returned << LEDGER_RETURNED_SHIFT |
           (uint32_t)balance->tickets << LEDGER_TICKETS_SHIFT;
}

/* ENTRY_VALUES is the number of integer columns of the table `entries` before the checksum.
 * PLAYER_VALUES is the number of integer columns of the table `round_players`. */
#define ENTRY_VALUES 18
#define PLAYER_VALUES 8

static void entry_values(const struct ledger_entry *entry, int64_t out[ENTRY_VALUES + 1])
{
    const struct balance *balance = &entry->balance;
    const struct health *health = &entry->health;
    const int64_t values[ENTRY_VALUES + 1] = {
        entry->id,        entry->boot,           entry->tick,
        entry->day,       entry->minute,         entry->kind,
        entry->detail,    entry->count,          entry->value,
        balance->units,   balance->bonus_units,  balance->paid,
        balance->service, balance->unlogged,     pack_open(balance),
        health->up_s,     health->dropped_ticks, health->device_faults,
    };
    memcpy(out, values, sizeof values);
}

static void player_values(const struct ledger_entry *entry, uint32_t slot,
                          int64_t out[PLAYER_VALUES])
{
    CORE_ASSERT(slot < POI_MAX);
    const struct player_record *player = &entry->round.player[slot];
    const int64_t values[PLAYER_VALUES] = {
        entry->id,         slot,           player->caught, player->scoops, player->hole_area_mm2,
        player->torn_tick, player->sheets, player->fouls
    };
    memcpy(out, values, sizeof values);
}

/* Hashes the low 32 bits of each value. */
static uint64_t hash_values(uint64_t sum, const int64_t *values, int count)
{
    for (int i = 0; i < count; i++) {
        sum = hash_u32(sum, (uint32_t)values[i]);
    }
    return sum;
}

int64_t ledger_entry_sum(const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    const int64_t game[] = { round->seed,   round->start_tick, round->end_tick,
                             round->caught, round->by_bot,     round->mode,
                             round->grade,  round->players,    round->unscored };
    const int64_t tank[] = { round->fish_count, round->round_s, round->preset };
    int64_t values[ENTRY_VALUES + 1], own[PLAYER_VALUES];
    entry_values(entry, values);
    uint64_t sum = hash_values(HASH_START, values, ENTRY_VALUES);
    if (entry->kind != LEDGER_ROUND) {
        return (int64_t)sum;
    }
    sum = hash_values(sum, game, COUNT(game));
    sum = round->fish_count > 0 ? hash_values(sum, tank, COUNT(tank)) : sum;
    sum = round->level != LEVEL_MASTER ? hash_u32(sum, round->level) : sum;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        /* The checksum does not cover the first two values, which are the entry's id and the
         * player's slot. */
        player_values(entry, i, own);
        sum = round->players >> i & 1u ? hash_values(sum, own + 2, PLAYER_VALUES - 2) : sum;
    }
    return (int64_t)sum;
}

/* ---- Statements ---------------------------------------------------------------------------- */

static const char *const texts[LEDGER_STATEMENT_COUNT] = {
    [PUT_ENTRY] = sql_put_entry,
    [PUT_ROUND] = sql_put_round,
    [PUT_PLAYER] = sql_put_player,
    [PUT_NAME] = sql_put_name,
    [FORGET_NAME] = sql_forget_name,
    [PUT_SETTING] = sql_put_setting,
    [FORGET_SETTINGS] = sql_forget_settings,
    [PUT_AUDIT] = sql_put_audit,
    [PUT_RANK] = sql_put_rank,
    [PUT_STATE] = sql_put_state,
    [PUT_REPLAY] = sql_put_replay,
    [GET_REPLAY] = sql_get_replay,
    [HAS_REPLAY] = sql_has_replay,
};

int ledger_statement(struct ledger_file *file, enum ledger_statement which, sqlite3_stmt **out)
{
    CORE_ASSERT(which < LEDGER_STATEMENT_COUNT && texts[which]);
    CORE_ASSERT(file->db);
    int code = SQLITE_OK;
    if (!file->statement[which]) {
        code = sqlite3_prepare_v3(file->db, texts[which], -1, SQLITE_PREPARE_PERSISTENT,
                                  &file->statement[which], NULL);
    }
    *out = file->statement[which];
    return code;
}

/* Runs the statement `which`. `values` are the first parameters of the statement, and `text` is the
 * next parameter. If `text` is null, no text is bound. Otherwise `size` is the size of the buffer
 * `text`. Returns SQLITE_CORRUPT if the statement must store one row and stored none. */
static int put(struct ledger_file *file, enum ledger_statement which, const int64_t *values,
               int count, const char *text, size_t size)
{
    const bool is_one = which != PUT_NAME && which != FORGET_NAME && which != FORGET_SETTINGS;
    sqlite3_stmt *statement = NULL;
    const int code = ledger_statement(file, which, &statement);
    if (code != SQLITE_OK) {
        return code;
    }
    if (text) {
        sqlite3_bind_text(statement, count + 1, text, (int)strnlen(text, size), SQLITE_TRANSIENT);
    }
    return is_one ? sql_put_one(statement, values, count) : sql_put(statement, values, count);
}

/* ---- Rows of an entry ---------------------------------------------------------------------- */

static int put_round(struct ledger_file *file, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    const int64_t values[] = { entry->id,       entry->boot,       entry->day,      entry->minute,
                               round->seed,     round->start_tick, round->end_tick, round->caught,
                               round->by_bot,   round->mode,       round->grade,    round->players,
                               round->unscored, round->fish_count, round->round_s,  round->preset,
                               round->level };
    int code = put(file, PUT_ROUND, values, COUNT(values), NULL, 0);
    for (uint32_t i = 0; code == SQLITE_OK && i < POI_MAX; i++) {
        int64_t columns[PLAYER_VALUES];
        player_values(entry, i, columns);
        if (round->players >> i & 1u) {
            code = put(file, PUT_PLAYER, columns, PLAYER_VALUES, NULL, 0);
        }
    }
    return code;
}

int ledger_rows_put(struct ledger_file *file, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->id > 0);
    int64_t values[ENTRY_VALUES + 1];
    entry_values(entry, values);
    values[ENTRY_VALUES] = ledger_entry_sum(entry);
    int code = put(file, PUT_ENTRY, values, COUNT(values), entry->name, sizeof entry->name);
    if (code == SQLITE_OK && entry->kind == LEDGER_ROUND) {
        code = put_round(file, entry);
    } else if (code == SQLITE_OK && entry->kind == LEDGER_NAME) {
        /* An empty name revokes the player's earlier names. The names are also erased in the
         * entries of the ledger. */
        const int64_t whose[] = { entry->count, entry->detail, LEDGER_NAME };
        code = put(file, PUT_NAME, whose, 2, entry->name, sizeof entry->name);
        if (code == SQLITE_OK && !entry->name[0]) {
            code = put(file, FORGET_NAME, whose, 3, NULL, 0);
        }
    }
    return code;
}

/* ---- Aggregates ---------------------------------------------------------------------------- */

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
            memory->settings.value[id] = entry->value;
            content->has_setting[id] = 1;
        }
    } else if (entry->kind == LEDGER_FACTORY) {
        memset(content->has_setting, 0, sizeof content->has_setting);
        memset(&memory->settings, 0, sizeof memory->settings);
    }
    audits_note(&memory->audits, entry);
    ranking_note(&memory->ranking, entry);
}

/* Writes the changed settings. If a setting must be deleted, deletes all settings and writes the
 * remaining ones again. */
static int put_settings(struct ledger_file *file, const struct ledger_content *before,
                        const struct ledger_content *after)
{
    int code = SQLITE_OK;
    bool is_kept = true;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        is_kept = is_kept && after->has_setting[id] >= before->has_setting[id];
    }
    if (!is_kept) {
        code = put(file, FORGET_SETTINGS, NULL, 0, NULL, 0);
    }
    for (uint32_t id = 0; code == SQLITE_OK && id < SETTING_COUNT; id++) {
        const int64_t value = after->memory.settings.value[id];
        const bool is_same =
            is_kept && before->has_setting[id] && before->memory.settings.value[id] == value;
        if (after->has_setting[id] && !is_same) {
            code =
                put(file, PUT_SETTING, &value, 1, settings_entry(id)->name, LEDGER_ROW_NAME_SIZE);
        }
    }
    return code;
}

static int put_ranking(struct ledger_file *file, const struct ranking *before,
                       const struct ranking *after)
{
    const struct {
        const char *name;
        int64_t before, after;
    } states[] = {
        { "ranking-boot", before->boot, after->boot },
        { "ranking-day", before->day, after->day },
        { "ranking-week", before->week, after->week },
        { "ranking-week-boot", before->week_boot, after->week_boot },
    };
    int code = SQLITE_OK;
    for (uint32_t i = 0; code == SQLITE_OK && i < LEDGER_RANKS; i++) {
        const struct rank_row *row = &after->row[0][0][0] + i;
        const struct rank_board board = ranking_board_at(i / RANK_ROWS / RANK_PERIOD_COUNT);
        const int64_t values[] = { board.level,   board.mode,  i / RANK_ROWS % RANK_PERIOD_COUNT,
                                   i % RANK_ROWS, row->caught, row->round_id,
                                   row->day,      row->slot };
        if (memcmp(row, &before->row[0][0][0] + i, sizeof *row) != 0) {
            code = put(file, PUT_RANK, values, COUNT(values), row->name, sizeof row->name);
        }
    }
    for (int i = 0; code == SQLITE_OK && i < COUNT(states); i++) {
        if (states[i].after != states[i].before) {
            code = put(file, PUT_STATE, &states[i].after, 1, states[i].name, LEDGER_ROW_NAME_SIZE);
        }
    }
    return code;
}

int ledger_aggregates_put(struct ledger_file *file, const struct ledger_content *before,
                          const struct ledger_content *after)
{
    CORE_ASSERT(file->db && !file->refusal);
    int code = put_settings(file, before, after);
    for (uint32_t id = 0; code == SQLITE_OK && id < AUDIT_COUNT; id++) {
        const int64_t count = after->memory.audits.count[id];
        if (count != before->memory.audits.count[id]) {
            char name[AUDIT_NAME_SIZE];
            audits_name(id, name);
            code = put(file, PUT_AUDIT, &count, 1, name, sizeof name);
        }
    }
    code = code == SQLITE_OK ? put_ranking(file, &before->memory.ranking, &after->memory.ranking)
                             : code;
    return code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
}

/* ---- Transaction --------------------------------------------------------------------------- */

int ledger_file_write(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count)
{
    CORE_ASSERT(file->db && entries);
    struct ledger_content after = file->content;
    int code = file->is_suspect ? ledger_log_secure(file) : SQLITE_OK;
    code = code == SQLITE_OK ? sql_run(file->db, "BEGIN IMMEDIATE") : code;
    if (code != SQLITE_OK) {
        return code;
    }
    for (uint32_t i = 0; code == SQLITE_OK && i < count; i++) {
        if (entries[i].id > after.memory.ledger.last_id) {
            code = ledger_rows_put(file, &entries[i]);
            ledger_aggregates_note(&after, &entries[i]);
        }
    }
    code = code == SQLITE_OK ? ledger_aggregates_put(file, &file->content, &after) : code;
    code = sql_commit(file->db, code);
    if (code != SQLITE_OK) {
        /* Reads the content again, because SQLite may have written the entries although it reported
         * an error, or another program may have written entries. A connection that reported a
         * failed sync of a transaction does not return the content of that transaction. */
        struct ledger_content found;
        if (ledger_aggregates_read(file, &found) == SQLITE_OK) {
            file->content = found;
        }
        return code;
    }
    file->content = after;
    return ledger_log_result(file, SQLITE_OK);
}
